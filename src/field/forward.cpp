#include "field/forward.h"

#include <algorithm>

namespace ts::field {
namespace {

constexpr std::size_t kColumns = 8;  // a task's: a cache line of each row

}  // namespace

Forward::Forward(const Factor &f, std::span<const Index> places, const Executor &executor)
    : columns_(static_cast<Index>(places.size())) {
  follow(f, places);
  for (std::size_t k = 0; k < places.size(); ++k) value_[row_of(f, places[k], 0) * columns_ + k] = 1;
  executor.ranges(columns_, kColumns, [&](std::size_t begin, std::size_t end) {
    eliminate(f, static_cast<Index>(begin), static_cast<Index>(end));
  });
}

Forward::Forward(const Factor &f, std::span<const Index> places, std::span<const double> weights) : columns_(1) {
  follow(f, places);
  for (std::size_t k = 0; k < places.size(); ++k) value_[row_of(f, places[k], 0)] = weights[k];
  eliminate(f, 0, 1);
}

// The parts on the paths from these places, and room for their rows.
void Forward::follow(const Factor &f, std::span<const Index> places) {
  for (const Index place : places)
    for (Index part = f.part_of(place); part != mesh::none; part = f.parts()[part].parent) part_.push_back(part);
  std::sort(part_.begin(), part_.end());
  part_.erase(std::unique(part_.begin(), part_.end()), part_.end());
  start_.push_back(0);
  for (const Index part : part_) start_.push_back(start_.back() + f.parts()[part].end - f.parts()[part].begin);
  start_.push_back(start_.back() + f.nodes());
  value_.assign(start_.back() * columns_, 0);
}

// `from`: the first part that may have it.
std::size_t Forward::row_of(const Factor &f, Index place, std::size_t from) const {
  if (place >= f.interior()) return start_[part_.size()] + place - f.interior();
  const Index part = f.part_of(place);
  const auto at = std::lower_bound(part_.begin() + static_cast<std::ptrdiff_t>(from), part_.end(), part);
  return start_[static_cast<std::size_t>(at - part_.begin())] + place - f.parts()[part].begin;
}

void Forward::eliminate(const Factor &f, Index first, Index end) {
  const Eigen::Index columns = end - first;
  const Eigen::OuterStride<> stride(columns_);
  Vec<double> values;  // not a matrix: Eigen 3.4 frees one twice that cannot be made larger
  Block made;
  Index made_of = mesh::none;
  for (std::size_t i = 0; i < part_.size(); ++i) {
    const Index part = part_[i], chunk = f.chunk_of(part);
    if (!f.kept(chunk) && made_of != chunk) made = f.make(chunk), made_of = chunk;
    const Factor::Panel panel = f.panel(part, made);
    const std::span<const Index> rows = f.rows(part);
    const auto n = static_cast<Eigen::Index>(panel.columns);
    Eigen::Map<Rows, 0, Eigen::OuterStride<>> own(value_.data() + start_[i] * columns_ + first, n, columns, stride);
    if (!rows.empty()) {
      const Eigen::Map<const Rows> touched(panel.touched, static_cast<Eigen::Index>(rows.size()), n);
      values.resize(rows.size() * static_cast<std::size_t>(columns));
      Eigen::Map<Rows> passed(values.data(), static_cast<Eigen::Index>(rows.size()), columns);
      passed.noalias() = touched * own;
      for (std::size_t r = 0; r < rows.size(); ++r) {
        Eigen::Map<Eigen::RowVectorXd> to(value_.data() + row_of(f, rows[r], i + 1) * columns_ + first, columns);
        to -= passed.row(static_cast<Eigen::Index>(r));
      }
    }
    for (std::size_t j = 0; j < panel.columns; ++j) {
      double *const from = own.data() + j * columns_;
      const double *const below = panel.below(j);
      const std::size_t left = panel.columns - j - 1;
      for (Eigen::Index c = 0; c < columns; ++c) from[c] *= panel.inverse[j];
      if (columns_ == 1) {  // the values lie in one piece
        for (std::size_t k = 0; k < left; ++k) from[k + 1] -= below[k] * from[0];
        continue;
      }
      for (std::size_t k = 0; k < left; ++k) {
        double *const to = from + (k + 1) * columns_;
        for (Eigen::Index c = 0; c < columns; ++c) to[c] -= below[k] * from[c];
      }
    }
  }
}

Eigen::MatrixXd Forward::products(const Forward &other) const {
  Eigen::MatrixXd sum = Eigen::MatrixXd::Zero(columns_, other.columns_);
  for (std::size_t i = 0, k = 0; i < part_.size() && k < other.part_.size();) {
    if (part_[i] == other.part_[k])
      sum.noalias() += block(i++).transpose() * other.block(k++);
    else
      part_[i] < other.part_[k] ? ++i : ++k;
  }
  return sum;
}

Source Forward::source(const Eigen::VectorXd &flux) const {
  Source s;
  s.part = part_;
  s.start.assign(start_.begin(), start_.end() - 1);
  s.value.resize(s.start.back());
  Eigen::Map<Eigen::VectorXd>(s.value.data(), static_cast<Eigen::Index>(s.value.size())).noalias() =
      Eigen::Map<const Rows>(value_.data(), static_cast<Eigen::Index>(s.start.back()), columns_) * flux;
  return s;
}

Weighed weigh(const Factor &f, std::span<const Index> vertices, std::span<const double> weights) {
  Weighed w;
  w.held = Eigen::VectorXd::Zero(f.nodes());
  for (std::size_t k = 0; k < vertices.size(); ++k) {
    const Index place = f.place(vertices[k]);
    if (place == mesh::none) continue;
    if (place >= f.interior()) {
      w.held[place - f.interior()] += weights[k];
    } else {
      w.place.push_back(place);
      w.weight.push_back(weights[k]);
    }
  }
  return w;
}

}  // namespace ts::field
