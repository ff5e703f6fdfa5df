// How many teeth of labelled scans own exactly one feature group of theirs alone.
//   bench_features FOLDER...     prints one line a scan and totals
//   bench_features --image DIR FOLDER...   also writes DIR/<name>.ppm: the strip with cuts, points and labels (keep it
//   private)
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <map>
#include <set>

#include "bench/features_image.h"
#include "bench/scan_folder.h"
#include "features/detect.h"

namespace {

using namespace ts;

struct Score {
  int teeth = 0, groups = 0, right = 0, loose = 0, split = 0, merged = 0, missed = 0, spurious = 0, points = 0,
      on_crown = 0;
  bool sign = false;
  double ms = 0;
};

// The label most of the faces around a vertex have.
int label_of(const bench::ScanFolder &scan, mesh::Index v) {
  std::map<int, int> votes;
  for (const mesh::Index f : scan.surface.vertex_faces[v]) ++votes[scan.label[f]];
  int best = 0, most = 0;
  for (const auto &[label, count] : votes)
    if (count > most) most = count, best = label;
  return best;
}

// From the labels: the crowns' mean normal looks to the biting side.
mesh::Vec3 labelled_up(const bench::ScanFolder &scan) {
  mesh::Vec3 sum = mesh::Vec3::Zero();
  for (std::size_t f = 0; f < scan.surface.faces(); ++f)
    if (scan.label[f]) sum += scan.surface.face_area[f] * scan.surface.face_normal[f];
  return sum.normalized();
}

void judge(const bench::ScanFolder &scan, const features::Features &found, Score &s) {
  std::map<int, double> area;
  for (std::size_t f = 0; f < scan.surface.faces(); ++f)
    if (scan.label[f]) area[scan.label[f]] += scan.surface.face_area[f];
  std::erase_if(area, [](const auto &a) { return a.second < 5; });  // a few stray faces are no tooth
  s.teeth = static_cast<int>(area.size());
  s.groups = static_cast<int>(found.groups.size());
  s.sign = found.occlusal.dot(labelled_up(scan)) > 0.5;
  std::map<int, int> owned, touched;
  std::set<int> impure;
  for (const features::Group &g : found.groups) {
    std::map<int, int> votes;
    for (const features::Point &p : g.points) {
      const int label = label_of(scan, p.vertex);
      ++votes[label];
      ++s.points;
      s.on_crown += label != 0;
    }
    int best = 0, most = 0, kinds = 0;
    for (const auto &[label, count] : votes) {
      if (count > most || (count == most && best == 0)) most = count, best = label;
      kinds += label != 0;
      if (label) ++touched[label];
    }
    if (best == 0) {
      ++s.spurious;
      continue;
    }
    ++owned[best];
    if (kinds > 1) {
      ++s.merged;
      for (const auto &[label, count] : votes) impure.insert(label);
    }
  }
  for (const auto &[tooth, mm2] : area) {
    s.loose += owned[tooth] == 1;
    s.right += owned[tooth] == 1 && !impure.contains(tooth);
    s.split += owned[tooth] > 1;
    s.missed += touched[tooth] == 0;
    if (owned[tooth] != 1 || impure.contains(tooth))
      std::printf("    tooth %d: %d groups%s\n", tooth, owned[tooth], impure.contains(tooth) ? ", shared" : "");
  }
}

void print(const char *name, const Score &s) {
  std::printf(
      "%-22s teeth %3d groups %3d right %3d loose %3d split %2d merged %2d missed %2d false %2d  on crown %5.1f %% of "
      "%3d  %s  %6.1f ms\n",
      name, s.teeth, s.groups, s.right, s.loose, s.split, s.merged, s.missed, s.spurious,
      100.0 * s.on_crown / std::max(1, s.points), s.points, s.sign ? "up" : "UPSIDE DOWN", s.ms);
}

}  // namespace

int main(int argc, char **argv) {
  std::string image;
  Score total;
  int scans = 0, counts = 0;
  total.sign = true;
  for (int a = 1; a < argc; ++a) {
    if (!std::strcmp(argv[a], "--image") && a + 1 < argc) {
      image = argv[++a];
      continue;
    }
    const bench::ScanFolder scan = bench::read_scan_folder(argv[a]);
    Score s;
    try {
      const auto begin = std::chrono::steady_clock::now();
      const Executor executor(1);
      const features::Features found = features::detect(scan.surface, {}, executor, {});
      s.ms = std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin).count();
      if (!image.empty()) bench::draw_strip(image + "/" + scan.name + ".ppm", scan, found);
      s.groups = static_cast<int>(found.groups.size());
      if (!scan.label.empty()) judge(scan, found, s);
      for (const auto &g : found.groups)
        if (g.confidence < 0.6) std::printf("    unsure: %.1f to %.1f, %.2f\n", g.from, g.to, g.confidence);
    } catch (const Error &e) {
      std::printf("%s: %s\n", scan.name.c_str(), e.what());
    }
    print(scan.name.c_str(), s);
    if (scan.label.empty()) continue;
    ++scans;
    counts += s.teeth == s.groups;
    total.teeth += s.teeth, total.groups += s.groups, total.right += s.right, total.loose += s.loose,
        total.split += s.split;
    total.merged += s.merged, total.missed += s.missed, total.spurious += s.spurious, total.points += s.points,
        total.on_crown += s.on_crown;
    total.sign &= s.sign;
    total.ms += s.ms;
  }
  print("total", total);
  std::printf("right %.1f %%, loose %.1f %%, count right on %d of %d\n", 100.0 * total.right / std::max(1, total.teeth),
              100.0 * total.loose / std::max(1, total.teeth), counts, scans);
}
