#include "field/outliers.h"

#include <algorithm>

namespace ts::field {
namespace {

// Of 663 points found on 15 labelled scans 6 lie on gingiva: convexity .16 to .18, five with a conductance to the
// gingiva of .65 to 1.2 (weights are at most 1, so it has no unit and hardly depends on the mesh). Points on crowns: at
// most .29 where the convexity is under .2.
constexpr double kFlat = 0.2, kOpen = 0.45;

// By how much a flat point's conductance to the gingiva is more than that of a point on a crown; <= 0 if it is not.
double sunk(const Eigen::MatrixXd &s, const Nodes &nodes, std::size_t i, double convexity) {
  if (nodes.gingiva == mesh::none || !(convexity > 0 && convexity < kFlat)) return 0;
  return -s(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(nodes.gingiva)) - kOpen;
}

// By how much another tooth's share of node i's conductance exceeds its own tooth's; <= 0 if i is no outlier. A seam
// between the two, however weak, speaks for the feature groups: a premolar's fissure can be a stronger one (own points
// .02, the canine's .09). On the wrong tooth a point sees that tooth's with 1.2 to 2.5.
double excess(const Eigen::MatrixXd &s, const Nodes &nodes, const Vec<std::uint8_t> &freed, std::size_t i,
              Vec<double> &to) {
  to.assign(nodes.groups, 0);
  double all = 0;
  for (std::size_t j = 0; j < nodes.size(); ++j) {
    if (j == i || freed[j]) continue;
    const double g = -s(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j));
    if (nodes.group[j] != gingiva_group) to[nodes.group[j]] += g;
    all += g;
  }
  double most = 0;
  for (std::size_t k = 0; k < nodes.groups; ++k)
    if (k != nodes.group[i] && to[k] > std::max(0.5 * all, kOpen)) most = (to[k] - to[nodes.group[i]]) / all;
  return most;
}

}  // namespace

Vec<std::uint8_t> find_outliers(const Solver &solver, const Nodes &nodes, std::span<const double> convexity) {
  Eigen::MatrixXd s = solver.schur();
  Vec<Index> members(nodes.groups, 0);
  for (const Index g : nodes.group)
    if (g != gingiva_group) ++members[g];
  Vec<std::uint8_t> freed(nodes.size(), 0);
  Vec<double> to;
  for (;;) {
    std::size_t worst = 0;
    double most = 0;
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      if (freed[i] || nodes.group[i] == gingiva_group || members[nodes.group[i]] < 2) continue;
      const double e = std::max(excess(s, nodes, freed, i, to), sunk(s, nodes, i, convexity[nodes.point[i]]));
      if (e > most) most = e, worst = i;
    }
    if (!(most > 0)) return freed;
    // To free a node is to eliminate it.
    const auto w = static_cast<Eigen::Index>(worst);
    const Eigen::VectorXd column = s.col(w);
    s -= column * column.transpose() / column[w];
    freed[worst] = 1;
    --members[nodes.group[worst]];
  }
}

}  // namespace ts::field
