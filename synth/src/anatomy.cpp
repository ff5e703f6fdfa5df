// SPDX-License-Identifier: Apache-2.0
#include "tooth_shape.h"

namespace tsa {
namespace {

// Crown length, mesiodistal width of crown and cervix, faciolingual width of crown and cervix, in mm: the table of
// average measurements in Ash & Nelson, Wheeler's Dental Anatomy, Physiology and Occlusion, 8th ed. (2003), ch. 1.
struct Size {
  double length, md, mdCervix, fl, flCervix;
};
constexpr Size kUpper[7] = {{10.5, 8.5, 7.0, 7.0, 6.0}, {9.0, 6.5, 5.0, 6.0, 5.0}, {10.0, 7.5, 5.5, 8.0, 7.0},
                            {8.5, 7.0, 5.0, 9.0, 8.0},  {8.5, 7.0, 5.0, 9.0, 8.0}, {7.5, 10.0, 8.0, 11.0, 10.0},
                            {7.0, 9.0, 7.0, 11.0, 10.0}};
constexpr Size kLower[7] = {{9.0, 5.0, 3.5, 6.0, 5.3},  {9.5, 5.5, 4.0, 6.5, 5.8}, {11.0, 7.0, 5.5, 7.5, 7.0},
                            {8.5, 7.0, 5.0, 7.5, 6.5},  {8.0, 7.0, 5.0, 8.0, 7.0}, {7.5, 11.0, 9.0, 10.5, 9.0},
                            {7.0, 10.5, 8.0, 10.0, 9.0}};

const std::vector<double> kLevels = {-1.2, 0.0, 0.25, 0.5, 0.7, 0.85, 1.0, 1.2};

CapElement cone(double u, double v, double h, double slope) {
  return {u, v, h, u, v, h, slope, 1};
}
CapElement ridge(double u0, double v0, double h0, double u1, double v1, double h1, double slope, double groove) {
  return {u0, v0, h0, u1, v1, h1, slope, groove};
}

// A cusp with its mesial and distal arms along the outline.
void addCusp(ToothShape &t, double u, double v, double drop, double slope, double arm, double fall) {
  const double h = t.height - drop;
  t.cap.push_back(cone(u, v, h, slope));
  if (arm > 0) {
    const double turn = 0.12 * (v > 0 ? -1 : 1) * arm;
    t.cap.push_back(ridge(u, v, h, u - arm, v + turn, h - fall, 1.3 * slope, 0.5));
    t.cap.push_back(ridge(u, v, h, u + arm, v + turn, h - fall, 1.3 * slope, 0.5));
  }
  t.tips.push_back({u, v, 0});
}

void addMarginalRidges(ToothShape &t, double at, double reach, double dropMesial, double dropDistal) {
  t.cap.push_back(ridge(-at, -reach, t.height - dropMesial, -at, reach, t.height - dropMesial, 0.75, 0.3));
  t.cap.push_back(ridge(at, -reach, t.height - dropDistal, at, reach, t.height - dropDistal, 0.75, 0.3));
}

void shapeIncisor(ToothShape &t, const Size &s, bool upper) {
  const double m = 0.5 * t.md, c = 0.5 * s.mdCervix / s.md * t.md, f = 0.5 * t.fl, fc = 0.5 * t.flCervix;
  t.halfWidth = Profile(kLevels, {0.55 * c, c, 0.5 * (c + m), 0.86 * m + 0.1 * c, m, 0.99 * m, 0.93 * m, 0.84 * m});
  t.facial = Profile(kLevels, {0.6 * fc, fc, 1.02 * f, 0.88 * f, 0.67 * f, 0.49 * f, 0.29 * f, 0.12 * f});
  t.lingual = Profile(kLevels, {0.6 * fc, fc, 0.93 * f, 0.48 * f, 0.26 * f, 0.2 * f, 0.19 * f, 0.17 * f});
  t.roundness = Profile(kLevels, {1.0, 0.95, 0.85, 0.75, 0.65, 0.55, 0.5, 0.5});
  t.taper = upper ? 0.2 : 0.14;
  const double distalDrop = upper ? 0.35 : 0.1;
  t.cap.push_back(ridge(-0.37 * t.md, 0.05 * f, t.height, 0.30 * t.md, 0.05 * f, t.height - distalDrop, 0.9, 0));
  t.tips.push_back({-0.42 * t.md, 0.08 * f, 1});
  t.tips.push_back({0.38 * t.md, 0.08 * f, 1});
  t.capBlend = 0.5;
  t.fossaDepth = upper ? 0.5 : 0.25;
  t.fossaWidth = 0.34 * t.md;
  t.grooves.push_back({-0.17 * t.md, 1, 0.09 * t.md, 0.10, 0.45});
  t.grooves.push_back({0.17 * t.md, 1, 0.09 * t.md, 0.10, 0.45});
  // Rounded facial line angles: the embrasure between two incisors is a furrow up to the incisal edge.
  for (const double side : {-0.5, 0.5}) t.grooves.push_back({side * t.md, 1, 0.14 * t.md, 0.4, -0.1});
  t.contactW = 0.76 * t.height;
  t.contactV = 0.2 * f;
}

void shapeCanine(ToothShape &t, const Size &s, bool upper) {
  const double m = 0.5 * t.md, c = 0.5 * s.mdCervix / s.md * t.md, f = 0.5 * t.fl, fc = 0.5 * t.flCervix;
  t.halfWidth = Profile(kLevels, {0.6 * c, c, 0.55 * (c + m), 0.98 * m, m, 0.95 * m, 0.82 * m, 0.7 * m});
  t.facial = Profile(kLevels, {0.65 * fc, fc, 1.03 * f, 0.92 * f, 0.72 * f, 0.52 * f, 0.28 * f, 0.12 * f});
  t.lingual = upper ? Profile(kLevels, {0.65 * fc, fc, 0.95 * f, 0.6 * f, 0.36 * f, 0.25 * f, 0.18 * f, 0.12 * f})
                    : Profile(kLevels, {0.65 * fc, fc, 0.86 * f, 0.46 * f, 0.28 * f, 0.2 * f, 0.16 * f, 0.12 * f});
  t.roundness = Profile(kLevels, {1.0, 1.0, 0.95, 0.85, 0.75, 0.7, 0.7, 0.7});
  t.taper = 0.2;
  const double v = 0.06 * f, fall = upper ? 0.19 : 0.16;
  t.cap.push_back(ridge(-0.05 * t.md, v, t.height, -0.45 * t.md, v, t.height - 0.8 * fall * t.md, 0.75, 0));
  t.cap.push_back(ridge(-0.05 * t.md, v, t.height, 0.48 * t.md, v, t.height - 1.6 * fall * t.md, 0.75, 0));
  t.tips.push_back({-0.05 * t.md, v, 0});
  t.capBlend = 0.6;
  t.fossaDepth = 0.25;
  t.fossaWidth = 0.3 * t.md;
  t.grooves.push_back({0, -1, 0.1 * t.md, -0.2, 0.3});  // the lingual ridge between its two fossae
  t.grooves.push_back({0, 1, 0.14 * t.md, -0.18, 0.3});
  t.contactW = 0.66 * t.height;
  t.contactV = 0.25 * f;
}

void shapePremolar(ToothShape &t, const Size &s, bool upper, bool first) {
  const double m = 0.5 * t.md, c = 0.5 * s.mdCervix / s.md * t.md, f = 0.5 * t.fl, fc = 0.5 * t.flCervix;
  t.halfWidth = Profile(kLevels, {0.6 * c, c, 0.55 * (c + m), 0.95 * m, m, 0.98 * m, 0.9 * m, 0.8 * m});
  const double lean = upper ? 0 : 0.1 * f;  // lower premolars carry the buccal cusp over the root
  t.facial = Profile(kLevels, {0.6 * fc, fc, 1.04 * f, 0.97 * f - lean, 0.86 * f - lean, 0.74 * f - lean,
                               0.6 * f - lean, 0.45 * f - lean});
  t.lingual = Profile(kLevels, {0.6 * fc, fc, 0.97 * f, 1.0 * f, 0.95 * f, 0.85 * f, 0.7 * f, 0.55 * f});
  t.roundness = Profile(kLevels, {1.0, 1.0, 0.95, 0.9, 0.85, 0.8, 0.8, 0.8});
  t.taper = 0.1;
  const double lingualDrop = upper ? (first ? 0.9 : 0.4) : (first ? 1.8 : 1.0);
  const double vb = 0.27 * t.fl - lean, vl = (upper ? -0.27 : -0.28) * t.fl;
  addCusp(t, -0.02 * t.md, vb, 0, !upper && first ? 0.8 : 0.62, 0.36 * t.md, 1.2);
  if (!upper && !first) {  // three cusps
    addCusp(t, -0.16 * t.md, vl, lingualDrop, 0.6, 0, 0);
    addCusp(t, 0.22 * t.md, vl, lingualDrop + 0.3, 0.6, 0, 0);
  } else {
    addCusp(t, -0.06 * t.md, vl, lingualDrop, 0.62, 0.3 * t.md, 0.9);
  }
  const double marginal = upper ? 1.7 : (first ? 2.3 : 1.8);
  addMarginalRidges(t, 0.41 * t.md, 0.2 * t.fl, marginal, marginal + 0.1);
  t.fissureDepth = first && !upper ? 0.2 : 0.3;
  t.capBlend = 0.8;
  t.contactW = 0.66 * t.height;
  t.contactV = 0.12 * f;
}

void shapeMolar(ToothShape &t, const Size &s, bool upper, bool first) {
  const double m = 0.5 * t.md, c = 0.5 * s.mdCervix / s.md * t.md, f = 0.5 * t.fl, fc = 0.5 * t.flCervix;
  t.halfWidth = Profile(kLevels, {0.75 * c, c, 0.5 * (c + m), 0.93 * m, m, 0.98 * m, 0.9 * m, 0.8 * m});
  const double bf = upper ? 0 : 0.08 * f, bl = upper ? 0.06 * f : 0;  // the working cusps stand further in
  t.facial = Profile(kLevels, {0.75 * fc, fc, 1.03 * f, 0.98 * f - 0.5 * bf, 0.9 * f - bf, 0.8 * f - bf, 0.68 * f - bf,
                               0.55 * f - bf});
  t.lingual =
      Profile(kLevels, {0.75 * fc, fc, 0.96 * f, 1.0 * f, 0.94 * f - bl, 0.85 * f - bl, 0.72 * f - bl, 0.58 * f - bl});
  t.roundness = Profile(kLevels, {0.8, 0.75, 0.6, 0.5, 0.45, 0.45, 0.45, 0.45});
  const double vb = 0.28 * t.fl - bf, vl = -0.28 * t.fl + bl, M = t.md;
  if (upper) {
    t.shear = 0.1;
    t.taper = first ? -0.03 : 0.06;
    addCusp(t, -0.22 * M, vb, 0.1, 0.58, 0.14 * M, 0.5);
    addCusp(t, 0.24 * M, vb, 0.5, 0.58, 0.14 * M, 0.5);
    addCusp(t, -0.2 * M, vl, 0.0, 0.52, 0.12 * M, 0.4);
    addCusp(t, 0.27 * M, vl, first ? 0.9 : 1.5, 0.6, 0, 0);
    t.cap.push_back(
        ridge(0.2 * M, 0.8 * vb, t.height - 1.3, -0.12 * M, 0.8 * vl, t.height - 1.2, 0.8, 0.15));  // oblique ridge
    t.grooves.push_back({0.02 * M, 1, 0.55, 0.4, 0.4});
    t.grooves.push_back({0.1 * M, -1, 0.5, 0.35, 0.45});
  } else {
    t.taper = 0.04;
    if (first) {
      addCusp(t, -0.29 * M, vb, 0.3, 0.58, 0.12 * M, 0.4);
      addCusp(t, 0.06 * M, vb + 0.02 * t.fl, 0.45, 0.58, 0.1 * M, 0.35);
      addCusp(t, 0.35 * M, 0.6 * vb, 0.9, 0.6, 0, 0);
      addCusp(t, -0.24 * M, vl, 0.0, 0.58, 0.13 * M, 0.4);
      addCusp(t, 0.2 * M, vl, 0.15, 0.58, 0.13 * M, 0.4);
      t.grooves.push_back({-0.12 * M, 1, 0.5, 0.4, 0.4});
      t.grooves.push_back({0.23 * M, 1, 0.45, 0.3, 0.5});
    } else {
      addCusp(t, -0.24 * M, vb, 0.25, 0.58, 0.14 * M, 0.4);
      addCusp(t, 0.24 * M, vb, 0.4, 0.58, 0.14 * M, 0.4);
      addCusp(t, -0.24 * M, vl, 0.0, 0.58, 0.14 * M, 0.4);
      addCusp(t, 0.24 * M, vl, 0.15, 0.58, 0.14 * M, 0.4);
      t.grooves.push_back({0, 1, 0.55, 0.4, 0.4});
    }
    t.grooves.push_back({-0.02 * M, -1, 0.5, 0.3, 0.5});
  }
  addMarginalRidges(t, 0.43 * M, 0.18 * t.fl, 1.4, 1.6);
  t.fissureDepth = 0.42;
  t.capBlend = 0.9;
  t.contactW = 0.68 * t.height;
  t.contactV = 0.05 * f;
}

}  // namespace

ToothShape makeTooth(bool upper, int position, Random &random) {
  const Size &s = (upper ? kUpper : kLower)[position - 1];
  ToothShape t;
  t.height = s.length * (1 + 0.03 * random.symmetric());
  t.md = s.md * (1 + 0.03 * random.symmetric());
  t.fl = s.fl * (1 + 0.03 * random.symmetric());
  t.flCervix = t.fl * s.flCervix / s.fl;
  t.warpSeed = static_cast<uint32_t>(random.next());
  if (position <= 2) shapeIncisor(t, s, upper);
  if (position == 3) shapeCanine(t, s, upper);
  if (position == 4 || position == 5) shapePremolar(t, s, upper, position == 4);
  if (position >= 6) shapeMolar(t, s, upper, position == 6);
  // The gingival margin lies 1 to 2 mm occlusal of the cervical line; papillae end below the contact.
  t.gumFacial = 1.1 + 0.3 * random.symmetric();
  t.gumLingual = 1.3 + 0.3 * random.symmetric();
  const double papilla = (position <= 3 ? 0.52 : 0.5) * t.height;
  t.papillaMesial = papilla + 0.2 * random.symmetric();
  t.papillaDistal = papilla + 0.2 * random.symmetric();
  return t;
}

}  // namespace tsa
