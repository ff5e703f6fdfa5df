#include <doctest/doctest.h>

#include <Eigen/Dense>

#include "../geometry/forms.h"
#include "field/outliers.h"
#include "field/solver.h"
#include "geometry/laplacian.h"

using namespace ts;
using namespace ts::field;

namespace {

Nodes single_vertices(const mesh::Surface &s, const Vec<Index> &points, const Vec<Index> &groups, Index count) {
  return make_nodes(s, {points, groups, count}, {0, false, 13});
}

double pseudo_random(std::uint32_t &state) {
  state = state * 1664525u + 1013904223u;
  return double(state >> 8) / 16777216.0;
}

}  // namespace

TEST_CASE("Eq. 3 agrees with a dense solve of (L + P) u = P b") {
  const mesh::Surface s = forms::terrain(5, 5, 14, 14, [](double x, double y) { return std::sin(2 * x) * y / 4; });
  std::uint32_t state = 5;
  Vec<double> w(s.edge.size());
  for (double &x : w) x = 1e-3 + pseudo_random(state);
  const Vec<Index> points = {20, 60, 110, 150, 200};
  const Nodes nodes = single_vertices(s, points, {0, 0, 1, 1, 2}, 3);
  const Solver solver(s, w, nodes, Executor(1));
  const double alpha = 1e8;
  const Vec<double> held = {0, 0, 1, 1, free_node};  // the last one belongs to a tooth that is not of the pair

  const auto n = static_cast<Eigen::Index>(s.vertices());
  Eigen::MatrixXd a = Eigen::MatrixXd::Zero(n, n);
  Eigen::VectorXd b = Eigen::VectorXd::Zero(n);
  for (Index e = 0; e < s.edge.size(); ++e) {
    const auto [i, j] = s.edge[e];
    a(i, i) += w[e], a(j, j) += w[e];
    a(i, j) -= w[e], a(j, i) -= w[e];
  }
  for (std::size_t k = 0; k < 4; ++k) a(points[k], points[k]) += alpha, b[points[k]] = alpha * held[k];
  const Eigen::VectorXd dense = a.ldlt().solve(b);

  const Eigen::VectorXd at_nodes = solver.solve_nodes(held, alpha);
  const Vec<double> u = solver.extend_to_all(at_nodes);
  double worst = 0;
  for (Index v = 0; v < s.vertices(); ++v) worst = std::max(worst, std::abs(u[v] - dense[v]));
  CHECK(worst < 1e-6);
  CHECK(at_nodes[4] == doctest::Approx(dense[200]).epsilon(1e-6));

  // A small penalty is felt, and is that of Eq. 3 all the same.
  for (std::size_t k = 0; k < 4; ++k) a(points[k], points[k]) += 0.5 - alpha, b[points[k]] = 0.5 * held[k];
  const Eigen::VectorXd loose = a.ldlt().solve(b), found = solver.solve_nodes(held, 0.5);
  CHECK(found[0] > 0.01);
  for (Eigen::Index k = 0; k < 5; ++k) CHECK(found[k] == doctest::Approx(loose[points[std::size_t(k)]]).epsilon(1e-8));
}

TEST_CASE("discs: a dense solve with the vertices of each disc made one") {
  const mesh::Surface s = forms::plane(6, 6, 18, 18);
  const Nodes nodes = make_nodes(s, {{5 * 19 + 4, 13 * 19 + 14, 9 * 19 + 9}, {0, 1, 2}, 3}, {0.7, false, 13});
  const Vec<double> w(s.edge.size(), 1);
  const Solver solver(s, w, nodes, Executor(1));
  Vec<Index> unknown(s.vertices());
  Index n = 3;
  for (Index v = 0; v < s.vertices(); ++v) unknown[v] = nodes.of_vertex[v] != mesh::none ? nodes.of_vertex[v] : n++;
  Eigen::MatrixXd a = Eigen::MatrixXd::Zero(n, n);
  for (Index e = 0; e < s.edge.size(); ++e) {
    const Index i = unknown[s.edge[e][0]], j = unknown[s.edge[e][1]];
    if (i == j) continue;
    a(i, i) += 1, a(j, j) += 1;
    a(i, j) -= 1, a(j, i) -= 1;
  }
  Eigen::VectorXd b = Eigen::VectorXd::Zero(n);
  a(0, 0) += 1e8, a(1, 1) += 1e8, b[1] = 1e8;
  const Eigen::VectorXd dense = a.ldlt().solve(b);
  const Eigen::VectorXd at_nodes = solver.solve_nodes(Vec<double>{0, 1, free_node}, 1e8);
  const Vec<double> u = solver.extend_to_all(at_nodes);
  for (Index v = 0; v < s.vertices(); ++v) CHECK(std::abs(u[v] - dense[unknown[v]]) < 1e-6);
}

