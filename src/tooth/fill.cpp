#include "tooth/fill.h"

#include <Eigen/IterativeLinearSolvers>
#include <Eigen/SparseCore>
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <unordered_set>

#include "base/stop.h"
#include "mesh/triangulate.h"

namespace ts::tooth {
namespace {

// The least area takes the cube of the points: 1000 take .2 s. Longer loops, which only the rims of a whole scan have,
// are cut by ears in their plane.
constexpr std::size_t kMostForLeastArea = 1000;
constexpr double kTaken = 1e9;  // mm^2, the price of an edge that is there already

// Eigen's own preconditioner, which looks at each step of a solve whether to stop.
struct Asking : Eigen::DiagonalPreconditioner<double> {
  template <class Right>
  auto solve(const Eigen::MatrixBase<Right> &right) const {
    stop_if_asked();
    return Eigen::DiagonalPreconditioner<double>::solve(right);
  }
};

std::uint64_t key(Index a, Index b) {
  return std::uint64_t{std::min(a, b)} << 32 | std::max(a, b);
}

Vec<Triangle> least_area(std::span<const Vec3> loop, FunctionRef<bool(Index, Index)> taken, const Progress &progress) {
  const std::size_t n = loop.size();
  Vec<double> cost(n * n, 0);
  Vec<Index> middle(n * n, 0);
  for (std::size_t gap = 2; gap < n; ++gap) {
    progress(static_cast<double>(gap) / static_cast<double>(n));
    for (std::size_t i = 0; i + gap < n; ++i) {
      const std::size_t j = i + gap;
      const Vec3 &a = loop[i], side = loop[j] - a;
      double best = std::numeric_limits<double>::infinity();
      // cost(k, j) is read from (j, k), where it is kept as well: rows are read in order.
      for (std::size_t k = i + 1; k < j; ++k) {
        const double before = cost[i * n + k] + cost[j * n + k];
        if (before >= best) continue;
        const double whole = before + side.cross(loop[k] - a).norm() / 2;
        if (whole < best) best = whole, middle[i * n + j] = static_cast<Index>(k);
      }
      const bool side_of_loop = gap == n - 1;
      if (!side_of_loop && taken(static_cast<Index>(i), static_cast<Index>(j))) best += kTaken;
      cost[i * n + j] = cost[j * n + i] = best;
    }
  }
  Vec<Triangle> out;
  Vec<std::array<Index, 2>> stack = {{0, static_cast<Index>(n - 1)}};
  while (!stack.empty()) {
    const auto [i, j] = stack.back();
    stack.pop_back();
    if (j < i + 2) continue;
    const Index k = middle[i * n + j];
    out.push_back({i, k, j});
    stack.push_back({i, k});
    stack.push_back({k, j});
  }
  return out;
}

Vec<Triangle> triangulate(Vec<Vec3> &position, FunctionRef<bool(Index, Index)> taken, const Progress &progress) {
  const Index n = static_cast<Index>(position.size());
  if (n <= kMostForLeastArea) return least_area(position, taken, progress);
  Vec<Index> polygon(n);
  for (Index i = 0; i < n; ++i) polygon[i] = i;
  Vec<Triangle> out;
  if (mesh::Triangulator()(position, polygon, out) && out.size() == n - 2) return out;
  // From the middle.
  out.clear();
  Vec3 middle = Vec3::Zero();
  for (const Vec3 &p : position) middle += p / n;
  position.push_back(middle);
  for (Index i = 0; i < n; ++i) out.push_back({i, (i + 1) % n, n});
  return out;
}

// Triangles with their neighbours.
class Patch {
 public:
  Patch(Vec<Vec3> position, Vec<double> spacing, Vec<Triangle> triangle, FunctionRef<bool(Index, Index)> taken)
      : position_(std::move(position)),
        spacing_(std::move(spacing)),
        triangle_(std::move(triangle)),
        taken_(taken),
        loop_(static_cast<Index>(spacing_.size())) {
    for (std::size_t v = spacing_.size(); v < position_.size(); ++v)  // a middle
      spacing_.push_back(*std::ranges::max_element(spacing_));
    std::map<std::uint64_t, std::array<Index, 2>> first;
    beside_.assign(triangle_.size(), {mesh::none, mesh::none, mesh::none});
    for (Index t = 0; t < triangle_.size(); ++t)
      for (Index k = 0; k < 3; ++k) {
        const std::uint64_t e = key(triangle_[t][k], triangle_[t][(k + 1) % 3]);
        edges_.insert(e);
        const auto [at, fresh] = first.try_emplace(e, std::array{t, k});
        if (fresh) continue;
        beside_[t][k] = at->second[0];
        beside_[at->second[0]][at->second[1]] = t;
      }
  }

