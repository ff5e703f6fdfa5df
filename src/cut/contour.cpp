#include "cut/contour.h"

#include <algorithm>
#include <cmath>

#include "base/stop.h"
#include "geometry/gradient.h"

namespace ts::cut {
namespace {

// Keeps the points of different edges apart where the line passes a vertex.
constexpr double kLeastT = 1e-6;

double seam(double c) {
  return c * c / (c * c + 0.25);
}

EdgePoint point_on(const Surface &s, Values u, double iso, Index halfedge) {
  EdgePoint p;
  p.a = s.from(halfedge), p.b = s.to(halfedge);
  if (p.a > p.b) std::swap(p.a, p.b);  // the same bytes from both faces
  const double a = u(p.a), b = u(p.b);
  p.t = std::clamp((iso - a) / (b - a), kLeastT, 1 - kLeastT);
  p.position = (1 - p.t) * s.position[p.a] + p.t * s.position[p.b];
  return p;
}

// A crossed face has one half-edge that leaves u < iso and one that comes back; the line runs from the first to the
// second, which the next face sees as its first.
struct Crossing {
  Index leaves = mesh::none, returns = mesh::none;
};

Crossing crossing(const Surface &s, Values u, double iso, Index f) {
  Crossing c;
  const auto &t = s.triangle[f];
  const double at[3] = {u(t[0]), u(t[1]), u(t[2])};
  if (std::isnan(at[0] + at[1] + at[2])) return c;
  const bool below[3] = {at[0] < iso, at[1] < iso, at[2] < iso};
  for (Index k = 0; k < 3; ++k) {
    const bool from = below[k], to = below[(k + 1) % 3];
    if (from && !to) c.leaves = 3 * f + k;
    if (!from && to) c.returns = 3 * f + k;
  }
  return c;
}

double face_gradient_norm(const Surface &s, Values u, Index f) {
  const auto &t = s.triangle[f];
  return geometry::face_gradient(s, f, u(t[0]), u(t[1]), u(t[2])).norm();
}

struct Sums {
  double length = 0, gradient = 0, concavity = 0, inverse = 0;

