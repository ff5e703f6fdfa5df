#include "tooth/cells.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "base/error.h"

namespace ts::tooth {
namespace {

constexpr double kSnap = 2e-3;    // mm
constexpr double kInside = 1e-6;  // of an edge: how far from its ends a point that is not on them is kept

// A point of a line before it has a number.
struct Spot {
  Index vertex = mesh::none;  // if it is on one
  Index near = mesh::none;    // the vertex that it may be put on
  Index edge = mesh::none;
  double t = 0;
};

}  // namespace

Cells::Cells(const Surface &surface, std::span<const CutLine> lines) : surface_(surface), position_(surface.position) {
  split(string(lines));
}

Index Cells::edge_between(Index a, Index b) const {
  for (const Index e : surface_.vertex_edges[a])
    if (surface_.other_end(e, a) == b) return e;
  return mesh::none;
}

// Gives the points of all lines numbers.
Vec<Cells::Strung> Cells::string(std::span<const CutLine> lines) {
  Vec<Vec<Spot>> spots;
  for (const CutLine &line : lines) {
    spots.emplace_back();
    for (const cut::EdgePoint &p : line.points) {
      Spot s;
      s.t = p.a < p.b ? p.t : 1 - p.t;
      if (p.a == p.b) {
        s.vertex = p.a;
      } else {
        s.edge = edge_between(p.a, p.b);
        if (s.edge == mesh::none) throw Error(Fault::internal, "a point of a cut lies on no edge of the scan");
        const auto [low, high] = surface_.edge[s.edge];
        const double length = surface_.edge_length(s.edge), end = std::min(s.t, 1 - s.t);
        if (s.t <= 0) s.vertex = low;
        if (s.t >= 1) s.vertex = high;
        if (end * length < kSnap) s.near = s.t < 0.5 ? low : high;
        s.t = std::clamp(s.t, kInside, 1 - kInside);
      }
      spots.back().push_back(s);
    }
  }
  // How often a tooth's lines come by a vertex: those that come by twice keep off it.
  std::map<std::pair<Index, Index>, int> passes;
  for (std::size_t l = 0; l < lines.size(); ++l) {
    const Vec<Spot> &line = spots[l];
    const auto at = [](const Spot &s) { return s.vertex != mesh::none ? s.vertex : s.near; };
    for (std::size_t i = 0; i < line.size(); ++i) {
      const Index v = at(line[i]);
      const bool begins = i > 0 ? at(line[i - 1]) != v : !lines[l].closed || at(line.back()) != v;
      if (v != mesh::none && begins) ++passes[{lines[l].tooth, v}];
    }
  }
  struct Place {
    Index edge;
    double t;
    Index tooth;
    std::size_t line, i;
  };
  Vec<Place> places;
  Vec<Strung> strung;
  for (std::size_t l = 0; l < lines.size(); ++l) {
    const Index tooth = lines[l].tooth;
    strung.push_back({Vec<Index>(spots[l].size(), mesh::none), lines[l].closed, tooth});
    for (std::size_t i = 0; i < spots[l].size(); ++i) {
      Spot &s = spots[l][i];
      if (s.near != mesh::none && (tooth == mesh::none || passes[{tooth, s.near}] < 2)) s.vertex = s.near;
      if (s.vertex != mesh::none)
        strung[l].id[i] = s.vertex;
      else
        places.push_back({s.edge, s.t, tooth, l, i});
    }
  }
  std::sort(places.begin(), places.end(), [](const Place &a, const Place &b) {
    return std::tie(a.edge, a.t, a.tooth, a.line, a.i) < std::tie(b.edge, b.t, b.tooth, b.line, b.i);
  });
  Vec<Index> here;  // the teeth of the point being gathered
  for (std::size_t k = 0; k < places.size(); ++k) {
    const Place &p = places[k];
    const bool same_edge = k > 0 && places[k - 1].edge == p.edge;
    if (!same_edge) {
      edges_.push_back(p.edge);
      edge_start_.push_back(static_cast<Index>(edge_points_.size()));
    }
    const double away = same_edge ? p.t - point_t_.back() : 1;
    const bool joins =
        same_edge &&
        (away == 0 || (away * surface_.edge_length(p.edge) < kSnap && std::ranges::find(here, p.tooth) == here.end()));
    if (!joins) {
      here.clear();
      const auto [low, high] = surface_.edge[p.edge];
      edge_points_.push_back(static_cast<Index>(position_.size()));
      position_.push_back((1 - p.t) * surface_.position[low] + p.t * surface_.position[high]);
      point_edge_.push_back(p.edge);
      point_t_.push_back(p.t);
    }
    here.push_back(p.tooth);
    strung[p.line].id[p.i] = edge_points_.back();
  }
  edge_start_.push_back(static_cast<Index>(edge_points_.size()));
  // Points that became one, and turns on the spot.
  for (Strung &line : strung) {
    Vec<Index> kept;
    const auto tidy = [&] {
      for (;;) {
        const std::size_t n = kept.size();
        if (n >= 2 && kept[n - 1] == kept[n - 2])
          kept.pop_back();
        else if (n >= 3 && kept[n - 1] == kept[n - 3])
          kept.resize(n - 2);
        else
          break;
      }
    };
    for (const Index id : line.id) {
      kept.push_back(id);
      tidy();
    }
    while (line.closed && kept.size() > 1 &&
           (kept.front() == kept.back() || kept.front() == kept[kept.size() - 2] || kept[1] == kept.back())) {
      if (kept.front() != kept.back() && kept[1] == kept.back())
        kept.erase(kept.begin());
      else
        kept.pop_back();
    }
    line.id = std::move(kept);
  }
  std::erase_if(strung, [](const Strung &l) { return l.id.size() < (l.closed ? 3 : 2); });
  return strung;
}

std::span<const Index> Cells::points_on(Index edge) const {
  const auto at = std::ranges::lower_bound(edges_, edge);
  if (at == edges_.end() || *at != edge) return {};
  const std::size_t k = static_cast<std::size_t>(at - edges_.begin());
  return {edge_points_.data() + edge_start_[k], edge_points_.data() + edge_start_[k + 1]};
}

bool Cells::is_end(Index vertex, Index edge) const {
  return surface_.edge[edge][0] == vertex || surface_.edge[edge][1] == vertex;
}

// The edge that both points lie on; none if there is none.
Index Cells::common_edge(Index p, Index q) const {
  const Index n = static_cast<Index>(surface_.vertices());
  if (p < n && q < n) return edge_between(p, q);
  if (p < n) std::swap(p, q);
  const Index e = point_edge_[p - n];
  return (q < n ? is_end(q, e) : point_edge_[q - n] == e) ? e : mesh::none;
}

bool Cells::touches(Index id, Index face) const {
  const Index n = static_cast<Index>(surface_.vertices());
  for (Index k = 0; k < 3; ++k)
    if (id < n ? surface_.triangle[face][k] == id : surface_.edge_of[3 * face + k] == point_edge_[id - n]) return true;
  return false;
}

Index Cells::common_face(Index p, Index q) const {
  const Index n = static_cast<Index>(surface_.vertices());
  for (const Index f : surface_.vertex_faces[p < n ? p : surface_.edge[point_edge_[p - n]][0]])
    if (touches(p, f) && touches(q, f)) return f;
  throw Error(Fault::internal, "two points of a cut that follow each other share no face");
}

Vec<RingPoint> Cells::ring_of(Index face) const {
  Vec<RingPoint> ring;
  for (Index k = 0; k < 3; ++k) {
    const Index h = 3 * face + k, from = surface_.from(h), e = surface_.edge_of[h];
    ring.push_back({from, Vec3::Unit(k)});
    const std::span<const Index> on = points_on(e);
    const bool forward = surface_.edge[e][0] == from;
    for (std::size_t i = 0; i < on.size(); ++i) {
      const Index id = on[forward ? i : on.size() - 1 - i];
      const double t = point_t_[id - surface_.vertices()], far = forward ? t : 1 - t;
      ring.push_back({id, (1 - far) * Vec3::Unit(k) + far * Vec3::Unit((k + 1) % 3)});
    }
  }
  return ring;
}

void Cells::split(const Vec<Strung> &lines) {
  Vec<std::pair<Index, Chord>> chords;
  Vec<Index> crossed;
  const auto add_faces = [&](Index e) {
    for (const Index f : surface_.vertex_faces[surface_.edge[e][0]])
      for (Index k = 0; k < 3; ++k)
        if (surface_.edge_of[3 * f + k] == e) crossed.push_back(f);
  };
  for (const Index e : edges_) add_faces(e);
  for (const Strung &line : lines)
    for (std::size_t i = 0; i + (line.closed ? 0 : 1) < line.id.size(); ++i) {
      const Index p = line.id[i], q = line.id[(i + 1) % line.id.size()];
      const Index e = common_edge(p, q);
      if (e == mesh::none) {
        const Index f = common_face(p, q);
        chords.push_back({f, {p, q, line.tooth}});
        crossed.push_back(f);
        continue;
      }
      add_faces(e);
      if (line.tooth == mesh::none) continue;
      Vec<Index> along = {surface_.edge[e][0]};
      for (const Index id : points_on(e)) along.push_back(id);
      along.push_back(surface_.edge[e][1]);
      auto from = std::ranges::find(along, p), to = std::ranges::find(along, q);
      const bool forward = from < to;
      if (!forward) std::swap(from, to);
      for (; from != to; ++from)
        marks_.push_back(forward ? Mark{from[0], from[1], line.tooth} : Mark{from[1], from[0], line.tooth});
    }
  std::sort(crossed.begin(), crossed.end());
  crossed.erase(std::unique(crossed.begin(), crossed.end()), crossed.end());
  std::stable_sort(chords.begin(), chords.end(), [](const auto &a, const auto &b) { return a.first < b.first; });

  first_piece_.assign(surface_.faces(), mesh::none);
  auto next = chords.begin();
  for (const Index f : crossed) {
    Vec<Chord> here;
    for (; next != chords.end() && next->first == f; ++next) here.push_back(next->second);
    first_piece_[f] = static_cast<Index>(piece_.size());
    const auto add = [&](const Vec3 &w) {
      const auto &t = surface_.triangle[f];
      position_.push_back(w[0] * surface_.position[t[0]] + w[1] * surface_.position[t[1]] +
                          w[2] * surface_.position[t[2]]);
      return static_cast<Index>(position_.size() - 1);
    };
    split_face(ring_of(f), here, add, piece_, marks_);
    piece_face_.resize(piece_.size(), f);
  }
  std::erase_if(marks_, [](const Mark &m) { return m.line == mesh::none; });
  std::sort(marks_.begin(), marks_.end());
  marks_.erase(std::unique(marks_.begin(), marks_.end()), marks_.end());
  for (Index p = 0; p < piece_.size(); ++p)
    for (std::size_t k = 0; k < piece_[p].size(); ++k)
      sides_.push_back({piece_[p][k], piece_[p][(k + 1) % piece_[p].size()], p});
  std::sort(sides_.begin(), sides_.end(),
            [](const Side &a, const Side &b) { return std::tie(a.from, a.to) < std::tie(b.from, b.to); });
}

std::span<const Index> Cells::corners(Index cell) const {
  if (whole(cell)) return surface_.triangle[cell];
  return piece_[cell - surface_.faces()];
}

Vec3 Cells::centre(Index cell) const {
  Vec3 sum = Vec3::Zero();
  const std::span<const Index> ring = corners(cell);
  for (const Index v : ring) sum += position_[v];
  return sum / static_cast<double>(ring.size());
}

double Cells::area(Index cell) const {
  if (whole(cell)) return surface_.face_area[cell];
  Vec3 twice = Vec3::Zero();
  const std::span<const Index> ring = corners(cell);
  for (std::size_t k = 1; k + 1 < ring.size(); ++k)
    twice += (position_[ring[k]] - position_[ring[0]]).cross(position_[ring[k + 1]] - position_[ring[0]]);
  return twice.norm() / 2;
}

bool Cells::is_marked(Index a, Index b, Index tooth) const {
  return std::ranges::binary_search(marks_, Mark{a, b, tooth}) || std::ranges::binary_search(marks_, Mark{b, a, tooth});
}

Index Cells::cell_at(Index a, Index b) const {
  const auto at = std::lower_bound(sides_.begin(), sides_.end(), std::pair{a, b}, [](const Side &s, const auto &key) {
    return std::pair{s.from, s.to} < key;
  });
  if (at == sides_.end() || at->from != a || at->to != b) return mesh::none;
  return static_cast<Index>(surface_.faces()) + at->piece;
}

Index Cells::behind(Index cell, Index a, Index b) const {
  if (const Index other = cell_at(b, a); other != mesh::none) return other;
  const Index f = face_of(cell);
  for (Index h = 3 * f; h < 3 * f + 3; ++h)
    if (surface_.from(h) == a && surface_.to(h) == b) {
      const Index twin = surface_.twin[h];
      if (twin != mesh::none && first_piece_[mesh::face_of(twin)] == mesh::none) return mesh::face_of(twin);
    }
  return mesh::none;
}

}  // namespace ts::tooth
