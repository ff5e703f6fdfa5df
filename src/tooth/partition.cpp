#include "tooth/partition.h"

#include <algorithm>
#include <limits>
#include <map>

#include "base/stop.h"
#include "tooth/cells.h"

namespace ts::tooth {
namespace {

// The cells that each tooth lays claim to.
class Claims {
 public:
  Claims(const mesh::Surface &surface, const Cells &cells, std::span<const Tooth *const> teeth)
      : surface_(surface), cells_(cells), seen_(cells.count(), mesh::none) {
    for (Index k = 0; k < teeth.size(); ++k) add(k, *teeth[k]);
    std::sort(claims_.begin(), claims_.end());
  }

  // Cell and tooth, sorted.
  const Vec<std::pair<Index, Index>> &all() const { return claims_; }

  // visit(cell, its claims)
  void each_cell(const auto &visit) const {
    for (std::size_t i = 0, j = 0; i < claims_.size(); i = j) {
      while (j < claims_.size() && claims_[j].first == claims_[i].first) ++j;
      visit(claims_[i].first, std::span(claims_.data() + i, claims_.data() + j));
    }
  }

 private:
  void add(Index k, const Tooth &tooth) {
    Vec<std::uint8_t> parted(surface_.components, 0);  // pieces of the scan that a cut of the tooth runs on
    Vec<Index> stack;
    const auto enter = [&](Index cell) {
      if (cell == mesh::none || seen_[cell] == k) return;
      seen_[cell] = k;
      claims_.push_back({cell, k});
      stack.push_back(cell);
    };
    for (const Mark &m : cells_.marks()) {
      if (m.line != k) continue;
      const Index left = cells_.cell_at(m.from, m.to);
      enter(left);
      for (const Index cell : {left, cells_.cell_at(m.to, m.from)})
        if (cell != mesh::none) parted[surface_.component[cells_.face_of(cell)]] = 1;
    }
    for (const Index f : tooth.faces)
      if (!parted[surface_.component[f]]) cells_.each_of(f, enter);
    while (!stack.empty()) {
      const Index cell = stack.back();
      stack.pop_back();
      cells_.each_neighbour(cell, [&](Index other, Index a, Index b) {
        if (!cells_.is_marked(a, b, k)) enter(other);
      });
    }
    for (const Mark &m : cells_.marks())
      if (const Index right = m.line == k ? cells_.cell_at(m.to, m.from) : mesh::none;
          right != mesh::none && seen_[right] == k)
        throw Error(Fault::no_cut,
                    "the cut of group " + std::to_string(tooth.group) + " does not part it from the rest");
  }

  const mesh::Surface &surface_;
  const Cells &cells_;
  Vec<Index> seen_;  // the last tooth that came by
  Vec<std::pair<Index, Index>> claims_;
};

double squared_distance(const mesh::Surface &surface, const Tooth &tooth, const Vec3 &p) {
  double least = std::numeric_limits<double>::infinity();
  for (const Index v : tooth.seeds) least = std::min(least, (surface.position[v] - p).squaredNorm());
  return least;
}

// Of the faces that several teeth lay claim to, where the seeds of each two of them are equally near.
class Bisectors {
 public:
  Bisectors(const mesh::Surface &surface, const Cells &cells, const Claims &claims, std::span<const Tooth *const> teeth)
      : surface_(surface), teeth_(teeth) {
    Vec<std::array<Index, 3>> shared;  // face and two teeth
    claims.each_cell([&](Index cell, std::span<const std::pair<Index, Index>> by) {
      for (std::size_t i = 0; i < by.size(); ++i)
        for (std::size_t j = i + 1; j < by.size(); ++j)
          shared.push_back({cells.face_of(cell), by[i].second, by[j].second});
    });
    std::sort(shared.begin(), shared.end());
    shared.erase(std::unique(shared.begin(), shared.end()), shared.end());
    StopNowAndThen stop(1 << 6);
    for (const auto &[f, a, b] : shared) {
      stop();
      add(f, a, b);
    }
  }

  void append_to(Vec<CutLine> &lines) const {
    for (const auto &segment : segments_) lines.push_back({segment, false, mesh::none});
  }

 private:
  double distance(Index tooth, Index v) {
    const auto [at, fresh] = known_.try_emplace({tooth, v}, 0);
    if (fresh) at->second = std::sqrt(squared_distance(surface_, *teeth_[tooth], surface_.position[v]));
    return at->second;
  }

  void add(Index f, Index a, Index b) {
    double nearer[3];  // to a where negative
    for (std::size_t k = 0; k < 3; ++k) {
      const Index v = surface_.triangle[f][k];
      nearer[k] = distance(a, v) - distance(b, v);
    }
    std::array<cut::EdgePoint, 2> segment;
    std::size_t n = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t next = (k + 1) % 3;
      if ((nearer[k] < 0) == (nearer[next] < 0)) continue;
      // From the smaller vertex on: the same bytes from both faces.
      const bool forward = surface_.triangle[f][k] < surface_.triangle[f][next];
      const std::size_t low = forward ? k : next, high = forward ? next : k;
      segment[n].a = surface_.triangle[f][low];
      segment[n].b = surface_.triangle[f][high];
      segment[n++].t = nearer[low] / (nearer[low] - nearer[high]);
    }
    if (n == 2) segments_.push_back(segment);
  }