  void add(double l, double g, double c) {
    length += l;
    gradient += l * g;
    concavity += l * seam(c);
    inverse += l / std::max(g, 1e-12);
  }
  Score score() const {
    if (!(length > 0)) return {};
    return {length, gradient / length, concavity / length, length / inverse};
  }
};

// Calls visit(i, length, concavity) for the segments of a line.
void each_segment(std::span<const double> concavity, const Polyline &line, const auto &visit) {
  const auto at = [&](const EdgePoint &p) { return (1 - p.t) * concavity[p.a] + p.t * concavity[p.b]; };
  for (std::size_t i = 0; i < line.faces.size(); ++i) {
    const EdgePoint &p = line.points[i], &q = line.points[(i + 1) % line.points.size()];
    visit(i, (q.position - p.position).norm(), (at(p) + at(q)) / 2);
  }
}

// Calls visit(k, iso) for those of n iso-values whose contour crosses a face with these values: low < iso <= high.
void each_iso(double low, double high, std::size_t n, const auto &visit) {
  const double first = std::max(0.0, std::floor(low * static_cast<double>(n + 1)) - 1);
  if (!(high > low) || first >= static_cast<double>(n)) return;
  for (auto k = static_cast<std::size_t>(first); k < n; ++k) {
    const double iso = iso_value(k, n);
    if (iso > high) break;
    if (iso > low) visit(k, iso);
  }
}

}  // namespace

Vec<Polyline> contour(const Surface &surface, Values u, double iso, std::span<const Index> among) {
  constexpr std::size_t kNowhere = SIZE_MAX;
  Vec<Index> crossed;
  Vec<Crossing> way;
  for (const Index f : among) {
    const Crossing c = crossing(surface, u, iso, f);
    if (c.leaves == mesh::none) continue;
    crossed.push_back(f);
    way.push_back(c);
  }
  // The place in `crossed` of the face across a half-edge.
  const auto across = [&](Index halfedge) {
    const Index t = surface.twin[halfedge];
    if (t == mesh::none) return kNowhere;
    const auto at = std::lower_bound(crossed.begin(), crossed.end(), mesh::face_of(t));
    return at != crossed.end() && *at == mesh::face_of(t) ? static_cast<std::size_t>(at - crossed.begin()) : kNowhere;
  };
  Vec<std::uint8_t> done(crossed.size(), 0);
  Vec<Polyline> lines;
  const auto trace = [&](std::size_t i) {
    Polyline line;
    for (;; i = across(way[i].returns)) {
      done[i] = 1;
      line.points.push_back(point_on(surface, u, iso, way[i].leaves));
      line.faces.push_back(crossed[i]);
      const std::size_t next = across(way[i].returns);
      if (next == kNowhere) line.points.push_back(point_on(surface, u, iso, way[i].returns));
      if (next != kNowhere && !done[next]) continue;
      line.closed = next != kNowhere;
      break;
    }
    for (std::size_t k = 0; k < line.faces.size(); ++k)
      line.length += (line.points[(k + 1) % line.points.size()].position - line.points[k].position).norm();
    lines.push_back(std::move(line));
  };
  for (std::size_t i = 0; i < crossed.size(); ++i)  // open lines, from their beginnings
    if (across(way[i].leaves) == kNowhere) trace(i);
  for (std::size_t i = 0; i < crossed.size(); ++i)
    if (!done[i]) trace(i);
  return lines;
}

Vec<Vec<Index>> crossed_faces(const Surface &surface, std::span<const double> u, std::size_t n) {
  Vec<Vec<Index>> crossed(n);
  StopNowAndThen stop(1 << 13);
  for (Index f = 0; f < surface.faces(); ++f) {
    stop();
    const auto &[a, b, c] = surface.triangle[f];
    if (std::isnan(u[a] + u[b] + u[c])) continue;
    each_iso(std::min({u[a], u[b], u[c]}), std::max({u[a], u[b], u[c]}), n, [&](std::size_t k, double) {
      stop();
      crossed[k].push_back(f);
    });
  }
  return crossed;
}

Score score(const Surface &surface, Values u, std::span<const double> concavity, std::span<const Polyline> lines) {
  Sums sums;
  for (const Polyline &line : lines)
    each_segment(concavity, line, [&](std::size_t i, double length, double c) {
      sums.add(length, face_gradient_norm(surface, u, line.faces[i]), c);
    });
  return sums.score();
}

double mean_concavity(std::span<const double> concavity, const Polyline &line) {
  Sums sums;
  each_segment(concavity, line, [&](std::size_t, double length, double c) { sums.add(length, 1, c); });
  return sums.score().concavity;
}

Vec<Score> score_all(const Surface &surface, std::span<const double> u, std::span<const double> concavity,
                     std::size_t n) {
  Vec<Sums> sums(n);
  for (Index f = 0; f < surface.faces(); ++f) {
    auto t = surface.triangle[f];
    if (std::isnan(u[t[0]] + u[t[1]] + u[t[2]])) continue;
    std::sort(t.begin(), t.end(), [&](Index a, Index b) { return u[a] < u[b]; });
    const double low = u[t[0]], middle = u[t[1]], high = u[t[2]];
    double gradient = -1;
    each_iso(low, high, n, [&](std::size_t k, double iso) {
      if (gradient < 0)
        gradient = face_gradient_norm(
            surface, [&](Index v) { return u[v]; }, f);
      const double s = (iso - low) / (high - low);
      const bool early = iso <= middle;
      const Index a = early ? t[0] : t[1], b = early ? t[1] : t[2];
      const double r = u[b] > u[a] ? (iso - u[a]) / (u[b] - u[a]) : 0;
      const Vec3 p = (1 - s) * surface.position[t[0]] + s * surface.position[t[2]];
      const Vec3 q = (1 - r) * surface.position[a] + r * surface.position[b];
      const double cp = (1 - s) * concavity[t[0]] + s * concavity[t[2]];
      const double cq = (1 - r) * concavity[a] + r * concavity[b];
      sums[k].add((q - p).norm(), gradient, (cp + cq) / 2);
    });
  }
  Vec<Score> scores(n);
  for (std::size_t k = 0; k < n; ++k) scores[k] = sums[k].score();
  return scores;
}

}  // namespace ts::cut
