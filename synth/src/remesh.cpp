// SPDX-License-Identifier: Apache-2.0
#include "remesh.h"

#include <algorithm>
#include <utility>

namespace tsa {

Remesher::Remesher(TriMesh mesh) : mesh_(std::move(mesh)) {
  link();
}

void Remesher::link() {
  const size_t n = mesh_.points.size(), h = mesh_.faces.size() * 3;
  twin_.assign(h, kNone);
  border_.assign(n, 0);
  onLine_.assign(n, 0);
  std::vector<uint32_t> start(n + 1, 0), order(h);
  const auto low = [&](uint32_t e) { return std::min(from(e), to(e)); };
  for (uint32_t e = 0; e < h; ++e) ++start[low(e) + 1];
  for (size_t v = 0; v < n; ++v) start[v + 1] += start[v];
  std::vector<uint32_t> fill(start.begin(), start.end() - 1);
  for (uint32_t e = 0; e < h; ++e) order[fill[low(e)]++] = e;
  for (size_t v = 0; v < n; ++v)
    for (uint32_t i = start[v]; i < start[v + 1]; ++i)
      for (uint32_t j = i + 1; j < start[v + 1] && twin_[order[i]] == kNone; ++j)
        if (twin_[order[j]] == kNone && from(order[i]) == to(order[j]) && to(order[i]) == from(order[j])) {
          twin_[order[i]] = order[j];
          twin_[order[j]] = order[i];
        }
  for (uint32_t e = 0; e < h; ++e)
    if (twin_[e] == kNone) border_[from(e)] = border_[to(e)] = 1;
}

Vec3 Remesher::normal(uint32_t f) const {
  const auto &t = mesh_.faces[f];
  return cross(mesh_.points[t[1]] - mesh_.points[t[0]], mesh_.points[t[2]] - mesh_.points[t[0]]);
}

bool Remesher::ring(uint32_t h) {
  constexpr size_t kMost = 24;
  ring_.clear();
  uint32_t e = h;
  do {
    ring_.push_back(e);
    e = twin_[prev(e)];
  } while (e != h && ring_.size() <= kMost);
  return ring_.size() <= kMost;
}

bool Remesher::survives(const std::vector<uint32_t> &outgoing, uint32_t without, uint32_t vertex, Vec3 position,
                        double longest) const {
  for (const uint32_t e : outgoing) {
    const uint32_t b = to(e), c = from(prev(e));
    if (b == without || c == without) continue;
    const Vec3 &pb = mesh_.points[b], &pc = mesh_.points[c];
    const Vec3 before = cross(pb - mesh_.points[vertex], pc - mesh_.points[vertex]),
               after = cross(pb - position, pc - position);
    if (dot(before, after) < 0.4 * norm(before) * norm(after)) return false;
    const Vec3 d = pb - position;
    if (dot(d, d) > longest * longest) return false;
    // Twice the area against the longest edge: no needle may come of it.
    const double side = std::max({dot(pb - pc, pb - pc), dot(d, d), dot(pc - position, pc - position)});
    if (norm(after) < 0.12 * side) return false;
  }
  return true;
}

bool Remesher::mayCollapse(uint32_t h, Vec3 position, double longest) {
  const uint32_t t = twin_[h], a = from(h), b = to(h), c = from(prev(h)), d = from(prev(t));
  if (border_[a] || border_[b] || border_[c] || border_[d]) return false;
  if (valence_[c] <= 3 || valence_[d] <= 3 || valence_[a] + valence_[b] < 7 || valence_[a] + valence_[b] > 13)
    return false;
  if (!ring(h)) return false;
  ringA_ = ring_;
  if (!ring(t)) return false;
  int common = 0;
  for (const uint32_t e : ringA_)
    for (const uint32_t g : ring_) common += to(e) == to(g);
  if (common != 2) return false;
  return survives(ringA_, b, a, position, longest) && survives(ring_, a, b, position, longest);
}

void Remesher::collapse(uint32_t h, Vec3 position) {
  const uint32_t t = twin_[h], a = from(h), c = from(prev(h)), d = from(prev(t));
  ++clock_;
  for (const uint32_t e : ringA_) changed_[to(e)] = clock_;
  for (const uint32_t e : ring_) changed_[to(e)] = clock_;
  for (const uint32_t e : ring_) corner(e) = a;  // ring_ is that of the other end
  for (const uint32_t e : {h, t}) {
    const uint32_t p = twin_[next(e)], q = twin_[prev(e)];
    twin_[p] = q;
    twin_[q] = p;
    mesh_.faces[e / 3] = {kNone, kNone, kNone};
  }
  mesh_.points[a] = position;
  valence_[a] = static_cast<uint8_t>(ringA_.size() + ring_.size() - 4);
  --valence_[c];
  --valence_[d];
}

void Remesher::countValences() {
  std::vector<uint32_t> count(mesh_.points.size(), 0);
  for (uint32_t f = 0; f < mesh_.faces.size(); ++f)
    if (!dead(f))
      for (const uint32_t v : mesh_.faces[f]) ++count[v];
  valence_.resize(count.size());
  for (size_t v = 0; v < count.size(); ++v) valence_[v] = static_cast<uint8_t>(std::min(count[v], 255u));
  changed_.assign(count.size(), clock_);
  refused_.assign(twin_.size(), 0);
}

void Remesher::collapseTo(size_t target, const std::vector<uint8_t> &counted, double edge) {
  size_t left = 0;
  for (const uint8_t c : counted) left += c;
  // Where the grid's pattern blocks further collapses, flips and a little smoothing unlock it.
  for (int round = 0; round < 6 && left > target; ++round) {
    countValences();
    collapsePass(target, counted, edge, round == 0 ? 0.3 : 0.7, left);
    flip();
    if (left > target) relax(0.3);
  }
}

void Remesher::collapsePass(size_t target, const std::vector<uint8_t> &counted, double edge, double shortest,
                            size_t &left) {
  const uint32_t n = static_cast<uint32_t>(twin_.size());
  double limit = shortest;
  while (limit < 1.3 && left > target) {
    for (uint32_t h = 0; h < n && left > target; ++h) {
      if (dead(h / 3) || twin_[h] == kNone || twin_[h] < h) continue;
      const Vec3 a = mesh_.points[from(h)], b = mesh_.points[to(h)], d = b - a;
      if (dot(d, d) > limit * limit * edge * edge) continue;
      const Vec3 middle = 0.5 * (a + b);
      const uint32_t f = h / 3, g = twin_[h] / 3;
      if (refused_[h] >= std::max(changed_[from(h)], changed_[to(h)])) continue;
      if (!mayCollapse(h, middle, 1.7 * edge)) {
        refused_[h] = clock_;
        continue;
      }
      collapse(h, middle);
      left -= counted[f] + counted[g];
    }
    limit *= limit < 0.75 ? 1.2 : 1.05;
  }
}

bool Remesher::shouldFlip(uint32_t h) {
  const uint32_t t = twin_[h], a = from(h), b = to(h), c = from(prev(h)), d = from(prev(t));
  if (border_[a] || border_[b] || (onLine_[a] && onLine_[b])) return false;
  const Vec3 pa = mesh_.points[a], pb = mesh_.points[b], pc = mesh_.points[c], pd = mesh_.points[d];
  const auto cotangent = [](Vec3 u, Vec3 v) { return dot(u, v) / std::max(norm(cross(u, v)), 1e-12); };
  if (cotangent(pa - pc, pb - pc) + cotangent(pa - pd, pb - pd) > -1e-3) return false;
  const Vec3 nf = normal(h / 3), ng = normal(t / 3);
  if (dot(nf, ng) < 0.85 * norm(nf) * norm(ng)) return false;
  const Vec3 n1 = cross(pd - pa, pc - pa), n2 = cross(pc - pb, pd - pb), sum = nf + ng;
  if (dot(n1, sum) < 0.5 * norm(n1) * norm(sum) || dot(n2, sum) < 0.5 * norm(n2) * norm(sum)) return false;
  if (!ring(h) || ring_.size() <= 4) return false;
  if (!ring(t) || ring_.size() <= 4) return false;
  if (border_[c] || border_[d]) return false;
  if (!ring(prev(h))) return false;
  return std::none_of(ring_.begin(), ring_.end(), [&](uint32_t e) { return to(e) == d; });
}

void Remesher::flip() {
  for (int pass = 0; pass < 4; ++pass) {
    size_t flips = 0;
    for (uint32_t h = 0; h < twin_.size(); ++h) {
      if (dead(h / 3) || twin_[h] == kNone || twin_[h] < h || !shouldFlip(h)) continue;
      const uint32_t t = twin_[h], f = h / 3, g = t / 3;
      const uint32_t a = from(h), b = to(h), c = from(prev(h)), d = from(prev(t));
      const uint32_t bc = twin_[next(h)], ca = twin_[prev(h)], ad = twin_[next(t)], db = twin_[prev(t)];
      mesh_.faces[f] = {a, d, c};
      mesh_.faces[g] = {b, c, d};
      const auto join = [&](uint32_t e, uint32_t other) {
        twin_[e] = other;
        if (other != kNone) twin_[other] = e;
      };
      join(3 * f, ad), join(3 * f + 2, ca), join(3 * g, bc), join(3 * g + 2, db);
      join(3 * f + 1, 3 * g + 1);
      ++flips;
    }
    if (flips * 200 < mesh_.faces.size()) break;
  }
}

void Remesher::snap(const std::function<uint32_t(Vec3)> &label) {
  struct Crossing {
    double share;  // of the edge, from the end that h leaves
    uint32_t h;
  };
  std::vector<uint32_t> at(mesh_.points.size(), kNone);
  for (const auto &t : mesh_.faces)
    if (t[0] != kNone)
      for (const uint32_t v : t)
        if (at[v] == kNone) at[v] = label(mesh_.points[v]);
  std::vector<Crossing> crossings;
  for (uint32_t h = 0; h < twin_.size(); ++h) {
    if (dead(h / 3) || twin_[h] == kNone || at[from(h)] == at[to(h)]) continue;
    const Vec3 a = mesh_.points[from(h)], b = mesh_.points[to(h)];
    double low = 0, high = 1;
    for (int i = 0; i < 10; ++i) {
      const double middle = 0.5 * (low + high);
      (label(a + middle * (b - a)) == at[from(h)] ? low : high) = middle;
    }
    crossings.push_back({0.5 * (low + high), h});
  }
  std::sort(crossings.begin(), crossings.end(),
            [](const Crossing &a, const Crossing &b) { return a.share != b.share ? a.share < b.share : a.h < b.h; });
  for (const auto &[share, h] : crossings) {
    const uint32_t a = from(h), b = to(h);
    if (onLine_[a] || onLine_[b] || border_[a] || !ring(h)) continue;
    const Vec3 target = mesh_.points[a] + share * (mesh_.points[b] - mesh_.points[a]);
    if (!survives(ring_, kNone, a, target, 1e9)) continue;
    mesh_.points[a] = target;
    onLine_[a] = 1;
  }
}

void Remesher::relax(double amount) {
  const size_t n = mesh_.points.size();
  std::vector<Vec3> sum(n), normals(n);
  std::vector<uint32_t> count(n, 0);
  for (uint32_t f = 0; f < mesh_.faces.size(); ++f) {
    if (dead(f)) continue;
    const Vec3 nf = normal(f);
    for (int i = 0; i < 3; ++i) {
      const uint32_t a = mesh_.faces[f][i], b = mesh_.faces[f][(i + 1) % 3];
      sum[a] = sum[a] + mesh_.points[b];
      normals[a] = normals[a] + nf;
      ++count[a];
    }
  }
  for (size_t v = 0; v < n; ++v) {
    if (border_[v] || onLine_[v] || count[v] == 0) continue;
    const Vec3 d = (1.0 / count[v]) * sum[v] - mesh_.points[v], m = normalised(normals[v]);
    mesh_.points[v] = mesh_.points[v] + amount * (d - dot(d, m) * m);
  }
}

void Remesher::project(const std::function<double(Vec3)> &field, double longestStep) {
  std::vector<uint8_t> used(mesh_.points.size(), 0);
  for (uint32_t f = 0; f < mesh_.faces.size(); ++f)
    if (!dead(f))
      for (const uint32_t v : mesh_.faces[f]) used[v] = 1;
  for (size_t v = 0; v < mesh_.points.size(); ++v) {
    if (!used[v] || border_[v]) continue;
    Vec3 &p = mesh_.points[v];
    // At a crease the gradient over a wider span has the direction of the bisector, and leads to its bottom.
    const double e = onLine_[v] ? 0.12 : 0.01;
    // The four corners of a tetrahedron give value and gradient at once.
    const double a = field({p.x + e, p.y + e, p.z + e}), b = field({p.x + e, p.y - e, p.z - e}),
                 c = field({p.x - e, p.y + e, p.z - e}), d = field({p.x - e, p.y - e, p.z + e});
    const double f = onLine_[v] ? field(p) : 0.25 * (a + b + c + d), k = 1 / (4 * e);
    const Vec3 g = {k * (a + b - c - d), k * (a - b + c - d), k * (a - b - c + d)};
    const double gg = std::max(dot(g, g), 0.05);
    Vec3 step = (-f / gg) * g;
    const double length = norm(step);
    if (length > longestStep) step = (longestStep / length) * step;
    p = p + step;
  }
}

TriMesh Remesher::take() {
  TriMesh out;
  std::vector<uint32_t> id(mesh_.points.size(), kNone);
  for (uint32_t f = 0; f < mesh_.faces.size(); ++f) {
    if (dead(f)) continue;
    auto t = mesh_.faces[f];
    for (uint32_t &v : t) {
      if (id[v] == kNone) {
        id[v] = static_cast<uint32_t>(out.points.size());
        out.points.push_back(mesh_.points[v]);
      }
      v = id[v];
    }
    out.faces.push_back(t);
  }
  return out;
}

}  // namespace tsa
