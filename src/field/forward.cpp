#include "field/forward.h"

#include <algorithm>

namespace ts::field {

Forward::Forward(const Factor &f, std::span<const Index> places) : columns_(static_cast<Index>(places.size())) {
  for (const Index place : places)
    for (Index part = f.part_of(place); part != mesh::none; part = f.parts()[part].parent) part_.push_back(part);
  std::sort(part_.begin(), part_.end());
  part_.erase(std::unique(part_.begin(), part_.end()), part_.end());
  start_.push_back(0);
  for (const Index part : part_) start_.push_back(start_.back() + f.parts()[part].end - f.parts()[part].begin);
  start_.push_back(start_.back() + f.nodes());
  value_.assign(start_.back() * columns_, 0);

  const auto row_of = [&](Index place, std::size_t from) {
    if (place >= f.interior()) return start_[part_.size()] + place - f.interior();
    const Index part = f.part_of(place);
    const auto at = std::lower_bound(part_.begin() + static_cast<std::ptrdiff_t>(from), part_.end(), part);
    return start_[static_cast<std::size_t>(at - part_.begin())] + place - f.parts()[part].begin;
  };
  for (std::size_t k = 0; k < places.size(); ++k) value_[row_of(places[k], 0) * columns_ + k] = 1;

  Rows passed;
  Block made;
  Index made_of = mesh::none;
  for (std::size_t i = 0; i < part_.size(); ++i) {
    const Index part = part_[i], chunk = f.chunk_of(part);
    if (!f.kept(chunk) && made_of != chunk) made = f.make(chunk), made_of = chunk;
    const Factor::Panel panel = f.panel(part, made);
    const std::span<const Index> rows = f.rows(part);
    const auto n = static_cast<Eigen::Index>(panel.columns);
    Eigen::Map<Rows> own(value_.data() + start_[i] * columns_, n, columns_);
    if (!rows.empty()) {
      const Eigen::Map<const Rows> touched(panel.touched, static_cast<Eigen::Index>(rows.size()), n);
      passed.noalias() = touched * own;
      for (std::size_t r = 0; r < rows.size(); ++r) {
        Eigen::Map<Eigen::RowVectorXd> to(value_.data() + row_of(rows[r], i + 1) * columns_, columns_);
        to -= passed.row(static_cast<Eigen::Index>(r));
      }
    }
    for (Eigen::Index j = 0; j < n; ++j) {
      own.row(j) *= panel.inverse[j];
      const double *const below = panel.below(static_cast<std::size_t>(j));
      for (Eigen::Index k = j + 1; k < n; ++k) own.row(k) -= below[k - j - 1] * own.row(j);
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

}  // namespace ts::field
