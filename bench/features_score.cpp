#include "bench/features_score.h"

#include <algorithm>
#include <cstdio>
#include <map>
#include <set>

namespace ts::bench {
namespace {

// The label most of the faces around a vertex have.
int label_of(const ScanFolder &scan, mesh::Index v) {
  std::map<int, int> votes;
  for (const mesh::Index f : scan.surface.vertex_faces[v]) ++votes[scan.label[f]];
  int best = 0, most = 0;
  for (const auto &[label, count] : votes)
    if (count > most) most = count, best = label;
  return best;
}

// From the labels: the crowns' mean normal looks to the biting side.
mesh::Vec3 labelled_up(const ScanFolder &scan) {
  mesh::Vec3 sum = mesh::Vec3::Zero();
  for (std::size_t f = 0; f < scan.surface.faces(); ++f)
    if (scan.label[f]) sum += scan.surface.face_area[f] * scan.surface.face_normal[f];
  return sum.normalized();
}

}  // namespace

FeatureScore score_features(const ScanFolder &scan, const features::Features &found, bool verbose) {
  FeatureScore s;
  s.scans = 1;
  std::map<int, double> area;
  for (std::size_t f = 0; f < scan.surface.faces(); ++f)
    if (scan.label[f] > 0) area[scan.label[f]] += scan.surface.face_area[f];
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
    if (verbose && (owned[tooth] != 1 || impure.contains(tooth)))
      std::printf("    tooth %d: %d groups%s\n", tooth, owned[tooth], impure.contains(tooth) ? ", shared" : "");
  }
  s.counts = s.teeth == s.groups;
  return s;
}

void FeatureScore::add(const FeatureScore &s) {
  teeth += s.teeth, groups += s.groups, right += s.right, loose += s.loose, split += s.split, merged += s.merged;
  missed += s.missed, spurious += s.spurious, points += s.points, on_crown += s.on_crown, scans += s.scans;
  counts += s.counts, ms += s.ms;
  sign = sign && s.sign;
}

void FeatureScore::print(const char *name) const {
  std::printf(
      "%-22s teeth %3d groups %3d right %3d (%5.1f %%) loose %3d split %2d merged %2d missed %2d false %2d "
      "counts %2d/%d  points %3d, on crown %5.1f %%  %s  %6.1f ms\n",
      name, teeth, groups, right, 100.0 * right / std::max(1, teeth), loose, split, merged, missed, spurious, counts,
      scans, points, 100.0 * on_crown / std::max(1, points), sign ? "up" : "UPSIDE DOWN", ms);
}

}  // namespace ts::bench
