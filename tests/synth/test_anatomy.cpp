// SPDX-License-Identifier: Apache-2.0
#include "arch_mesh.h"

namespace {

double distance2d(Point a, const double *b) {
  return std::hypot(a.x - b[0], a.y - b[1]);
}

}  // namespace

TEST_CASE("the teeth are those of the jaw, from the patient's right to the left") {
  const ArchMesh &upper = plainArch(TSA_JAW_UPPER, 20000), &lower = plainArch(TSA_JAW_LOWER, 20000);
  CHECK(upper.fdi == std::vector<uint32_t>{17, 16, 15, 14, 13, 12, 11, 21, 22, 23, 24, 25, 26, 27});
  CHECK(lower.fdi == std::vector<uint32_t>{47, 46, 45, 44, 43, 42, 41, 31, 32, 33, 34, 35, 36, 37});
  for (const ArchMesh *m : {&upper, &lower}) {
    const auto area = m->areas();
    for (size_t k = 1; k < area.size(); ++k) {
      const uint32_t position = m->fdi[k - 1] % 10;
      CAPTURE(m->fdi[k - 1]);
      CHECK(area[k] > (position <= 2 ? 45 : position <= 5 ? 85 : 130));
      CHECK(area[k] < (position <= 2 ? 190 : position <= 5 ? 190 : 270));
    }
    CHECK(area[0] > 1200);
    // +z is occlusal: no gingiva is as high as the tips, and the front is at +y.
    double top = -1e9, gum = -1e9;
    for (size_t f = 0; f < m->faces.size(); ++f) {
      double &z = m->labels[f] == 0 ? gum : top;
      z = std::max(z, m->points[m->faces[f][0]].z);
    }
    CHECK(gum < top - 2);
  }
}

TEST_CASE("neighbours touch") {
  const ArchMesh &m = plainArch(TSA_JAW_UPPER, 30000);
  std::vector<int> contact(m.fdi.size() + 1, 0);
  for (const auto &[e, s] : m.edges()) {
    if (s.faces != 2) continue;
    const uint32_t a = std::min(m.labels[s.up], m.labels[s.down]), b = std::max(m.labels[s.up], m.labels[s.down]);
    if (a > 0 && b == a + 1) ++contact[a];
  }
  for (size_t k = 1; k < m.fdi.size(); ++k) {
    CAPTURE(m.fdi[k - 1]);
    CHECK(contact[k] >= 5);
  }
}

TEST_CASE("gum line and contacts run in concave creases") {
  const ArchMesh &m = plainArch(TSA_JAW_LOWER, 40000);
  double concave[2] = {0, 0}, all[2] = {0, 0};
  for (const auto &[e, s] : m.edges()) {
    if (s.faces != 2 || m.labels[s.up] == m.labels[s.down]) continue;
    const int kind = m.labels[s.up] == 0 || m.labels[s.down] == 0 ? 0 : 1;
    // Below the plane of the one face lies the far corner of the other: convex; above: concave.
    uint32_t far = 0;
    for (const uint32_t v : m.faces[s.down])
      if (v != e.first && v != e.second) far = v;
    const double length = norm(m.points[e.first] - m.points[e.second]);
    all[kind] += length;
    concave[kind] += length * (dot(m.normal(s.up), m.points[far] - m.points[e.first]) > 0);
  }
  CHECK(concave[0] > 0.75 * all[0]);
  CHECK(concave[1] > 0.65 * all[1]);  // the bridged part below a contact is a flat saddle
}

TEST_CASE("crowns have undercuts, which a height field has not") {
  const ArchMesh &m = plainArch(TSA_JAW_LOWER, 20000);
  std::vector<double> under(m.fdi.size() + 1, 0);
  for (size_t f = 0; f < m.faces.size(); ++f) {
    const Point n = m.normal(f);
    if (n.z < -0.1 * norm(n)) under[m.labels[f]] += 0.5 * norm(n);
  }
  for (size_t k = 1; k < under.size(); ++k)
    if (m.fdi[k - 1] % 10 >= 5) CHECK(under[k] > 3);
}