TEST_CASE("harmonic on a strip: linear between its ends") {
  const mesh::Surface s = forms::plane(10, 3, 40, 12);
  Vec<Index> points, groups;
  Vec<double> held;
  for (Index v = 0; v < s.vertices(); ++v) {
    const double x = s.position[v].x();
    if (x != 0 && x != 10) continue;
    points.push_back(v);
    groups.push_back(x == 0 ? 0 : 1);
    held.push_back(x == 0 ? 0 : 1);
  }
  const Solver solver(s, geometry::cotangent_weights(s, 0, Executor(1)), single_vertices(s, points, groups, 2),
                      Executor(1));
  const Eigen::VectorXd at_nodes = solver.solve_nodes(held, 0);
  const Vec<double> u = solver.extend_to_all(at_nodes);
  for (Index v = 0; v < s.vertices(); ++v) CHECK(u[v] == doctest::Approx(s.position[v].x() / 10).epsilon(1e-9));
}

TEST_CASE("harmonic on a tube held at cos(angle): falls off like cosh") {
  const double radius = 2, length = 4;
  const mesh::Surface s = forms::tube(radius, length, 128, 40);
  Vec<Index> points, groups;
  Vec<double> held;
  for (Index v = 0; v < s.vertices(); ++v) {
    const auto &p = s.position[v];
    if (p.z() > 1e-9 && p.z() < length - 1e-9) continue;
    points.push_back(v);
    groups.push_back(p.z() < 1 ? 0 : 1);
    held.push_back(std::cos(std::atan2(p.y(), p.x())));
  }
  const Solver solver(s, geometry::cotangent_weights(s, 0, Executor(1)), single_vertices(s, points, groups, 2),
                      Executor(1));
  const Eigen::VectorXd at_nodes = solver.solve_nodes(held, 0);
  const Vec<double> u = solver.extend_to_all(at_nodes);
  for (Index v = 0; v < s.vertices(); ++v) {
    const auto &p = s.position[v];
    const double exact =
        std::cos(std::atan2(p.y(), p.x())) * std::cosh((p.z() - length / 2) / radius) / std::cosh(length / 2 / radius);
    CHECK(std::abs(u[v] - exact) < 2e-3);
  }
}

