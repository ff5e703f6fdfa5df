#include <doctest/doctest.h>

#include "../geometry/forms.h"
#include "field/weights.h"
#include "geometry/concavity.h"
#include "geometry/curvature.h"

using namespace ts;
using namespace ts::field;
using mesh::Index;

namespace {

const mesh::Surface valley = forms::terrain(6, 6, 24, 24, [](double x, double) { return std::abs(x - 3); });

}  // namespace

TEST_CASE("concavity weights: 1 on flat ground, beta deep in a seam, the worse end decides") {
  const Executor one(1);
  Vec<double> c(valley.vertices(), 0);
  c[30] = 10, c[31] = 0.07;
  const Vec<double> w = edge_weights(valley, c, {Scheme::concavity, 1e-3, 1e-4, 0.2, 0.07}, one);
  for (Index e = 0; e < w.size(); ++e) {
    const auto [a, b] = valley.edge[e];
    const bool deep = a == 30 || b == 30, middle = a == 31 || b == 31;
    CHECK(w[e] == doctest::Approx(deep ? 1e-3 : middle ? 1e-3 + (1 - 1e-3) * std::exp(-1.0) : 1.0));
  }
}

TEST_CASE("Eq. 8 literally: |e| / (|G_i + G_j| + gamma), times beta where an end is concave") {
  const Executor one(1);
  const WeightOptions o{Scheme::paper, 0.01, 1e-4, 0.001, 0.07};
  const Vec<double> w = edge_weights(valley, {}, o, one);
  const Vec<double> g = geometry::gaussian_curvature(valley, one);
  const auto concave = geometry::concave_by_edges(
      valley, geometry::vertex_normals(valley, geometry::NormalWeight::angle, one), o.theta, one);
  int held_down = 0;
  for (Index e = 0; e < w.size(); ++e) {
    const auto [a, b] = valley.edge[e];
    const double plain = valley.edge_length(e) / (std::abs(g[a] + g[b]) + 1e-4);
    const bool seam = concave[a] || concave[b];
    held_down += seam;
    CHECK(w[e] == doctest::Approx(seam ? plain * 0.01 : plain));
  }
  CHECK(held_down > 50);
  CHECK(held_down < int(w.size()) / 2);
}

TEST_CASE("a mesh that looks inwards has the same weights when that is said") {
  const Executor one(1);
  Vec<mesh::Triangle> turned = valley.triangle;
  for (auto &t : turned) std::swap(t[1], t[2]);
  const mesh::Surface inwards = mesh::make_surface(valley.position, turned);
  for (const Scheme scheme : {Scheme::concavity, Scheme::paper}) {
    WeightOptions o{scheme, 0.01, 1e-4, 0.1, 0.07};
    const Vec<double> w = edge_weights(valley, geometry::concavity(valley, 0.15, false, one).vertex, o, one);
    o.inside_out = true;
    const Vec<double> v = edge_weights(inwards, geometry::concavity(inwards, 0.15, true, one).vertex, o, one);
    for (Index e = 0; e < w.size(); ++e) CHECK(v[e] == doctest::Approx(w[e]).epsilon(1e-9));
  }
}

TEST_CASE("cotangent weights of a right-angled grid: 1 along its lines, clamped above 0 on diagonals; uniform is 1") {
  const mesh::Surface s = forms::plane(4, 4, 8, 8);
  const Vec<double> cot = edge_weights(s, {}, {Scheme::cotangent}, Executor(1));
  for (Index e = 0; e < cot.size(); ++e) {
    const auto d = s.position[s.edge[e][1]] - s.position[s.edge[e][0]];
    const bool diagonal = std::abs(d.x()) > 1e-9 && std::abs(d.y()) > 1e-9;
    const bool rim = s.on_boundary[s.edge[e][0]] && s.on_boundary[s.edge[e][1]] && !diagonal;
    if (diagonal)
      CHECK(cot[e] == doctest::Approx(1e-3));
    else if (!rim)
      CHECK(cot[e] == doctest::Approx(1));
  }
  for (const double w : edge_weights(s, {}, {Scheme::uniform}, Executor(1))) CHECK(w == 1);
  // Eq. 8 without the share of concave edges.
  const WeightOptions all_alike{.scheme = Scheme::paper, .beta = 1, .gamma = 0.5};
  CHECK(edge_weights(s, {}, {.scheme = Scheme::feature, .beta = 0.1, .gamma = 0.5}, Executor(1)) ==
        edge_weights(s, {}, all_alike, Executor(1)));
}