TEST_CASE("features lie on their tooth, tips at its high points") {
  for (const uint32_t jaw : {TSA_JAW_UPPER, TSA_JAW_LOWER}) {
    const ArchMesh &m = plainArch(jaw, 40000);
    const double edge = m.meanEdge();
    std::vector<int> cusps(m.fdi.size() + 1, 0), corners(m.fdi.size() + 1, 0);
    std::vector<char> mine(m.points.size());
    for (const tsa_feature &t : m.features) {
      REQUIRE(t.label >= 1);
      REQUIRE(t.label <= m.fdi.size());
      ++(t.kind == TSA_CUSP ? cusps : corners)[t.label];
      double closest = 1e9, highest = -1e9;
      for (size_t f = 0; f < m.faces.size(); ++f)
        for (const uint32_t v : m.faces[f]) {
          const Point p = m.points[v];
          if (m.labels[f] == t.label)
            closest = std::min(closest, norm(p - Point{t.position[0], t.position[1], t.position[2]}));
          if (distance2d(p, t.position) < 0.6) highest = std::max(highest, p.z);
        }
      CAPTURE(m.fdi[t.label - 1]);
      CHECK(closest < edge);
      if (t.kind == TSA_CUSP) CHECK(t.position[2] > highest - 0.35);
    }
    for (size_t k = 1; k <= m.fdi.size(); ++k) {
      const uint32_t position = m.fdi[k - 1] % 10;
      CAPTURE(m.fdi[k - 1]);
      CHECK(corners[k] == (position <= 2 ? 2 : 0));
      if (position == 3) CHECK(cusps[k] == 1);
      if (position == 4 || position == 5) CHECK((cusps[k] == 2 || cusps[k] == 3));
      if (position >= 6) CHECK((cusps[k] == 4 || cusps[k] == 5));
    }
  }
}

TEST_CASE("molars have a fossa about as deep as real ones") {
  for (const uint32_t jaw : {TSA_JAW_UPPER, TSA_JAW_LOWER}) {
    const ArchMesh &m = plainArch(jaw, 40000);
    for (uint32_t k = 1; k <= m.fdi.size(); ++k) {
      if (m.fdi[k - 1] % 10 < 6) continue;
      double middle[3] = {0, 0, 0}, n = 0;
      for (const tsa_feature &t : m.features)
        if (t.label == k) {
          for (int c = 0; c < 3; ++c) middle[c] += t.position[c];
          ++n;
        }
      for (double &c : middle) c /= n;
      double lowest = 1e9;
      for (const Point &p : m.points)
        if (distance2d(p, middle) < 1.0 && p.z > middle[2] - 4) lowest = std::min(lowest, p.z);
      CAPTURE(m.fdi[k - 1]);
      CHECK(middle[2] - lowest > 0.8);
      CHECK(middle[2] - lowest < 2.8);
    }
  }
}

TEST_CASE("missing teeth leave a healed ridge") {
  tsa_options o = archOptions(TSA_JAW_LOWER, 20000);
  const uint32_t missing[] = {36, 45};
  o.missing = missing;
  o.missing_count = 2;
  const ArchMesh gap = make(o);
  const ArchMesh &full = plainArch(TSA_JAW_LOWER, 20000);
  CHECK(gap.fdi == std::vector<uint32_t>{47, 46, 44, 43, 42, 41, 31, 32, 33, 34, 35, 37});
  for (const uint32_t l : gap.labels) REQUIRE(l <= 12);
  // Where the molar stood, gingiva is the highest thing now, well below the crown that was.
  double x = 0, y = 0, n = 0;
  for (const tsa_feature &t : full.features)
    if (full.fdi[t.label - 1] == 36) x += t.position[0], y += t.position[1], ++n;
  const double at[2] = {x / n, y / n};
  double ridge = -1e9, crown = -1e9;
  for (size_t f = 0; f < gap.faces.size(); ++f) {
    const Point p = gap.points[gap.faces[f][0]];
    if (distance2d(p, at) > 1.5) continue;
    CHECK(gap.labels[f] == 0);
    ridge = std::max(ridge, p.z);
  }
  for (const Point &p : full.points)
    if (distance2d(p, at) < 1.5) crown = std::max(crown, p.z);
  CHECK(ridge > crown - 12);
  CHECK(ridge < crown - 3);
}
