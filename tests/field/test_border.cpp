#include <doctest/doctest.h>

#include <Eigen/Dense>
#include <Eigen/SparseCholesky>
#include <cmath>
#include <vector>

#include "../geometry/forms.h"
#include "base/error.h"
#include "field/border.h"

using namespace ts;
using namespace ts::field;

namespace {

// Uneven weights, as seams make them.
struct Problem {
  mesh::Surface surface = forms::terrain(8, 6, 40, 30, [](double x, double y) { return std::sin(2 * x) * y / 4; });
  Vec<double> weight;
  Vec<Vec<Index>> first = {{45}, {700, 701, 740}, {1100}, {1225}};

  Problem() {
    std::uint32_t state = 5;
    for (std::size_t e = 0; e < surface.edge.size(); ++e) {
      state = state * 1664525u + 1013904223u;
      weight.push_back(std::pow(10, -3 * double(state >> 8) / 16777216.0));
    }
  }
  // What make_nodes would make of them; a vertex belongs to the first that names it.
  Nodes nodes(const Vec<Vec<Index>> &sets) const {
    Nodes n;
    n.of_vertex.assign(surface.vertices(), mesh::none);
    for (Index k = 0; k < sets.size(); ++k) {
      n.group.push_back(k);
      for (const Index v : sets[k])
        if (n.of_vertex[v] == mesh::none) n.of_vertex[v] = k;
    }
    return n;
  }
  Vec<Index> disc(Index centre, double radius) const {
    Vec<Index> in;
    for (Index v = 0; v < surface.vertices(); ++v)
      if ((surface.position[v] - surface.position[centre]).norm() <= radius) in.push_back(v);
    return in;
  }
};

Vec<double> all_of(Solution solution, const mesh::Surface &s) {
  Vec<double> u(s.vertices());
  for (Index v = 0; v < u.size(); ++v) u[v] = solution(v);
  return u;
}

// Eq. 3 with a row for each vertex; vertices of a node are one unknown.
Vec<double> by_rows(const Problem &p, const Nodes &nodes, const Vec<double> &held, double alpha) {
  Vec<Index> unknown(p.surface.vertices());
  Index n = static_cast<Index>(nodes.size());
  for (Index v = 0; v < unknown.size(); ++v) unknown[v] = nodes.of_vertex[v] != mesh::none ? nodes.of_vertex[v] : n++;
  std::vector<Eigen::Triplet<double>> entry;
  const auto add = [&](Index i, Index j, double value) {
    entry.emplace_back(static_cast<int>(i), static_cast<int>(j), value);
  };
  Eigen::VectorXd b = Eigen::VectorXd::Zero(n);
  for (Index e = 0; e < p.surface.edge.size(); ++e) {
    const Index i = unknown[p.surface.edge[e][0]], j = unknown[p.surface.edge[e][1]];
    if (i == j) continue;
    add(i, i, p.weight[e]), add(j, j, p.weight[e]);
    add(i, j, -p.weight[e]), add(j, i, -p.weight[e]);
  }
  for (Index k = 0; k < nodes.size(); ++k)
    if (!std::isnan(held[k])) add(k, k, alpha), b[k] = alpha * held[k];
  Eigen::SparseMatrix<double> a(n, n);
  a.setFromTriplets(entry.begin(), entry.end());
  const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> factor(a);
  REQUIRE(factor.info() == Eigen::Success);
  const Eigen::VectorXd x = factor.solve(b);
  Vec<double> u;
  for (const Index i : unknown) u.push_back(x[i]);
  return u;
}

double worst(const Vec<double> &a, const Vec<double> &b) {
  double most = 0;
  for (std::size_t i = 0; i < a.size(); ++i) most = std::max(most, std::abs(a[i] - b[i]));
  return most;
}

// The border against a solver of all nodes, and against Eq. 3.
void check(const Problem &p, const Vec<Vec<Index>> &added, std::size_t most_bytes = SIZE_MAX) {
  Vec<Vec<Index>> together = p.first;
  together.insert(together.end(), added.begin(), added.end());
  const Nodes nodes = p.nodes(together);
  const Solver few(p.surface, p.weight, p.nodes(p.first), Executor(1), {}, most_bytes);
  const Solver all(p.surface, p.weight, nodes, Executor(1));
  const Border border(few, added, Executor(2));
  REQUIRE(border.schur().rows() == all.schur().rows());
  CHECK((border.schur() - all.schur()).norm() < 1e-9 * all.schur().norm());
  CHECK(border.schur().rowwise().sum().norm() < 1e-12 * all.schur().norm());
  CHECK((border.schur() - border.schur().transpose()).norm() == 0);
  for (std::size_t one = 0; one < together.size(); ++one)
    for (const double alpha : {1e8, 0.0, 0.5}) {
      Vec<double> held(together.size(), 0);
      held[one] = 1;
      held[(one + 1) % together.size()] = free_node;
      const Eigen::VectorXd at_nodes = border.solve_nodes(held, alpha), wanted = all.solve_nodes(held, alpha);
      CHECK((at_nodes - wanted).cwiseAbs().maxCoeff() < 1e-6);
      const Vec<double> u = all_of(border.extend(at_nodes), p.surface);
      CHECK(worst(u, all.extend_to_all(wanted)) < 1e-6);
      if (alpha > 0) CHECK(worst(u, by_rows(p, nodes, held, alpha)) < 1e-6);
    }
  for (const Index v : {Index{0}, Index{333}, Index{700}, Index{1000}})
    CHECK((border.measure(v) - all.measure(v)).cwiseAbs().maxCoeff() < 1e-6);
}

}  // namespace

