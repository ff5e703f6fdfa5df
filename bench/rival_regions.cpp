#include "bench/rival_regions.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <queue>
#include <vector>

namespace ts::bench {
namespace {

// A line that two regions share.
struct Side {
  double length = 0, depth = 0;  // mm; integral of the concavity along it
};

struct Region {
  double area = 0, outline = 0, border = 0, top = std::numeric_limits<double>::infinity();
  std::map<Index, Side> beside;
  bool tooth = false;
};

// Numbers the vertices off the lines by the pieces that they make up.
Vec<Index> pieces(const Surface &s, const Mask &line, Index &count) {
  Vec<Index> piece(s.vertices(), mesh::none);
  std::vector<Index> stack;
  for (Index start = 0; start < s.vertices(); ++start) {
    if (line[start] || piece[start] != mesh::none) continue;
    piece[start] = count;
    stack.assign(1, start);
    while (!stack.empty()) {
      const Index v = stack.back();
      stack.pop_back();
      for (const Index e : s.vertex_edges[v]) {
        const Index w = s.other_end(e, v);
        if (line[w] || piece[w] != mesh::none) continue;
        piece[w] = count;
        stack.push_back(w);
      }
    }
    ++count;
  }
  return piece;
}

// A face belongs to the piece that one of its corners is in (two pieces never share a face). One with all corners on
// lines is given to the region that reaches it first.
Vec<Index> regions_of_faces(const Surface &s, const Mask &line, Index &count) {
  const Vec<Index> piece = pieces(s, line, count);
  Vec<Index> of(s.faces(), mesh::none);
  std::queue<Index> queue;
  for (Index f = 0; f < s.faces(); ++f) {
    for (const Index v : s.triangle[f]) of[f] = std::min(of[f], piece[v]);
    if (of[f] != mesh::none) queue.push(f);
  }
  for (; !queue.empty(); queue.pop()) {
    const Index f = queue.front();
    for (Index h = 3 * f; h < 3 * f + 3; ++h) {
      if (s.twin[h] == mesh::none) continue;
      const Index g = mesh::face_of(s.twin[h]);
      if (of[g] != mesh::none) continue;
      of[g] = of[f];
      queue.push(g);
    }
  }
  return of;  // none only where a whole component is line
}

std::vector<Region> measured(const Surface &s, const Vec<Index> &of, Index count, const Vec<double> &concavity,
                             const Heights &heights) {
  std::vector<Region> region(count);
  for (Index h = 0; h < s.twin.size(); ++h) {
    const Index r = of[mesh::face_of(h)];
    if (r == mesh::none) continue;
    Region &own = region[r];
    if (h % 3 == 0) own.area += s.face_area[h / 3];
    own.top = std::min(own.top, heights.below_top[s.from(h)]);
    const Index other = s.twin[h] == mesh::none ? r : of[mesh::face_of(s.twin[h])];
    if (s.twin[h] != mesh::none && (other == r || other == mesh::none)) continue;
    const double length = s.edge_length(s.edge_of[h]);
    own.outline += length;
    if (s.twin[h] == mesh::none) {
      own.border += length;
    } else {
      own.beside[other].length += length;
      own.beside[other].depth += length * (concavity[s.from(h)] + concavity[s.to(h)]) / 2;
    }
  }
  return region;
}

void tell_teeth(std::vector<Region> &region, const RegionOptions &options) {
  for (Region &r : region)
    r.tooth = r.area < options.most_tooth && r.top < options.stands && r.border < options.border_share * r.outline;
}

// Joins region `a` to `b`, whose outlines then have one line less between them.
void join(std::vector<Region> &region, Index a, Index b) {
  Region &from = region[a], &to = region[b];
  const double shared = to.beside[a].length;
  to.area += from.area;
  to.outline += from.outline - 2 * shared;
  to.border += from.border;
  to.top = std::min(to.top, from.top);
  to.beside.erase(a);
  from.beside.erase(b);
  for (const auto &[n, side] : from.beside) {
    to.beside[n].length += side.length, to.beside[n].depth += side.depth;
    region[n].beside[b].length += side.length, region[n].beside[b].depth += side.depth;
    region[n].beside.erase(a);
  }
  from = {};
}

// Regions too small for a tooth, the smallest first, go to the tooth or part of one behind the shallowest line (cusps
// that fissures cut off), or are gingiva.
void merge_small(std::vector<Region> &region, std::vector<Index> &into, const RegionOptions &options) {
  for (;;) {
    Index small = mesh::none;
    for (Index r = 0; r < region.size(); ++r)
      if (region[r].tooth && region[r].area < options.least_tooth &&
          (small == mesh::none || region[r].area < region[small].area))
        small = r;
    if (small == mesh::none) return;
    Index best = mesh::none;
    double least = std::numeric_limits<double>::infinity();
    for (const auto &[n, side] : region[small].beside) {
      if (!region[n].tooth || region[n].area + region[small].area > options.most_tooth) continue;
      const double cost = side.depth / side.length / side.length;  // shallow and long
      if (cost < least) least = cost, best = n;
    }
    if (best == mesh::none) {
      region[small].tooth = false;
      continue;
    }
    join(region, small, best);
    into[small] = best;
  }
}

// While there are more teeth than wanted, the two that look most like parts of one are joined. It stands for the user
// of the published programs, who joins what is one tooth, and is the best that we found to do with the number of teeth.
void merge_surplus(std::vector<Region> &region, std::vector<Index> &into, const RegionOptions &options) {
  auto count =
      static_cast<unsigned>(std::count_if(region.begin(), region.end(), [](const Region &r) { return r.tooth; }));
  for (; count > options.wanted; --count) {
    Index a = mesh::none, b = mesh::none;
    double least = std::numeric_limits<double>::infinity();
    for (Index r = 0; r < region.size(); ++r) {
      if (!region[r].tooth) continue;
      for (const auto &[n, side] : region[r].beside) {
        const double area = region[r].area + region[n].area;
        if (n < r || !region[n].tooth || area > options.most_tooth) continue;
        // Cusps lie beside each other along a long and shallow line, and are smaller than teeth. The powers were tried
        // on real and on synthetic arches.
        const double cost = side.depth / side.length / std::sqrt(side.length) * area;
        if (cost < least) least = cost, a = r, b = n;
      }
    }
    if (a == mesh::none) return;
    join(region, a, b);
    into[a] = b;
  }
}

}  // namespace

Teeth teeth_between(const Surface &surface, const Mask &line, const Vec<double> &concavity, const Heights &heights,
                    const RegionOptions &options) {
  Index count = 0;
  const Vec<Index> of = regions_of_faces(surface, line, count);
  std::vector<Region> region = measured(surface, of, count, concavity, heights);
  tell_teeth(region, options);
  std::vector<Index> into(count);
  for (Index r = 0; r < count; ++r) into[r] = r;
  merge_small(region, into, options);
  merge_surplus(region, into, options);

  Teeth teeth;
  teeth.regions = count;
  std::vector<Index> number(count, 0);
  double sum = 0, squares = 0;
  for (Index r = 0; r < count; ++r) {
    if (!region[r].tooth) continue;
    number[r] = ++teeth.count;
    const double size = std::log(region[r].area);
    sum += size, squares += size * size;
  }
  if (teeth.count > 0) {
    const double mean = sum / teeth.count;
    teeth.spread = std::sqrt(std::max(0.0, squares / teeth.count - mean * mean));
  }
  teeth.of_face.assign(surface.faces(), 0);
  for (Index f = 0; f < surface.faces(); ++f) {
    Index r = of[f];
    if (r == mesh::none) continue;
    while (into[r] != r) r = into[r];
    teeth.of_face[f] = number[r];
  }
  return teeth;
}

}  // namespace ts::bench