TEST_CASE("a value has the same bytes asked for alone, in any order, with any number of threads, in little memory") {
  const mesh::Surface s = forms::sphere(5, 5);
  const Nodes nodes = single_vertices(s, {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10}, {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10}, 11);
  const Vec<double> w(s.edge.size(), 1);
  const Solver solver(s, w, nodes, Executor(1)), threads(s, w, nodes, Executor(3));
  const std::size_t all_of_it = solver.bytes();
  const Solver small(s, w, nodes, Executor(2), {}, all_of_it / 3);
  CHECK(small.bytes() < all_of_it);
  CHECK((threads.schur() - solver.schur()).norm() == 0);
  CHECK((small.schur() - solver.schur()).norm() == 0);
  Vec<double> sum(s.vertices(), 0);
  for (Index k = 0; k < 11; ++k) {
    Vec<double> held(11, 0);
    held[k] = 1;
    const Eigen::VectorXd at_nodes = solver.solve_nodes(held, 1e8);
    const Vec<double> u = solver.extend_to_all(at_nodes);
    CHECK(threads.extend_to_all(at_nodes) == u);
    CHECK(small.extend_to_all(at_nodes) == u);
    const Index some[] = {1000, 5, static_cast<Index>(s.vertices()) - 1, 77};
    Solution all = solver.extend(at_nodes);
    std::size_t bytes = 0;
    for (const Index v : some) {
      Solution one = solver.extend(at_nodes);
      CHECK(one(v) == u[v]);
      CHECK(all(v) == u[v]);
      bytes = one.bytes();
    }
    CHECK(bytes > 0);
    CHECK(bytes < all_of_it / 8);
    for (const Index v : some) CHECK(solver.measure(v)[k] == doctest::Approx(u[v]).epsilon(1e-6));
    for (Index v = 0; v < s.vertices(); ++v) sum[v] += u[v];
  }
  for (const double x : sum) CHECK(x == doctest::Approx(1).epsilon(1e-6));  // a partition of unity
  for (const Index v : {Index{11}, Index{100}, Index{333}}) CHECK(solver.measure(v).sum() == doctest::Approx(1));
  CHECK_THROWS_AS(Solver(s, w, nodes, Executor(1), {}, 100), Error);
}

TEST_CASE("pieces without a node are left out; pieces without a held one are NaN in that click only") {
  const mesh::Surface one = forms::plane(3, 3, 6, 6);
  Vec<mesh::Vec3> p;
  Vec<mesh::Triangle> t;
  const Index n = static_cast<Index>(one.vertices());
  for (Index k = 0; k < 3; ++k) {
    for (const auto &q : one.position) p.push_back(q + mesh::Vec3(10.0 * k, 0, 0));
    for (const auto &f : one.triangle) t.push_back({f[0] + k * n, f[1] + k * n, f[2] + k * n});
  }
  const mesh::Surface s = mesh::make_surface(p, t);
  const Nodes nodes = single_vertices(s, {10, 30, n + 10}, {0, 1, 2}, 3);
  const Solver solver(s, Vec<double>(s.edge.size(), 1), nodes, Executor(1));
  const Eigen::VectorXd pair = solver.solve_nodes(Vec<double>{0, 1, free_node}, 1e8);
  const Vec<double> u = solver.extend_to_all(pair);
  for (Index v = 0; v < 3 * n; ++v) CHECK(std::isnan(u[v]) == (v >= n));
  const Eigen::VectorXd all = solver.solve_nodes(Vec<double>{0, 1, 0.25}, 1e8);
  const Vec<double> w = solver.extend_to_all(all);
  for (Index v = n; v < 2 * n; ++v) CHECK(w[v] == doctest::Approx(0.25));
  for (Index v = 2 * n; v < 3 * n; ++v) CHECK(std::isnan(w[v]));
  CHECK(solver.measure(2 * n + 5).sum() == 0);
}

TEST_CASE("pieces that lie within each other: one in which nothing is held is NaN, and the other is as if alone") {
  const mesh::Surface one = forms::plane(4, 4, 12, 12);
  Vec<mesh::Vec3> p = one.position;
  Vec<mesh::Triangle> t = one.triangle;
  const Index n = static_cast<Index>(one.vertices());
  for (const auto &q : one.position) p.push_back(q + mesh::Vec3(0.1, 0.1, 0.05));  // parts of the factor hold both
  for (const auto &f : one.triangle) t.push_back({f[0] + n, f[1] + n, f[2] + n});
  const mesh::Surface s = mesh::make_surface(p, t);
  const Nodes nodes = single_vertices(s, {30, 120, n + 60}, {0, 1, 2}, 3);
  const Solver solver(s, Vec<double>(s.edge.size(), 1), nodes, Executor(1));
  const Vec<double> u = solver.extend_to_all(solver.solve_nodes(Vec<double>{0, 1, free_node}, 1e8));
  const Solver alone(one, Vec<double>(one.edge.size(), 1), single_vertices(one, {30, 120}, {0, 1}, 2), Executor(1));
  const Vec<double> expected = alone.extend_to_all(alone.solve_nodes(Vec<double>{0, 1}, 1e8));
  for (Index v = 0; v < n; ++v) {
    CHECK(std::abs(u[v] - expected[v]) < 1e-12);
    CHECK(std::isnan(u[n + v]));
  }
}

