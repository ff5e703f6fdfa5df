#include "bench/bench_table.h"

#include <cmath>
#include <cstdio>

namespace ts::bench {
namespace {

struct Row {
  const char *text;
  const char *figure;
  double scale;
  const char *unit;
};

std::string cell(double value) {
  if (std::isnan(value)) return "-";
  char text[40];
  std::snprintf(text, sizeof text, std::abs(value) >= 100 ? "%.0f" : std::abs(value) >= 10 ? "%.1f" : "%.3g", value);
  return text;
}

void print_rows(const Figures &figures, const char *title, std::initializer_list<Row> rows) {
  std::printf("  %s\n", title);
  for (const Row &r : rows)
    std::printf("    %-52s %10s %s\n", r.text, cell(figures.get(r.figure) * r.scale).c_str(), r.unit);
}

// A real scan: a line.
void print_line(const Result &result) {
  const Figures &f = result.figures;
  if (!result.failure.empty()) {
    std::printf("%-24s failed: %s\n", result.name.c_str(), result.failure.c_str());
    return;
  }
  std::printf("%-24s %7.0f triangles %3.0f teeth", result.name.c_str(), f.get("triangles"), f.get("groups"));
  const std::pair<const char *, const char *> shown[] = {
      {"prepare", "prepare"}, {"click", "click"}, {"p95", "click_p95"}, {"(a)", "a"}, {"(b)", "b"}};
  for (const auto &[text, figure] : shown) std::printf("  %s %s", text, cell(f.get(figure)).c_str());
  std::printf(" ms  peak %s GB\n", cell(f.get("peak_gb")).c_str());
}

}  // namespace

void print_result(const Result &result) {
  if (result.size == 0) return print_line(result);
  const Figures &f = result.figures;
  std::printf("\n%s", result.name.c_str());
  if (!result.failure.empty()) {
    std::printf(": failed: %s\n", result.failure.c_str());
    return;
  }
  std::printf(": %.0f triangles, %.0f vertices, %.0f teeth; took %.0f s, others kept %.1f cores busy\n",
              f.get("triangles"), f.get("vertices"), f.get("groups"), f.get("took_s"), f.get("others_cores"));
  print_rows(f, "preparation",
             {{"load (binary STL in memory, intake included)", "load", 1, "ms"},
              {"intake", "intake", 1, "ms"},
              {"features", "features", 1, "ms"},
              {"weights", "weights", 1, "ms"},
              {"factorise", "factorise", 1, "ms"},
              {"basis", "basis", 1, "ms"},
              {"prepare: intake + features + segmentation", "prepare", 1, "ms"}});
  print_rows(f, "clicks",
             {{"click, point to labels, p50", "click", 1, "ms"},
              {"click, point to labels, p95", "click_p95", 1, "ms"},
              {"  pick", "pick", 1, "ms"},
              {"  field", "field", 1, "ms"},
              {"  cut", "cut", 1, "ms"},
              {"  label", "label", 1, "ms"},
              {"  labels of all faces", "labels", 1, "ms"},
              {"click with 1 thread", "click_1t", 1, "ms"},
              {"  field with 1 thread", "field_1t", 1, "ms"},
              {"clicks timed", "clicks", 1, ""},
              {"clicks refused", "clicks_failed", 1, ""},
              {"all clicks of the arch together, 1 thread", "batch_1t", 1, "ms"},
              {"all clicks of the arch together, 2 threads", "batch_2t", 1, "ms"}});
  print_rows(f, "memory",
             {{"peak", "peak_gb", 1, "GB"},
              {"peak until prepared", "peak_prepare_gb", 1, "GB"},
              {"resident once prepared", "steady_gb", 1, "GB"},
              {"of it from the caller's allocator", "steady_hook_gb", 1, "GB"}});
  if (std::isnan(f.get("a"))) return;
  print_rows(f, "baselines",
             {{"(a) a click with Eigen's SimplicialLDLT", "a", 1, "ms"},
              {"  assemble", "a_assemble", 1, "ms"},
              {"  analyse", "a_analyse", 1, "ms"},
              {"  factorise", "a_factorise", 1, "ms"},
              {"  solve", "a_solve", 1, "ms"},
              {"(b) a click with CHOLMOD, 1 thread", "b_1t", 1, "ms"},
              {"  analyse", "b_1t_analyse", 1, "ms"},
              {"  factorise", "b_1t_factorise", 1, "ms"},
              {"  solve", "b_1t_solve", 1, "ms"},
              {"(b) a click with CHOLMOD, 2 threads", "b_2t", 1, "ms"},
              {"  factorise", "b_2t_factorise", 1, "ms"},
              {"  METIS chosen", "b_metis", 1, ""},
              {"  CHOLMOD's own loops chosen with 2 threads", "b_own_loops", 1, ""},
              {"numeric factorisation, 1 thread", "factor_1t", 1, "ms"},
              {"numeric factorisation, 2 threads", "factor_2t", 1, "ms"},
              {"CHOLMOD's, 1 thread", "cholmod_factor_1t", 1, "ms"},
              {"CHOLMOD's, 2 threads", "cholmod_factor_2t", 1, "ms"},
              {"CHOLMOD's analysis", "cholmod_analyse", 1, "ms"},
              {"(c) factor read by a click", "field_bytes", 1e-6, "MB"},
              {"(c) bandwidth of one core (triad)", "bandwidth", 1e-9, "GB/s"},
              {"(c) bound of the field", "bound", 1, "ms"},
              {"largest difference of the field from (b)'s", "difference_b", 1, ""}});
}

const std::vector<std::string> &grown_stages() {
  static const std::vector<std::string> stages = {"load",    "intake",   "features", "weights", "factorise",  "basis",
                                                  "prepare", "click",    "pick",     "field",   "cut",        "label",
                                                  "labels",  "batch_1t", "batch_2t", "peak_gb", "field_bytes"};
  return stages;
}

void print_growth(const std::vector<Result> &results) {
  if (std::isnan(growth(results, "prepare", 100000))) return;
  std::printf("\ngrowth from 100k triangles up: exponents\n");
  for (const std::string &stage : grown_stages())
    std::printf("    %-52s %10s\n", stage.c_str(), cell(growth(results, stage, 100000)).c_str());
}

void print_targets(const std::vector<Target> &targets) {
  std::printf("\ntargets%49s %10s %10s\n", "", "measured", "goal");
  for (const Target &t : targets) {
    std::printf("    %-52s %10s", t.name.c_str(), std::isnan(t.value) ? "-" : cell(t.value).c_str());
    if (!std::isnan(t.goal))
      std::printf(" %10s  %s", cell(t.goal).c_str(), std::isnan(t.value) ? "" : t.value <= t.goal ? "met" : "not met");
    std::printf("\n");
  }
}

}  // namespace ts::bench