TEST_CASE("an added node is as good as one that was there: one vertex, a disc, two of them, in little memory") {
  const Problem p;
  const Index middle = 15 * 41 + 12, beside = 15 * 41 + 19;
  check(p, {{middle}});
  check(p, {p.disc(middle, 0.7)});
  check(p, {p.disc(middle, 0.7), p.disc(beside, 0.7)});  // they share vertices
  check(p, {{middle}, {middle + 1}});
  const std::size_t all_of_it = Solver(p.surface, p.weight, p.nodes(p.first), Executor(1)).bytes();
  check(p, {p.disc(middle, 0.7), p.disc(1100, 0.5)}, all_of_it / 3);
}

TEST_CASE("vertices of other nodes stay with them; a node without any of its own is refused") {
  const Problem p;
  check(p, {p.disc(700, 0.7)});  // around one that is held
  const Solver solver(p.surface, p.weight, p.nodes(p.first), Executor(1));
  const auto refused = [&](const Vec<Vec<Index>> &added) {
    try {
      const Border border(solver, added, Executor(1));
    } catch (const Error &e) {
      return e.fault() == Fault::no_constraint;
    }
    return false;
  };
  CHECK(refused({{45}}));
  CHECK(refused({{700, 740}}));
  CHECK(refused({{500}, {500}}));
  CHECK(refused({{}}));
  CHECK(!refused({{500}, {500, 501}}));
}

TEST_CASE("inside a disc its value, between the solver's own nodes what was there before as long as it is free") {
  const Problem p;
  const Solver solver(p.surface, p.weight, p.nodes(p.first), Executor(1));
  const Vec<Index> disc = p.disc(15 * 41 + 12, 0.9);
  const Border border(solver, {{disc}}, Executor(2));
  Solution u = border.extend(border.solve_nodes(Vec<double>{0, 0, 0, 0, 0.75}, 0));
  for (const Index v : disc) CHECK(u(v) == doctest::Approx(0.75).epsilon(1e-9));

  const Border point(solver, {{Vec<Index>{600}}}, Executor(1));
  const Vec<double> held = {0, 1, free_node, 0}, more = {0, 1, free_node, 0, free_node};
  const Vec<double> before = solver.extend_to_all(solver.solve_nodes(held, 1e8));
  CHECK(worst(before, all_of(point.extend(point.solve_nodes(more, 1e8)), p.surface)) < 1e-9);
}

TEST_CASE("an added node on a piece of its own leaves the others alone; one on a piece left out is refused") {
  const mesh::Surface one = forms::plane(3, 3, 6, 6);
  Vec<mesh::Vec3> position;
  Vec<mesh::Triangle> triangle;
  const Index n = static_cast<Index>(one.vertices());
  for (Index k = 0; k < 3; ++k) {
    for (const auto &q : one.position) position.push_back(q + mesh::Vec3(10.0 * k, 0, 0));
    for (const auto &f : one.triangle) triangle.push_back({f[0] + k * n, f[1] + k * n, f[2] + k * n});
  }
  const mesh::Surface s = mesh::make_surface(position, triangle);
  Nodes nodes;
  nodes.of_vertex.assign(s.vertices(), mesh::none);
  nodes.of_vertex[10] = 0, nodes.of_vertex[30] = 1, nodes.of_vertex[n + 10] = 2;
  nodes.group = {0, 1, 2};
  const Solver solver(s, Vec<double>(s.edge.size(), 1), nodes, Executor(1));
  const Border border(solver, {{Vec<Index>{n + 30}}}, Executor(1));
  const auto solve = [&](const Vec<double> &held) { return all_of(border.extend(border.solve_nodes(held, 1e8)), s); };
  const Vec<double> u = solve({0, 1, free_node, free_node});
  const Vec<double> before = solver.extend_to_all(solver.solve_nodes(Vec<double>{0, 1, free_node}, 1e8));
  for (Index v = 0; v < 3 * n; ++v) CHECK(std::isnan(u[v]) == (v >= n));
  for (Index v = 0; v < n; ++v) CHECK(u[v] == doctest::Approx(before[v]));
  const Vec<double> w = solve({free_node, free_node, free_node, 0.25});
  for (Index v = 0; v < 2 * n; ++v) CHECK(std::isnan(w[v]) == (v < n));
  for (Index v = n; v < 2 * n; ++v) CHECK(w[v] == doctest::Approx(0.25));
  CHECK(border.measure(n + 3)[3] > 0);
  CHECK(border.measure(3)[3] == 0);
  CHECK_THROWS_AS(Border(solver, {{Vec<Index>{2 * n + 5}}}, Executor(1)), Error);
}
