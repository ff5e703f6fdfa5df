#include "field/solution.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstring>

#include "field/dense.h"

namespace ts::field {
namespace {

void prefetch(const double *begin, const double *end) {
#if defined(__GNUC__)
  for (; begin < end; begin += 8) __builtin_prefetch(begin);
#else
  static_cast<void>(begin);
  static_cast<void>(end);
#endif
}

}  // namespace

Solution::Space::Space(const Factor &f)
    : x(std::size_t{f.interior()} + f.nodes(), std::bit_cast<double>(kUnset)),
      done(f.tiles().size(), 0),
      made(f.chunks()),
      factor(&f) {
  tiles.reserve(f.tiles().size());
  std::size_t most = 0;
  for (const Part &p : f.parts()) most = std::max<std::size_t>(most, p.end - p.begin);
  sums.resize(2 * most);
}

void Solution::Space::clear() noexcept {
  for (const Index i : tiles) {
    const Factor::Tile &t = factor->tiles()[i];
    std::fill(x.begin() + t.first, x.begin() + t.end, std::bit_cast<double>(kUnset));
    done[i] = 0;
    made[t.chunk] = {};
  }
  tiles.clear();
}

Solution::Solution(const Factor &factor, Pool<Space> &pool, std::span<const double> at_nodes, Dark dark, Source source)
    : factor_(&factor),
      space_(pool.take([&] { return std::make_unique<Space>(factor); })),
      dark_(std::move(dark)),
      source_(std::move(source)) {
  std::ranges::transform(at_nodes, space_->x.begin() + factor.interior(),
                         [](double value) { return std::isnan(value) ? 0 : value; });
}

// With a value all others of its tile: what is asked of next lies beside it.
void Solution::evaluate(Index tile) {
  const auto begin = std::chrono::steady_clock::now();
  Space &s = *space_;
  const std::size_t before = s.tiles.size();
  for (Index t = tile; t != mesh::none && !s.done[t]; t = factor_->tiles()[t].parent) s.tiles.push_back(t);
  for (std::size_t i = s.tiles.size(); i-- > before;) {
    substitute(factor_->tiles()[s.tiles[i]]);
    s.done[s.tiles[i]] = 1;
  }
  milliseconds_ += std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin).count();
}

void Solution::evaluate_all() {
  for (Index i = 0; i < factor_->tiles().size(); ++i)
    if (!space_->done[i]) evaluate(i);
}

// x = -(L21 L11^-1)^T x_rows, and L11^-T of the source.
void Solution::substitute(const Factor::Tile &tile) {
  // Doubles that are asked for ahead of use, across the end of a tile too: the next one is likely to be wanted next.
  constexpr std::size_t kAhead = 512;
  Space &s = *space_;
  const double *at = tile.records;
  if (!at) {
    Block &made = s.made[tile.chunk];
    if (!made) made = factor_->make(tile.chunk);
    at = made.data() + tile.offset;
  }
  const double *const end = at + tile.doubles;
  prefetch(at, at + kAhead);
  double *const x = s.x.data();
  const DenseKernels &kernels = dense_kernels();
  while (at < end) {
    Factor::Record record;
    std::memcpy(&record, at, sizeof record);
    const double *const next = at + record.doubles();
    prefetch(at + kAhead, next + kAhead);
    const auto *const rows = reinterpret_cast<const Index *>(at + Factor::Record::rows());
    kernels.minus_product(at + record.matrix(), record.count, record.columns, rows, x, x + record.begin);
    if (!source_.part.empty()) add_source(record);
    at = next;
  }
  bytes_ += tile.doubles * sizeof(double);
}

void Solution::add_source(const Factor::Record &record) {
  const Index part = record.part;
  const std::span<const double> source = source_[part];
  if (source.empty()) return;
  Space &s = *space_;
  const Factor::Panel panel = factor_->panel(part, s.made[factor_->chunk_of(part)]);
  double *const x = s.x.data() + record.begin, *const t = s.sums.data();
  for (std::size_t j = panel.columns; j-- > 0;) {  // L11^T t = source
    t[j] = source[j];
    const double *below = panel.below(j);
    for (std::size_t i = j + 1; i < panel.columns; ++i) t[j] -= below[i - j - 1] * t[i];
    t[j] *= panel.inverse[j];
    x[j] += t[j];
  }
}

}  // namespace ts::field
