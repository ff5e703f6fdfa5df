// A call of each function of the API, for the test of their thread rules. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "check.h"
#include "scene.h"

// What calls are about: of a context and a model that all share, the rest a thread's own or shared, as the rule has it.
struct Objects {
  ts_context *context;
  const ts_model *model;
  Handle<ts_features> features;
  Handle<ts_segmentation> segmentation;  // of three teeth two are separated, numbered, one cut is smoothed
  Handle<ts_mesh> mesh;
  Handle<ts_job> job;
  std::vector<std::uint32_t> teeth;
  std::string path;  // begins the names of files

  const ts_segmentation *s() const { return segmentation.get(); }
};

const Bumps &rule_bumps();
Objects objects_on(ts_context *context, const ts_model *model, const std::string &path);

// What the call gave, as bytes: the same whichever thread makes it.
using Call = std::string (*)(Objects &);
struct Rule {
  const char *function;
  Call call;
};

std::vector<Rule> concurrent_rules();  // const handles: at once on one object
std::vector<Rule> exclusive_rules();   // on an object that the thread has to itself
std::vector<Rule> any_rules();         // at once, with whatever they are given

// ------------------------------------------------------------------------------------------------- results as bytes

template <class T>
std::string bytes_of(const T *values, std::size_t n) {
  return {reinterpret_cast<const char *>(values), n * sizeof *values};
}
template <class T>
std::string bytes_of(const T &value) {
  return bytes_of(&value, 1);
}
// Of a getter of the two-call idiom; never empty.
template <class T, class Get>
std::string got(const Get &get, std::size_t width = 1) {
  const auto values = check::all<T>(get, width);
  return std::to_string(values.size()) + ":" + bytes_of(values.data(), values.size());
}
// Of one that fills a struct that begins with its size.
template <class T, class Get>
std::string info(const Get &get) {
  T t{};
  t.struct_size = sizeof t;
  HOLDS(get(&t) == TS_OK);
  return bytes_of(t);
}
std::string all_of(const ts_model *model);
std::string all_of(const ts_features *features);
std::string all_of(const ts_segmentation *segmentation);
std::string all_of(const ts_mesh *mesh);

// What a maker made, and that goes again; where it refuses, why.
template <class T, class Make>
std::string made_bytes(const Make &make) {
  ts_status status;
  const auto object = made<T>(make, &status);
  HOLDS((status == TS_OK) == (object != nullptr) && status / 100 != 1);
  return object ? all_of(object.get()) : ts_status_name(status);
}
