#include "field/factor.h"

#include <algorithm>
#include <atomic>
#include <cmath>

#include "base/error.h"
#include "field/dense.h"
#include "mesh/rows.h"

namespace ts::field {
namespace {

// Subtrees of this many unknowns are chunks: small enough that one can be made again within a click.
constexpr std::size_t kChunk = 6000;

constexpr std::size_t padded(std::size_t n) {
  return (n + 7) / 8 * 8;
}

std::size_t own_doubles(std::size_t k) {
  return padded(k + k * (k - 1) / 2);
}

// Calls body(part) for a subtree, children first; large halves at the same time.
void bottom_up(const Vec<Part> &parts, Index part, const Executor &executor, const auto &body) {
  constexpr Index kParallel = 4096;
  const Part &p = parts[part];
  const auto go = [&](std::size_t k) {
    if (p.children[k] != mesh::none) bottom_up(parts, p.children[k], executor, body);
  };
  if (p.end - p.first > kParallel)
    executor.each(2, go);
  else
    go(0), go(1);
  body(part);
}

// a and b united, of both what is at least `from`; all ascending.
Vec<Index> unite(std::span<const Index> a, std::span<const Index> b, Index from) {
  a = a.subspan(static_cast<std::size_t>(std::ranges::lower_bound(a, from) - a.begin()));
  b = b.subspan(static_cast<std::size_t>(std::ranges::lower_bound(b, from) - b.begin()));
  Vec<Index> all(a.size() + b.size());
  const auto end = std::set_union(a.begin(), a.end(), b.begin(), b.end(), all.begin());
  all.resize(static_cast<std::size_t>(end - all.begin()));
  return all;
}

}  // namespace

Factor::Factor(const Laplacian &laplacian, Dissection dissection, std::span<const Index> place, std::size_t most_bytes,
               const Executor &executor, const Progress &progress)
    : interior_(static_cast<Index>(dissection.order.size())),
      nodes_(laplacian.nodes),
      place_(place.begin(), place.end()),
      parts_(std::move(dissection.parts)) {
  corner_ = Eigen::MatrixXd::Zero(nodes_, nodes_);
  for (std::size_t e = 0; e < laplacian.edge_weight.size(); ++e) {
    const auto [a, b] = laplacian.surface.edge[e];
    const Index i = laplacian.node_of[a], j = laplacian.node_of[b];
    if (i == mesh::none || j == mesh::none || i == j) continue;
    corner_(i, j) -= laplacian.edge_weight[e];
    corner_(j, i) -= laplacian.edge_weight[e];
  }
  if (parts_.empty()) return;
  find_rows(laplacian.surface, dissection.order, executor);
  lay_out();
  keep(most_bytes);
  collect_entries(laplacian, dissection.order, executor);
  progress(0.1);

  const Index root = static_cast<Index>(parts_.size() - 1);
  Block made;  // a small surface is one chunk
  if (is_below(root) && !kept(chunk_of_[root])) made = Block(chunk_[chunk_of_[root]].doubles);
  const Vec<double> update = eliminate(root, made, &executor, &progress);
  const std::span<const Index> rows = rows_[root];
  for (std::size_t j = 0, k = 0; j < rows.size(); ++j)
    for (std::size_t i = j; i < rows.size(); ++i, ++k) {
      if (i == j) continue;
      corner_(rows[i] - interior_, rows[j] - interior_) += update[k];
      corner_(rows[j] - interior_, rows[i] - interior_) += update[k];
    }
  if (std::ranges::all_of(chunk_, [](const Chunk &c) { return static_cast<bool>(c.panels); })) entries_ = {};
}

void Factor::find_rows(const mesh::Surface &surface, std::span<const Index> order, const Executor &executor) {
  Vec<Vec<Index>> rows(parts_.size());
  part_of_.resize(interior_);
  bottom_up(parts_, static_cast<Index>(parts_.size() - 1), executor, [&](Index i) {
    const Part &p = parts_[i];
    Vec<Index> own;
    for (Index c = p.begin; c < p.end; ++c) {
      part_of_[c] = i;
      for (const Index e : surface.vertex_edges[order[c]])
        if (const Index q = place_[surface.other_end(e, order[c])]; q >= p.end) own.push_back(q);
    }
    std::sort(own.begin(), own.end());
    own.erase(std::unique(own.begin(), own.end()), own.end());
    for (const Index c : p.children)
      if (c != mesh::none) own = unite(own, rows[c], p.end);
    rows[i] = std::move(own);
  });
  rows_.start.resize(parts_.size() + 1);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    rows_.start[i] = static_cast<Index>(rows_.item.size());
    rows_.item.insert(rows_.item.end(), rows[i].begin(), rows[i].end());
    most_rows_ = std::max(most_rows_, rows[i].size());
  }
  rows_.start.back() = static_cast<Index>(rows_.item.size());
}

