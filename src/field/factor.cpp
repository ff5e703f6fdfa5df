#include "field/factor.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstring>

#include "base/error.h"
#include "field/dense.h"

namespace ts::field {
namespace {

// Subtrees of at most this many unknowns are chunks: few enough that one can be made again within a click, and many
// chunks, so that all threads have work.
constexpr Index kChunk = 6000;

// Subtrees of at most this many unknowns are tiles, which are solved for together: of 64 to 512 this is the quickest.
constexpr Index kTile = 256;

constexpr std::size_t padded(std::size_t n) {
  return (n + 7) / 8 * 8;
}

// Of a panel, what is not of the rows that it touches. Eight at least, and they lie behind those: DenseKernels reads
// on.
std::size_t own_doubles(std::size_t columns) {
  return padded(columns + columns * (columns - 1) / 2);
}

std::size_t packed(std::size_t rows) {
  return rows * (rows + 1) / 2;
}

}  // namespace

// Fronts and the updates of the parts whose parents have not come yet: those of a chunk in order are a stack.
struct Factor::Space {
  Block front, below;  // `below`: the rows that a part touches
  Vec<double> stack;
  Vec<std::size_t> to;
  std::size_t ld = 0;  // of the front

  explicit Space(const Factor &f) : front(padded(f.most_unknowns_) * f.most_unknowns_), below(f.most_below_) {}
  void clear() noexcept {}
  void begin(std::size_t m) {
    ld = padded(m);
    std::fill_n(front.data(), ld * m, 0.0);
  }
  // What was eliminated of `m` unknowns last leaves on those after the first k: the lower triangle, packed by columns.
  void pack(std::size_t m, std::size_t k, double *u) const {
    for (std::size_t j = k; j < m; ++j) u = std::copy_n(front.data() + j * ld + j, m - j, u);
  }
};

Factor::Factor(Laplacian laplacian, Dissection dissection, std::span<const Index> place, std::size_t most_bytes,
               const Executor &executor, const Progress &progress)
    : surface_(&laplacian.surface),
      weight_(std::move(laplacian.edge_weight)),
      interior_(static_cast<Index>(dissection.order.size())),
      nodes_(laplacian.nodes),
      order_(std::move(dissection.order)),
      place_(place.begin(), place.end()),
      parts_(std::move(dissection.parts)) {
  corner_ = Eigen::MatrixXd::Zero(nodes_, nodes_);
  for (std::size_t e = 0; e < weight_.size(); ++e) {
    const auto [a, b] = surface_->edge[e];
    const Index i = laplacian.node_of[a], j = laplacian.node_of[b];
    if (i == mesh::none || j == mesh::none || i == j) continue;
    corner_(i, j) -= weight_[e];
    corner_(j, i) -= weight_[e];
  }
  if (parts_.empty()) return;
  find_chunks();
  find_rows(executor);
  lay_out();
  keep(most_bytes);
  progress(0.2);
  const auto begin = std::chrono::steady_clock::now();
  eliminate_all(executor, progress.part(0.2, 1, "factorisation"));
  elimination_ms_ = std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin).count();
  // Nothing has to be made again?
  if (std::ranges::all_of(chunk_, [](const Chunk &c) { return c.panels != nullptr; })) weight_ = {}, order_ = {};
}

void Factor::find_chunks() {
  chunk_of_.assign(parts_.size(), mesh::none);
  const auto size = [&](Index part) { return parts_[part].end - parts_[part].first; };
  for (Index i = 0, first = 0; i < parts_.size(); ++i) {
    const Index up = parts_[i].parent;
    if (size(i) > kChunk) {
      first = i + 1;
      continue;
    }
    if (up != mesh::none && size(up) <= kChunk) continue;
    for (Index p = first; p <= i; ++p) chunk_of_[p] = static_cast<Index>(chunk_.size());
    chunk_.push_back({first, i + 1});
    first = i + 1;
  }
  for (Index &c : chunk_of_)
    if (c == mesh::none) c = static_cast<Index>(chunk_.size());
  chunk_.emplace_back();
}

