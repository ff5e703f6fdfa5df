#include "mesh/bvh.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace ts::mesh {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr std::size_t leaf_size = 4;
// divide() leaves at least an eighth on either side: log(2^30) / log(8/7) = 156 levels at most.
constexpr std::size_t deepest = 192;

float down(double x) {
  const float f = static_cast<float>(x);
  return f > x ? std::nextafter(f, -std::numeric_limits<float>::infinity()) : f;
}

float up(double x) {
  const float f = static_cast<float>(x);
  return f < x ? std::nextafter(f, std::numeric_limits<float>::infinity()) : f;
}

// Weights of the point of a triangle nearest to p, by the region of the plane that p falls into.
Vec3 nearest_weights(const Vec3 &p, const Vec3 &a, const Vec3 &b, const Vec3 &c) {
  const Vec3 ab = b - a, ac = c - a, ap = p - a;
  const double d1 = ab.dot(ap), d2 = ac.dot(ap);
  if (d1 <= 0 && d2 <= 0) return {1, 0, 0};
  const Vec3 bp = p - b;
  const double d3 = ab.dot(bp), d4 = ac.dot(bp);
  if (d3 >= 0 && d4 <= d3) return {0, 1, 0};
  const double vc = d1 * d4 - d3 * d2;
  if (vc <= 0 && d1 >= 0 && d3 <= 0) {
    const double t = d1 / (d1 - d3);
    return {1 - t, t, 0};
  }
  const Vec3 cp = p - c;
  const double d5 = ab.dot(cp), d6 = ac.dot(cp);
  if (d6 >= 0 && d5 <= d6) return {0, 0, 1};
  const double vb = d5 * d2 - d1 * d6;
  if (vb <= 0 && d2 >= 0 && d6 <= 0) {
    const double t = d2 / (d2 - d6);
    return {1 - t, 0, t};
  }
  const double va = d3 * d6 - d5 * d4;
  if (va <= 0 && d4 >= d3 && d5 >= d6) {
    const double t = (d4 - d3) / ((d4 - d3) + (d5 - d6));
    return {0, 1 - t, t};
  }
  const double sum = va + vb + vc;
  return {va / sum, vb / sum, vc / sum};
}

}  // namespace

// A branch of the upper tree, or one of the trees below it.
struct Bvh::Part {
  std::span<Item> items;
  std::size_t left = 0;  // items of the left child of a branch
  Box box;
  std::size_t child = 0;  // the left one's place among the parts, the right one follows; 0: a tree of its own
  Vec<Node> node;         // of a tree of its own
};

Bvh::Bvh(const Surface &surface, const Executor &executor) {
  if (surface.faces() == 0) return;
  Vec<Item> items(surface.faces());
  executor.ranges(items.size(), 1 << 13, [&](std::size_t begin, std::size_t end) {
    for (std::size_t f = begin; f < end; ++f) {
      const auto [a, b, c] = surface.triangle[f];
      const Vec3 low = surface.position[a].cwiseMin(surface.position[b]).cwiseMin(surface.position[c]);
      const Vec3 high = surface.position[a].cwiseMax(surface.position[b]).cwiseMax(surface.position[c]);
      items[f] = {{low.unaryExpr(&down), high.unaryExpr(&up)}, static_cast<Index>(f)};
    }
  });
  // Level by level until there are trees enough to share out, then each by itself.
  constexpr std::size_t tree_size = 1 << 12, most_levels = 8;
  Vec<Part> parts(1);
  parts[0].items = items;
  for (std::size_t level = 0, begin = 0; level < most_levels && begin < parts.size(); ++level) {
    const std::size_t end = parts.size();
    executor.each(end - begin, [&](std::size_t i) {
      Part &p = parts[begin + i];
      if (p.items.size() > tree_size) p.left = divide(p.items, p.box);
    });
    for (std::size_t i = begin; i < end; ++i) {
      if (parts[i].left == 0) continue;
      const std::span<Item> all = parts[i].items;
      const std::size_t left = parts[i].left;
      parts[i].child = parts.size();
      parts.emplace_back().items = all.first(left);
      parts.emplace_back().items = all.subspan(left);
    }
    begin = end;
  }
  executor.each(parts.size(), [&](std::size_t i) {
    if (parts[i].child == 0) build(parts[i].items, 0, parts[i].node);
  });
  std::size_t nodes = 0;
  for (const Part &p : parts) nodes += p.child ? 1 : p.node.size();
  node_.reserve(nodes);
  join(parts, 0, 0);
  face_.resize(items.size());
  for (std::size_t i = 0; i < items.size(); ++i) face_[i] = items[i].face;
}