TEST_CASE("a point on the wrong side of a seam is an outlier; the points on their own side are not") {
  const mesh::Surface s = forms::plane(12, 6, 48, 24);
  Vec<double> w(s.edge.size(), 1);
  for (Index e = 0; e < w.size(); ++e)
    if (std::abs((s.position[s.edge[e][0]].x() + s.position[s.edge[e][1]].x()) / 2 - 6.1) < 0.2) w[e] = 1e-3;
  const auto at = [](Index i, Index j) { return j * 49 + i; };
  const Sites sites{{at(8, 6), at(8, 18), at(14, 12), at(34, 12), at(40, 6), at(40, 18)}, {0, 0, 0, 0, 1, 1}, 2};
  const Nodes nodes = make_nodes(s, sites, {0.7, false, 13});
  const Vec<std::uint8_t> outlier = find_outliers(Solver(s, w, nodes, Executor(1)), nodes, Vec<double>(6, 0.3));
  CHECK(outlier == Vec<std::uint8_t>{0, 0, 0, 1, 0, 0});
  const Nodes right = make_nodes(s, {sites.point, {0, 0, 0, 1, 1, 1}, 2}, {0.7, false, 13});
  CHECK(find_outliers(Solver(s, w, right, Executor(1)), right, Vec<double>(6, 0.3)) == Vec<std::uint8_t>(6, 0));
}

TEST_CASE("a point that a seam parts from another tooth stays, though a deeper one parts it from its own") {
  const mesh::Surface s = forms::plane(12, 6, 48, 24);
  Vec<double> w(s.edge.size(), 1);
  for (Index e = 0; e < w.size(); ++e) {
    const double x = (s.position[s.edge[e][0]].x() + s.position[s.edge[e][1]].x()) / 2;
    if (std::abs(x - 3.1) < 0.2) w[e] = 1e-3;
    if (std::abs(x - 7.1) < 0.2) w[e] = 1e-2;
  }
  const auto at = [](Index i, Index j) { return j * 49 + i; };
  const Sites sites{{at(6, 12), at(20, 12), at(36, 6), at(36, 18)}, {0, 0, 1, 1}, 2};
  const Nodes nodes = make_nodes(s, sites, {0.7, false, 13});
  CHECK(find_outliers(Solver(s, w, nodes, Executor(1)), nodes, Vec<double>(4, 0.3)) == Vec<std::uint8_t>(4, 0));
}

TEST_CASE("a flat point with no seam between it and the gingiva is freed; a cusp there, or one set by hand, is not") {
  const mesh::Surface s = forms::plane(40, 6, 160, 24);  // a tooth up to x = 6, gingiva for certain near the far end
  Vec<double> w(s.edge.size(), 1);
  for (Index e = 0; e < w.size(); ++e)
    if (std::abs((s.position[s.edge[e][0]].x() + s.position[s.edge[e][1]].x()) / 2 - 6.1) < 0.2) w[e] = 1e-3;
  const auto at = [](Index i, Index j) { return j * 161 + i; };
  const Sites sites{{at(8, 6), at(8, 18), at(40, 12)}, {0, 0, 0}, 1};
  const Nodes nodes = make_nodes(s, sites, {0.7, true, 13});
  REQUIRE(nodes.gingiva != mesh::none);
  const Solver solver(s, w, nodes, Executor(1));
  const auto freed = [&](double convexity) { return find_outliers(solver, nodes, Vec<double>{0.15, 0.15, convexity}); };
  CHECK(freed(0.15) == Vec<std::uint8_t>{0, 0, 1, 0});
  CHECK(freed(0.30) == Vec<std::uint8_t>{0, 0, 0, 0});
  CHECK(freed(0.0) == Vec<std::uint8_t>{0, 0, 0, 0});
}
