// How concave labelled arches are, and where: what the synthetic arch is made to resemble.
//
//   bench_concavity [FOLDER | --arch upper|lower:SEED:CROWDING:TRIANGLES]...
//
// One table for all arches given, by kind of tooth and place. c = max(0, -kappa_min), 1/mm (geometry/concavity.h,
// normals smoothed over 0.15 mm).
//   gum facial, lingual, proximal; contact: the lines between the labels. On the line: c of the label line itself.
//     Valley: the largest c within 0.8 mm of it. Offset: how far from the line that is, mm, positive towards the
//     gingiva; for contacts without a sign.
//   occlusal: crowns further than 1.2 mm from every line, where they face the occlusal side: fissures and fossae.
//   wall: the same where they do not. Below .8-2, 2-4: gingiva by its distance from the nearest gum line, mm.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <map>
#include <string>

#include "bench/field_labels.h"
#include "bench/synthetic_scan.h"
#include "geometry/concavity.h"
#include "geometry/paths.h"

namespace {

using namespace ts;
using bench::Index;
using mesh::Vec3;

constexpr double kNormalRadius = 0.15;  // of tooth::Options
constexpr double kAround = 0.8;

struct Weighted {
  double value, weight;
};

double quantile(Vec<Weighted> &values, double q) {
  std::sort(values.begin(), values.end(), [](const Weighted &a, const Weighted &b) { return a.value < b.value; });
  double sum = 0, reached = 0;
  for (const Weighted &v : values) sum += v.weight;
  for (const Weighted &v : values)
    if ((reached += v.weight) >= q * sum) return v.value;
  return 0;
}

struct Row {
  Vec<Weighted> line, valley, offset;  // along lines
  Vec<Weighted> area;                  // over areas
};
using Table = std::map<std::string, Row>;

const char *kind_of(int fdi) {
  const int position = fdi % 10;
  return position <= 2 ? "incisor" : position == 3 ? "canine" : position <= 5 ? "premolar" : "molar";
}

struct Measured {
  const bench::ScanFolder &scan;
  bench::LabelledTeeth teeth;
  Vec<double> concavity;
  Vec<Vec3> centre;
  Vec3 hub = Vec3::Zero();

  explicit Measured(const bench::ScanFolder &s) : scan(s), teeth(bench::labelled_teeth(s)) {
    concavity = geometry::concavity(s.surface, kNormalRadius, false, Executor(1)).vertex;
    centre.assign(teeth.label.size(), Vec3::Zero());
    Vec<double> area(centre.size(), 0);
    for (Index f = 0; f < s.surface.faces(); ++f) {
      const Index i = teeth.of_face[f];
      if (i == mesh::none) continue;
      centre[i] += s.surface.face_area[f] * s.surface.position[s.surface.triangle[f][0]];
      area[i] += s.surface.face_area[f];
    }
    for (Index i = 0; i < centre.size(); ++i) {
      centre[i] /= area[i];
      hub += centre[i] / static_cast<double>(centre.size());
    }
  }

  // Sides by the direction from the middle of the tooth, in plan.
  const char *side(Index tooth, const Vec3 &p) const {
    const Vec3 from = centre[tooth > 0 ? tooth - 1 : 0],
               to = centre[std::min<std::size_t>(tooth + 1, centre.size() - 1)];
    const Vec3 along = (to - from).cross(teeth.occlusal).cross(-teeth.occlusal).normalized();
    Vec3 out = along.cross(teeth.occlusal);
    if (out.dot(centre[tooth] - hub) < 0) out = -out;
    const Vec3 d = p - centre[tooth];
    if (std::abs(d.dot(along)) > std::abs(d.dot(out))) return "gum proximal";
    return d.dot(out) > 0 ? "gum facial" : "gum lingual";
  }

  // -1 in a tooth, 1 on gingiva, 0 on a line.
  int place(Index v) const {
    int sign = 2;
    for (const Index f : scan.surface.vertex_faces[v]) {
      const int here = teeth.of_face[f] == mesh::none ? 1 : -1;
      if (sign != 2 && sign != here) return 0;
      sign = here;
    }
    return sign;
  }

  Vec<Index> around(Index start, const Vec3 &p) const {
    Vec<Index> found{start};
    for (std::size_t i = 0; i < found.size(); ++i)
      for (const Index e : scan.surface.vertex_edges[found[i]]) {
        const Index v = scan.surface.other_end(e, found[i]);
        if ((scan.surface.position[v] - p).norm() < kAround && std::find(found.begin(), found.end(), v) == found.end())
          found.push_back(v);
      }
    return found;
  }

