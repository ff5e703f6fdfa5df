#include "bench/field_labels.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <set>

#include "geometry/paths.h"

namespace ts::bench {
namespace {

using mesh::Vec3;

// As in the scorer: by angle round a hub on the open side of the arch.
Vec<Index> arch_order(const Vec<Vec3> &centre, const Vec3 &up) {
  const Vec3 x = up.unitOrthogonal(), y = up.cross(x);
  const std::size_t n = centre.size();
  Vec<Eigen::Vector2d> p;
  for (const Vec3 &c : centre) p.push_back({c.dot(x), c.dot(y)});
  std::size_t a = 0, b = 0, far = 0;
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j < n; ++j)
      if ((p[i] - p[j]).norm() > (p[a] - p[b]).norm()) a = i, b = j;
  const Eigen::Vector2d middle = (p[a] + p[b]) / 2;
  for (std::size_t i = 0; i < n; ++i)
    if ((p[i] - middle).norm() > (p[far] - middle).norm()) far = i;
  const Eigen::Vector2d hub = middle + 0.35 * (p[far] - middle);
  Vec<std::pair<double, Index>> angle;
  for (std::size_t i = 0; i < n; ++i)
    angle.push_back({std::atan2(p[i].y() - hub.y(), p[i].x() - hub.x()), static_cast<Index>(i)});
  std::sort(angle.begin(), angle.end());
  std::size_t first = 0;
  double widest = -1;
  for (std::size_t i = 0; i < n; ++i) {
    const double next = i + 1 < n ? angle[i + 1].first : angle[0].first + 2 * std::numbers::pi;
    if (next - angle[i].first > widest) widest = next - angle[i].first, first = (i + 1) % n;
  }
  Vec<Index> order;
  for (std::size_t i = 0; i < n; ++i) order.push_back(angle[(first + i) % n].second);
  return order;
}

double next_random(std::uint64_t &state) {
  state = state * 6364136223846793005u + 1442695040888963407u;
  return static_cast<double>(state >> 11) / 9007199254740992.0;
}

}  // namespace

LabelledTeeth labelled_teeth(const ScanFolder &scan) {
  const mesh::Surface &s = scan.surface;
  LabelledTeeth t;
  std::set<int> labels(scan.label.begin(), scan.label.end());
  labels.erase(0);
  Vec<int> unsorted(labels.begin(), labels.end());
  std::map<int, Index> place;
  for (Index i = 0; i < unsorted.size(); ++i) place[unsorted[i]] = i;
  Vec<Vec3> centre(unsorted.size(), Vec3::Zero());
  Vec<double> area(unsorted.size(), 0);
  for (Index f = 0; f < s.faces(); ++f) {
    if (!scan.label[f]) continue;
    const auto &c = s.triangle[f];
    const Index i = place[scan.label[f]];
    centre[i] += s.face_area[f] / 3 * (s.position[c[0]] + s.position[c[1]] + s.position[c[2]]);
    area[i] += s.face_area[f];
    t.occlusal += s.face_area[f] * s.face_normal[f];  // a crown is open at the gum: its area vector points away from it
  }
  t.occlusal.normalize();
  for (Index i = 0; i < centre.size(); ++i) centre[i] /= area[i];
  for (const Index i : arch_order(centre, t.occlusal)) {
    t.label.push_back(unsorted[i]);
    t.centre.push_back(centre[i]);
  }
  for (Index i = 0; i < t.label.size(); ++i) place[t.label[i]] = i;

  t.of_face.assign(s.faces(), mesh::none);
  for (Index f = 0; f < s.faces(); ++f)
    if (scan.label[f]) t.of_face[f] = place[scan.label[f]];
  Vec<geometry::PathStart> border;
  for (Index v = 0; v < s.vertices(); ++v)
    for (const Index f : s.vertex_faces[v])
      if (t.of_face[f] == mesh::none || t.of_face[f] != t.of_face[s.vertex_faces[v].front()]) {
        border.push_back({v});
        break;
      }
  t.depth = geometry::edge_distances(s, border);
  t.deepest.assign(t.label.size(), 0);
  for (Index f = 0; f < s.faces(); ++f)
    if (t.of_face[f] != mesh::none)
      for (const Index v : s.triangle[f]) {
        if (!std::isfinite(t.depth[v])) t.depth[v] = 0;
        t.deepest[t.of_face[f]] = std::max(t.deepest[t.of_face[f]], t.depth[v]);
      }
  return t;
}

