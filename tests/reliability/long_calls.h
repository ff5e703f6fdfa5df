// Every function of the API that takes a job, on an arch of any size: for the tests of cancelling and of failing
// memory, and for the benchmark of how soon a call returns. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <functional>
#include <string>
#include <vector>

#include "arch.h"
#include "scene.h"

// An arch with its features, the first two teeth separated and numbered, and places for every kind of correction.
struct Stage {
  // Files go into `folder`.
  Stage(Handle<ts_context> context, Mesh mesh, std::string folder);

  std::string state() const;  // all that a caller could see of it
  std::string path(const std::string &name) const { return folder + "/" + name; }

  Handle<ts_context> context;
  Mesh mesh, soup;
  std::string folder;
  Handle<ts_model> model;
  Handle<ts_features> features;
  Handle<ts_segmentation> segmentation;
  std::vector<std::uint32_t> teeth;
  std::vector<double> clicks;  // that separate what is left
  Handle<ts_mesh> tooth;
  std::string session, ply, stl, obj, off;  // as files have them

  using Place = std::array<double, 3>;
  Place inside{}, excluded{}, keep{}, part{}, from{}, to{}, dragged{};
  std::uint32_t dragged_point = 0;
  std::array<Place, 3> stroke{};

 private:
  void find_places();
};

struct LongCall {
  std::string function, how;
  // Holds the call to what it promises of its out-parameters. `result`, where not null: all that it made, or the state
  // after a step.
  std::function<ts_status(Stage &, ts_job *, std::string *result)> run;
  bool is_step = false;   // taken back by ts_undo
  std::string file = {};  // that it writes
  std::string name() const { return how.empty() ? function : function + ", " + how; }
};

std::vector<LongCall> long_calls();

// Names of the functions with a ts_job among their arguments, from abi/toothseg.json.
std::vector<std::string> functions_with_a_job(const std::string &description);

std::string bytes_of_file(const std::string &path);