void Factor::lay_out() {
  chunk_of_.assign(parts_.size(), mesh::none);
  for (Index i = 0; i < parts_.size(); ++i) {
    const auto size = [&](Index part) { return parts_[part].end - parts_[part].first; };
    const Index up = parts_[i].parent;
    if (size(i) > kChunk || (up != mesh::none && size(up) <= kChunk)) continue;
    const Index first = chunk_.empty() ? 0 : chunk_.back().root + 1;
    Chunk chunk;
    chunk.root = i;
    chunk.first = i;
    while (chunk.first > first && parts_[chunk.first - 1].first >= parts_[i].first) --chunk.first;
    for (Index p = chunk.first; p <= i; ++p) chunk_of_[p] = static_cast<Index>(chunk_.size());
    chunk_.push_back(std::move(chunk));
  }
  chunk_.emplace_back();  // what is above
  offset_.resize(parts_.size());
  for (Index i = 0; i < parts_.size(); ++i) {
    if (chunk_of_[i] == mesh::none) chunk_of_[i] = static_cast<Index>(chunk_.size() - 1);
    Chunk &c = chunk_[chunk_of_[i]];
    const std::size_t k = parts_[i].end - parts_[i].begin;
    offset_[i] = c.doubles;
    c.doubles += own_doubles(k) + k * padded(rows_[i].size());
  }
}

std::size_t Factor::panel_bytes(Index part) const {
  const std::size_t k = parts_[part].end - parts_[part].begin;
  return sizeof(double) * (own_doubles(k) + k * padded(rows_[part].size()));
}

void Factor::keep(std::size_t most_bytes) {
  std::size_t left = most_bytes;
  const auto take = [&](Chunk &c) {
    const std::size_t bytes = c.doubles * sizeof(double);
    if (bytes > left) return false;
    left -= bytes;
    c.panels = Block(c.doubles);
    return true;
  };
  if (!take(chunk_.back()))
    throw Error(Fault::out_of_memory, "memory_limit: the factor needs " +
                                          std::to_string(chunk_.back().doubles * sizeof(double)) + " bytes at least, " +
                                          std::to_string(most_bytes) + " are left to it");
  for (std::size_t c = 0; c + 1 < chunk_.size(); ++c)
    if (!take(chunk_[c])) break;
}

std::size_t Factor::bytes() const {
  std::size_t sum = place_.size() * sizeof(Index) +
                    parts_.size() * (sizeof(Part) + sizeof(Index) + sizeof(std::size_t)) +
                    part_of_.size() * sizeof(Index) + (rows_.start.size() + rows_.item.size()) * sizeof(Index) +
                    entries_.start.size() * sizeof(std::size_t) + entries_.place.size() * sizeof(Index) +
                    (entries_.value.size() + entries_.diagonal.size()) * sizeof(double);
  for (const Chunk &c : chunk_)
    if (c.panels) sum += c.doubles * sizeof(double);
  return sum;
}

void Factor::collect_entries(const Laplacian &l, std::span<const Index> order, const Executor &executor) {
  constexpr std::size_t kGrain = 4096;
  entries_.start.assign(std::size_t{interior_} + 1, 0);
  entries_.diagonal.resize(interior_);
  const auto later = [&](std::size_t c, const auto &visit) {
    for (const Index e : l.surface.vertex_edges[order[c]])
      if (const Index q = place_[l.surface.other_end(e, order[c])]; q > c) visit(q, l.edge_weight[e]);
  };
  executor.ranges(interior_, kGrain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t c = begin; c < end; ++c) {
      double sum = 0;
      for (const Index e : l.surface.vertex_edges[order[c]]) sum += l.edge_weight[e];
      entries_.diagonal[c] = sum;
      later(c, [&](Index, double) { ++entries_.start[c + 1]; });
    }
  });
  for (std::size_t c = 0; c < interior_; ++c) entries_.start[c + 1] += entries_.start[c];
  entries_.place.resize(entries_.start.back());
  entries_.value.resize(entries_.start.back());
  executor.ranges(interior_, kGrain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t c = begin; c < end; ++c) {
      std::size_t k = entries_.start[c];
      later(c, [&](Index q, double w) { entries_.place[k] = q, entries_.value[k++] = -w; });
    }
  });
}

