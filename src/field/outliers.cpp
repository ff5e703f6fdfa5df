#include "field/outliers.h"

namespace ts::field {
namespace {

// By how much another tooth's share of node i's conductance exceeds its own tooth's; <= 0 if i is no outlier.
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
    if (k != nodes.group[i] && to[k] > 0.5 * all) most = (to[k] - to[nodes.group[i]]) / all;
  return most;
}

}  // namespace

Vec<std::uint8_t> find_outliers(const Solver &solver, const Nodes &nodes) {
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
      const double e = excess(s, nodes, freed, i, to);
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
