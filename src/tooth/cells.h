// The scan's faces, those that cuts cross split along them.
#pragma once

#include <span>

#include "cut/polyline.h"
#include "tooth/split_face.h"

namespace ts::tooth {

using mesh::Surface;

// A line to cut along: of a tooth, which is on its left, or of none, and then cut along but not marked.
struct CutLine {
  std::span<const cut::EdgePoint> points;
  bool closed = false;
  Index tooth = mesh::none;
};

// A cell is a whole face (its number is the face's) or a piece of one (faces + place in `piece`).
class Cells {
 public:
  // Points of a line within 2 um of a vertex are put on it, and points of different teeth as near to each other on an
  // edge are one: a hundredth of what a scanner resolves, and what keeps triangles from having no area once they are
  // rounded to the floats of a file. A line is never made to touch itself by this.
  // Throws Error{internal} where two points of a line that follow each other share no face.
  Cells(const Surface &surface, std::span<const CutLine> lines);

  std::size_t count() const { return surface_.faces() + piece_.size(); }
  const Vec<Vec3> &position() const { return position_; }  // the surface's vertices first
  Index face_of(Index cell) const { return whole(cell) ? cell : piece_face_[cell - surface_.faces()]; }
  std::span<const Index> corners(Index cell) const;
  Vec3 centre(Index cell) const;  // of its corners
  double area(Index cell) const;
  // visit(cell) for the face, or each of its pieces.
  void each_of(Index face, const auto &visit) const {
    if (first_piece_[face] == mesh::none) return visit(face);
    for (Index p = first_piece_[face]; p < piece_.size() && piece_face_[p] == face; ++p)
      visit(static_cast<Index>(surface_.faces()) + p);
  }
  // visit(neighbour, a, b) for each side from a to b of a cell that has a cell behind it.
  void each_neighbour(Index cell, const auto &visit) const {
    const std::span<const Index> ring = corners(cell);
    for (std::size_t k = 0; k < ring.size(); ++k) {
      const Index a = ring[k], b = ring[(k + 1) % ring.size()];
      if (const Index other = behind(cell, a, b); other != mesh::none) visit(other, a, b);
    }
  }

  std::span<const Mark> marks() const { return marks_; }  // sorted; Mark::line is the tooth
  bool is_marked(Index a, Index b, Index tooth) const;    // in either direction
  Index cell_at(Index a, Index b) const;  // the piece that has the side from a to b, none if there is none

 private:
  struct Side {
    Index from, to, piece;
  };
  struct Strung {  // a line as points of the cells
    Vec<Index> id;
    bool closed;
    Index tooth;
  };

  bool whole(Index cell) const { return cell < surface_.faces(); }
  Index behind(Index cell, Index a, Index b) const;
  Index edge_between(Index a, Index b) const;
  std::span<const Index> points_on(Index edge) const;
  bool touches(Index id, Index face) const;
  bool is_end(Index vertex, Index edge) const;
  Index common_edge(Index p, Index q) const;
  Index common_face(Index p, Index q) const;
  Vec<Strung> string(std::span<const CutLine> lines);
  void split(const Vec<Strung> &lines);
  Vec<RingPoint> ring_of(Index face) const;

  const Surface &surface_;
  Vec<Vec3> position_;
  Vec<Index> point_edge_;  // of position_[vertices + i]: the edge it lies on; those inside faces come after
  Vec<double> point_t_;    // from the edge's first end
  Vec<Index> edges_, edge_start_, edge_points_;  // edges with points, ascending; their points by rising t
  Vec<Index> first_piece_;                       // a face
  Vec<Index> piece_face_;
  Vec<Vec<Index>> piece_;
  Vec<Side> sides_;  // of pieces, sorted
  Vec<Mark> marks_;
};

}  // namespace ts::tooth
