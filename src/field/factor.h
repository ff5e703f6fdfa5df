// The Cholesky factor of the Laplacian with the constraint nodes ordered last: dense parts along a tree of dissection.
#pragma once

#include <Eigen/Core>
#include <memory>
#include <span>

#include "base/pool.h"
#include "base/progress.h"
#include "field/dissection.h"

namespace ts::field {

// The matrix: an entry -weight for each edge, row sums zero, nodes (sets of vertices) taken as one unknown each.
struct Laplacian {
  const mesh::Surface &surface;  // has to outlive the factor
  Vec<double> edge_weight;
  std::span<const Index> node_of;  // a vertex: its node, or none
  Index nodes = 0;
};

// Doubles that begin without a value, from the caller's allocator.
class Block {
 public:
  Block() = default;
  explicit Block(std::size_t doubles) : data_(static_cast<double *>(allocate(doubles * sizeof(double)))) {}
  double *data() const { return data_.get(); }
  explicit operator bool() const { return data_ != nullptr; }

 private:
  struct Free {
    void operator()(double *p) const noexcept { deallocate(p); }
  };
  std::unique_ptr<double, Free> data_;
};

class Factor {
 public:
  // Unknowns are numbered by places: the free vertices in the order of elimination, then the nodes. `place` has that of
  // each vertex, none for vertices that take no part. Factorised are the free ones; what this leaves of the matrix on
  // the nodes is `corner`, which has no diagonal. Panels of the lower parts of the tree are kept as long as all that is
  // kept stays within `most_bytes`; the others are worked out again where they are needed, to the same bytes. Throws
  // Fault::solver, and Fault::out_of_memory if not even the upper parts fit.
  Factor(Laplacian laplacian, Dissection dissection, std::span<const Index> place, std::size_t most_bytes,
         const Executor &executor, const Progress &progress);

  const mesh::Surface &surface() const { return *surface_; }
  Index interior() const { return interior_; }
  Index nodes() const { return nodes_; }
  Index place(Index vertex) const { return place_[vertex]; }
  const Eigen::MatrixXd &corner() const { return corner_; }

  const Vec<Part> &parts() const { return parts_; }
  Index part_of(Index place) const;
  std::span<const Index> rows(Index part) const { return rows_[part]; }  // places after the part's that it touches

  // Parts live in chunks: subtrees at the bottom, and all that is above them.
  Index chunks() const { return static_cast<Index>(chunk_.size()); }
  Index chunk_of(Index part) const { return chunk_of_[part]; }
  bool kept(Index chunk) const { return chunk_[chunk].panels != nullptr; }
  Block make(Index chunk) const;  // of one that is not kept

  // A part's columns of the factor: 1 / l_jj for each; the rows below the diagonal of its own (L11), packed column by
  // column; and, for the rows it touches (L21), L21 L11^-1 row by row: so that the values of a part are those of its
  // rows times a matrix, x = -(L21 L11^-1)^T x_rows.
  struct Panel {
    const double *inverse, *own, *touched;
    std::size_t columns;
    // Rows of column j below the diagonal begin here.
    const double *below(std::size_t j) const { return own + j * columns - j * (j + 1) / 2; }
  };
  Panel panel(Index part, const Block &made) const;  // `made`: its chunk if that is not kept

  // What a solution reads, in one piece and in the order in which it does. A tile is a subtree of at most some hundred
  // unknowns, or a part above those. Its records are those of its parts, parents first: a Record, the places of the
  // rows, a value's worth of bytes or two filled up, and the matrix.
  struct Record {
    Index part, begin, columns, count;

    static constexpr std::size_t rows() { return sizeof(Record) / sizeof(double); }  // where they begin, in doubles
    std::size_t matrix() const { return rows() + (std::size_t{count} + 1) / 2; }
    std::size_t doubles() const { return matrix() + std::size_t{columns} * count; }
  };
  struct Tile {
    const double *records = nullptr;  // nullptr if its chunk is not kept
    std::size_t offset = 0;           // of the records in the chunk
    std::size_t doubles = 0;          // of them
    Index first = 0, end = 0;         // its places
    Index parent = mesh::none;        // the tile of what is next above, mesh::none for the root's
    Index chunk = 0;
  };
  const Vec<Tile> &tiles() const { return tile_; }
  Index tile_of(Index place) const { return tile_of_[place]; }

  std::size_t bytes() const;           // of all that is kept
  std::size_t left_out_bytes() const;  // of the panels that are not
  double elimination_ms() const { return elimination_ms_; }

 private:
  struct Chunk {
    Index first = 0, end = 0;  // parts [first, end): a subtree; of the last chunk, no more than where they begin
    std::size_t doubles = 0;
    double *panels = nullptr;  // in `kept_`, or nullptr
  };
  struct Space;  // to eliminate in

  void find_chunks();
  void find_rows(const Executor &executor);
  void lay_out();
  void keep(std::size_t most_bytes);
  Record record(Index part) const;
  void eliminate_all(const Executor &executor, const Progress &progress);
  Vec<double> eliminate_above(Index part, Vec<Vec<double>> &updates, Pool<Space> &spaces, const Executor &executor,
                              const Progress &progress) const;
  void eliminate_chunk(Index chunk, double *panels, Space &space) const;
  void eliminate(Index part, const double *left, const double *right, double *panels, Space &space) const;

  const mesh::Surface *surface_;
  Vec<double> weight_;  // an edge
  Index interior_ = 0, nodes_ = 0;
  Vec<Index> order_;  // of elimination
  Vec<Index> place_;  // a vertex
  Vec<Part> parts_;
  Vec<Index> chunk_of_;  // a part
  Vec<Index> tile_of_;   // a place
  mesh::Rows rows_;
  Vec<std::size_t> offset_, own_offset_;  // a part: of its record and of the rest in its chunk
  Vec<Chunk> chunk_;
  Vec<Tile> tile_;
  Block kept_;
  std::size_t kept_doubles_ = 0;
  std::size_t most_unknowns_ = 0, most_below_ = 0;  // of a part: its own with those it touches; values of L21, padded

  Eigen::MatrixXd corner_;
  double elimination_ms_ = 0;
};

}  // namespace ts::field