double *Factor::place_of_panel(Index part, const Block &made) const {
  const Chunk &c = chunk_[chunk_of_[part]];
  return (c.panels ? c.panels : made).data() + offset_[part];
}

Factor::Panel Factor::panel(Index part, const Block &made) const {
  const std::size_t k = parts_[part].end - parts_[part].begin;
  const double *at = place_of_panel(part, made);
  return {at, at + k, at + own_doubles(k), k, padded(rows_[part].size())};
}

Block Factor::make(Index chunk) const {
  Block made(chunk_[chunk].doubles);
  eliminate(chunk_[chunk].root, made, nullptr, nullptr);
  return made;
}

Vec<double> Factor::eliminate(Index part, const Block &made, const Executor *executor, const Progress *progress) const {
  const Part &p = parts_[part];
  if (progress && (!is_below(part) || part == chunk_[chunk_of_[part]].root))
    (*progress)(0.1 + 0.9 * p.first / interior_);
  Vec<double> update[2];
  if (!is_below(part)) {
    // The children of what is above the chunks are independent of each other.
    executor->each(2, [&](std::size_t k) {
      const Index child = p.children[k];
      if (child == mesh::none) return;
      Block own;
      if (is_below(child) && !kept(chunk_of_[child])) own = Block(chunk_[chunk_of_[child]].doubles);
      update[k] = eliminate(child, own, executor, progress);
    });
  } else {
    for (std::size_t k = 0; k < 2; ++k)
      if (p.children[k] != mesh::none) update[k] = eliminate(p.children[k], made, nullptr, nullptr);
  }
  return eliminate_one(part, update[0], update[1], made);
}

Vec<double> Factor::eliminate_one(Index part, std::span<const double> left, std::span<const double> right,
                                  const Block &made) const {
  const Part &p = parts_[part];
  const std::span<const Index> rows = rows_[part];
  const std::size_t k = p.end - p.begin, r = rows.size(), m = k + r, ld = padded(m);
  Vec<double> front(ld * m, 0);
  const auto local = [&](Index q) {
    return q < p.end ? q - p.begin : k + static_cast<std::size_t>(std::ranges::lower_bound(rows, q) - rows.begin());
  };
  for (std::size_t j = 0; j < k; ++j) {
    const std::size_t c = p.begin + j;
    double *column = front.data() + j * ld;
    column[j] = entries_.diagonal[c];
    for (std::size_t e = entries_.start[c]; e < entries_.start[c + 1]; ++e)
      column[local(entries_.place[e])] += entries_.value[e];
  }
  Vec<std::size_t> to;
  const auto add = [&](Index child, std::span<const double> update) {
    if (child == mesh::none) return;
    const std::span<const Index> from = rows_[child];
    to.resize(from.size());
    for (std::size_t i = 0, at = 0; i < from.size(); ++i) {
      if (from[i] < p.end) {
        to[i] = from[i] - p.begin;
        continue;
      }
      while (rows[at] < from[i]) ++at;
      to[i] = k + at;
    }
    const double *u = update.data();
    for (std::size_t j = 0; j < from.size(); ++j) {
      double *column = front.data() + to[j] * ld;
      for (std::size_t i = j; i < from.size(); ++i) column[to[i]] += *u++;
    }
  };
  add(p.children[0], left);
  add(p.children[1], right);
  if (!dense_kernels().eliminate(front.data(), ld, m, k))
    throw Error(Fault::solver, "the Laplacian could not be factorised: weights not positive");

  double *out = place_of_panel(part, made);
  for (std::size_t j = 0; j < k; ++j) *out++ = 1 / front[j * ld + j];
  for (std::size_t j = 0; j < k; ++j) out = std::copy_n(front.data() + j * ld + j + 1, k - j - 1, out);
  out = std::fill_n(out, own_doubles(k) - k - k * (k - 1) / 2, 0.0);
  for (std::size_t j = 0; j < k; ++j) {
    out = std::copy_n(front.data() + j * ld + k, r, out);
    out = std::fill_n(out, padded(r) - r, 0.0);
  }
  Vec<double> update(r * (r + 1) / 2);
  double *u = update.data();
  for (std::size_t j = 0; j < r; ++j) u = std::copy_n(front.data() + (k + j) * ld + k + j, r - j, u);
  return update;
}

}  // namespace ts::field