  void lines(Table &table) const {
    const mesh::Surface &s = scan.surface;
    for (Index h = 0; h < 3 * s.faces(); ++h) {
      if (s.twin[h] == mesh::none || s.twin[h] < h) continue;
      Index a = teeth.of_face[h / 3], b = teeth.of_face[s.twin[h] / 3];
      if (a == b) continue;
      if (a == mesh::none) std::swap(a, b);
      const Index from = s.from(h), to = s.to(h);
      const Vec3 p = 0.5 * (s.position[from] + s.position[to]);
      const double length = (s.position[from] - s.position[to]).norm();
      Index deepest = from;
      for (const Index v : around(from, p))
        if (concavity[v] > concavity[deepest]) deepest = v;
      Row &row = table[std::string(kind_of(teeth.label[a])) + ' ' + (b == mesh::none ? side(a, p) : "contact")];
      row.line.push_back({0.5 * (concavity[from] + concavity[to]), length});
      row.valley.push_back({concavity[deepest], length});
      const double off = teeth.depth[deepest];
      row.offset.push_back({b == mesh::none ? place(deepest) * off : off, length});
    }
  }

  void areas(Table &table) const {
    const mesh::Surface &s = scan.surface;
    Vec<geometry::PathStart> gumLine;
    for (Index v = 0; v < s.vertices(); ++v)
      if (place(v) == 0)
        for (const Index f : s.vertex_faces[v])
          if (teeth.of_face[f] != mesh::none) {
            gumLine.push_back({v, 0, teeth.of_face[f]});
            break;
          }
    geometry::PathFinder paths(s);
    paths.search(
        gumLine, [&](Index e) { return s.edge_length(e); },
        [&](Index v, double d, Index tooth) {
          if (d > 4) return false;
          if (place(v) == 1 && d > 0.8 && !s.on_boundary[v])
            table[std::string(kind_of(teeth.label[tooth])) + (d < 2 ? " below .8-2" : " below 2-4")].area.push_back(
                {concavity[v], s.vertex_area[v]});
          return true;
        });
    for (Index f = 0; f < s.faces(); ++f) {
      const Index tooth = teeth.of_face[f];
      if (tooth == mesh::none) continue;
      for (const Index v : s.triangle[f])
        if (teeth.depth[v] > 1.2)
          table[std::string(kind_of(teeth.label[tooth])) +
                (s.face_normal[f].dot(teeth.occlusal) > 0.5 ? " occlusal" : " wall")]
              .area.push_back({concavity[v], s.face_area[f] / 3});
    }
  }
};

bench::ScanFolder arch(const std::string &text) {
  char jaw[6];
  unsigned seed = 0, triangles = 0;
  double crowding = 0;
  if (std::sscanf(text.c_str(), "%5[a-z]:%u:%lf:%u", jaw, &seed, &crowding, &triangles) != 4)
    throw std::runtime_error("not an arch: " + text);
  return bench::synthetic_scan(std::strcmp(jaw, "upper") == 0, crowding, seed, {}, triangles);
}

void print(Table &table) {
  std::printf("%-22s %7s | %s | %s | %s\n", "", "mm", "on the line 25 50 75", "valley 10 25 50 75",
              "offset 10 25 50 75 90");
  for (auto &[name, r] : table) {
    if (r.line.empty()) continue;
    double length = 0;
    for (const Weighted &w : r.line) length += w.weight;
    std::printf("%-22s %7.0f |  ", name.c_str(), length);
    for (const double q : {.25, .5, .75}) std::printf("%6.2f", quantile(r.line, q));
    std::printf("   |");
    for (const double q : {.1, .25, .5, .75}) std::printf("%6.2f", quantile(r.valley, q));
    std::printf(" |");
    for (const double q : {.1, .25, .5, .75, .9}) std::printf("%6.2f", quantile(r.offset, q));
    std::printf("\n");
  }
  std::printf("%-22s %7s | %s\n", "", "mm^2", "c 25 50 75 90 95");
  for (auto &[name, r] : table) {
    if (r.area.empty()) continue;
    double area = 0;
    for (const Weighted &w : r.area) area += w.weight;
    std::printf("%-22s %7.0f |", name.c_str(), area);
    for (const double q : {.25, .5, .75, .9, .95}) std::printf("%6.2f", quantile(r.area, q));
    std::printf("\n");
  }
}

}  // namespace

int main(int argc, char **argv) try {
  Table table;
  for (int i = 1; i < argc; ++i) {
    const bool made = std::strcmp(argv[i], "--arch") == 0 && i + 1 < argc;
    const bench::ScanFolder scan = made ? arch(argv[++i]) : bench::read_scan_folder(argv[i]);
    if (scan.label.size() != scan.surface.faces()) throw std::runtime_error("no labels in " + scan.name);
    const Measured measured(scan);
    measured.lines(table);
    measured.areas(table);
  }
  print(table);
  return 0;
} catch (const std::exception &e) {
  std::fprintf(stderr, "bench_concavity: %s\n", e.what());
  return 1;
}
