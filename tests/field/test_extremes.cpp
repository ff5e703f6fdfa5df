// What floating-point numbers do to the solve: weights over many orders of magnitude, against eliminations in more
// digits, and weights that no factorisation can take.
#include <doctest/doctest.h>

#include <Eigen/Dense>
#include <Eigen/SparseCholesky>
#include <limits>

#include "../geometry/forms.h"
#include "field/border.h"
#include "field/dense.h"
#include "field/solver.h"
#include "geometry/laplacian.h"

using namespace ts;
using namespace ts::field;

namespace {

using Long = long double;
using LongMatrix = Eigen::Matrix<Long, Eigen::Dynamic, Eigen::Dynamic>;
using LongVector = Eigen::Matrix<Long, Eigen::Dynamic, 1>;

double next_share(std::uint32_t &state) {
  state = state * 1664525u + 1013904223u;
  return double(state >> 8) / 16777216.0;
}

mesh::Surface hilly() {
  return forms::terrain(5, 5, 16, 16, [](double x, double y) { return std::sin(2 * x) * y / 4; });
}

// From 10^-12 to 1, evenly by their logarithms.
Vec<double> twelve_orders(const mesh::Surface &s) {
  std::uint32_t state = 12;
  Vec<double> w(s.edge.size());
  for (double &x : w) x = std::pow(10, -12 * next_share(state));
  return w;
}

const Vec<Index> kPoints = {20, 60, 150, 200, 270};
const Vec<double> kHeld = {0, 0, 1, 1, free_node};

Nodes nodes_of(const mesh::Surface &s) {
  return make_nodes(s, {kPoints, {0, 0, 1, 1, 2}, 3}, {0, false, 13});
}

// (L + P) u = P b, and u where it is held exactly for alpha 0.
LongVector reference(const mesh::Surface &s, const Vec<double> &w, Long alpha) {
  const auto n = static_cast<Eigen::Index>(s.vertices());
  LongMatrix a = LongMatrix::Zero(n, n);
  LongVector b = LongVector::Zero(n);
  for (Index e = 0; e < s.edge.size(); ++e) {
    const auto [i, j] = s.edge[e];
    a(i, j) -= w[e], a(j, i) -= w[e], a(i, i) += w[e], a(j, j) += w[e];
  }
  for (std::size_t k = 0; k < 4; ++k) {
    if (alpha == 0) a.row(kPoints[k]).setZero();
    a(kPoints[k], kPoints[k]) += alpha == 0 ? 1 : alpha;
    b[kPoints[k]] = (alpha == 0 ? 1 : alpha) * Long(kHeld[k]);
  }
  const Eigen::PartialPivLU<LongMatrix> lu(a);  // the one with full pivoting takes the smallest pivots for nothing
  LongVector u = lu.solve(b);
  for (int step = 0; step < 3; ++step) u += lu.solve(b - a * u);
  return u;
}

// How far u is from balance at its free vertices, of the weights there.
double residual(const mesh::Surface &s, const Vec<double> &w, const Vec<double> &u) {
  double worst = 0;
  for (Index v = 0; v < s.vertices(); ++v) {
    if (std::ranges::find(kPoints.begin(), kPoints.end() - 1, v) != kPoints.end() - 1) continue;
    Long flux = 0, all = 0;
    for (const Index e : s.vertex_edges[v]) flux += Long(w[e]) * (Long(u[v]) - u[s.other_end(e, v)]), all += w[e];
    worst = std::max(worst, double(std::abs(flux) / all));
  }
  return worst;
}

}  // namespace

TEST_CASE("weights over twelve orders of magnitude: as in more digits, and balanced at every vertex") {
  const mesh::Surface s = hilly();
  const Vec<double> w = twelve_orders(s);
  const Solver solver(s, w, nodes_of(s), Executor(1));
  for (const double alpha : {0.0, 1.0, 1e8}) {
    const Vec<double> u = solver.extend_to_all(solver.solve_nodes(kHeld, alpha));
    const LongVector exact = reference(s, w, alpha);
    double worst = 0;
    for (Index v = 0; v < s.vertices(); ++v) worst = std::max(worst, std::abs(u[v] - double(exact[v])));
    CAPTURE(alpha);
    CHECK(worst < 1e-6);
    CHECK(residual(s, w, u) < 1e-13);
    for (const double x : u) CHECK((x >= -1e-12 && x <= 1 + 1e-12));
  }
}

