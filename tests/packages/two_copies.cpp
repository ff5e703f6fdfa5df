// Two copies of the library in one process, as where two plug-ins bring one each.
//   two_copies A.so B.so
// Clicks in both, in turns and in two threads; the labels are those of one copy alone. SPDX-License-Identifier:
// Apache-2.0
#include <dlfcn.h>
#include <toothseg.h>

#include <cstdio>
#include <exception>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include "consumer/made_arch.hpp"
#include "consumer/summary.h"

// The functions that are used, of one copy.
// clang-format off
#define FUNCTIONS(DO) \
  DO(ts_context_create) DO(ts_mesh_input_init) DO(ts_model_create) DO(ts_detect_features) DO(ts_segmentation_create) \
  DO(ts_propose_clicks) DO(ts_segment_click) DO(ts_get_labels) DO(ts_last_error_message) DO(ts_segmentation_destroy) \
  DO(ts_features_destroy) DO(ts_model_destroy) DO(ts_context_destroy)
// clang-format on

struct Copy {
#define MEMBER(name) decltype(&::name) name = nullptr;
  FUNCTIONS(MEMBER)

  explicit Copy(const char *path) {
    void *library = dlopen(path, RTLD_NOW | RTLD_LOCAL);
    if (library == nullptr) throw std::runtime_error(dlerror());
#define FIND(name)                                                   \
  name = reinterpret_cast<decltype(&::name)>(dlsym(library, #name)); \
  if (name == nullptr) throw std::runtime_error(#name " is not there");
    FUNCTIONS(FIND)
  }
};

// One scan in one copy.
class Scan {
 public:
  Scan(const Copy &copy, const MadeArch &arch)
      : ts(copy), faces(static_cast<std::uint32_t>(arch.triangles.size() / 3)) {
    need(ts.ts_context_create(nullptr, &context));
    ts_mesh_input mesh;
    need(ts.ts_mesh_input_init(&mesh, sizeof mesh));
    mesh.scalar = TS_FLOAT64;
    mesh.positions = arch.positions.data();
    mesh.vertex_count = static_cast<std::uint32_t>(arch.positions.size() / 3);
    mesh.triangles = arch.triangles.data();
    mesh.triangle_count = faces;
    need(ts.ts_model_create(context, &mesh, nullptr, nullptr, &model));
    need(ts.ts_detect_features(model, nullptr, nullptr, &features));
    need(ts.ts_segmentation_create(features, nullptr, nullptr, &segmentation));
    std::uint32_t count = 0;
    need(ts.ts_propose_clicks(segmentation, nullptr, 0, &count));
    clicks.resize(3 * std::size_t{count});
    need(ts.ts_propose_clicks(segmentation, clicks.data(), count, nullptr));
  }
  Scan(const Scan &) = delete;
  Scan &operator=(const Scan &) = delete;
  ~Scan() {
    ts.ts_segmentation_destroy(segmentation);
    ts.ts_features_destroy(features);
    ts.ts_model_destroy(model);
    ts.ts_context_destroy(context);
  }

  std::vector<std::uint32_t> click(std::size_t which) {
    std::uint32_t number = 0;
    need(ts.ts_segment_click(segmentation, &clicks.at(3 * which), nullptr, &number));
    std::vector<std::uint32_t> labels(faces);
    need(ts.ts_get_labels(segmentation, labels.data(), faces, nullptr));
    return labels;
  }

  // A fault in one copy is not seen in the other.
  std::string fault() {
    const double nowhere[3] = {1000, 0, 0};
    std::uint32_t number = 0;
    if (ts.ts_segment_click(segmentation, nowhere, nullptr, &number) != TS_E_CLICK_OFF_SURFACE)
      throw std::runtime_error("a click beside the scan is taken");
    return last_error();
  }
  std::string last_error() const { return ts.ts_last_error_message(); }

 private:
  const Copy &ts;
  std::uint32_t faces;
  ts_context *context = nullptr;
  ts_model *model = nullptr;
  ts_features *features = nullptr;
  ts_segmentation *segmentation = nullptr;
  std::vector<double> clicks;

  void need(ts_status status) {
    if (status != TS_OK) throw std::runtime_error(ts.ts_last_error_message());
  }
};

static void same(bool equal, const char *what) {
  if (!equal) throw std::runtime_error(what);
}

static void run(const Copy &a, const Copy &b) {
  same(a.ts_segment_click != b.ts_segment_click, "both copies are one");
  const MadeArch arch;
  std::vector<std::uint32_t> first, second;
  {
    Scan in_a(a, arch), in_b(b, arch);
    first = in_a.click(0);
    same(in_b.click(0) == first, "in turns, first click: other labels");
    same(!in_a.fault().empty() && in_b.last_error().empty(), "a fault of one copy shows in the other");
    second = in_b.click(4);
    same(second != first, "the second click did nothing");
    same(in_a.click(4) == second, "in turns, second click: other labels");
  }
  std::vector<std::uint32_t> ends[2];
  std::string faults[2];
  const auto work = [&](std::size_t i) {
    try {
      Scan scan(i == 0 ? a : b, arch);
      scan.click(0);
      ends[i] = scan.click(4);
    } catch (const std::exception &e) {
      faults[i] = e.what();
    }
  };
  std::thread other(work, 1);
  work(0);
  other.join();
  for (std::size_t i = 0; i < 2; ++i) same(faults[i].empty(), faults[i].c_str());
  same(ends[0] == second && ends[1] == second, "in two threads: other labels");
  print_summary(first.data(), static_cast<std::uint32_t>(first.size()));
}

int main(int argc, char **argv) {
  try {
    if (argc != 3) throw std::runtime_error("two_copies A.so B.so");
    run(Copy(argv[1]), Copy(argv[2]));
    return 0;
  } catch (const std::exception &e) {
    return std::fprintf(stderr, "two_copies: %s\n", e.what()), 1;
  }
}
