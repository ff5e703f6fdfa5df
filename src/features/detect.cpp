#include "features/detect.h"

#include <string>

#include "base/shown.h"
#include "features/analysis.h"
#include "features/doubts.h"
#include "features/points.h"
#include "features/weights.h"

namespace ts::features {
namespace {

constexpr double kLargest = 400;  // mm: what intake takes for a scan in mm, a tray with both plaster bases

}  // namespace

Analysis analyse(const mesh::Surface &surface, const DetectOptions &options, const Executor &executor,
                 const Progress &progress) {
  constexpr double spacing = 0.5;  // of the area samples, mm: a quarter of the default radius
  const geometry::Frame frame = geometry::principal_frame(surface);
  const Vec<geometry::Sample> samples = geometry::area_samples(surface, spacing, frame);
  if (samples.empty()) throw Error(Fault::no_teeth, "the surface has no area");
  progress(0.2);
  const geometry::SampleBins bins(samples, 1.0);
  Vec<Vec3> position(samples.size());
  for (std::size_t i = 0; i < samples.size(); ++i) position[i] = samples[i].position;
  const Vec<double> cv = geometry::convexity(bins, position, {}, options.radius, executor);
  progress(0.5);
  const Orientation up = orientation(samples, cv, options.occlusal);
  const Plan plan(up.occlusal, frame);
  const ArchCurve curve = arch_curve(samples, cv, up.inside_out, plan);
  const Looks looks = looks_of(samples, cv, up, curve, plan);
  const TopView view(surface, plan, up.inside_out, executor);
  progress(0.7);
  const Strip strip = make_strip(curve, view, plan, bins, up.inside_out, options.radius, executor);
  progress(0.9);
  return {up, looks, plan, view, strip, gather(strip, executor)};
}

Features divide(const mesh::Surface &surface, const Analysis &a, const Weights &weights, const DetectOptions &options) {
  const Lattice lattice(a.evidence, weights);
  const Division division = best_division(lattice);
  Features found;
  found.occlusal = a.orientation.occlusal;
  found.inside_out = a.orientation.inside_out;
  found.looks = a.looks;
  float height = 0;
  for (int i = 0; i < a.strip.slices; i += 4) {
    const Vec2 p = a.strip.curve.point[i];
    if (!std::isnan(a.strip.crest[i])) height = a.strip.crest[i];
    found.arch.push_back(a.plan.back({p.x(), p.y(), height}));
  }
  const auto add = [&](const ToothSpan &tooth, const Ridge *ridge) {
    Group group;
    group.points = tooth_points(surface, a.strip, a.view, a.plan, tooth, options.max_points, ridge);
    group.from = (ridge ? ridge->from : tooth.from) * Strip::step;
    group.to = (ridge ? ridge->to : tooth.to) * Strip::step;
    group.confidence = tooth.confidence;
    if (!group.points.empty()) found.groups.push_back(std::move(group));
  };
  const Vec<Pair> ridges = two_ridges(a.strip, division, lattice);
  for (std::size_t t = 0; t < ridges.size(); ++t) {
    if (ridges[t])
      for (const Ridge &ridge : *ridges[t]) add(division.teeth[t], &ridge);
    else
      add(division.teeth[t], nullptr);
  }
  if (found.groups.empty()) throw Error(Fault::no_teeth, "nothing along the arch looks like a tooth");
  return found;
}

Features detect(const mesh::Surface &surface, const DetectOptions &options, const Executor &executor,
                const Progress &progress) {
  // Sampled at a physical spacing, a surface of that size would cost as much as it is large.
  if (surface.diagonal > kLargest)
    throw Error(Fault::no_teeth, "the surface is " + shown(surface.diagonal) + " mm across: no jaw is");
  const Analysis a = analyse(surface, options, executor, progress.part(0, 0.95, "features"));
  Features found = divide(surface, a, fitted_weights, options);
  progress(1);
  return found;
}

}  // namespace ts::features
