// How many teeth of labelled scans own exactly one feature group of theirs alone.
//   bench_features [--image DIR] FOLDER...
// One line a scan and the total. --image writes DIR/<name>.ppm: the strip with cuts, points and labels (keep it
// private).
#include <chrono>
#include <cstdio>
#include <cstring>

#include "bench/features_image.h"
#include "bench/features_score.h"
#include "features/detect.h"

int main(int argc, char **argv) {
  using namespace ts;
  std::string image;
  bench::FeatureScore total;
  for (int a = 1; a < argc; ++a) {
    if (!std::strcmp(argv[a], "--image") && a + 1 < argc) {
      image = argv[++a];
      continue;
    }
    const bench::ScanFolder scan = bench::read_scan_folder(argv[a]);
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
