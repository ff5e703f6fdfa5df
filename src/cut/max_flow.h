// Minimum cut of a graph with two terminals, by augmenting paths along two search trees that are kept and repaired
// (Boykov and Kolmogorov, PAMI 26(9), 2004): quick on the thin bands of faces it is used for.
#pragma once

#include "mesh/surface.h"

namespace ts::cut {

using mesh::Index;

class MaxFlow {
 public:
  explicit MaxFlow(std::size_t nodes = 0) { reset(nodes); }
  void reset(std::size_t nodes);  // a new graph, in the memory of the old one

  // Capacities >= 0, added to what is there.
  void add_terminals(Index node, double from_source, double to_sink);
  void add_edge(Index a, Index b, double there, double back);

  double solve();  // the value of the minimum cut; once

  // After solve: on the source's side of the minimum cut nearest to the source.
  bool with_source(Index node) const { return node_[node].tree == Tree::source; }

 private:
  enum class Tree : std::uint8_t { none, source, sink };
  struct Arc {
    Index head, next;
    double residual;
  };
  struct Node {
    double excess = 0;  // residual of the terminal: > 0 from the source, < 0 to the sink
    Index first = mesh::none, parent = mesh::none, stamp = 0, distance = 0;
    Tree tree = Tree::none;
    bool active = false;
  };
  static constexpr Index kRoot = mesh::none - 1;  // parent of a node fed by its terminal

  Index tail(Index arc) const { return arc_[arc ^ 1].head; }
  // Residual of the arc between a node and a tree neighbour, in the direction of the flow.
  double towards(Index arc, Tree tree) const { return arc_[tree == Tree::source ? arc ^ 1 : arc].residual; }
  void activate(Index node);
  Index grow();
  void augment(Index middle);
  void push(Index node, double amount);
  double bottleneck(Index node, double least) const;
  void adopt(Index node);
  Index distance_to_root(Index node);

  Vec<Arc> arc_;  // in pairs
  Vec<Node> node_;
  Vec<Index> queue_, orphans_;
  std::size_t queue_head_ = 0;
  Index time_ = 0;
  double flow_ = 0;
};

}  // namespace ts::cut