  void refine(double growth) {
    part_taken();
    constexpr int most = 40;
    for (int pass = 0; pass < most && add_points(growth); ++pass) flip();
  }

  void flip() {
    constexpr int most = 40;
    bool flipped = true;
    StopNowAndThen stop(1 << 13);
    for (int pass = 0; pass < most && flipped; ++pass) {
      flipped = false;
      for (Index t = 0; t < triangle_.size(); ++t, stop())
        for (Index k = 0; k < 3; ++k) flipped = try_flip(t, k) || flipped;
    }
  }

  // Puts the points inside where each is the mean of its neighbours, by the cotangents of the triangles as they are.
  void relax() {
    const Index inside = static_cast<Index>(position_.size()) - loop_;
    if (inside == 0) return;
    Vec<Eigen::Triplet<double>> entries;
    Eigen::MatrixX3d right = Eigen::MatrixX3d::Zero(inside, 3), now(inside, 3);
    for (Index v = 0; v < inside; ++v) now.row(v) = position_[loop_ + v];
    Vec<double> diagonal(inside, 0);
    const auto couple = [&](Index v, Index w, double weight) {
      if (v < loop_) return;
      diagonal[v - loop_] += weight;
      if (w < loop_)
        right.row(v - loop_) += weight * position_[w];
      else
        entries.emplace_back(v - loop_, w - loop_, -weight);
    };
    StopNowAndThen stop(1 << 13);
    for (Index t = 0; t < triangle_.size(); ++t, stop())
      for (Index k = 0; k < 3; ++k) {
        const Index other = beside_[t][k];
        if (other == mesh::none || other < t) continue;
        const Index a = triangle_[t][k], b = triangle_[t][(k + 1) % 3];
        // Never negative, so that no point leaves the hull of its neighbours.
        const double weight = std::max(1e-3, cotangent(t, k) + cotangent(other, place(other, b)));
        couple(a, b, weight);
        couple(b, a, weight);
      }
    for (Index v = 0; v < inside; ++v) entries.emplace_back(v, v, diagonal[v]);
    Eigen::SparseMatrix<double> matrix(inside, inside);
    stop_if_asked();
    matrix.setFromTriplets(entries.begin(), entries.end());
    stop_if_asked();
    Eigen::ConjugateGradient<Eigen::SparseMatrix<double>, Eigen::Lower | Eigen::Upper, Asking> solver;
    solver.setTolerance(1e-8);
    solver.compute(matrix);
    const Eigen::MatrixX3d x = solver.solveWithGuess(right, now);
    for (Index v = 0; v < inside; ++v) position_[loop_ + v] = x.row(v);
  }

  Fill give() && { return {std::move(position_), std::move(triangle_)}; }

 private:
  // Which side of a triangle begins at a vertex.
  Index place(Index t, Index v) const {
    const Triangle &c = triangle_[t];
    return c[0] == v ? 0 : c[1] == v ? 1 : 2;
  }

  // Of the angle opposite to a side.
  double cotangent(Index t, Index k) const {
    const Vec3 &a = position_[triangle_[t][k]], &b = position_[triangle_[t][(k + 1) % 3]];
    const Vec3 &c = position_[triangle_[t][(k + 2) % 3]];
    const double sine = (a - c).cross(b - c).norm();
    return (a - c).dot(b - c) / std::max(sine, 1e-12);
  }

  Vec3 normal(Index a, Index b, Index c) const {
    return (position_[b] - position_[a]).cross(position_[c] - position_[a]);
  }

  void replace_neighbour(Index t, Index from, Index to) {
    if (t == mesh::none) return;
    *std::ranges::find(beside_[t], from) = to;
  }

  // Adds a point in the middle of the triangles that are larger than the spacing.
  bool add_points(double growth) {
    const double root2 = std::sqrt(2.0);
    bool added = false;
    for (Index t = 0, end = static_cast<Index>(triangle_.size()); t < end; ++t) {
      const Triangle c = triangle_[t];
      const Vec3 middle = (position_[c[0]] + position_[c[1]] + position_[c[2]]) / 3;
      const double wanted = growth * (spacing_[c[0]] + spacing_[c[1]] + spacing_[c[2]]) / 3;
      const bool large = std::ranges::all_of(c, [&](Index v) {
        const double away = root2 * (position_[v] - middle).norm();
        return away > wanted && away > spacing_[v];
      });
      if (!large) continue;
      added = true;
      const Index m = static_cast<Index>(position_.size());
      position_.push_back(middle);
      spacing_.push_back(wanted);
      const Triangle n = beside_[t];
      const Index second = static_cast<Index>(triangle_.size()), third = second + 1;
      triangle_[t] = {c[0], c[1], m};
      triangle_.push_back({c[1], c[2], m});
      triangle_.push_back({c[2], c[0], m});
      beside_[t] = {n[0], second, third};
      beside_.push_back({n[1], third, t});
      beside_.push_back({n[2], t, second});
      replace_neighbour(n[1], t, second);
      replace_neighbour(n[2], t, third);
      for (const Index v : c) edges_.insert(key(v, m));
    }
    return added;
  }

