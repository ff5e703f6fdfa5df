#include "field/solution.h"

#include <algorithm>
#include <chrono>
#include <cmath>

#include "field/dense.h"

namespace ts::field {
namespace {

void prefetch(const Factor::Step &step) {
#if defined(__GNUC__)
  if (!step.touched) return;
  const std::size_t doubles = std::size_t{step.columns} * step.stride;
  for (std::size_t i = 0; i < doubles; i += 8) __builtin_prefetch(step.touched + i);
#else
  static_cast<void>(step);
#endif
}

}  // namespace

Solution::Space::Space(const Factor &f)
    : x(std::size_t{f.interior()} + f.nodes(), std::bit_cast<double>(kUnset)),
      done(f.parts().size(), 0),
      made(f.chunks()),
      gathered((f.most_rows() + 7) / 8 * 8, 0),
      factor(&f) {
  parts.reserve(f.parts().size());
  std::size_t most = 0;
  for (const Part &p : f.parts()) most = std::max<std::size_t>(most, p.end - p.begin);
  sums.resize(2 * most);
}

void Solution::Space::clear() noexcept {
  for (const Index i : parts) {
    const Part &p = factor->parts()[i];
    std::fill(x.begin() + p.begin, x.begin() + p.end, std::bit_cast<double>(kUnset));
    done[i] = 0;
    made[factor->chunk_of(i)] = {};
  }
  parts.clear();
}

Solution::Solution(const Factor &factor, Pool<Space> &pool, std::span<const double> at_nodes, Dark dark, Source source)
    : factor_(&factor),
      space_(pool.take([&] { return std::make_unique<Space>(factor); })),
      dark_(std::move(dark)),
      source_(std::move(source)) {
  std::ranges::transform(at_nodes, space_->x.begin() + factor.interior(),
                         [](double value) { return std::isnan(value) ? 0 : value; });
}

// With a part all others of its tile: what is asked of next lies beside it, and the panels of a tile lie in one piece.
void Solution::evaluate(Index part) {
  const auto begin = std::chrono::steady_clock::now();
  Space &s = *space_;
  const Index tile = factor_->tile_of(part);
  const std::size_t before = s.parts.size();
  for (Index p = tile; p != mesh::none && !s.done[p]; p = factor_->parts()[p].parent) s.parts.push_back(p);
  std::reverse(s.parts.begin() + static_cast<std::ptrdiff_t>(before), s.parts.end());
  for (Index p = tile; p-- > 0 && factor_->tile_of(p) == tile;) s.parts.push_back(p);  // below its root, parents first
  // A part waits for the values of those above it, and would wait for its own panel after that.
  constexpr std::size_t kAhead = 4;
  for (std::size_t i = before; i < std::min(before + kAhead, s.parts.size()); ++i) prefetch(factor_->step(s.parts[i]));
  for (std::size_t i = before; i < s.parts.size(); ++i) {
    if (i + kAhead < s.parts.size()) prefetch(factor_->step(s.parts[i + kAhead]));
    substitute(s.parts[i]);
  }
  milliseconds_ += std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin).count();
}

void Solution::evaluate_all() {
  for (Index i = static_cast<Index>(factor_->parts().size()); i-- > 0;)
    if (!space_->done[i]) evaluate(i);
}

// x = -(L21 L11^-1)^T x_rows, and L11^-T of the source.
void Solution::substitute(Index part) {
  Space &s = *space_;
  const Factor::Step &step = factor_->step(part);
  const double *touched = step.touched;
  if (!touched) {
    Block &made = s.made[factor_->chunk_of(part)];
    if (!made) made = factor_->make(factor_->chunk_of(part));
    touched = factor_->panel(part, made).touched;
  }
  double *const gathered = s.gathered.data(), *const x = s.x.data();
  for (Index i = 0; i < step.count; ++i) gathered[i] = x[step.rows[i]];
  for (Index i = step.count; i < step.stride; ++i) gathered[i] = 0;
  dense_kernels().minus_dots(touched, step.stride, step.columns, gathered, x + step.begin);
  bytes_ += step.bytes();
  s.done[part] = 1;
  if (!source_.part.empty()) add_source(part);
}

void Solution::add_source(Index part) {
  const std::span<const double> source = source_[part];
  if (source.empty()) return;
  Space &s = *space_;
  const Factor::Panel panel = factor_->panel(part, s.made[factor_->chunk_of(part)]);
  double *const x = s.x.data() + factor_->parts()[part].begin, *const t = s.sums.data();
  for (std::size_t j = panel.columns; j-- > 0;) {  // L11^T t = source
    t[j] = source[j];
    const double *below = panel.below(j);
    for (std::size_t i = j + 1; i < panel.columns; ++i) t[j] -= below[i - j - 1] * t[i];
    t[j] *= panel.inverse[j];
    x[j] += t[j];
  }
}

}  // namespace ts::field