TEST_CASE("cotangents of needles of aspect 10^6: balanced, and as Eigen's factorisation has it") {
  mesh::Surface flat = forms::plane(5, 5, 16, 16);
  Vec<mesh::Vec3> p = flat.position;
  Vec<mesh::Triangle> t = flat.triangle;
  for (std::size_t f = 0; f < flat.triangle.size(); f += 5) {
    const auto [a, b, c] = flat.triangle[f];
    const auto q = static_cast<Index>(p.size());
    p.push_back(mesh::Vec3((p[a] + p[b]) / 2 + 1e-6 * (p[c] - (p[a] + p[b]) / 2)));
    t[f] = {a, b, q};
    t.push_back({b, c, q});
    t.push_back({c, a, q});
  }
  const mesh::Surface s = mesh::make_surface(std::move(p), std::move(t));
  const Vec<double> w = geometry::cotangent_weights(s, 1e-3, Executor(1));
  CHECK(*std::ranges::max_element(w) > 1e5);
  const Solver solver(s, w, nodes_of(s), Executor(1));
  const Vec<double> u = solver.extend_to_all(solver.solve_nodes(kHeld, 0));
  CHECK(residual(s, w, u) < 1e-13);

  const auto n = static_cast<Eigen::Index>(s.vertices());
  Eigen::SparseMatrix<double> a(n, n);
  std::vector<Eigen::Triplet<double>> entry;
  const double alpha = 1e12;
  for (Index e = 0; e < s.edge.size(); ++e) {
    const auto [i, j] = s.edge[e];
    entry.emplace_back(i, j, -w[e]), entry.emplace_back(j, i, -w[e]);
    entry.emplace_back(i, i, w[e]), entry.emplace_back(j, j, w[e]);
  }
  Eigen::VectorXd b = Eigen::VectorXd::Zero(n);
  for (std::size_t k = 0; k < 4; ++k) {
    const auto v = static_cast<int>(kPoints[k]);
    entry.emplace_back(v, v, alpha);
    b[v] = alpha * kHeld[k];
  }
  a.setFromTriplets(entry.begin(), entry.end());
  const Eigen::VectorXd sparse = Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>>(a).solve(b);
  for (Index v = 0; v < s.vertices(); ++v) CHECK(std::abs(u[v] - sparse[v]) < 1e-5);
}

TEST_CASE("an added node among weights over twelve orders of magnitude is as one from the beginning") {
  const mesh::Surface s = hilly();
  const Vec<double> w = twelve_orders(s);
  const Solver solver(s, w, nodes_of(s), Executor(1));
  const Vec<Vec<Index>> added = {{100}};
  const Border border(solver, added, Executor(1));
  Vec<double> held = kHeld;
  held.push_back(0.5);
  Solution u = border.extend(border.solve_nodes(held, 0));
  Vec<Index> points = kPoints;
  points.push_back(100);
  const Solver whole(s, w, make_nodes(s, {points, {0, 0, 1, 1, 2, 3}, 4}, {0, false, 13}), Executor(1));
  const Vec<double> expected = whole.extend_to_all(whole.solve_nodes(held, 0));
  for (Index v = 0; v < s.vertices(); ++v) CHECK(std::abs(u(v) - expected[v]) < 1e-6);
}

TEST_CASE("a weight that is not positive and finite is told as such") {
  const mesh::Surface s = hilly();
  const Nodes nodes = nodes_of(s);
  constexpr double inf = std::numeric_limits<double>::infinity();
  const auto fault_with = [&](Index edge, double weight, unsigned threads) {
    Vec<double> w(s.edge.size(), 1);
    w[edge] = weight;
    try {
      const Solver solver(s, w, nodes, Executor(threads));
      const Vec<double> u = solver.extend_to_all(solver.solve_nodes(kHeld, 1e8));
      return std::ranges::all_of(u, [](double x) { return std::isfinite(x); }) ? Fault::no_change : Fault::internal;
    } catch (const Error &e) {
      return e.fault();
    }
  };
  for (Index e = 0; e < s.edge.size(); e += 7)
    for (const double bad : {std::numeric_limits<double>::quiet_NaN(), inf, -inf, -1e3}) {
      CAPTURE(e);
      CAPTURE(bad);
      CHECK(fault_with(e, bad, 1 + e % 2) == Fault::solver);
    }
  for (Index e = 0; e < s.edge.size(); e += 7)
    for (const double good : {1e-300, 1e-30, 1e12}) {
      CAPTURE(e);
      CAPTURE(good);
      CHECK(fault_with(e, good, 1) == Fault::no_change);
    }
  // More orders of magnitude apart than a double has digits: the ones are lost beside it, which is told if it is felt.
  for (Index e = 0; e < s.edge.size(); e += 7) {
    const Fault got = fault_with(e, 1e30, 1);
    CHECK((got == Fault::solver || got == Fault::no_change));
  }
  // All of them nothing: no pivot is left.
  CHECK_THROWS_AS(Solver(s, Vec<double>(s.edge.size(), 0), nodes, Executor(1)), Error);
}

TEST_CASE("a weight between two constraints, which no pivot sees") {
  const mesh::Surface s = hilly();
  const auto [a, b] = s.edge[40];
  const Nodes nodes = make_nodes(s, {{a, b}, {0, 1}, 2}, {0, false, 13});
  for (const double bad : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    Vec<double> w(s.edge.size(), 1);
    w[40] = bad;
    try {
      const Solver solver(s, w, nodes, Executor(1));
      FAIL("was taken");
    } catch (const Error &e) {
      CHECK(e.fault() == Fault::solver);
    }
  }
}

TEST_CASE("an elimination ends at a pivot that is not positive and finite, wherever it is") {
  for (const DenseKernels *kernels : runnable_dense_kernels())
    for (const std::size_t at : {std::size_t{0}, std::size_t{3}, std::size_t{66}, std::size_t{99}})
      for (const double bad :
           {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity(), -1.0, 0.0}) {
        constexpr std::size_t n = 104;
        Vec<double> front(n * n, 0);  // Vec: aligned as the kernels want it
        for (std::size_t i = 0; i < n; ++i) front[i + i * n] = i == at ? bad : 2;
        CHECK_FALSE(kernels->eliminate(front.data(), n, n, 100));
      }
}
