#include "geometry/convexity.h"

namespace ts::geometry {

double convexity(const SampleBins &bins, const Vec3 &q, double radius) {
  double area = 0;
  Vec3 centre = Vec3::Zero(), normal = Vec3::Zero();
  bins.ball(q, radius, [&](const Sample &s, double) {
    area += s.area;
    centre += s.area * (s.position - q);
    normal += s.area * s.normal;
  });
  const double length = normal.norm();
  if (!(area > 0) || length < 1e-6 * area) return 0;
  return -centre.dot(normal) / (area * length * radius);
}

Vec<double> convexity(const SampleBins &bins, std::span<const Vec3> queries, std::span<const std::uint8_t> wanted,
                      double radius, const Executor &executor) {
  Vec<double> result(queries.size(), 0);
  executor.ranges(queries.size(), 512, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
      if (wanted.empty() || wanted[i]) result[i] = convexity(bins, queries[i], radius);
  });
  return result;
}

}  // namespace ts::geometry
