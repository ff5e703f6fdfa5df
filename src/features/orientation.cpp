#include "features/orientation.h"

#include <Eigen/Geometry>
#include <cmath>

#include "base/error.h"

namespace ts::features {

Orientation orientation(std::span<const geometry::Sample> samples, std::span<const double> convexity,
                        const Vec3 &given) {
  Orientation o;
  Vec3 sum = Vec3::Zero();
  double rough = 0;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const double w = samples[i].area * std::abs(convexity[i]);
    sum += w * samples[i].normal;
    rough += w;
  }
  // A plane has no roughness but rounding; a sphere, a cylinder or a cube has no side that is rougher.
  constexpr double least_roughness = 1e-3, least_clarity = 0.02;
  double area = 0;
  for (const auto &s : samples) area += s.area;
  if (!(rough > least_roughness * area))
    throw Error(Fault::no_teeth, "the surface is flat: nothing on it looks like a tooth");
  o.clarity = sum.norm() / rough;
  const bool set_by_hand = given.norm() > 0;
  if (!set_by_hand && o.clarity < least_clarity)
    throw Error(Fault::no_teeth, "no side of the surface is rougher than the others: no occlusal direction");
  o.occlusal = set_by_hand ? given.normalized() : sum.normalized();

  // Crowns bulge: on the occlusal side large convexities outweigh large concavities, unless the faces look inwards.
  double cubes = 0, absolute = 0;
  const double side = set_by_hand && sum.dot(given) < 0 ? -1 : 1;  // by hand: faces inside out look the other way
  for (std::size_t i = 0; i < samples.size(); ++i) {
    if (!(side * samples[i].normal.dot(o.occlusal) > 0.2)) continue;
    const double c3 = samples[i].area * std::pow(convexity[i], 3);
    cubes += c3;
    absolute += std::abs(c3);
  }
  o.outward = absolute > 0 ? cubes / absolute : 0;
  o.inside_out = o.outward < 0;
  if (o.inside_out && !set_by_hand) o.occlusal = -o.occlusal;
  return o;
}

Plan::Plan(const Vec3 &occlusal, const geometry::Frame &frame) : d(occlusal), origin(frame.origin) {
  int along = 0;  // the axis that d lies along most is of no use
  for (int k = 1; k < 3; ++k)
    if (std::abs(d.dot(frame.axis[k])) > std::abs(d.dot(frame.axis[along]))) along = k;
  const Vec3 &first = frame.axis[along == 0 ? 1 : 0], &second = frame.axis[along == 2 ? 1 : 2];
  u = (first - first.dot(d) * d).normalized();
  v = d.cross(u);
  if (v.dot(second) < 0) v = -v;
}

}  // namespace ts::features
