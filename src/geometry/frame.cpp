#include "geometry/frame.h"

#include <Eigen/Eigenvalues>

#include "base/stop.h"

namespace ts::geometry {

Frame principal_frame(const mesh::Surface &surface) {
  Frame frame;
  // The middles of its edges stand for a triangle: exact to the second moment.
  const auto each = [&](auto &&visit) {
    StopNowAndThen stop(1 << 15);
    for (std::size_t f = 0; f < surface.faces(); ++f) {
      stop();
      for (int k = 0; k < 3; ++k) {
        const Vec3 middle =
            (surface.position[surface.triangle[f][k]] + surface.position[surface.triangle[f][(k + 1) % 3]]) / 2;
        visit(middle, surface.face_area[f]);
      }
    }
  };
  if (surface.position.empty()) return frame;
  const Vec3 near = surface.position[0];
  double area = 0;
  Vec3 sum = Vec3::Zero();
  each([&](const Vec3 &p, double a) { area += a, sum += a * (p - near); });
  if (!(area > 0)) return frame;
  frame.origin = near + sum / area;
  Eigen::Matrix3d second = Eigen::Matrix3d::Zero();
  each([&](const Vec3 &p, double a) { second += a * (p - frame.origin) * (p - frame.origin).transpose(); });
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(second / area);
  for (int k = 0; k < 3; ++k) frame.axis[k] = solver.eigenvectors().col(2 - k);
  Vec3 third = Vec3::Zero();
  each([&](const Vec3 &p, double a) { third.array() += a * frame.of(p).array().cube(); });
  for (int k = 0; k < 3; ++k)
    if (third[k] < 0) frame.axis[k] = -frame.axis[k];
  return frame;
}

}  // namespace ts::geometry
