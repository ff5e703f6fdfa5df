#include "tooth/fields.h"

#include <algorithm>

namespace ts::tooth {
namespace {

// Node values for "1 on `group`, 0 on what else is held".
Vec<double> held_for(const Prepared &p, const Pick &pick, Index group) {
  Vec<double> held(p.nodes.size(), field::free_node);
  for (Index n = 0; n < p.nodes.size(); ++n) {
    const Index g = p.nodes.group[n];
    if (p.outlier[n]) continue;
    const bool rest = g == field::gingiva_group || p.options.background == Background::all;
    if (g == group)
      held[n] = 1;
    else if (rest || g == pick.target || g == pick.neighbour)
      held[n] = 0;
  }
  return held;
}

field::Solution solve(const Prepared &p, const Pick &pick, Index group) {
  const Vec<double> held = held_for(p, pick, group);
  if (p.border) return p.border->extend(p.border->solve_nodes(held, p.options.alpha));
  return p.solver->extend(p.solver->solve_nodes(held, p.options.alpha));
}

}  // namespace

Fields::Fields(const Prepared &p, const Pick &pick, bool whole) : prepared_(p), target_(solve(p, pick, pick.target)) {
  if (pick.neighbour != mesh::none) neighbour_.emplace(solve(p, pick, pick.neighbour));
  if (!whole) return;
  target_.evaluate_all();
  if (neighbour_) neighbour_->evaluate_all();
}

Vec<double> Fields::all_of_u() {
  Vec<double> all(prepared_.surface->vertices());
  for (Index v = 0; v < all.size(); ++v) all[v] = u(v);
  return all;
}

std::size_t Fields::bytes() const {
  return target_.bytes() + (neighbour_ ? neighbour_->bytes() : 0);
}

double Fields::milliseconds() const {
  const double target = target_.milliseconds(), neighbour = neighbour_ ? neighbour_->milliseconds() : 0;
  return prepared_.executor->threads() > 1 ? std::max(target, neighbour) : target + neighbour;
}

bool own_field_decides(const Options &o) {
  return o.background == Background::all && o.cut_rule != CutRule::gradient;
}

}  // namespace ts::tooth