// The rows of a part are those of its children and what its own vertices touch, less its own.
void Factor::find_rows(const Executor &executor) {
  const Index below = chunks() - 1;
  Vec<mesh::Rows> rows(chunks());  // those of a chunk's parts, in order
  Vec<Index> place_in(parts_.size());
  for (Index i = 0; i < parts_.size(); ++i) place_in[i] = chunk_of_[i] < below ? i - chunk_[chunk_of_[i]].first : 0;
  for (Index i = 0, n = 0; i < parts_.size(); ++i)
    if (chunk_of_[i] == below) place_in[i] = n++;
  const auto add = [&](Index i) {
    const Part &p = parts_[i];
    mesh::Rows &to = rows[chunk_of_[i]];
    if (to.start.empty()) to.start.push_back(0);
    Vec<Index> own, united;
    for (Index c = p.begin; c < p.end; ++c) {
      for (const Index e : surface_->vertex_edges[order_[c]])
        if (const Index q = place_[surface_->other_end(e, order_[c])]; q >= p.end) own.push_back(q);
    }
    std::sort(own.begin(), own.end());
    own.erase(std::unique(own.begin(), own.end()), own.end());
    for (const Index child : p.children) {
      if (child == mesh::none) continue;
      std::span<const Index> of = rows[chunk_of_[child]][place_in[child]];
      of = of.subspan(static_cast<std::size_t>(std::ranges::lower_bound(of, p.end) - of.begin()));
      united.clear();
      std::set_union(own.begin(), own.end(), of.begin(), of.end(), std::back_inserter(united));
      own.swap(united);
    }
    to.item.insert(to.item.end(), own.begin(), own.end());
    to.start.push_back(static_cast<Index>(to.item.size()));
  };
  executor.each(below, [&](std::size_t c) {
    for (Index i = chunk_[c].first; i < chunk_[c].end; ++i) add(i);
  });
  for (Index i = 0; i < parts_.size(); ++i)
    if (chunk_of_[i] == below) add(i);
  std::size_t all = 0;
  for (const mesh::Rows &r : rows) all += r.item.size();
  rows_.item.reserve(all);
  rows_.start.reserve(parts_.size() + 1);
  for (Index i = 0; i < parts_.size(); ++i) {
    const std::span<const Index> r = rows[chunk_of_[i]][place_in[i]];
    rows_.start.push_back(static_cast<Index>(rows_.item.size()));
    rows_.item.insert(rows_.item.end(), r.begin(), r.end());
    most_below_ = std::max(most_below_, padded(r.size()) * (parts_[i].end - parts_[i].begin));
    most_unknowns_ = std::max(most_unknowns_, r.size() + parts_[i].end - parts_[i].begin);
  }
  rows_.start.push_back(static_cast<Index>(rows_.item.size()));
}

Factor::Record Factor::record(Index part) const {
  const Part &p = parts_[part];
  return {part, p.begin, p.end - p.begin, static_cast<Index>(rows_[part].size())};
}

// A chunk begins with the records of its tiles; the rest of its panels comes after them.
void Factor::lay_out() {
  offset_.resize(parts_.size());
  own_offset_.resize(parts_.size());
  tile_of_.resize(interior_);
  Vec<Index> tile(parts_.size());
  const auto size = [&](Index part) { return parts_[part].end - parts_[part].first; };
  for (Index i = static_cast<Index>(parts_.size()); i-- > 0;) {
    const Part &p = parts_[i];
    Chunk &c = chunk_[chunk_of_[i]];
    if (p.parent != mesh::none && size(p.parent) <= kTile) {
      tile[i] = tile[p.parent];
    } else {
      tile[i] = static_cast<Index>(tile_.size());
      tile_.push_back(
          {nullptr, c.doubles, 0, p.end, p.end, p.parent == mesh::none ? p.parent : tile[p.parent], chunk_of_[i]});
    }
    Tile &t = tile_[tile[i]];
    offset_[i] = c.doubles;
    t.doubles += record(i).doubles();
    c.doubles += record(i).doubles();
    t.first = p.begin;
    std::fill(tile_of_.begin() + p.begin, tile_of_.begin() + p.end, tile[i]);
  }
  for (Index i = static_cast<Index>(parts_.size()); i-- > 0;) {
    Chunk &c = chunk_[chunk_of_[i]];
    own_offset_[i] = c.doubles;
    c.doubles += own_doubles(parts_[i].end - parts_[i].begin);
  }
}

