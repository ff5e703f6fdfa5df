#include "features/strip.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace ts::features {
namespace {

constexpr float nothing = std::numeric_limits<float>::quiet_NaN();
constexpr int crown_reach = 28;  // |t| <= 7 mm: a crown's half width and what the curve may be off
constexpr double depth = 6;      // below the top of a crown, where convexity is of interest, mm

// Cells with surface all around them, for 1.5 mm along and across.
Vec<std::uint8_t> off_rims(const Strip &strip) {
  constexpr int margin = static_cast<int>(1.5 / Strip::step);
  Vec<std::uint8_t> inside(strip.height.size(), 0), along(strip.height.size(), 0);
  for (int j = 0; j < Strip::across; ++j) {
    int run = 0;
    for (int i = 0; i < strip.slices; ++i) {
      run = std::isnan(strip.height[strip.at(i, j)]) ? 0 : run + 1;
      if (run > 2 * margin) along[strip.at(i - margin, j)] = 1;
    }
  }
  for (int i = 0; i < strip.slices; ++i) {
    int run = 0;
    for (int j = 0; j < Strip::across; ++j) {
      run = std::isnan(strip.height[strip.at(i, j)]) ? 0 : run + 1;
      if (run > 2 * margin && along[strip.at(i, j - margin)]) inside[strip.at(i, j - margin)] = 1;
    }
  }
  return inside;
}

}  // namespace

TopView::TopView(const mesh::Surface &surface, const Plan &plan, bool inside_out, const Executor &executor) {
  constexpr double most_pixels = 2000;  // a side
  constexpr std::size_t grain = 1 << 13;
  Vec<Vec3> p(surface.vertices());
  executor.ranges(p.size(), grain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) p[i] = plan.of(surface.position[i]);
  });
  Vec2 high = Vec2::Zero();
  for (std::size_t i = 0; i < p.size(); ++i) {
    low_ = i ? Vec2(low_.cwiseMin(p[i].head<2>())) : Vec2(p[i].head<2>());
    high = i ? Vec2(high.cwiseMax(p[i].head<2>())) : Vec2(p[i].head<2>());
  }
  pixel_ = std::max(pixel_, (high - low_).maxCoeff() / most_pixels);
  width_ = static_cast<int>((high.x() - low_.x()) / pixel_) + 1;
  rows_ = static_cast<int>((high.y() - low_.y()) / pixel_) + 1;
  height_.assign(static_cast<std::size_t>(width_) * rows_, nothing);
  face_.assign(height_.size(), mesh::none);
  // Bands of rows are drawn each for itself, from the faces that touch them, in their order.
  constexpr int bands = 16;
  const int band = (rows_ + bands - 1) / bands;
  const double side = inside_out ? -1 : 1;
  const std::size_t ranges = (surface.faces() + grain - 1) / grain;
  Vec<std::array<Vec<Index>, bands>> touches(ranges);
  executor.ranges(surface.faces(), grain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t f = begin; f < end; ++f) {
      if (side * surface.face_normal[f].dot(plan.d) <= 0) continue;
      const auto [a, b, c] = surface.triangle[f];
      const auto [top, bottom] = pixel_range({p[a], p[b], p[c]}, 1, rows_);
      if (top > bottom) continue;
      for (int k = top / band; k <= bottom / band; ++k) touches[begin / grain][k].push_back(static_cast<Index>(f));
    }
  });
  executor.each(bands, [&](std::size_t k) {
    const int top = static_cast<int>(k) * band, bottom = std::min(rows_, top + band) - 1;
    for (const auto &range : touches)
      for (const Index f : range[k]) {
        const auto [a, b, c] = surface.triangle[f];
        draw({p[a], p[b], p[c]}, f, top, bottom);
      }
  });
}

// The pixels whose middles the bounds of a triangle enclose.
std::pair<int, int> TopView::pixel_range(const Corners &corner, int axis, int count) const {
  const double a = std::min({corner[0][axis], corner[1][axis], corner[2][axis]}),
               b = std::max({corner[0][axis], corner[1][axis], corner[2][axis]});
  return {std::max(0, static_cast<int>(std::ceil((a - low_[axis]) / pixel_ - 0.5))),
          std::min(count - 1, static_cast<int>(std::floor((b - low_[axis]) / pixel_ - 0.5)))};
}

