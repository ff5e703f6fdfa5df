// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "arch_curve.h"
#include "tooth_shape.h"

namespace tsa {

struct Settings {
  bool upper = true;
  uint32_t triangles = 100000;
  bool base = false;
  uint64_t seed = 1;
  double crowding = 0;
  double noise = 0;
  bool isotropic = false;
  std::vector<uint32_t> missing;
};

struct PlacedTooth {
  ToothShape shape;
  uint32_t fdi = 0;
  Vec3 origin, distal, facial, occlusal;

  Vec3 world(double u, double v, double w) const { return origin + u * distal + v * facial + w * occlusal; }
  Vec3 local(Vec3 p) const {
    const Vec3 d = p - origin;
    return {dot(d, distal), dot(d, facial), dot(d, occlusal)};
  }
};

// Teeth and gingiva as one implicit solid: negative inside, about the distance in mm near the surface.
class Dentition {
 public:
  // `bridging` scales the blends that close the contacts.
  explicit Dentition(const Settings &settings, double bridging = 1);

  const std::vector<PlacedTooth> &teeth() const { return teeth_; }
  double field(Vec3 p) const { return evaluate(p).value; }
  // 0 = gingiva or base, else 1 + index of the tooth whose surface is closest.
  uint32_t label(Vec3 p) const { return evaluate(p).label; }
  // An open shell ends where this falls below 0; without limit when the model has a base.
  double trim(Vec3 p) const;

 private:
  struct Value {
    double value, crown, gum;
    uint32_t label;
  };
  struct Crest {
    double t, z, halfWidth, lean, missing;
  };
  void place(const Settings &settings);
  void layRidge();
  Crest crest(double s) const;
  double trimLevel(const ArchCurve::Coordinates &c, double crestZ) const;
  double ridge(Vec3 p, const ArchCurve::Coordinates &c) const;
  Value evaluate(Vec3 p) const;

  bool upper_, base_;
  double bridging_;
  uint32_t noiseSeed_;
  ArchCurve curve_;
  std::vector<PlacedTooth> teeth_;
  struct RidgePoint {
    double s, t, z, halfWidth, lean, missing;
  };
  std::vector<RidgePoint> ridgePoints_;
  std::vector<Crest> crests_;
  double end_[2] = {0, 0};  // where the alveolar ridge ends, on the sides of -x and +x
  double floor_ = -1e9;
};

}  // namespace tsa
