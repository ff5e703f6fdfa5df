// ts-bench: how long the library takes, how much memory, and how that compares.
//
// The harness is small and its own. Every scan is measured in three processes, each forked by one that holds nothing:
// the first makes the mesh and puts it into a file, the second does what a caller does and tells its peak memory, the
// third takes the times. What a target divides by each other is repeated in turns in one process, and medians are
// taken. bench_stages.cpp has the clicks, bench_compare.cpp the baselines, bench_targets.cpp what the targets are.
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <stdexcept>

#include "bench/bench_run.h"
#include "bench/bench_scan.h"
#include "bench/bench_table.h"

namespace {

using namespace ts::bench;

constexpr const char *kHelp = R"(ts-bench: times and memory of toothseg, against the paper's way of work and CHOLMOD

usage: ts-bench [options]
  --sizes N,N,...   triangles of the synthetic arches, 5000 to 8000000; above 600000 an arch of a quarter with every
                    edge halved (default 20000,100000,300000,1000000,2000000)
  --scans DIR       folder of real scans, a folder each with mesh.ply (default ../shared/data/scans where it exists)
  --no-real         no real scans
  --no-baselines    the library alone
  --quick           20000 and 100000 triangles, fewer repetitions, no real scans unless --scans is given
  --json FILE       all figures and the targets as JSON
  --help            this text

Figures: ms unless said otherwise, medians of repetitions in turns.
  load       ts_model_read of a binary STL in memory          intake    ts_model_create from arrays
  prepare    intake + ts_detect_features + ts_segmentation_create, with the default number of threads
  click      ts_segment_click and ts_get_labels: from the point to the labels of all faces, default preset
  batch      ts_segment_clicks of the clicks that ts_propose_clicks gives, on a scan without clicks
  (a)        one field by the paper: assembly, analysis, factorisation, solution with Eigen's SimplicialLDLT, 1 thread
  (b)        the same with CHOLMOD's supernodal LL^T, the better of its ordering and METIS, of 1 and 2 threads
  (c)        bytes of the factor that a click reads, over the bandwidth of one core: a[i] = b[i] + s * c[i] on 3 x 128 MB
  factor     numeric factorisation of the same matrix (free vertices and nodes), ours and cholmod_factorize
  peak       of a process that does nothing but model, features, segmentation and clicks
  others     cores that other programs kept busy meanwhile: figures are worth something where this is near 0
)";

struct Arguments {
  std::vector<unsigned> sizes;
  std::string scans, json;
  bool real = true;
  RunOptions run;
};

[[noreturn]] void refuse(const std::string &why) {
  std::fprintf(stderr, "ts-bench: %s; --help tells more\n", why.c_str());
  std::exit(2);
}

std::vector<unsigned> sizes_of(const std::string &text) {
  std::vector<unsigned> sizes;
  for (std::size_t at = 0; at <= text.size();) {
    const std::size_t end = std::min(text.find(',', at), text.size());
    const std::string item = text.substr(at, end - at);
    char *rest = nullptr;
    const unsigned long n = std::strtoul(item.c_str(), &rest, 10);
    if (item.empty() || item.find_first_not_of("0123456789") != std::string::npos || n < 5000 || n > 8000000)
      refuse("--sizes: \"" + item + "\" is not a number from 5000 to 8000000");
    sizes.push_back(static_cast<unsigned>(n));
    at = end + 1;
  }
  std::sort(sizes.begin(), sizes.end());
  sizes.erase(std::unique(sizes.begin(), sizes.end()), sizes.end());
  return sizes;
}

Arguments arguments_of(int argc, char **argv) {
  Arguments a;
  for (int i = 1; i < argc; ++i) {
    const std::string name = argv[i];
    const auto value = [&]() -> std::string {
      if (++i >= argc) refuse(name + " needs a value");
      return argv[i];
    };
    if (name == "--help") {
      std::fputs(kHelp, stdout);
      std::exit(0);
    } else if (name == "--sizes") {
      a.sizes = sizes_of(value());
    } else if (name == "--scans") {
      a.scans = value();
      if (!std::filesystem::is_directory(a.scans)) refuse("--scans: no folder " + a.scans);
    } else if (name == "--json") {
      a.json = value();
    } else if (name == "--no-real") {
      a.real = false;
    } else if (name == "--no-baselines") {
      a.run.baselines = false;
    } else if (name == "--quick") {
      a.run.quick = true;
    } else {
      refuse("unknown argument " + name);
    }
  }
  if (a.sizes.empty())
    a.sizes = a.run.quick ? std::vector<unsigned>{20000, 100000}
                          : std::vector<unsigned>{20000, 100000, 300000, 1000000, 2000000};
  if (a.real && a.scans.empty() && !a.run.quick && std::filesystem::is_directory("../shared/data/scans"))
    a.scans = "../shared/data/scans";
  if (!a.real) a.scans.clear();
  return a;
}