// What of a triangle lies in the rows from top to bottom.
void TopView::draw(const Corners &corner, Index face, int top, int bottom) {
  const auto [x0, x1] = pixel_range(corner, 0, width_);
  auto [y0, y1] = pixel_range(corner, 1, rows_);
  y0 = std::max(y0, top), y1 = std::min(y1, bottom);
  if (x0 > x1 || y0 > y1) return;
  const Vec2 e1 = (corner[1] - corner[0]).head<2>(), e2 = (corner[2] - corner[0]).head<2>();
  const double twice = e1.x() * e2.y() - e1.y() * e2.x();
  if (twice == 0) return;
  constexpr double slack = 1e-9;  // so that no pixel falls between two triangles
  for (int y = y0; y <= y1; ++y)
    for (int x = x0; x <= x1; ++x) {
      const Vec2 q = low_ + pixel_ * Vec2(x + 0.5, y + 0.5) - corner[0].head<2>();
      const double b = (q.x() * e2.y() - q.y() * e2.x()) / twice, c = (e1.x() * q.y() - e1.y() * q.x()) / twice;
      if (b < -slack || c < -slack || b + c > 1 + slack) continue;
      const auto z =
          static_cast<float>(corner[0].z() + b * (corner[1].z() - corner[0].z()) + c * (corner[2].z() - corner[0].z()));
      const std::size_t i = static_cast<std::size_t>(y) * width_ + x;
      if (!(z <= height_[i])) height_[i] = z, face_[i] = face;
    }
}

double TopView::height(const Vec2 &p) const {
  const Vec2 q = (p - low_) / pixel_ - Vec2(0.5, 0.5);
  if (!(q.x() > -1 && q.y() > -1 && q.x() < width_ && q.y() < rows_)) return nothing;
  const int x = static_cast<int>(std::floor(q.x())), y = static_cast<int>(std::floor(q.y()));
  double sum = 0, weight = 0;
  for (int k = 0; k < 4; ++k) {
    const int i = x + k % 2, j = y + k / 2;
    if (i < 0 || j < 0 || i >= width_ || j >= rows_) continue;
    const float h = height_[static_cast<std::size_t>(j) * width_ + i];
    const double w = (1 - std::abs(q.x() - i)) * (1 - std::abs(q.y() - j));
    if (!std::isnan(h)) sum += w * h, weight += w;
  }
  return weight > 0.25 ? sum / weight : nothing;
}

Index TopView::face(const Vec2 &p) const {
  const Vec2 q = (p - low_) / pixel_;
  if (!(q.x() >= 0 && q.y() >= 0 && q.x() < width_ && q.y() < rows_)) return mesh::none;
  return face_[static_cast<std::size_t>(q.y()) * width_ + static_cast<std::size_t>(q.x())];
}

Strip make_strip(const ArchCurve &curve, const TopView &view, const Plan &plan, const geometry::SampleBins &bins,
                 bool inside_out, double radius, const Executor &executor) {
  Strip strip;
  strip.curve = curve;
  strip.slices = static_cast<int>(curve.point.size());
  const std::size_t cells = strip.at(strip.slices, 0);
  strip.height.assign(cells, nothing);
  Vec<Vec3> query(cells, Vec3::Zero());
  executor.ranges(strip.slices, 32, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
      for (int j = 0; j < Strip::across; ++j) {
        const Vec2 p = strip.plan_point(static_cast<int>(i), Strip::t(j));
        const std::size_t c = strip.at(static_cast<int>(i), j);
        strip.height[c] = static_cast<float>(view.height(p));
        if (!std::isnan(strip.height[c])) query[c] = plan.back({p.x(), p.y(), strip.height[c]});
      }
  });

  // Near a rim of the scan a flap of cheek or a ragged corner may stand higher than the teeth.
  const Vec<std::uint8_t> inside = off_rims(strip);
  strip.crest.assign(strip.slices, nothing);
  for (int i = 0; i < strip.slices; ++i)
    for (int j = Strip::half - crown_reach; j <= Strip::half + crown_reach; ++j)
      if (inside[strip.at(i, j)]) strip.crest[i] = std::fmax(strip.crest[i], strip.height[strip.at(i, j)]);
  strip.top.assign(strip.slices, nothing);
  const int tooth = static_cast<int>(4 / Strip::step);  // a tooth or its neighbour is within 4 mm
  for (int i = 0; i < strip.slices; ++i)
    for (int k = std::max(0, i - tooth); k <= std::min(strip.slices - 1, i + tooth); ++k)
      strip.top[i] = std::fmax(strip.top[i], strip.crest[k]);

  Vec<std::uint8_t> wanted(cells, 0);
  for (int i = 0; i < strip.slices; ++i)
    for (int j = 0; j < Strip::across; ++j)
      wanted[strip.at(i, j)] = strip.height[strip.at(i, j)] > strip.top[i] - depth;
  const float side = inside_out ? -1 : 1;
  const auto measure = [&](double r) {
    const Vec<double> cv = geometry::convexity(bins, query, wanted, r, executor);
    Vec<float> result(cells);
    for (std::size_t c = 0; c < cells; ++c) result[c] = side * static_cast<float>(cv[c]);
    return result;
  };
  strip.convexity = measure(radius);
  strip.fine = measure(radius / 2);
  return strip;
}

}  // namespace ts::features
