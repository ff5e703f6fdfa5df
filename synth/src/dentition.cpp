// SPDX-License-Identifier: Apache-2.0
#include "dentition.h"

#include <algorithm>
#include <array>

#include "contacts.h"

namespace tsa {
namespace {

// Inclination of the crown to the occlusal plane, degrees, facial positive, after the trend of Andrews' crown torque
// (Am J Orthod 1972); the long axes of incisors stand a little steeper out than their facial surfaces.
constexpr double kTorqueUpper[7] = {14, 11, 2, -5, -6, -8, -8};
constexpr double kTorqueLower[7] = {6, 5, -2, -7, -10, -14, -16};
// Height of the tips above the occlusal plane, mm: laterals short, canines long, the rest after the curve of Spee.
constexpr double kTipUpper[7] = {0.1, -0.5, 0.4, 0.1, 0.0, -0.2, -0.9};
constexpr double kTipLower[7] = {0.9, 0.9, 0.9, 0.1, -0.1, 0.2, 0.9};
// What crowding does to the contact line: facial (+) or lingual displacement, and rotation.
constexpr double kShiftUpper[7] = {0.5, -1.0, 1.1, -0.5, 0.3, 0, 0};
constexpr double kShiftLower[7] = {-0.7, 1.0, 0.3, -0.6, 0.4, 0, 0};

// Contacts are bridged as scanners do it: gaps up to half the blend close, the narrow space under the contact sooner.
constexpr double kContactBlend = 0.15, kEmbrasureBlend = 0.6;
constexpr double kSulcusBlend = 0.05;
constexpr double kGumBlend = 2.2, kMarginBlend = 0.5;
constexpr double kRidgeLimit = 75, kRidgeStep = 0.5;

double radians(double degrees) {
  return degrees * 0.017453292519943295;
}

ArchCurve archForm(bool upper) {
  return upper ? ArchCurve(0.020, 5.6e-5) : ArchCurve(0.023, 6.6e-5);
}

}  // namespace

Dentition::Dentition(const Settings &settings, double bridging)
    : upper_(settings.upper),
      base_(settings.base),
      bridging_(bridging),
      noiseSeed_(static_cast<uint32_t>(mix(settings.seed ^ 0x5ca1ab1e))),
      curve_(archForm(settings.upper)) {
  place(settings);
  layRidge();
}

void Dentition::place(const Settings &settings) {
  Random random(settings.seed * 2 + (upper_ ? 1 : 0));
  const double crowding = settings.crowding;
  const double midline = 1.2 * crowding * random.symmetric();
  std::vector<PlacedTooth> sides[2];
  for (int side = 0; side < 2; ++side) {  // 0: +x
    double s = 0;
    // FDI quadrants: seen from the occlusal side the patient's right is at -x in the upper jaw, at +x in the lower.
    const uint32_t quadrant = upper_ ? (side == 0 ? 2 : 1) : (side == 0 ? 4 : 3);
    const double flip = side == 0 ? 1 : -1;
    for (int i = 0; i < 7; ++i) {
      PlacedTooth tooth;
      tooth.fdi = quadrant * 10 + static_cast<uint32_t>(i) + 1;
      tooth.shape = makeTooth(upper_, i + 1, random);
      const ToothShape &shape = tooth.shape;
      // Lack of space is largest between the incisors and fades towards the premolars.
      const double lack = crowding * (i <= 2 ? 0.17 : (i <= 4 ? 0.07 : 0)) * shape.md;
      const double width = 0.975 * shape.md - lack;
      const double at = flip * (s + 0.5 * width) + midline;
      s += width;

      const double wobble = 0.25 + 0.35 * crowding;
      const double shift = (upper_ ? kShiftUpper : kShiftLower)[i] * crowding * (1.3 + 0.9 * random.uniform()) *
                               (upper_ || side == 0 || i > 2 ? 1 : -0.8) +
                           0.5 * wobble * random.symmetric();
      const double turnAmount = i <= 2 ? 26 : (i <= 4 ? 16 : 5);
      const double turn =
          radians((2.5 + turnAmount * crowding * (random.uniform() < 0.5 ? -1 : 1)) * (0.5 + 0.5 * random.uniform()));
      const double torque =
          radians((upper_ ? kTorqueUpper : kTorqueLower)[i] + (2 + 5 * crowding) * random.symmetric());
      const double tip = radians(4 + (2 + 5 * crowding) * random.symmetric());
      const double rise =
          (upper_ ? kTipUpper : kTipLower)[i] + (0.15 + (i <= 2 ? 0.7 : 0.2) * crowding) * random.symmetric();

      const Vec3 n = curve_.outward(at), z = {0, 0, 1};
      const Vec3 along = flip > 0 ? Vec3{n.y, -n.x, 0} : Vec3{-n.y, n.x, 0};
      const double ct = std::cos(turn), st = std::sin(turn);
      const Vec3 distal = ct * along + st * n, facial = ct * n - st * along;
      const Vec3 axis = std::cos(torque) * z + std::sin(torque) * facial;
      tooth.facial = std::cos(torque) * facial - std::sin(torque) * z;
      tooth.occlusal = std::cos(tip) * axis - std::sin(tip) * distal;
      tooth.distal = std::cos(tip) * distal + std::sin(tip) * axis;
      Vec3 anchor = curve_.point(at) + shift * n;
      anchor.z = rise - (shape.height - shape.contactW);
      tooth.origin = anchor - (shape.contactV * tooth.facial + shape.contactW * tooth.occlusal);
      end_[1 - side] = s + 2.2;
      sides[side].push_back(std::move(tooth));
    }
  }
  // Along the arch from the patient's right to the left.
  std::vector<PlacedTooth> all;
  const int right = upper_ ? 1 : 0;
  for (int i = 6; i >= 0; --i) all.push_back(std::move(sides[right][i]));
  for (int i = 0; i < 7; ++i) all.push_back(std::move(sides[1 - right][i]));

  moveApart(all);

  const auto isMissing = [&](const PlacedTooth &t) {
    return std::find(settings.missing.begin(), settings.missing.end(), t.fdi) != settings.missing.end();
  };
  for (size_t i = 0; i < all.size(); ++i) {
    PlacedTooth &t = all[i];
    const double v = 0.5 * (t.shape.facial(0) - t.shape.lingual(0));
    const Vec3 neck = t.world(0, v, 0.4), apex = t.world(0, v, -7.6);
    const auto cn = curve_.locate(neck.x, neck.y), ca = curve_.locate(apex.x, apex.y);
    const bool gone = isMissing(t);
    ridgePoints_.push_back({cn.s, cn.t - (gone ? 0.5 : 0), neck.z - (gone ? 1.2 : 0),
                            0.5 * t.shape.flCervix * (gone ? 0.7 : 0.88), (ca.t - cn.t) / 8, gone ? 1.0 : 0.0});
    if (gone) continue;
    // A papilla needs two teeth: beside a gap, and behind the last molar, it is flat.
    for (int step = -1; step <= 1; step += 2) {
      const size_t j = i + static_cast<size_t>(step);
      if (j < all.size() && !isMissing(all[j])) continue;
      const bool towardsMidline = (step > 0) == (i < 7);
      (towardsMidline ? t.shape.papillaMesial : t.shape.papillaDistal) = 0.22 * t.shape.height;
    }
  }
  for (PlacedTooth &t : all)
    if (!isMissing(t)) teeth_.push_back(std::move(t));
}

void Dentition::layRidge() {
  constexpr double kWidth = 3.5;  // of the kernel along the arch: about half a tooth
  double lowest = 0;
  for (int k = 0; k <= static_cast<int>(2 * kRidgeLimit / kRidgeStep); ++k) {
    const double s = -kRidgeLimit + k * kRidgeStep;
    Crest c{0, 0, 0, 0, 0};
    double sum = 0;
    for (const RidgePoint &p : ridgePoints_) {
      // Beyond the ends the nearest molar goes on.
      const double d = (std::clamp(s, ridgePoints_.front().s < 0 ? ridgePoints_.front().s : ridgePoints_.back().s,
                                   ridgePoints_.front().s < 0 ? ridgePoints_.back().s : ridgePoints_.front().s) -
                        p.s) /
                       kWidth;
      const double w = std::exp(-0.5 * d * d);
      c.t += w * p.t, c.z += w * p.z, c.halfWidth += w * p.halfWidth, c.lean += w * p.lean, c.missing += w * p.missing;
      sum += w;
    }
    c = {c.t / sum, c.z / sum, c.halfWidth / sum, c.lean / sum, c.missing / sum};
    crests_.push_back(c);
    lowest = std::min(lowest, c.z);
  }
  if (base_) floor_ = lowest - 14;
}

Dentition::Crest Dentition::crest(double s) const {
  const double x = std::clamp((s + kRidgeLimit) / kRidgeStep, 0.0, static_cast<double>(crests_.size()) - 1.001);
  const size_t i = static_cast<size_t>(x);
  const double f = x - static_cast<double>(i);
  const Crest &a = crests_[i], &b = crests_[i + 1];
  const auto mixed = [f](double p, double q) { return p + f * (q - p); };
  return {mixed(a.t, b.t), mixed(a.z, b.z), mixed(a.halfWidth, b.halfWidth), mixed(a.lean, b.lean),
          mixed(a.missing, b.missing)};
}

double Dentition::trimLevel(const ArchCurve::Coordinates &c, double crestZ) const {
  const double wave = 0.9 * smoothNoise({c.s / 9, c.t > 0 ? 0.5 : 20.5, 0.5}, noiseSeed_ + 7) +
                      0.5 * smoothNoise({c.s / 2.5, c.t > 0 ? 0.5 : 20.5, 0.5}, noiseSeed_ + 8);
  const double depth = upper_ ? (c.t > 0 ? 6.5 : 7.5) : (c.t > 0 ? 5.5 : 6.0);
  return crestZ - depth + wave;
}

double Dentition::trim(Vec3 p) const {
  if (base_) return 1e3;
  const auto c = curve_.locate(p.x, p.y);
  return p.z - trimLevel(c, crest(c.s).z);
}

double Dentition::ridge(Vec3 p, const ArchCurve::Coordinates &c) const {
  const Crest k = crest(c.s);
  double d = k.z - p.z;
  if (base_) d = std::min(d, 7.5);  // the plaster goes straight down from where a scan ends
  const double body = d > 0 ? d : 0;
  const double front = smoothstep(22, 8, std::abs(c.s));
  const double bulge = 0.9 * (1 - std::exp(-body / 2.5));
  const double over = body > 5 ? body - 5 : 0;
  const double facial = k.halfWidth + bulge + 0.1 * body + 0.1 * over * over;
  const double lingual =
      k.halfWidth + bulge + (upper_ ? 0.6 * front : 0) + (upper_ ? 0.7 + 0.4 * front : 0.05 + 0.1 * front) * body;
  const double t = c.t - k.t - k.lean * body;
  double f = std::fmax(t - facial, -t - lingual);
  f = smoothMax(f, -d, 2.6 + 0.6 * k.missing);
  const double end = end_[c.s > 0 ? 1 : 0] + 0.25 * body;
  return smoothMax(f, std::abs(c.s) - end, 5.0);
}

Dentition::Value Dentition::evaluate(Vec3 p) const {
  const auto c = curve_.locate(p.x, p.y);
  double gum = ridge(p, c), crown = 1e3, closest = 1e3;
  uint32_t label = 0;
  std::array<ToothSample, 14> near;
  size_t count = 0;
  for (size_t i = 0; i < teeth_.size(); ++i) {
    const Vec3 d = p - teeth_[i].origin;
    if (d.x * d.x + d.y * d.y > 18.0 * 18.0) continue;
    const Vec3 q = teeth_[i].local(p);
    const ToothSample s = teeth_[i].shape.sample(q.x, q.y, q.z);
    if (s.crown >= 1e3) continue;
    near[count++] = s;
    const double open = smoothstep(0.5, 0.85, q.z / teeth_[i].shape.height);
    crown = smoothMin(crown, s.crown, bridging_ * (kEmbrasureBlend + (kContactBlend - kEmbrasureBlend) * open));
    if (s.crown < closest) closest = s.crown, label = static_cast<uint32_t>(i) + 1;
  }
  // The free gingiva of a tooth grows out of the ridge, but keeps its own form at the crown.
  const double growth = kMarginBlend + (kGumBlend - kMarginBlend) * smoothstep(0.1, 0.8, closest);
  for (size_t i = 0; i < count; ++i) gum = smoothMin(gum, near[i].gum, growth);
  // Nothing living is smooth: stippling and unevenness of the gingiva, perikymata and wear of the enamel.
  if (std::abs(gum) < 2)
    gum += 0.22 * smoothNoise((1 / 5.5) * p, noiseSeed_) + 0.09 * smoothNoise((1 / 1.7) * p, noiseSeed_ + 1) +
           0.03 * smoothNoise((1 / 0.6) * p, noiseSeed_ + 2);
  if (std::abs(crown) < 1)
    crown += 0.06 * smoothNoise((1 / 2.6) * p, noiseSeed_ + 3) + 0.025 * smoothNoise((1 / 0.9) * p, noiseSeed_ + 4);
  double f = smoothMin(crown, gum, kSulcusBlend);
  if (base_) f = smoothMax(f, floor_ - p.z, 0.4);
  return {f, crown, gum, crown < gum ? label : 0};
}

}  // namespace tsa