void Factor::keep(std::size_t most_bytes) {
  const std::size_t structure = bytes(), above = chunk_.back().doubles;
  const std::size_t most = most_bytes > structure ? (most_bytes - structure) / sizeof(double) : 0;
  if (above > most)
    throw Error(Fault::out_of_memory, "memory_limit: the factor needs " +
                                          std::to_string(structure + above * sizeof(double)) + " bytes at least, " +
                                          std::to_string(most_bytes) + " are left to it");
  kept_doubles_ = above;
  Index chunk = 0;
  for (; chunk + 1 < chunks() && chunk_[chunk].doubles <= most - kept_doubles_; ++chunk)
    kept_doubles_ += chunk_[chunk].doubles;
  kept_ = Block(kept_doubles_);
  double *at = kept_.data();
  chunk_.back().panels = at;
  at += above;
  for (Index c = 0; c < chunk; ++c) {
    chunk_[c].panels = at;
    at += chunk_[c].doubles;
  }
  for (Tile &t : tile_)
    if (const double *const panels = chunk_[t.chunk].panels) t.records = panels + t.offset;
}

std::size_t Factor::left_out_bytes() const {
  std::size_t doubles = 0;
  for (const Chunk &c : chunk_)
    if (!c.panels) doubles += c.doubles;
  return sizeof(double) * doubles;
}

std::size_t Factor::bytes() const {
  const std::size_t indices =
      place_.size() + order_.size() + chunk_of_.size() + tile_of_.size() + rows_.start.size() + rows_.item.size();
  return sizeof(double) * (kept_doubles_ + weight_.size()) + sizeof(Index) * indices +
         (sizeof(Part) + 2 * sizeof(std::size_t)) * parts_.size() + sizeof(Tile) * tile_.size();
}

Index Factor::part_of(Index place) const {
  return static_cast<Index>(std::ranges::upper_bound(parts_, place, {}, &Part::begin) - parts_.begin()) - 1;
}

Factor::Panel Factor::panel(Index part, const Block &made) const {
  const Chunk &c = chunk_[chunk_of_[part]];
  const std::size_t k = parts_[part].end - parts_[part].begin;
  const double *at = c.panels ? c.panels : made.data(), *own = at + own_offset_[part];
  return {own, own + k, at + offset_[part] + record(part).matrix(), k};
}

Block Factor::make(Index chunk) const {
  Block made(chunk_[chunk].doubles);
  Space space(*this);
  eliminate_chunk(chunk, made.data(), space);
  return made;
}

void Factor::eliminate_all(const Executor &executor, const Progress &progress) {
  const Index below = chunks() - 1;
  Vec<Vec<double>> updates(parts_.size());  // of the roots of chunks, and of what is above
  Pool<Space> spaces;
  const auto space = [&] { return spaces.take([&] { return std::make_unique<Space>(*this); }); };
  std::atomic<Index> done{0};
  executor.each(below, [&](std::size_t c) {
    const auto s = space();
    const Chunk &chunk = chunk_[c];
    Block made;
    if (!chunk.panels) made = Block(chunk.doubles);
    eliminate_chunk(static_cast<Index>(c), chunk.panels ? chunk.panels : made.data(), *s);
    updates[chunk.end - 1].assign(s->stack.begin(), s->stack.begin() + packed(rows_[chunk.end - 1].size()));
    progress(0.75 * ++done / below);
  });
  const Index root = static_cast<Index>(parts_.size() - 1);
  if (chunk_of_[root] == below) updates[root] = eliminate_above(root, updates, spaces, executor, progress);
  const std::span<const Index> rows = rows_[root];
  for (std::size_t j = 0, k = 0; j < rows.size(); ++j)
    for (std::size_t i = j; i < rows.size(); ++i, ++k) {
      if (i == j) continue;
      corner_(rows[i] - interior_, rows[j] - interior_) += updates[root][k];
      corner_(rows[j] - interior_, rows[i] - interior_) += updates[root][k];
    }
  progress(1);
}

