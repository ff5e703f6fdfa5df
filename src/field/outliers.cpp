#include "field/outliers.h"

namespace ts::field {

Vec<std::uint8_t> find_outliers(const Solver &solver, const Nodes &nodes) {
  const Eigen::MatrixXd &s = solver.schur();
  const std::size_t n = nodes.size();
  Vec<Index> members(nodes.groups, 0);
  for (const Index g : nodes.group)
    if (g != gingiva_group) ++members[g];
  Vec<std::uint8_t> outlier(n, 0);
  Vec<double> to(nodes.groups + 1);  // conductance to each tooth; the last is the gingiva
  for (std::size_t i = 0; i < n; ++i) {
    if (nodes.group[i] == gingiva_group || members[nodes.group[i]] < 2) continue;
    std::fill(to.begin(), to.end(), 0);
    double all = 0;
    for (std::size_t j = 0; j < n; ++j) {
      if (j == i) continue;
      const double g = -s(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j));
      to[nodes.group[j] == gingiva_group ? nodes.groups : nodes.group[j]] += g;
      all += g;
    }
    for (std::size_t k = 0; k < nodes.groups; ++k)
      if (k != nodes.group[i] && to[k] > 0.5 * all && to[k] > to[nodes.group[i]]) outlier[i] = 1;
  }
  // Should all points of a tooth be outliers, then it is no single point that is wrong: keep them.
  Vec<Index> kept(nodes.groups, 0);
  for (std::size_t i = 0; i < n; ++i)
    if (nodes.group[i] != gingiva_group && !outlier[i]) ++kept[nodes.group[i]];
  for (std::size_t i = 0; i < n; ++i)
    if (nodes.group[i] != gingiva_group && kept[nodes.group[i]] == 0) outlier[i] = 0;
  return outlier;
}

}  // namespace ts::field
