// SPDX-License-Identifier: Apache-2.0
#include "finish.h"

#include <algorithm>
#include <numeric>

#include "random.h"

namespace tsa {
namespace {

constexpr uint32_t kNone = UINT32_MAX;

// Neighbour faces across the edges, kNone at a border.
std::vector<std::array<uint32_t, 3>> neighbours(const TriMesh &mesh) {
  struct Edge {
    uint32_t a, b, face, side;
  };
  std::vector<uint32_t> start(mesh.points.size() + 1, 0);
  for (const auto &t : mesh.faces)
    for (int i = 0; i < 3; ++i) ++start[std::min(t[i], t[(i + 1) % 3]) + 1];
  std::partial_sum(start.begin(), start.end(), start.begin());
  std::vector<Edge> edges(mesh.faces.size() * 3);
  std::vector<uint32_t> fill(start.begin(), start.end() - 1);
  for (uint32_t f = 0; f < mesh.faces.size(); ++f)
    for (uint32_t i = 0; i < 3; ++i) {
      const uint32_t a = mesh.faces[f][i], b = mesh.faces[f][(i + 1) % 3];
      edges[fill[std::min(a, b)]++] = {std::min(a, b), std::max(a, b), f, i};
    }
  std::vector<std::array<uint32_t, 3>> out(mesh.faces.size(), {kNone, kNone, kNone});
  for (size_t v = 0; v < mesh.points.size(); ++v)
    for (uint32_t i = start[v]; i < start[v + 1]; ++i)
      for (uint32_t j = i + 1; j < start[v + 1]; ++j)
        if (edges[i].b == edges[j].b) {
          out[edges[i].face][edges[i].side] = edges[j].face;
          out[edges[j].face][edges[j].side] = edges[i].face;
        }
  return out;
}

// Components of the faces for which `joined` holds across their common edge; returns the sizes.
std::vector<uint32_t> components(const std::vector<std::array<uint32_t, 3>> &adjacent, std::vector<uint32_t> &component,
                                 const std::function<bool(uint32_t, uint32_t)> &joined) {
  component.assign(adjacent.size(), kNone);
  std::vector<uint32_t> sizes, stack;
  for (uint32_t f = 0; f < adjacent.size(); ++f) {
    if (component[f] != kNone) continue;
    const uint32_t id = static_cast<uint32_t>(sizes.size());
    sizes.push_back(0);
    component[f] = id;
    stack.push_back(f);
    while (!stack.empty()) {
      const uint32_t g = stack.back();
      stack.pop_back();
      ++sizes[id];
      for (const uint32_t n : adjacent[g])
        if (n != kNone && component[n] == kNone && joined(g, n)) component[n] = id, stack.push_back(n);
    }
  }
  return sizes;
}

TriMesh compacted(const TriMesh &mesh, const std::vector<uint8_t> &keep) {
  TriMesh out;
  std::vector<uint32_t> id(mesh.points.size(), kNone);
  for (size_t f = 0; f < mesh.faces.size(); ++f) {
    if (!keep[f]) continue;
    auto t = mesh.faces[f];
    for (uint32_t &v : t) {
      if (id[v] == kNone) id[v] = static_cast<uint32_t>(out.points.size()), out.points.push_back(mesh.points[v]);
      v = id[v];
    }
    out.faces.push_back(t);
  }
  return out;
}

// Drops faces with two rim edges, and all faces at vertices where more than one rim passes; true if there was any.
bool cleanRim(const TriMesh &mesh, const std::vector<std::array<uint32_t, 3>> &adjacent, std::vector<uint8_t> &keep) {
  std::vector<uint8_t> rimEdges(mesh.points.size(), 0);
  bool any = false;
  for (uint32_t f = 0; f < mesh.faces.size(); ++f) {
    if (!keep[f]) continue;
    int open = 0;
    for (int i = 0; i < 3; ++i) {
      const uint32_t n = adjacent[f][i];
      if (n != kNone && keep[n]) continue;
      ++open;
      rimEdges[mesh.faces[f][i]]++;
      rimEdges[mesh.faces[f][(i + 1) % 3]]++;
    }
    if (open >= 2) keep[f] = 0, any = true;
  }
  if (any) return true;
  for (uint32_t f = 0; f < mesh.faces.size(); ++f) {
    if (!keep[f]) continue;
    for (const uint32_t v : mesh.faces[f])
      if (rimEdges[v] > 2) keep[f] = 0, any = true;
  }
  return any;
}

}  // namespace

TriMesh trimmed(const TriMesh &mesh, const std::function<double(Vec3)> &trim) {
  const auto adjacent = neighbours(mesh);
  std::vector<uint8_t> keep(mesh.faces.size());
  for (size_t f = 0; f < mesh.faces.size(); ++f) {
    const auto &t = mesh.faces[f];
    keep[f] = trim((1.0 / 3) * (mesh.points[t[0]] + mesh.points[t[1]] + mesh.points[t[2]])) >= 0;
  }
  // A patch beyond the trim that does not reach the border is a bump, not the end of the scan.
  std::vector<uint32_t> component;
  auto sizes = components(adjacent, component, [&](uint32_t a, uint32_t b) { return keep[a] == keep[b]; });
  std::vector<uint8_t> open(sizes.size(), 0);
  for (size_t f = 0; f < mesh.faces.size(); ++f)
    for (const uint32_t n : adjacent[f]) open[component[f]] |= n == kNone;
  for (size_t f = 0; f < mesh.faces.size(); ++f) keep[f] = keep[f] || !open[component[f]];
  for (int round = 0; round < 50; ++round) {
    sizes = components(adjacent, component, [&](uint32_t a, uint32_t b) { return keep[a] == keep[b]; });
    std::vector<uint8_t> isKept(sizes.size(), 0);
    for (size_t f = 0; f < mesh.faces.size(); ++f) isKept[component[f]] = keep[f];
    uint32_t largest = kNone;
    for (uint32_t c = 0; c < sizes.size(); ++c)
      if (isKept[c] && (largest == kNone || sizes[c] > sizes[largest])) largest = c;
    for (size_t f = 0; f < mesh.faces.size(); ++f) keep[f] = component[f] == largest;
    if (!cleanRim(mesh, adjacent, keep)) break;
  }
  return compacted(mesh, keep);
}

void removeSpecks(const TriMesh &mesh, std::vector<uint32_t> &labels, uint32_t labelCount) {
  const auto adjacent = neighbours(mesh);
  std::vector<uint32_t> component;
  for (int round = 0; round < 8; ++round) {
    const auto sizes = components(adjacent, component, [&](uint32_t a, uint32_t b) { return labels[a] == labels[b]; });
    std::vector<uint32_t> best(labelCount, kNone);
    for (size_t f = 0; f < labels.size(); ++f) {
      uint32_t &b = best[labels[f]];
      if (b == kNone || sizes[component[f]] > sizes[b]) b = component[f];
    }
    // Votes of the faces around a speck, by label.
    std::vector<uint32_t> winner(sizes.size(), kNone), votes(sizes.size(), 0);
    bool any = false;
    for (size_t f = 0; f < labels.size(); ++f) {
      if (component[f] == best[labels[f]]) continue;
      any = true;
      for (const uint32_t n : adjacent[f]) {
        if (n == kNone || labels[n] == labels[f]) continue;
        uint32_t &w = winner[component[f]], &v = votes[component[f]];
        if (w == labels[n])
          ++v;
        else if (v == 0)
          w = labels[n], v = 1;
        else
          --v;
      }
    }
    if (!any) break;
    const auto before = labels;
    for (size_t f = 0; f < labels.size(); ++f)
      if (component[f] != best[before[f]] && winner[component[f]] != kNone) labels[f] = winner[component[f]];
  }
}

int64_t eulerCharacteristic(const TriMesh &mesh) {
  int64_t open = 0;
  for (const auto &row : neighbours(mesh))
    for (const uint32_t n : row) open += n == kNone;
  const auto faces = static_cast<int64_t>(mesh.faces.size());
  return static_cast<int64_t>(mesh.points.size()) - (3 * faces + open) / 2 + faces;
}

double meanEdge(const TriMesh &mesh) {
  double sum = 0;
  for (const auto &t : mesh.faces)
    for (int i = 0; i < 3; ++i) sum += norm(mesh.points[t[i]] - mesh.points[t[(i + 1) % 3]]);
  return mesh.faces.empty() ? 0 : sum / (3.0 * static_cast<double>(mesh.faces.size()));
}

void addNoise(TriMesh &mesh, double sigma, bool isotropic, uint64_t seed) {
  std::vector<Vec3> normals(mesh.points.size());
  for (const auto &t : mesh.faces) {
    const Vec3 n = cross(mesh.points[t[1]] - mesh.points[t[0]], mesh.points[t[2]] - mesh.points[t[0]]);
    for (const uint32_t v : t) normals[v] = normals[v] + n;
  }
  Random random(mix(seed) ^ 0x6e6f697365u);
  for (size_t v = 0; v < mesh.points.size(); ++v) {
    const double a = random.gaussian(), b = random.gaussian(), c = random.gaussian();
    mesh.points[v] = mesh.points[v] + sigma * (isotropic ? Vec3{a, b, c} : a * normalised(normals[v]));
  }
}

}  // namespace tsa