features::Features features_from_labels(const ScanFolder &scan, const LabelledTeeth &teeth, PointsFrom from,
                                        std::size_t most) {
  const mesh::Surface &s = scan.surface;
  Vec<Vec<Index>> inside(teeth.label.size());  // vertices wholly in a tooth
  for (Index v = 0; v < s.vertices(); ++v) {
    if (s.vertex_faces[v].empty() || !(teeth.depth[v] > 0)) continue;
    const Index tooth = teeth.of_face[s.vertex_faces[v].front()];
    if (tooth != mesh::none) inside[tooth].push_back(v);
  }
  features::Features features;
  features.occlusal = teeth.occlusal;
  for (Index i = 0; i < inside.size(); ++i) {
    double low = 1e9, high = -1e9;
    for (const Index v : inside[i]) {
      low = std::min(low, s.position[v].dot(teeth.occlusal));
      high = std::max(high, s.position[v].dot(teeth.occlusal));
    }
    const auto height = [&](Index v) { return (s.position[v].dot(teeth.occlusal) - low) / std::max(1e-9, high - low); };
    Vec<Index> candidates, tops, taken;
    for (const Index v : inside[i])
      if (from == PointsFrom::cusp ? height(v) > 0.78 && teeth.depth[v] > 0.5 : teeth.depth[v] > 0.6 * teeth.deepest[i])
        candidates.push_back(v);
    if (candidates.empty()) candidates = inside[i];
    if (from == PointsFrom::cusp)
      for (const Index v : candidates) {
        const bool top = std::none_of(candidates.begin(), candidates.end(), [&](Index w) {
          return (s.position[v] - s.position[w]).norm() < 1.0 &&
                 (height(w) > height(v) || (height(w) == height(v) && w < v));
        });
        if (top) tops.push_back(v);
      }
    std::sort(tops.begin(), tops.end(), [&](Index a, Index b) { return height(a) > height(b); });
    for (const Index v : tops)
      if (taken.size() < most) taken.push_back(v);
    if (taken.empty() && !candidates.empty())
      taken.push_back(*std::max_element(candidates.begin(), candidates.end(),
                                        [&](Index a, Index b) { return teeth.depth[a] < teeth.depth[b]; }));
    while (taken.size() < most && taken.size() < candidates.size()) {  // fill up with the farthest
      Index best = mesh::none;
      double clearance = -1;
      for (const Index v : candidates) {
        double near = 1e9;
        for (const Index w : taken) near = std::min(near, (s.position[v] - s.position[w]).norm());
        if (near > clearance) clearance = near, best = v;
      }
      taken.push_back(best);
    }
    features::Group group;
    for (const Index v : taken) group.points.push_back({v, s.position[v], 0.3});
    features.groups.push_back(std::move(group));
  }
  return features;
}

Vec<Index> tooth_of_groups(const ScanFolder &scan, const LabelledTeeth &teeth, const features::Features &features) {
  Vec<Index> tooth;
  for (const features::Group &group : features.groups) {
    std::map<Index, int> votes;
    for (const features::Point &p : group.points) ++votes[teeth.of_face[scan.surface.vertex_faces[p.vertex].front()]];
    Index best = mesh::none;
    for (const auto &[t, n] : votes)
      if (best == mesh::none || n > votes[best]) best = t;
    tooth.push_back(best);
  }
  return tooth;
}

Index random_crown_face(const ScanFolder &scan, const LabelledTeeth &teeth, Index tooth, Index towards,
                        std::uint64_t &state) {
  const mesh::Surface &s = scan.surface;
  Vec<std::pair<double, Index>> faces;  // place towards the other tooth, face
  for (Index f = 0; f < s.faces(); ++f) {
    if (teeth.of_face[f] != tooth) continue;
    const auto &t = s.triangle[f];
    if ((teeth.depth[t[0]] + teeth.depth[t[1]] + teeth.depth[t[2]]) / 3 <= 0.35 * teeth.deepest[tooth]) continue;
    const Vec3 middle = (s.position[t[0]] + s.position[t[1]] + s.position[t[2]]) / 3;
    faces.push_back(
        {towards == mesh::none ? 0 : (middle - teeth.centre[tooth]).dot(teeth.centre[towards] - teeth.centre[tooth]),
         f});
  }
  if (faces.empty()) return mesh::none;
  if (towards != mesh::none) {
    std::sort(faces.begin(), faces.end());
    faces.erase(faces.begin(), faces.begin() + static_cast<std::ptrdiff_t>(faces.size() / 2));
  }
  double total = 0;
  for (const auto &[side, f] : faces) total += s.face_area[f];
  double left = next_random(state) * total;
  for (const auto &[side, f] : faces)
    if ((left -= s.face_area[f]) <= 0) return f;
  return faces.back().second;
}

Scores score_labels(const ScanFolder &scan, const LabelledTeeth &teeth, const Vec<std::uint32_t> &predicted) {
  const mesh::Surface &s = scan.surface;
  std::map<std::uint32_t, double> part_area;
  std::map<std::pair<Index, std::uint32_t>, double> common;
  Vec<double> tooth_area(teeth.label.size(), 0);
  for (Index f = 0; f < s.faces(); ++f) {
    const Index t = teeth.of_face[f];
    if (predicted[f]) part_area[predicted[f]] += s.face_area[f];
    if (t != mesh::none) tooth_area[t] += s.face_area[f];
    if (predicted[f] && t != mesh::none) common[{t, predicted[f]}] += s.face_area[f];
  }
  Vec<std::tuple<double, Index, std::uint32_t>> pairs;
  std::map<std::uint32_t, double> best;
  for (const auto &[key, area] : common) {
    const double iou = area / (tooth_area[key.first] + part_area[key.second] - area);
    pairs.push_back({iou, key.first, key.second});
    best[key.second] = std::max(best[key.second], iou);
  }
  std::sort(pairs.begin(), pairs.end(), std::greater<>());
  Scores scores;
  scores.iou.assign(teeth.label.size(), 0);
  std::set<Index> used_tooth;
  std::set<std::uint32_t> used_part;
  for (const auto &[iou, tooth, part] : pairs) {
    if (used_tooth.contains(tooth) || used_part.contains(part)) continue;
    used_tooth.insert(tooth);
    used_part.insert(part);
    scores.iou[tooth] = iou;
  }
  for (const auto &[part, area] : part_area) scores.false_parts += best[part] < 0.3;
  return scores;
}

}  // namespace ts::bench
