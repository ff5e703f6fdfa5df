// L^-1 E for a few free vertices: the first half of a solve, on the paths to the root of the tree alone.
#pragma once

#include "base/executor.h"
#include "field/solution.h"

namespace ts::field {

// What is put into a vertex goes to the root: a part keeps y = L11^-1 b of what comes to it, and passes b on to the
// rows it touches as -L21 L11^-1 b. What comes to the nodes is the vertex' harmonic measure.
class Forward {
 public:
  using Rows = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

  // A column for each of `places`, which are of free vertices and differ.
  Forward(const Factor &factor, std::span<const Index> places, const Executor &executor);
  // One column: their sum with these weights.
  Forward(const Factor &factor, std::span<const Index> places, std::span<const double> weights);

  Index columns() const { return columns_; }
  // A row for each place given: the share of each node in its value.
  Eigen::MatrixXd measures() const { return block(part_.size()).transpose(); }
  // Y^T other.Y, which is A^-1 between the two sets of places.
  Eigen::MatrixXd products(const Forward &other) const;
  // Y flux, as a solution takes it.
  Source source(const Eigen::VectorXd &flux) const;

 private:
  void follow(const Factor &factor, std::span<const Index> places);
  std::size_t row_of(const Factor &factor, Index place, std::size_t from) const;
  void eliminate(const Factor &factor, Index first, Index end);  // these columns

  Eigen::Map<const Rows> block(std::size_t i) const {
    return {value_.data() + start_[i] * columns_, static_cast<Eigen::Index>(start_[i + 1] - start_[i]),
            static_cast<Eigen::Index>(columns_)};
  }

  Index columns_ = 0;
  Vec<Index> part_;         // those on the paths, ascending: children first
  Vec<std::size_t> start_;  // of each part's rows; then of the nodes', and their end
  Vec<double> value_;       // row by row
};

// What a weighed sum of values is made of: the nodes' shares of it, and the free vertices.
struct Weighed {
  Eigen::VectorXd held;
  Vec<Index> place;
  Vec<double> weight;
};
// Vertices on pieces left out have none. The vertices differ.
Weighed weigh(const Factor &factor, std::span<const Index> vertices, std::span<const double> weights);

}  // namespace ts::field
