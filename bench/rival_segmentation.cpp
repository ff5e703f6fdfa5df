#include "bench/rival_segmentation.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "geometry/convexity.h"
#include "geometry/samples.h"

namespace ts::bench {

using mesh::Vec3;

namespace {

// Cells of the plan view, and how far around the highest point is looked for: a tooth's width, so that a palate or a
// vestibule beside the teeth is told to be low.
constexpr double kCell = 1.0;
constexpr int kReach = 8;

// The greatest of each window of 2 reach + 1 cells along rows (stride 1, count `columns`).
void widen(Vec<double> &grid, int rows, int columns, int row_step, int column_step) {
  Vec<double> line(static_cast<std::size_t>(columns));
  for (int r = 0; r < rows; ++r) {
    double *row = grid.data() + static_cast<std::ptrdiff_t>(r) * row_step;
    for (int c = 0; c < columns; ++c) line[static_cast<std::size_t>(c)] = row[c * column_step];
    for (int c = 0; c < columns; ++c) {
      const auto begin = line.begin() + std::max(0, c - kReach), end = line.begin() + std::min(columns, c + kReach + 1);
      row[c * column_step] = *std::max_element(begin, end);
    }
  }
}

}  // namespace

Heights heights(const Surface &surface, const Executor &executor) {
  Heights h;
  const geometry::Frame frame = geometry::principal_frame(surface);
  const Vec<geometry::Sample> samples = geometry::area_samples(surface, 0.5, frame);
  Vec<Vec3> at(samples.size());
  for (std::size_t i = 0; i < samples.size(); ++i) at[i] = samples[i].position;
  const geometry::SampleBins bins(samples, 1.0);
  h.orientation = features::orientation(samples, geometry::convexity(bins, at, {}, 2.0, executor), Vec3::Zero());

  const features::Plan plan(h.orientation.occlusal, frame);
  Vec<Vec3> q(surface.vertices());
  Eigen::Array2d low = Eigen::Array2d::Constant(std::numeric_limits<double>::infinity()), high = -low;
  for (std::size_t v = 0; v < q.size(); ++v) {
    q[v] = plan.of(surface.position[v]);
    low = low.min(q[v].head<2>().array());
    high = high.max(q[v].head<2>().array());
  }
  const int columns = static_cast<int>((high[0] - low[0]) / kCell) + 1;
  const int rows = static_cast<int>((high[1] - low[1]) / kCell) + 1;
  Vec<double> top(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows),
                  -std::numeric_limits<double>::infinity());
  const auto cell = [&](const Vec3 &p) {
    return static_cast<std::size_t>((p.y() - low[1]) / kCell) * static_cast<std::size_t>(columns) +
           static_cast<std::size_t>((p.x() - low[0]) / kCell);
  };
  for (const Vec3 &p : q) top[cell(p)] = std::max(top[cell(p)], p.z());
  widen(top, rows, columns, columns, 1);
  widen(top, columns, rows, 1, columns);
  h.below_top.resize(q.size());
  for (std::size_t v = 0; v < q.size(); ++v) h.below_top[v] = top[cell(q[v])] - q[v].z();
  return h;
}

bool fits_better(const Teeth &a, const Teeth &b, unsigned wanted) {
  const auto off = [&](const Teeth &t) { return t.count > wanted ? t.count - wanted : wanted - t.count; };
  return off(a) != off(b) ? off(a) < off(b) : a.spread < b.spread;
}

}  // namespace ts::bench
