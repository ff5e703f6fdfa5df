// How many teeth of labelled scans own exactly one feature group of theirs alone.
//   bench_features [--image DIR] [--stress] [--synthetic] FOLDER...
// One line a scan and the total. --image writes DIR/<name>.ppm: the strip with cuts, points and labels (keep it
// private).
#include <chrono>
#include <cstdio>
#include <cstring>

#include "bench/features_image.h"
#include "bench/features_score.h"
#include "bench/scan_variants.h"
#include "bench/synthetic_scan.h"
#include "features/detect.h"

namespace {

using namespace ts;

void stress(const Vec<bench::ScanFolder> &scans, const std::string &image) {
  for (int v = 0; v < static_cast<int>(bench::Variant::count); ++v) {
    const auto variant = static_cast<bench::Variant>(v);
    bench::FeatureScore total;
    for (const bench::ScanFolder &scan : scans) {
      if (scan.label.empty()) continue;
      const bench::ScanFolder changed = bench::make_variant(scan, variant, 7);
      try {
        const Executor executor(1);
        const features::Features found = features::detect(changed.surface, {}, executor, {});
        bench::FeatureScore s = bench::score_features(changed, found, false);
        if (variant == bench::Variant::inside_out) s.sign = !s.sign && found.inside_out;
        if (!image.empty())
          bench::draw_strip(image + "/" + scan.name + "-" + std::to_string(v) + ".ppm", changed, found);
        if (s.right < s.teeth || s.spurious || !s.sign) s.print(("  " + scan.name).c_str());
        total.add(s);
      } catch (const Error &e) {
        std::printf("  %s, %s: %s\n", scan.name.c_str(), bench::name_of(variant), e.what());
        total.add(bench::score_features(changed, {}, false));
      }
    }
    total.print(bench::name_of(variant));
  }
}

}  // namespace

int main(int argc, char **argv) {
  std::string image;
  bool stressed = false;
  Vec<bench::ScanFolder> scans;
  bench::FeatureScore total;
  for (int a = 1; a < argc; ++a) {
    if (!std::strcmp(argv[a], "--image") && a + 1 < argc) {
      image = argv[++a];
    } else if (!std::strcmp(argv[a], "--stress")) {
      stressed = true;
    } else if (!std::strcmp(argv[a], "--synthetic")) {
      for (const bool upper : {true, false})
        for (const double crowding : {0.0, 0.35, 0.65, 1.0})
          for (unsigned seed = 1; seed < 4; ++seed)
            scans.push_back(bench::synthetic_scan(upper, crowding, seed, {}, 30000));
      scans.push_back(bench::synthetic_scan(true, 0.35, 4, {12, 16, 25}, 30000));
      scans.push_back(bench::synthetic_scan(false, 0.35, 5, {31, 46}, 30000));
    } else {
      scans.push_back(bench::read_scan_folder(argv[a]));
    }
  }
  if (stressed) {
    stress(scans, image);
    return 0;
  }
  for (const bench::ScanFolder &scan : scans) {
    try {
      const auto begin = std::chrono::steady_clock::now();
      const Executor executor(1);
      const features::Features found = features::detect(scan.surface, {}, executor, {});
      const double ms = std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin).count();
      if (!image.empty()) bench::draw_strip(image + "/" + scan.name + ".ppm", scan, found);
      if (scan.label.empty()) {
        std::printf("%-22s no labels; groups %zu  %.1f ms\n", scan.name.c_str(), found.groups.size(), ms);
        continue;
      }
      bench::FeatureScore s = bench::score_features(scan, found, true);
      s.ms = ms;
      s.print(scan.name.c_str());
      total.add(s);
    } catch (const Error &e) {
      std::printf("%s: %s\n", scan.name.c_str(), e.what());
    }
  }
  total.print("total");
}