  const mesh::Surface &surface_;
  std::span<const Tooth *const> teeth_;
  std::map<std::pair<Index, Index>, double> known_;
  Vec<std::array<cut::EdgePoint, 2>> segments_;
};

// Each connected part of a tooth without a seed goes to what it borders on most.
void give_away_rests(const mesh::Surface &surface, const Cells &cells, std::span<const Tooth *const> teeth,
                     const Claims &claims, Vec<Index> &owner) {
  struct Part {
    Vec<Index> cells;
    double area = 0;
    bool seeded = false;
  };
  Vec<std::uint8_t> is_seed(surface.vertices(), 0), seen(cells.count(), 0);
  for (Index k = 0; k < teeth.size(); ++k) {
    for (const Index v : teeth[k]->seeds) is_seed[v] = 1;
    Vec<Part> parts;
    for (const auto &[start, tooth] : claims.all()) {
      if (tooth != k || owner[start] != k || seen[start]) continue;
      Part part;
      part.cells.push_back(start);
      seen[start] = 1;
      for (std::size_t i = 0; i < part.cells.size(); ++i) {
        const Index cell = part.cells[i];
        part.area += cells.area(cell);
        for (const Index v : cells.corners(cell)) part.seeded = part.seeded || (v < surface.vertices() && is_seed[v]);
        cells.each_neighbour(cell, [&](Index other, Index, Index) {
          if (owner[other] != k || seen[other]) return;
          seen[other] = 1;
          part.cells.push_back(other);
        });
      }
      parts.push_back(std::move(part));
    }
    for (const Index v : teeth[k]->seeds) is_seed[v] = 0;
    if (parts.empty()) continue;
    if (std::ranges::none_of(parts, &Part::seeded)) std::ranges::max_element(parts, {}, &Part::area)->seeded = true;
    for (const Part &part : parts) {
      if (part.seeded) continue;
      std::map<Index, double> border;
      for (const Index cell : part.cells)
        cells.each_neighbour(cell, [&](Index other, Index a, Index b) {
          if (owner[other] != k) border[owner[other]] += (cells.position()[a] - cells.position()[b]).norm();
        });
      Index to = mesh::none;
      for (const auto &[other, length] : border)
        if (to == mesh::none || length > border[to]) to = other;
      for (const Index cell : part.cells) owner[cell] = to;
    }
  }
}

Vec<CutLine> lines_of(std::span<const Tooth *const> teeth) {
  Vec<CutLine> lines;
  for (Index k = 0; k < teeth.size(); ++k)
    for (const Cut &c : teeth[k]->loops) lines.push_back({c.line.points, c.line.closed, k});
  return lines;
}

}  // namespace

Partition partition(const mesh::Surface &surface, std::span<const Tooth *const> teeth) {
  Vec<CutLine> lines = lines_of(teeth);
  auto cells = std::make_unique<Cells>(surface, lines);
  auto claims = std::make_unique<Claims>(surface, *cells, teeth);
  const Bisectors bisectors(surface, *cells, *claims, teeth);
  bisectors.append_to(lines);
  if (lines.size() > lines_of(teeth).size()) {
    claims.reset();
    cells = std::make_unique<Cells>(surface, lines);
    claims = std::make_unique<Claims>(surface, *cells, teeth);
  }

  Partition out;
  Vec<Index> owner(cells->count(), mesh::none);
  StopNowAndThen stop(1 << 6);
  claims->each_cell([&](Index cell, std::span<const std::pair<Index, Index>> by) {
    owner[cell] = by[0].second;
    if (by.size() < 2) return;
    stop();
    const Vec3 centre = cells->centre(cell);
    double least = std::numeric_limits<double>::infinity();
    for (const auto &[same, k] : by)
      if (const double d = squared_distance(surface, *teeth[k], centre); d < least) least = d, owner[cell] = k;
  });
  give_away_rests(surface, *cells, teeth, *claims, owner);
  out.lost.assign(teeth.size(), 0);
  for (const auto &[cell, k] : claims->all())
    if (owner[cell] != k) out.lost[k] += cells->area(cell);

  out.position = cells->position();
  out.vertices = static_cast<Index>(surface.vertices());
  for (Index f = 0; f < surface.faces(); ++f) {
    if (f % 65536 == 0) stop_if_asked();
    cells->each_of(f, [&](Index cell) {
      triangulate_convex(out.position, cells->corners(cell), out.triangle);
      out.face.resize(out.triangle.size(), f);
      out.owner.resize(out.triangle.size(), owner[cell]);
    });
  }
  return out;
}

}  // namespace ts::tooth
