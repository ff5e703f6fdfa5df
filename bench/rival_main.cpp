// ts-rival: other ways to segment teeth, for comparison.
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <fstream>
#include <stdexcept>
#include <string>

#include "bench/bench_figures.h"
#include "bench/rival_sdf.h"
#include "bench/rival_skeleton.h"
#include "mesh/intake.h"
#include "mesh/read.h"

namespace {

using namespace ts::bench;

constexpr const char *kHelp = R"(ts-rival: other ways to segment the teeth of a scan, to measure toothseg against

usage: ts-rival MESH --teeth N [options]
  MESH                PLY, STL, OBJ or OFF, in mm
  --teeth N           how many teeth the scan has, which the methods below are told
  --method NAME       skeleton (default) or sdf
  --threshold T       skeleton: this curvature, 1/mm, instead of the search
  --labels FILE       a number a face, in the order of the file; 0 = no tooth
  --json FILE         what was found, with which settings, and times
  --help              this text

skeleton: the morphologic skeleton of the region where the surface is concave (Li and Wang 2016, refs. 23, 24, 26, 28):
  least curvature, threshold, closing, thinning to lines one vertex wide, the regions between them; low regions are
  gingiva, small ones go to their neighbours. The published programs are interactive: the user picks the threshold (in
  ref. 28 gives the number of teeth, by which it is searched) and repairs the result. Here nobody helps: of 20
  thresholds the one is taken that gives N teeth, or nearest to N, with areas most alike, and surplus teeth are joined
  where the line between them is shallowest. time_ms is a single run at that threshold after intake, curvature and
  occlusal direction included, as for a user who knows the threshold; search_ms is what the search took on top.
sdf: clusters of the shape diameter function with a graph cut, by CGAL; the largest segment is taken for gingiva.
  Clusters (2 to 6) and smoothing (lambda .1 to .8) are searched by the number of teeth; 25 rays a facet as is CGAL's
  default, 12 above 150000 facets. time_ms is the values and one segmentation, search_ms all segmentations. Only where the program was built with CGAL.
)";

struct Arguments {
  std::string mesh, method = "skeleton", labels, json;
  unsigned teeth = 0;
  double threshold = 0;
};

[[noreturn]] void refuse(const std::string &why) {
  std::fprintf(stderr, "ts-rival: %s; --help tells more\n", why.c_str());
  std::exit(2);
}

double number_of(const std::string &name, const std::string &text) {
  char *rest = nullptr;
  const double x = std::strtod(text.c_str(), &rest);
  if (text.empty() || *rest != 0 || !(x > 0)) refuse(name + ": \"" + text + "\" is not a number above 0");
  return x;
}

Arguments arguments_of(int argc, char **argv) {
  Arguments a;
  for (int i = 1; i < argc; ++i) {
    const std::string name = argv[i];
    if (name == "--help") {
      std::fputs(kHelp, stdout);
      std::exit(0);
    }
    if (!name.starts_with("--")) {
      if (!a.mesh.empty()) refuse("one mesh at a time");
      a.mesh = name;
      continue;
    }
    if (i + 1 == argc) refuse(name + " needs a value");
    const std::string value = argv[++i];
    if (name == "--teeth") {
      a.teeth = static_cast<unsigned>(number_of(name, value));
    } else if (name == "--threshold") {
      a.threshold = number_of(name, value);
    } else if (name == "--method") {
      a.method = value;
    } else if (name == "--labels") {
      a.labels = value;
    } else if (name == "--json") {
      a.json = value;
    } else {
      refuse("no option " + name);
    }
  }
  if (a.mesh.empty()) refuse("no mesh given");
  if (a.teeth == 0) refuse("--teeth is missing");
  if (a.method != "skeleton" && a.method != "sdf") refuse("--method: skeleton or sdf, not " + a.method);
  return a;
}

void write_labels(const std::string &path, const ts::mesh::Model &model, const Teeth &teeth) {
  std::ofstream out(path);
  for (const Index f : model.label_source) out << (f == ts::mesh::none ? 0 : teeth.of_face[f]) << '\n';
  if (!out.flush()) throw std::runtime_error("cannot write " + path);
}

std::string json_of(const Arguments &a, const ts::mesh::Model &model, const Outcome &o, double intake_ms) {
  std::string text = "{\"method\": \"" + a.method + "\"";
  const auto add = [&](const std::string &name, double x) {
    char number[64];
    std::snprintf(number, sizeof number, "%.6g", x);
    text += ", \"" + name + "\": " + number;
  };
  for (const auto &[name, x] : o.settings) add(name, x);
  add("wanted", a.teeth);
  add("teeth", o.teeth.count);
  add("regions", o.teeth.regions);
  add("tried", o.tried);
  add("intake_ms", intake_ms);
  add("time_ms", o.run_ms);
  add("search_ms", o.search_ms);
  add("vertices", static_cast<double>(model.surface.vertices()));
  add("faces", static_cast<double>(model.surface.faces()));
  return text + "}\n";
}

int run(const Arguments &a) {
  const ts::Executor executor(0);
  const Timer intake;
  const ts::mesh::Model model = ts::mesh::make_model(ts::mesh::load_mesh(a.mesh), {}, executor, {});
  const double intake_ms = intake.ms();
  const Outcome found = a.method == "sdf" ? sdf_teeth(model.surface, a.teeth)
                                          : skeleton_teeth(model.surface, a.teeth, a.threshold, executor);
  if (!a.labels.empty()) write_labels(a.labels, model, found.teeth);
  const std::string json = json_of(a, model, found, intake_ms);
  std::fputs(json.c_str(), stdout);
  if (a.json.empty()) return 0;
  std::ofstream out(a.json);
  if (!(out << json).flush()) throw std::runtime_error("cannot write " + a.json);
  return 0;
}

}  // namespace

int main(int argc, char **argv) {
  const Arguments a = arguments_of(argc, argv);
  try {
    return run(a);
  } catch (const std::exception &e) {
    std::fprintf(stderr, "ts-rival: %s\n", e.what());
    return 1;
  }
}