// A folder for the meshes, gone at the end.
class Folder {
 public:
  Folder() {
    std::string name = (std::filesystem::temp_directory_path() / "ts-bench-XXXXXX").string();
    if (!mkdtemp(name.data())) throw std::runtime_error("no temporary folder");
    path_ = name;
  }
  ~Folder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  Folder(const Folder &) = delete;
  Folder &operator=(const Folder &) = delete;
  std::string file(const std::string &name) const { return path_ + "/" + name; }

 private:
  std::string path_;
};

// Seconds that all cores have been busy, this process' finished children left out; not_measured if nobody tells.
double busy_elsewhere_s() {
  std::ifstream stat("/proc/stat");
  std::string cpu;
  double user = 0, nice = 0, system = 0, idle = 0, wait = 0, irq = 0, soft = 0;
  if (!(stat >> cpu >> user >> nice >> system >> idle >> wait >> irq >> soft)) return not_measured;
  rusage own{};
  getrusage(RUSAGE_CHILDREN, &own);
  const auto seconds = [](const timeval &t) {
    return static_cast<double>(t.tv_sec) + static_cast<double>(t.tv_usec) / 1e6;
  };
  return (user + nice + system + irq + soft) / static_cast<double>(sysconf(_SC_CLK_TCK)) - seconds(own.ru_utime) -
         seconds(own.ru_stime);
}

Result measure(const std::string &name, unsigned size, const std::string &file, const RunOptions &run) {
  Result result;
  result.name = name;
  result.size = size;
  const Timer timer;
  const double busy = busy_elsewhere_s();
  try {
    if (size > 0)
      result.figures.add(
          in_child([&](Figures &f) { f.set("made_ms", ms_of([&] { write_mesh(make_arch(size), file); })); }));
    result.figures.add(in_child([&](Figures &f) { measure_memory(file, f); }));
    result.figures.add(in_child([&](Figures &f) { measure_times(file, run, f); }));
    result.figures.set("took_s", timer.ms() / 1e3);
    result.figures.set("others_cores", (busy_elsewhere_s() - busy) / (timer.ms() / 1e3));
  } catch (const std::exception &e) {
    result.failure = e.what();
  }
  print_result(result);
  std::fflush(stdout);
  return result;
}

}  // namespace

int main(int argc, char **argv) {
  const Arguments arguments = arguments_of(argc, argv);
  try {
    const Machine machine = this_machine();
    std::printf("%s, %u cores; BLAS: %s", machine.cpu.c_str(), machine.cores, machine.blas.c_str());
    if (!machine.openblas_coretype.empty()) std::printf(", OPENBLAS_CORETYPE=%s", machine.openblas_coretype.c_str());
    if (!machine.openblas_l2.empty()) std::printf(", OPENBLAS_L2_SIZE=%s", machine.openblas_l2.c_str());
    std::printf("\n");
    const Folder folder;
    std::vector<Result> results;
    for (const unsigned size : arguments.sizes) {
      const std::string file = folder.file("arch.ply");
      results.push_back(measure("arch-" + std::to_string(size), size, file, arguments.run));
    }
    if (!arguments.scans.empty()) {
      std::vector<std::filesystem::path> scans;
      for (const auto &entry : std::filesystem::directory_iterator(arguments.scans))
        if (std::filesystem::exists(entry.path() / "mesh.ply")) scans.push_back(entry.path());
      std::sort(scans.begin(), scans.end());
      RunOptions run = arguments.run;
      run.quick = true;
      std::printf("\nreal scans\n");
      for (const auto &scan : scans)
        results.push_back(measure(scan.filename().string(), 0, (scan / "mesh.ply").string(), run));
    }
    print_growth(results);
    const std::vector<Target> targets = targets_of(results);
    print_targets(targets);
    if (!arguments.json.empty()) write_json(arguments.json, machine, results, targets);
    const bool failed = std::any_of(results.begin(), results.end(), [](const Result &r) { return !r.failure.empty(); });
    return failed ? 1 : 0;
  } catch (const std::exception &e) {
    std::fprintf(stderr, "ts-bench: %s\n", e.what());
    return 1;
  }
}
