// The arch unrolled: heights and convexities over (s, t), s along the arch curve and t across it.
#pragma once

#include "base/executor.h"
#include "features/arch.h"
#include "geometry/convexity.h"

namespace ts::features {

using mesh::Index;

// What is seen from above: height and face for each pixel of a plan view.
class TopView {
 public:
  TopView(const mesh::Surface &surface, const Plan &plan, bool inside_out, const Executor &executor);

  // NaN where nothing is seen.
  double height(const Vec2 &p) const;
  Index face(const Vec2 &p) const;

 private:
  using Corners = std::array<Vec3, 3>;
  std::pair<int, int> pixel_range(const Corners &corner, int axis, int count) const;
  void draw(const Corners &corner, Index face, int top, int bottom);

  double pixel_ = 0.25;  // mm
  int width_ = 0, rows_ = 0;
  Vec2 low_ = Vec2::Zero();
  Vec<float> height_;
  Vec<Index> face_;
};

struct Strip {
  static constexpr double step = 0.25;                    // along and across, mm
  static constexpr int half = 40, across = 2 * half + 1;  // |t| <= 10 mm

  int slices = 0;
  ArchCurve curve;
  Vec<float> height;           // slice by slice, NaN where there is no surface
  Vec<float> convexity, fine;  // at the radius of the options, and at half of it
  Vec<float> crest;            // a slice: largest height within reach of its crown
  Vec<float> top;              // a slice: crest of the tooth it may belong to

  std::size_t at(int slice, int j) const { return static_cast<std::size_t>(slice) * across + j; }
  static double t(int j) { return (j - half) * step; }
  Vec2 plan_point(int slice, double t) const { return curve.point[slice] + t * curve.normal[slice]; }
};

Strip make_strip(const ArchCurve &curve, const TopView &view, const Plan &plan, const geometry::SampleBins &bins,
                 bool inside_out, double radius, const Executor &executor);

}  // namespace ts::features