// Children are independent of each other, and of these there are few, with large fronts.
Vec<double> Factor::eliminate_above(Index part, Vec<Vec<double>> &updates, Pool<Space> &spaces,
                                    const Executor &executor, const Progress &progress) const {
  const Part &p = parts_[part];
  executor.each(2, [&](std::size_t k) {
    const Index child = p.children[k];
    if (child != mesh::none && chunk_of_[child] == chunk_of_[part])
      updates[child] = eliminate_above(child, updates, spaces, executor, progress);
  });
  progress(0.75);
  const auto s = spaces.take([&] { return std::make_unique<Space>(*this); });
  const auto of = [&](Index child) { return child == mesh::none ? nullptr : updates[child].data(); };
  eliminate(part, of(p.children[0]), of(p.children[1]), chunk_.back().panels, *s);
  for (const Index child : p.children)
    if (child != mesh::none) updates[child] = {};
  const std::size_t r = rows_[part].size(), k = p.end - p.begin;
  Vec<double> update(packed(r));
  s->pack(k + r, k, update.data());
  return update;
}

void Factor::eliminate_chunk(Index chunk, double *panels, Space &s) const {
  std::size_t top = 0;
  for (Index i = chunk_[chunk].first; i < chunk_[chunk].end; ++i) {
    const Part &p = parts_[i];
    const double *of[2] = {nullptr, nullptr};
    for (int k = 1; k >= 0; --k)  // the second child's lies on top
      if (p.children[k] != mesh::none) {
        top -= packed(rows_[p.children[k]].size());
        of[k] = s.stack.data() + top;
      }
    eliminate(i, of[0], of[1], panels, s);
    const std::size_t r = rows_[i].size(), k = p.end - p.begin;
    if (s.stack.size() < top + packed(r)) s.stack.resize(std::max(2 * s.stack.size(), top + packed(r)));
    s.pack(k + r, k, s.stack.data() + top);
    top += packed(r);
  }
}

// One part: its rows of the matrix and the updates of its children, added up and eliminated.
void Factor::eliminate(Index part, const double *left, const double *right, double *panels, Space &s) const {
  const Part &p = parts_[part];
  const std::span<const Index> rows = rows_[part];
  const std::size_t k = p.end - p.begin, r = rows.size(), m = k + r;
  s.begin(m);
  double *const front = s.front.data();
  const std::size_t ld = s.ld;
  for (std::size_t j = 0; j < k; ++j) {
    const Index v = order_[p.begin + j];
    double *column = front + j * ld;
    for (const Index e : surface_->vertex_edges[v]) {
      const Index q = place_[surface_->other_end(e, v)];
      column[j] += weight_[e];
      if (q >= p.end)
        column[k + static_cast<std::size_t>(std::ranges::lower_bound(rows, q) - rows.begin())] -= weight_[e];
      else if (q > p.begin + j)
        column[q - p.begin] -= weight_[e];
    }
  }
  const auto add = [&](Index child, const double *u) {
    if (child == mesh::none) return;
    const std::span<const Index> from = rows_[child];
    s.to.resize(from.size());
    for (std::size_t i = 0, at = 0; i < from.size(); ++i) {
      if (from[i] < p.end) {
        s.to[i] = from[i] - p.begin;
        continue;
      }
      while (rows[at] < from[i]) ++at;
      s.to[i] = k + at;
    }
    const std::size_t *const to = s.to.data();
    for (std::size_t j = 0; j < from.size(); ++j) {
      double *column = front + to[j] * ld;
      for (std::size_t i = j; i < from.size(); ++i) column[to[i]] += *u++;
    }
  };
  add(p.children[0], left);
  add(p.children[1], right);
  if (!dense_kernels().eliminate(front, ld, m, k))
    throw Error(Fault::solver, "the Laplacian could not be factorised: weights not positive and finite");

  const Record head = record(part);
  double *const begin = panels + offset_[part], *const inverse = panels + own_offset_[part];
  std::memcpy(begin, &head, sizeof head);
  std::memcpy(begin + Record::rows(), rows.data(), rows.size_bytes());
  double *out = inverse;
  for (std::size_t j = 0; j < k; ++j) *out++ = 1 / front[j * ld + j];
  for (std::size_t j = 0; j < k; ++j) out = std::copy_n(front + j * ld + j + 1, k - j - 1, out);
  const std::size_t stride = padded(r);
  out = s.below.data();
  for (std::size_t j = 0; j < k; ++j) {
    out = std::copy_n(front + j * ld + k, r, out);
    out = std::fill_n(out, stride - r, 0.0);
  }
  dense_kernels().divide(s.below.data(), stride, k, front, ld, inverse);
  dense_kernels().transpose(s.below.data(), stride, r, k, begin + head.matrix());
}

}  // namespace ts::field