// The box of the items, and the bounds of twice their centres.
void Bvh::enclose(std::span<const Item> items, Box &box, Vec3f &low, Vec3f &high) {
  box = items[0].box;
  low = high = box.low + box.high;
  for (const Item &i : items) {
    const Vec3f twice = i.box.low + i.box.high;
    box.low = box.low.cwiseMin(i.box.low), box.high = box.high.cwiseMax(i.box.high);
    low = low.cwiseMin(twice), high = high.cwiseMax(twice);
  }
}

// Puts the items left of the middle of their centres first, and returns how many; half of them if that is lopsided.
std::size_t Bvh::divide(std::span<Item> items, Box &box) {
  Vec3f low, high;
  enclose(items, box, low, high);
  Eigen::Index axis = 0;
  (high - low).maxCoeff(&axis);
  const float middle = (low[axis] + high[axis]) / 2;
  const auto centre = [axis](const Item &i) { return i.box.low[axis] + i.box.high[axis]; };
  const auto cut = std::partition(items.begin(), items.end(), [&](const Item &i) { return centre(i) < middle; });
  const std::size_t left = static_cast<std::size_t>(cut - items.begin());
  if (std::min(left, items.size() - left) >= items.size() / 8 && left > 0 && left < items.size()) return left;
  const std::size_t half = items.size() / 2;
  std::nth_element(
      items.begin(), items.begin() + static_cast<std::ptrdiff_t>(half), items.end(),
      [&](const Item &a, const Item &b) { return centre(a) != centre(b) ? centre(a) < centre(b) : a.face < b.face; });
  return half;
}

void Bvh::build(std::span<Item> items, std::size_t first, Vec<Node> &node) {
  const std::size_t here = node.size();
  Node &n = node.emplace_back();
  if (items.size() <= leaf_size) {
    Vec3f low, high;
    enclose(items, n.box, low, high);
    n.first = static_cast<Index>(first);
    n.count = static_cast<Index>(items.size());
    return;
  }
  n.count = 0;
  const std::size_t left = divide(items, n.box);
  build(items.first(left), first, node);
  node[here].first = static_cast<Index>(node.size());
  build(items.subspan(left), first + left, node);
}

// Appends a part and all below it; its items begin at `first`.
void Bvh::join(std::span<const Part> parts, std::size_t part, std::size_t first) {
  const Part &p = parts[part];
  const std::size_t here = node_.size();
  if (p.child == 0) {
    for (Node n : p.node) {
      n.first += static_cast<Index>(n.count ? first : here);
      node_.push_back(n);
    }
    return;
  }
  node_.push_back({p.box, 0, 0});
  join(parts, p.child, first);
  node_[here].first = static_cast<Index>(node_.size());
  join(parts, p.child + 1, first + p.left);
}

SurfacePoint Bvh::nearest(const Surface &surface, const Vec3 &p) const {
  SurfacePoint best;
  if (node_.empty() || !p.allFinite()) return best;
  double least = infinity;
  const auto box_distance = [&](Index n) {
    const Vec3 low = node_[n].box.low.cast<double>(), high = node_[n].box.high.cast<double>();
    return (low - p).cwiseMax(p - high).cwiseMax(0).squaredNorm();
  };
  struct Visit {
    Index node;
    double distance;
  };
  std::array<Visit, deepest> stack;
  std::size_t size = 0;
  stack[size++] = {0, box_distance(0)};
  while (size > 0) {
    const Visit v = stack[--size];
    if (v.distance > least) continue;
    const Node &node = node_[v.node];
    for (Index i = node.first; i < node.first + node.count; ++i) {
      const Index f = face_[i];
      const auto [a, b, c] = surface.triangle[f];
      const Vec3 &pa = surface.position[a], &pb = surface.position[b], &pc = surface.position[c];
      const Vec3 w = nearest_weights(p, pa, pb, pc);
      const Vec3 q = w[0] * pa + w[1] * pb + w[2] * pc;
      const double d = (q - p).squaredNorm();
      if (d < least || (d == least && f < best.face)) least = d, best = {f, w, q, 0};
    }
    if (node.count > 0) continue;
    Visit near{v.node + 1, box_distance(v.node + 1)}, far{node.first, box_distance(node.first)};
    if (far.distance < near.distance) std::swap(near, far);
    stack[size++] = far;
    stack[size++] = near;
  }
  best.distance = std::sqrt(least);
  return best;
}

