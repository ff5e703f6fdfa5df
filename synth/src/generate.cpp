// SPDX-License-Identifier: Apache-2.0
#include "generate.h"

#include <algorithm>
#include <optional>

#include "finish.h"
#include "polygonise.h"
#include "remesh.h"

namespace tsa {
namespace {

std::vector<uint8_t> withinTrim(const Dentition &dentition, const TriMesh &mesh) {
  std::vector<uint8_t> vertex(mesh.points.size()), face(mesh.faces.size());
  for (size_t v = 0; v < vertex.size(); ++v) vertex[v] = dentition.trim(mesh.points[v]) >= 0;
  for (size_t f = 0; f < face.size(); ++f)
    face[f] = vertex[mesh.faces[f][0]] + vertex[mesh.faces[f][1]] + vertex[mesh.faces[f][2]] >= 2;
  return face;
}

double area(const TriMesh &mesh, const std::vector<uint8_t> &counted) {
  double sum = 0;
  for (size_t f = 0; f < mesh.faces.size(); ++f) {
    const auto &t = mesh.faces[f];
    if (counted[f])
      sum += 0.5 * norm(cross(mesh.points[t[1]] - mesh.points[t[0]], mesh.points[t[2]] - mesh.points[t[0]]));
  }
  return sum;
}

// Empty if its Euler characteristic is not the one given, unless it is wanted anyway.
TriMesh surface(const Dentition &dentition, uint32_t triangles, int64_t euler, bool anyway) {
  constexpr double kSurplus = 1.7;  // triangles of the grid for one of the result: enough to get rid of its slivers
  constexpr double kTrial = 0.8;
  const TriMesh trial = polygonise(dentition, kTrial);
  const auto inTrial = withinTrim(dentition, trial);
  const double found = static_cast<double>(std::count(inTrial.begin(), inTrial.end(), 1));
  TriMesh fine = polygonise(dentition, kTrial * std::sqrt(found / (kSurplus * triangles)));
  // Remeshing keeps the handles, so that they are looked for before it.
  if (!anyway && eulerCharacteristic(trimmed(fine, [&](Vec3 p) { return dentition.trim(p); })) != euler) return {};
  const auto counted = withinTrim(dentition, fine);
  const double edge = std::sqrt(4 / std::sqrt(3.0) * area(fine, counted) / triangles);

  const auto field = [&](Vec3 p) { return dentition.field(p); };
  Remesher remesher(std::move(fine));
  remesher.collapseTo(triangles, counted, edge);
  remesher.project(field, 0.4 * edge);
  for (int round = 0; round < 2; ++round) {
    remesher.relax(0.5);
    remesher.project(field, 0.4 * edge);
    remesher.flip();
  }
  remesher.snap([&](Vec3 p) { return dentition.label(p); });
  remesher.relax(0.3);
  for (int round = 0; round < 3; ++round) remesher.project(field, 0.4 * edge);
  remesher.flip();
  return trimmed(remesher.take(), [&](Vec3 p) { return dentition.trim(p); });
}

// The surface point under (u, v) of a tooth, seen along its axis; then uphill to the tip, which may lie a little aside.
bool findTip(const Dentition &dentition, const PlacedTooth &tooth, const Tip &tip, uint32_t label, Vec3 &out) {
  const auto drop = [&](double u, double v) {
    double w = tooth.shape.height + 1.5;
    for (int i = 0; i < 60; ++i) {
      const double f = dentition.field(tooth.world(u, v, w));
      if (f < 1e-4) break;
      w -= 0.7 * std::min(f, 1.0);
      if (w < 0.4 * tooth.shape.height) break;
    }
    return w;
  };
  double u = tip.u, v = tip.v, w = drop(u, v);
  if (tip.kind == 0)
    for (const double step : {0.3, 0.15, 0.075})
      for (int i = 0; i < 4; ++i) {
        double bestU = u, bestV = v;
        for (int d = 0; d < 4; ++d) {
          const double du = u + step * (d == 0) - step * (d == 1), dv = v + step * (d == 2) - step * (d == 3);
          if (std::hypot(du - tip.u, dv - tip.v) > 0.9) continue;
          const double dw = drop(du, dv);
          if (dw > w + 1e-6) w = dw, bestU = du, bestV = dv;
        }
        if (bestU == u && bestV == v) break;
        u = bestU, v = bestV;
      }
  out = tooth.world(u, v, w);
  return w > 0.4 * tooth.shape.height && dentition.label(out) == label;
}

}  // namespace

Arch generate(const Settings &settings) {
  // A narrow tunnel under a contact has no place on a scan: bridge more until there is none.
  constexpr double kBridging[] = {1, 1.15, 1.3, 1.5, 1.7, 2.2, 3, 4.2};
  Arch arch;
  std::optional<Dentition> made;
  for (const double bridging : kBridging) {
    made.emplace(settings, bridging);
    arch.mesh = surface(*made, settings.triangles, settings.base ? 2 : 1, bridging == kBridging[7]);
    if (!arch.mesh.faces.empty()) break;
  }
  const Dentition &dentition = *made;
  for (const auto &t : arch.mesh.faces)
    arch.labels.push_back(
        dentition.label((1.0 / 3) * (arch.mesh.points[t[0]] + arch.mesh.points[t[1]] + arch.mesh.points[t[2]])));
  removeSpecks(arch.mesh, arch.labels, static_cast<uint32_t>(dentition.teeth().size()) + 1);
  for (uint32_t i = 0; i < dentition.teeth().size(); ++i) {
    const PlacedTooth &tooth = dentition.teeth()[i];
    arch.fdi.push_back(tooth.fdi);
    for (const Tip &tip : tooth.shape.tips) {
      Vec3 p;
      if (findTip(dentition, tooth, tip, i + 1, p)) arch.features.push_back({i + 1, tip.kind, p});
    }
  }
  if (settings.noise > 0) addNoise(arch.mesh, settings.noise * meanEdge(arch.mesh), settings.isotropic, settings.seed);
  return arch;
}

}  // namespace tsa
