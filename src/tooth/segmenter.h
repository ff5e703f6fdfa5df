// Everything behind a click: the paper's pipeline from a prepared scan to two separated teeth.
#pragma once

#include <memory>
#include <optional>
#include <span>

#include "base/executor.h"
#include "base/progress.h"
#include "features/features.h"
#include "mesh/surface_point.h"
#include "tooth/options.h"
#include "tooth/tooth.h"

namespace ts::tooth {

// Milliseconds (paper, Fig. 11).
struct PrepareTimes {
  double weights = 0;    // curvature, concavity, weights
  double factorise = 0;  // constraints, ordering, factorisation, Schur complement, outliers
};
struct ClickTimes {
  double pick = 0, field = 0, cut = 0, label = 0, total = 0;
};

// Bytes.
struct Memory {
  std::size_t kept = 0;                      // of all that clicks share, the factor included
  std::size_t factor = 0, factor_whole = 0;  // as far as it is kept; if all of it were
  std::size_t click = 0;                     // of the work space of a tooth
};

struct Prepared;
// The groups that a click is made among where clicks before have made some; null: those of the features.
using Among = std::shared_ptr<const Prepared>;

struct Click {
  mesh::SurfacePoint at;
  Among among;                               // after it: it may have made a group itself
  Index target = mesh::none;                 // index of the group clicked
  Index neighbour = mesh::none;              // of the group separated with it; none if there is but one
  double target_distance = 0;                // along the surface, in the metric of the options, mm
  double target_iso = 0, neighbour_iso = 0;  // of the published field; NaN without a neighbour
  ClickTimes ms;
  std::size_t field_bytes = 0;  // of the factor that the field read
  Vec<Tooth> teeth;             // the target's, then the neighbour's if there is one and a cut was found for it
};

// What a click is not decided by and therefore does not work out.
struct ClickDetails {
  double neighbour_distance = 0;  // along the surface, in the metric of the options, mm; NaN without a neighbour
  double v_med = 0;               // centre of the fullest bin (Fig. 4C)
};

// One iso-value's contour of the published field (Fig. 4A).
struct Contour {
  double iso = 0, gradient = 0, concavity = 0, length = 0;
  unsigned chosen = 0;  // 1 = cut of the target, 2 = of the neighbour, 0 = neither
  Vec<cut::Polyline> lines;
};

// What can be looked at of a click; worked out again from the click when asked for, always the same.
struct ClickView {
  Vec<double> u;          // a vertex: 0 on the target, 1 on the neighbour; NaN on pieces without a constraint
  Vec<Index> histogram;   // vertices a bin over [0, 1]
  Vec<Contour> contours;  // by rising iso-value
};

class Segmenter {
 public:
  // `surface` and `executor` must outlive the segmenter; what is needed of `features` is copied.
  // Throws no_constraint (no group with a point), solver, cancelled, invalid_argument.
  Segmenter(const mesh::Surface &surface, const features::Features &features, const Options &options,
            const Executor &executor, const Progress &progress = {});
  ~Segmenter();
  Segmenter(Segmenter &&) noexcept;
  Segmenter &operator=(Segmenter &&) noexcept;

  // Separates the tooth at `at` and its neighbour. Depends on nothing but the segmenter, the point, the groups
  // `separated` before, which are passed over where there is another neighbour, and those that clicks have made. Where
  // a tooth's own field decides, the target's tooth holds the point: where the closest group's does not, it is that of
  // the group with most of the field there, or of one made of the click, whose index is the next.
  // Throws click_off_surface, click_on_gingiva, no_cut, cancelled.
  Click click(const mesh::SurfacePoint &at, std::span<const Index> separated = {}, const Progress &progress = {},
              const Among &among = {}) const;

  // What came of one click of several: a click, or the fault.
  struct Outcome {
    std::optional<Click> click;
    Fault fault = Fault::internal;
    std::string message;
  };

  // Several clicks in parallel, with the outcome of the same clicks one after the other.
  Vec<Outcome> clicks(std::span<const mesh::SurfacePoint> at, std::span<const Index> separated,
                      const Progress &progress = {}, const Among &among = {}) const;

  ClickDetails details(const Click &click) const;
  ClickView view(const Click &click, const Progress &progress = {}) const;

  // The fewest clicks that cover every group not in `separated`: points on the surface.
  Vec<Vec3> propose_clicks(std::span<const Index> separated = {}, const Among &among = {}) const;

  // What a correction (correct.h) is made on.
  const Prepared &prepared(const Among &among) const;

  const Options &options() const;
  const PrepareTimes &times() const;
  Memory memory() const;
  Index groups() const;  // of the features
  // The feature points of a group that contradicted the field and are not used: indices into Group::points.
  const Vec<Index> &rejected_points(Index group) const;

 private:
  struct Impl;
  std::unique_ptr<const Impl> impl_;
};

}  // namespace ts::tooth