// The ray in a frame in which it runs along the third axis from the origin.
struct Bvh::Ray {
  Vec3 origin, direction;
  std::array<Eigen::Index, 3> axis;
  Vec3 shear;

  Ray(const Vec3 &o, const Vec3 &d) : origin(o), direction(d) {
    Eigen::Index z = 0;
    d.cwiseAbs().maxCoeff(&z);
    axis = {(z + 1) % 3, (z + 2) % 3, z};
    shear = Vec3(d[axis[0]] / d[z], d[axis[1]] / d[z], 1 / d[z]);
  }

  Vec3 sheared(const Vec3 &p) const {
    const Vec3 q = p - origin;
    return {q[axis[0]] - shear[0] * q[axis[2]], q[axis[1]] - shear[1] * q[axis[2]], shear[2] * q[axis[2]]};
  }

  // Where the ray enters the box, infinity if it misses it. Generous by a few roundings.
  double enters(const Box &box) const {
    double from = 0, to = infinity;
    for (int k = 0; k < 3; ++k) {
      const double low = box.low[k] - origin[k], high = box.high[k] - origin[k];
      const double slack = 1e-14 * (std::abs(origin[k]) + std::max(std::abs(low), std::abs(high)));
      if (std::abs(direction[k]) < 1e-300) {
        if (low > slack || high < -slack) return infinity;
        continue;
      }
      const double a = (low - slack) / direction[k], b = (high + slack) / direction[k];
      from = std::max(from, std::min(a, b)), to = std::min(to, std::max(a, b));
    }
    return from <= to * (1 + 1e-14) ? from : infinity;
  }
};

std::optional<SurfacePoint> Bvh::raycast(const Surface &surface, const Vec3 &origin, const Vec3 &direction) const {
  const Vec3 unit = direction.stableNormalized();
  if (node_.empty() || !origin.allFinite() || !unit.allFinite() || unit.isZero(0)) return std::nullopt;
  const Ray ray(origin, unit);
  SurfacePoint best;
  best.distance = infinity;
  struct Visit {
    Index node;
    double enters;
  };
  std::array<Visit, deepest> stack;
  std::size_t size = 0;
  stack[size++] = {0, ray.enters(node_[0].box)};
  while (size > 0) {
    const Visit v = stack[--size];
    if (v.enters == infinity || v.enters * (1 - 1e-12) > best.distance) continue;
    const Node &node = node_[v.node];
    for (Index i = node.first; i < node.first + node.count; ++i) {
      const Index f = face_[i];
      const auto [ia, ib, ic] = surface.triangle[f];
      const Vec3 a = ray.sheared(surface.position[ia]), b = ray.sheared(surface.position[ib]),
                 c = ray.sheared(surface.position[ic]);
      const Vec3 w(c.x() * b.y() - c.y() * b.x(), a.x() * c.y() - a.y() * c.x(), b.x() * a.y() - b.y() * a.x());
      const double sum = w.sum();
      if ((w.minCoeff() < 0 && w.maxCoeff() > 0) || sum == 0) continue;
      const Vec3 weights = w / sum;
      const double t = weights.dot(Vec3(a.z(), b.z(), c.z()));
      if (!(t >= 0) || t > best.distance || (t == best.distance && f > best.face)) continue;
      const Vec3 hit =
          weights[0] * surface.position[ia] + weights[1] * surface.position[ib] + weights[2] * surface.position[ic];
      best = {f, weights, hit, t};
    }
    if (node.count > 0) continue;
    Visit near{v.node + 1, ray.enters(node_[v.node + 1].box)}, far{node.first, ray.enters(node_[node.first].box)};
    if (far.enters < near.enters) std::swap(near, far);
    stack[size++] = far;
    stack[size++] = near;
  }
  if (best.face == none) return std::nullopt;
  return best;
}

}  // namespace ts::mesh
