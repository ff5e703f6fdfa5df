#include <algorithm>
#include <cmath>
#include <fstream>
#include <stdexcept>
#include <thread>

#include "bench/bench_baselines.h"
#include "bench/bench_table.h"

namespace ts::bench {
namespace {

double figure(const std::vector<Result> &results, unsigned size, const char *name) {
  for (const Result &r : results)
    if (r.size == size && r.failure.empty()) return r.figures.get(name);
  return not_measured;
}

bool has(const std::vector<Result> &results, unsigned size) {
  return std::any_of(results.begin(), results.end(),
                     [&](const Result &r) { return r.size == size && r.failure.empty(); });
}

// The larger; not_measured if either is.
double worse(double a, double b) {
  return std::isnan(a) || std::isnan(b) ? not_measured : std::max(a, b);
}

std::string environment(const char *name) {
  const char *value = std::getenv(name);
  return value ? value : "";
}

}  // namespace

double growth(const std::vector<Result> &results, const std::string &name, unsigned from) {
  double n = 0, x = 0, y = 0, xx = 0, xy = 0;
  for (const Result &r : results) {
    const double value = r.figures.get(name), size = r.figures.get("triangles");
    if (r.size < from || r.size == 0 || !(value > 0) || !(size > 0)) continue;
    const double lx = std::log(size), ly = std::log(value);
    n += 1, x += lx, y += ly, xx += lx * lx, xy += lx * ly;
  }
  const double spread = n * xx - x * x;
  return n >= 2 && spread > 1e-9 ? (n * xy - x * y) / spread : not_measured;
}

std::vector<Target> targets_of(const std::vector<Result> &results) {
  constexpr unsigned at = 300000, large = 1000000;
  const auto ratio = [&](const char *above, const char *below, unsigned size) {
    return figure(results, size, above) / figure(results, size, below);
  };
  const bool whole_range = has(results, 100000) && has(results, 2000000);
  const auto grows = [&](const char *name) { return whole_range ? growth(results, name, 100000) : not_measured; };
  std::vector<Target> t = {
      {"click_vs_a", ratio("click", "a", at), 1.0 / 60},
      {"click_vs_b", ratio("click", "b", at), 1.0 / 25},
      {"click_ms", figure(results, at, "click"), 16},
      {"field_vs_bound", ratio("field_1t", "bound", at), 2},
      {"batch_2t_vs_1t", ratio("batch_2t", "batch_1t", at), 0.6},
  };
  for (const char *threads : {"1t", "2t"}) {
    const std::string ours = std::string("factor_") + threads, theirs = std::string("cholmod_factor_") + threads;
    const std::string name = std::string("factor_vs_cholmod_") + threads;
    const double small = ratio(ours.c_str(), theirs.c_str(), at), big = ratio(ours.c_str(), theirs.c_str(), large);
    t.push_back({name, worse(small, big), threads[0] == '1' ? 1.5 : 1.0});
    t.push_back({name + "_300k", small, not_measured});
    t.push_back({name + "_1m", big, not_measured});
  }
  t.push_back({"prepare_vs_a", ratio("prepare", "a", at), 2});
  t.push_back({"growth_prepare", grows("prepare"), 1.35});
  t.push_back({"growth_click", grows("click"), 1.1});
  t.push_back({"peak_gb_1m", figure(results, large, "peak_gb"), 1.2});
  return t;
}

Machine this_machine() {
  Machine m;
  m.cores = std::thread::hardware_concurrency();
  m.blas = has_cholmod() ? blas_in_use() : "no CHOLMOD";
  m.openblas_coretype = environment("OPENBLAS_CORETYPE");
  m.openblas_l2 = environment("OPENBLAS_L2_SIZE");
  std::ifstream cpu("/proc/cpuinfo");
  for (std::string line; m.cpu.empty() && std::getline(cpu, line);)
    if (line.starts_with("model name")) m.cpu = line.substr(std::min(line.find(": ") + 2, line.size()));
  return m;
}

namespace {

// NaN is no JSON.
std::string number(double value) {
  if (!std::isfinite(value)) return "null";
  char text[40];
  std::snprintf(text, sizeof text, "%.6g", value);
  return text;
}

std::string quoted(const std::string &text) {
  std::string out = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') out += '\\';
    if (static_cast<unsigned char>(c) >= 0x20) out += c;
  }
  return out + "\"";
}

}  // namespace

void write_json(const std::string &path, const Machine &machine, const std::vector<Result> &results,
                const std::vector<Target> &targets) {
  std::ofstream out(path);
  out << "{\n\"machine\": {\"cpu\": " << quoted(machine.cpu) << ", \"cores\": " << machine.cores
      << ", \"blas\": " << quoted(machine.blas) << ", \"OPENBLAS_CORETYPE\": " << quoted(machine.openblas_coretype)
      << ", \"OPENBLAS_L2_SIZE\": " << quoted(machine.openblas_l2) << "},\n\"scans\": [";
  const char *comma = "\n";
  for (const Result &r : results) {
    out << comma << "{\"name\": " << quoted(r.name) << ", \"size\": " << (r.size ? std::to_string(r.size) : "null");
    if (!r.failure.empty()) out << ", \"failure\": " << quoted(r.failure);
    for (const auto &[name, value] : r.figures.all()) out << ", " << quoted(name) << ": " << number(value);
    out << "}";
    comma = ",\n";
  }
  out << "\n],\n\"growth\": {";
  comma = "";
  for (const std::string &stage : grown_stages()) {
    out << comma << quoted(stage) << ": " << number(growth(results, stage, 100000));
    comma = ", ";
  }
  out << "},\n";
  for (const bool goals : {true, false}) {
    out << (goals ? "\"goals\": {" : "\"targets\": {");
    comma = "";
    for (const Target &t : targets) {
      if (goals && std::isnan(t.goal)) continue;
      out << comma << quoted(t.name) << ": " << number(goals ? t.goal : t.value);
      comma = ", ";
    }
    out << (goals ? "},\n" : "}\n}\n");
  }
  out.close();
  if (!out) throw std::runtime_error("cannot write " + path);
}

}  // namespace ts::bench