  // Edges of the fill that the mesh has already get a point in their middle.
  void part_taken() {
    for (Index t = 0; t < triangle_.size(); ++t)
      for (Index k = 0; k < 3; ++k) {
        const Index other = beside_[t][k], a = triangle_[t][k], b = triangle_[t][(k + 1) % 3];
        if (other == mesh::none || a >= loop_ || b >= loop_ || !taken_(a, b)) continue;
        const Index c = triangle_[t][(k + 2) % 3], j = place(other, b), d = triangle_[other][(j + 2) % 3];
        const Index m = static_cast<Index>(position_.size());
        position_.push_back((position_[a] + position_[b]) / 2);
        spacing_.push_back((spacing_[a] + spacing_[b]) / 2);
        const Index n_bc = beside_[t][(k + 1) % 3], n_ca = beside_[t][(k + 2) % 3];
        const Index n_ad = beside_[other][(j + 1) % 3], n_db = beside_[other][(j + 2) % 3];
        const Index mine = static_cast<Index>(triangle_.size()), its = mine + 1;
        triangle_[t] = {a, m, c};
        beside_[t] = {other, mine, n_ca};
        triangle_.push_back({m, b, c});
        beside_.push_back({its, n_bc, t});
        triangle_[other] = {m, a, d};
        beside_[other] = {t, n_ad, its};
        triangle_.push_back({b, m, d});
        beside_.push_back({mine, other, n_db});
        replace_neighbour(n_bc, t, mine);
        replace_neighbour(n_db, other, its);
        edges_.erase(key(a, b));
        for (const Index v : {a, b, c, d}) edges_.insert(key(v, m));
        k = mesh::none;  // from its first side again
      }
  }

  // Flips an edge between a and b whose opposite angles are more than two right ones together.
  bool try_flip(Index t, Index k) {
    const Index other = beside_[t][k];
    if (other == mesh::none || other < t) return false;
    const Index a = triangle_[t][k], b = triangle_[t][(k + 1) % 3], c = triangle_[t][(k + 2) % 3];
    const Index j = place(other, b), d = triangle_[other][(j + 2) % 3];
    if (cotangent(t, k) + cotangent(other, j) > -1e-6) return false;
    if (edges_.contains(key(c, d)) || (c < loop_ && d < loop_ && taken_(c, d))) return false;
    const Vec3 was = normal(a, b, c) + normal(b, a, d), one = normal(a, d, c), two = normal(d, b, c);
    if (!(one.dot(two) > 0) || !(one.dot(was) > 0) || !(two.dot(was) > 0)) return false;
    const Index n_bc = beside_[t][(k + 1) % 3], n_ca = beside_[t][(k + 2) % 3];
    const Index n_ad = beside_[other][(j + 1) % 3], n_db = beside_[other][(j + 2) % 3];
    triangle_[t] = {a, d, c};
    beside_[t] = {n_ad, other, n_ca};
    triangle_[other] = {d, b, c};
    beside_[other] = {n_db, n_bc, t};
    replace_neighbour(n_ad, other, t);
    replace_neighbour(n_bc, t, other);
    edges_.erase(key(a, b));
    edges_.insert(key(c, d));
    return true;
  }

  Vec<Vec3> position_;
  Vec<double> spacing_;
  Vec<Triangle> triangle_, beside_;  // across the side from corner k to the next
  FunctionRef<bool(Index, Index)> taken_;
  Index loop_;
  std::unordered_set<std::uint64_t> edges_;
};

}  // namespace

Fill fill_loop(std::span<const Vec3> loop, std::span<const double> spacing, FunctionRef<bool(Index, Index)> taken,
               const FillOptions &options, const Progress &progress) {
  Vec<Vec3> position(loop.begin(), loop.end());
  Vec<Triangle> first = triangulate(position, taken, progress.part(0, 0.6, "closing"));
  Patch patch(std::move(position), Vec<double>(spacing.begin(), spacing.end()), std::move(first), taken);
  patch.flip();
  patch.refine(options.growth);
  progress(0.8);
  for (int round = 0; round < options.rounds; ++round) {
    patch.relax();
    patch.flip();
  }
  progress(1);
  return std::move(patch).give();
}

}  // namespace ts::tooth
