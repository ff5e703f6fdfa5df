#include "field/solver.h"

#include <Eigen/Cholesky>
#include <Eigen/OrderingMethods>
#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>
#include <algorithm>
#include <cmath>
#include <numeric>

namespace ts::field {
namespace {

using Sparse = Eigen::SparseMatrix<double, Eigen::ColMajor, int>;

// Fill-reducing order of the free vertices: place -> vertex.
Vec<Index> order_free(const mesh::Surface &surface, const Vec<Index> &free, const Vec<Index> &rank) {
  const int n = static_cast<int>(free.size());
  Sparse upper(n, n);
  Vec<int> count(free.size(), 1);
  const auto before = [&](Index i, const auto &visit) {
    for (const Index e : surface.vertex_edges[free[i]]) {
      const Index j = rank[surface.other_end(e, free[i])];
      if (j != mesh::none && j < i) visit(j);
    }
  };
  for (Index i = 0; i < free.size(); ++i) before(i, [&](Index) { ++count[i]; });
  upper.reserve(Eigen::Map<Eigen::VectorXi>(count.data(), n));
  for (Index i = 0; i < free.size(); ++i) {
    before(i, [&](Index j) { upper.insert(static_cast<int>(j), static_cast<int>(i)) = 1; });
    upper.insert(static_cast<int>(i), static_cast<int>(i)) = 1;
  }
  upper.makeCompressed();
  Eigen::PermutationMatrix<Eigen::Dynamic, Eigen::Dynamic, int> place;
  Eigen::AMDOrdering<int>()(upper.selfadjointView<Eigen::Upper>(), place);
  Vec<Index> order(free.size());
  for (int k = 0; k < n; ++k) order[static_cast<std::size_t>(k)] = free[static_cast<std::size_t>(place.indices()[k])];
  return order;
}

Vec<std::uint8_t> pieces_with_node(const mesh::Surface &surface, const Vec<Index> &node_of) {
  Vec<std::uint8_t> has(surface.components, 0);
  for (Index v = 0; v < surface.vertices(); ++v)
    if (node_of[v] != mesh::none && surface.vertex_component[v] != mesh::none) has[surface.vertex_component[v]] = 1;
  return has;
}

// Sets of nodes that S connects: the first node of each node's set.
Vec<Index> connected_sets(const Eigen::MatrixXd &s) {
  const Index n = static_cast<Index>(s.rows());
  Vec<Index> set(n, mesh::none), stack;
  for (Index i = 0; i < n; ++i) {
    if (set[i] != mesh::none) continue;
    stack.assign(1, i);
    set[i] = i;
    while (!stack.empty()) {
      const Index j = stack.back();
      stack.pop_back();
      for (Index k = 0; k < n; ++k)
        if (set[k] == mesh::none && s(j, k) != 0) set[k] = i, stack.push_back(k);
    }
  }
  return set;
}

// Brings the rows of each column into order and adds up what several edges from a vertex to a node give.
void merge_columns(Vec<int> &start, Vec<int> &row, Vec<double> &value) {
  Vec<std::pair<int, double>> column;
  std::size_t to = 0;
  for (std::size_t j = 0; j + 1 < start.size(); ++j) {
    column.clear();
    for (auto k = static_cast<std::size_t>(start[j]); k < static_cast<std::size_t>(start[j + 1]); ++k)
      column.emplace_back(row[k], value[k]);
    std::ranges::stable_sort(column, {}, &std::pair<int, double>::first);
    start[j] = static_cast<int>(to);
    for (std::size_t k = 0; k < column.size(); ++k) {
      if (k > 0 && column[k].first == column[k - 1].first) {
        value[to - 1] += column[k].second;
        continue;
      }
      row[to] = column[k].first;
      value[to++] = column[k].second;
    }
  }
  start.back() = static_cast<int>(to);
  row.resize(to);
  value.resize(to);
}

}  // namespace

Solver::Solver(const mesh::Surface &surface, const Vec<double> &edge_weight, const Nodes &nodes,
               const Progress &progress)
    : node_of_(nodes.of_vertex), slot_(surface.vertices(), mesh::none), nodes_(static_cast<Index>(nodes.size())) {
  const Vec<std::uint8_t> used = pieces_with_node(surface, node_of_);
  Vec<Index> free;
  for (Index v = 0; v < surface.vertices(); ++v) {
    const Index piece = surface.vertex_component[v];
    if (node_of_[v] != mesh::none || piece == mesh::none || !used[piece]) continue;
    slot_[v] = static_cast<Index>(free.size());
    free.push_back(v);
  }
  interior_ = static_cast<Index>(free.size());
  progress(0);
  const Vec<Index> order = order_free(surface, free, slot_);
  for (Index k = 0; k < order.size(); ++k) slot_[order[k]] = k;
  progress(0.25);
  factorise(surface, edge_weight, progress);
  progress(1);
}

void Solver::factorise(const mesh::Surface &surface, const Vec<double> &edge_weight, const Progress &progress) {
  const std::size_t n = interior_ + nodes_;
  const auto unknown = [&](Index v) {
    return node_of_[v] != mesh::none ? interior_ + node_of_[v] : slot_[v];  // none stays none
  };
  Vec<double> diagonal(n, 0);
  Vec<int> start(n + 1, 0);
  const auto upper_entries = [&](const auto &visit) {
    for (Index e = 0; e < surface.edge.size(); ++e) {
      const Index i = unknown(surface.edge[e][0]), j = unknown(surface.edge[e][1]);
      if (i == mesh::none || j == mesh::none || i == j) continue;
      visit(std::min(i, j), std::max(i, j), edge_weight[e]);
    }
  };
  upper_entries([&](Index i, Index j, double w) {
    diagonal[i] += w;
    diagonal[j] += w;
    ++start[j + 1];
  });
  const double sigma = std::accumulate(diagonal.begin(), diagonal.end(), 0.0) / static_cast<double>(n);
  for (std::size_t i = interior_; i < n; ++i) diagonal[i] += sigma;
  for (std::size_t i = 0; i < n; ++i) ++start[i + 1];
  std::partial_sum(start.begin(), start.end(), start.begin());
  Vec<int> row(static_cast<std::size_t>(start.back())), fill(start.begin(), start.end() - 1);
  Vec<double> value(row.size());
  upper_entries([&](Index i, Index j, double w) {
    const auto k = static_cast<std::size_t>(fill[j]++);
    row[k] = static_cast<int>(i);
    value[k] = -w;
  });
  for (std::size_t i = 0; i < n; ++i) {
    const auto k = static_cast<std::size_t>(fill[i]++);
    row[k] = static_cast<int>(i);
    value[k] = diagonal[i];
  }
  merge_columns(start, row, value);
  const Eigen::Map<const Sparse> matrix(static_cast<int>(n), static_cast<int>(n), static_cast<int>(row.size()),
                                        start.data(), row.data(), value.data());
  Eigen::SimplicialLLT<Sparse, Eigen::Upper, Eigen::NaturalOrdering<int>> factor;
  const Sparse copy = matrix;
  factor.analyzePattern(copy);
  progress(0.35);
  factor.factorize(copy);
  progress(0.9);
  if (factor.info() != Eigen::Success)
    throw Error(Fault::solver, "the Laplacian could not be factorised: weights not positive");

  const Sparse &l = factor.matrixL().nestedExpression();
  column_.resize(interior_ + 1);
  for (Index j = 0; j <= interior_; ++j) column_[j] = static_cast<std::size_t>(l.outerIndexPtr()[j]);
  row_.assign(l.innerIndexPtr(), l.innerIndexPtr() + column_[interior_]);
  value_.assign(l.valuePtr(), l.valuePtr() + column_[interior_]);

  Eigen::MatrixXd corner = Eigen::MatrixXd::Zero(nodes_, nodes_);
  for (int j = static_cast<int>(interior_); j < static_cast<int>(n); ++j)
    for (Sparse::InnerIterator it(l, j); it; ++it)
      corner(it.row() - static_cast<int>(interior_), j - static_cast<int>(interior_)) = it.value();
  schur_ = corner * corner.transpose();
  // The shift by sigma and the rounding of the long sums fall on the diagonal; constants are in the kernel of S
  // exactly.
  for (Index i = 0; i < nodes_; ++i) {
    schur_(i, i) = 0;
    schur_(i, i) = -schur_.row(i).sum();
  }
}

Eigen::VectorXd Solver::solve_nodes(std::span<const double> held, double alpha) const {
  const Vec<Index> set = connected_sets(schur_);
  Vec<std::uint8_t> anchored(nodes_, 0);
  for (Index i = 0; i < nodes_; ++i)
    if (!std::isnan(held[i])) anchored[set[i]] = 1;
  Eigen::VectorXd u = Eigen::VectorXd::Constant(nodes_, free_node);
  Vec<Index> unknown;
  for (Index i = 0; i < nodes_; ++i) {
    if (!anchored[set[i]]) continue;
    if (!std::isnan(held[i]) && alpha <= 0)
      u[i] = held[i];
    else
      unknown.push_back(i);
  }
  if (unknown.empty()) return u;
  const auto m = static_cast<Eigen::Index>(unknown.size());
  Eigen::MatrixXd a(m, m);
  Eigen::VectorXd b(m);
  for (Eigen::Index i = 0; i < m; ++i) {
    const Index node = unknown[static_cast<std::size_t>(i)];
    for (Eigen::Index j = 0; j < m; ++j) a(i, j) = schur_(node, unknown[static_cast<std::size_t>(j)]);
    b[i] = 0;
    if (alpha > 0 && !std::isnan(held[node])) {
      a(i, i) += alpha;
      b[i] = alpha * held[node];
    } else {
      for (Index j = 0; j < nodes_; ++j)
        if (alpha <= 0 && !std::isnan(held[j])) b[i] -= schur_(node, j) * held[j];
    }
  }
  const Eigen::LLT<Eigen::MatrixXd> llt(a);
  if (llt.info() != Eigen::Success) throw Error(Fault::solver, "the system of a click's constraints is singular");
  const Eigen::VectorXd x = llt.solve(b);
  for (Eigen::Index i = 0; i < m; ++i) u[unknown[static_cast<std::size_t>(i)]] = x[i];
  return u;
}

template <int K>
void Solver::sweep(double *x) const {
  using Row = Eigen::Array<double, K, 1>;
  using Map = Eigen::Map<Row>;
  for (std::size_t j = interior_; j-- > 0;) {
    Row sum = Row::Zero();
    const std::size_t end = column_[j + 1];
    for (std::size_t k = column_[j] + 1; k < end; ++k)
      sum -= value_[k] * Eigen::Map<const Row>(x + static_cast<std::size_t>(row_[k]) * K);
    Map(x + j * K) = sum / value_[column_[j]];
  }
}

Vec<Vec<double>> Solver::extend(std::span<const Eigen::VectorXd> at_nodes) const {
  Vec<Vec<double>> u(at_nodes.size());
  Vec<double> x;
  for (std::size_t first = 0; first < at_nodes.size();) {
    const std::size_t left = at_nodes.size() - first, width = left > 4 ? 8 : left > 2 ? 4 : left;
    const std::size_t used = std::min(width, left);
    x.assign((std::size_t{interior_} + nodes_) * width, 0);
    for (std::size_t k = 0; k < used; ++k)
      for (std::size_t i = 0; i < nodes_; ++i)
        x[(interior_ + i) * width + k] = at_nodes[first + k][static_cast<Eigen::Index>(i)];
    if (width == 8)
      sweep<8>(x.data());
    else if (width == 4)
      sweep<4>(x.data());
    else if (width == 2)
      sweep<2>(x.data());
    else
      sweep<1>(x.data());
    for (std::size_t k = 0; k < used; ++k) {
      Vec<double> &out = u[first + k];
      out.assign(slot_.size(), free_node);
      for (std::size_t v = 0; v < slot_.size(); ++v) {
        const std::size_t i = node_of_[v] != mesh::none ? std::size_t{interior_} + node_of_[v] : slot_[v];
        if (i != mesh::none) out[v] = x[i * width + k];
      }
    }
    first += used;
  }
  return u;
}

Eigen::VectorXd Solver::measure(Index vertex) const {
  Eigen::VectorXd h = Eigen::VectorXd::Zero(nodes_);
  if (node_of_[vertex] != mesh::none) {
    h[node_of_[vertex]] = 1;
    return h;
  }
  if (slot_[vertex] == mesh::none) return h;
  // L y = e_v; the share of the nodes is -L21 y. Rows of a column lie on the column's path to the root.
  Vec<double> y(interior_, 0);
  y[slot_[vertex]] = 1;
  for (std::size_t j = slot_[vertex]; j < interior_;) {
    y[j] /= value_[column_[j]];
    for (std::size_t k = column_[j] + 1; k < column_[j + 1]; ++k) {
      if (row_[k] < interior_)
        y[row_[k]] -= value_[k] * y[j];
      else
        h[row_[k] - interior_] -= value_[k] * y[j];
    }
    j = column_[j] + 1 < column_[j + 1] ? row_[column_[j] + 1] : interior_;
  }
  return h;
}

}  // namespace ts::field
