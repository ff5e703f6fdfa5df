#include "cut/max_flow.h"

#include <algorithm>
#include <cmath>

namespace ts::cut {

using mesh::none;

MaxFlow::MaxFlow(std::size_t nodes)
    : first_(nodes, none),
      parent_(nodes, none),
      stamp_(nodes, 0),
      distance_(nodes, 0),
      excess_(nodes, 0),
      tree_(nodes, Tree::none),
      active_(nodes, 0) {}

void MaxFlow::add_terminals(Index node, double from_source, double to_sink) {
  if (excess_[node] > 0)
    from_source += excess_[node];
  else
    to_sink -= excess_[node];
  flow_ += std::min(from_source, to_sink);
  excess_[node] = from_source - to_sink;
}

void MaxFlow::add_edge(Index a, Index b, double there, double back) {
  arc_.push_back({b, first_[a], there});
  first_[a] = static_cast<Index>(arc_.size() - 1);
  arc_.push_back({a, first_[b], back});
  first_[b] = static_cast<Index>(arc_.size() - 1);
}

double MaxFlow::solve() {
  for (Index i = 0; i < tree_.size(); ++i) {
    if (excess_[i] == 0) continue;
    tree_[i] = excess_[i] > 0 ? Tree::source : Tree::sink;
    parent_[i] = kRoot;
    distance_[i] = 1;
    activate(i);
  }
  for (Index middle = grow(); middle != none; middle = grow()) {
    ++time_;
    augment(middle);
    while (!orphans_.empty()) {
      const Index orphan = orphans_.back();
      orphans_.pop_back();
      adopt(orphan);
    }
  }
  return flow_;
}

void MaxFlow::activate(Index node) {
  if (active_[node]) return;
  active_[node] = 1;
  queue_.push_back(node);
}

// Grows both trees until they touch: the arc from the source's tree to the sink's, or none when they cannot.
Index MaxFlow::grow() {
  while (queue_head_ < queue_.size()) {
    const Index p = queue_[queue_head_];
    if (tree_[p] != Tree::none) {
      const bool from_source = tree_[p] == Tree::source;
      for (Index a = first_[p]; a != none; a = arc_[a].next) {
        if (!(arc_[from_source ? a : a ^ 1].residual > 0)) continue;
        const Index q = arc_[a].head;
        if (tree_[q] == Tree::none) {
          tree_[q] = tree_[p];
          parent_[q] = a ^ 1;
          stamp_[q] = stamp_[p];
          distance_[q] = distance_[p] + 1;
          activate(q);
        } else if (tree_[q] != tree_[p]) {
          return from_source ? a : a ^ 1;  // p stays active
        }
      }
    }
    active_[p] = 0;
    ++queue_head_;
    if (queue_head_ > 4096 && 2 * queue_head_ > queue_.size()) {
      queue_.erase(queue_.begin(), queue_.begin() + static_cast<std::ptrdiff_t>(queue_head_));
      queue_head_ = 0;
    }
  }
  return none;
}

double MaxFlow::bottleneck(Index node, double least) const {
  while (parent_[node] != kRoot) {
    least = std::min(least, towards(parent_[node], tree_[node]));
    node = arc_[parent_[node]].head;
  }
  return std::min(least, std::abs(excess_[node]));
}

void MaxFlow::push(Index node, double amount) {
  const Tree tree = tree_[node];
  while (parent_[node] != kRoot) {
    const Index a = parent_[node], with = tree == Tree::source ? a ^ 1 : a;
    arc_[with].residual -= amount;
    arc_[with ^ 1].residual += amount;
    const Index up = arc_[a].head;
    if (!(arc_[with].residual > 0)) {
      parent_[node] = none;
      orphans_.push_back(node);
    }
    node = up;
  }
  excess_[node] += tree == Tree::source ? -amount : amount;
  if (tree == Tree::source ? !(excess_[node] > 0) : !(excess_[node] < 0)) {
    parent_[node] = none;
    orphans_.push_back(node);
  }
}

void MaxFlow::augment(Index middle) {
  const Index s = tail(middle), t = arc_[middle].head;
  const double amount = bottleneck(t, bottleneck(s, arc_[middle].residual));
  arc_[middle].residual -= amount;
  arc_[middle ^ 1].residual += amount;
  push(s, amount);
  push(t, amount);
  flow_ += amount;
}

// Arcs from a node to the root of its tree, none if the way ends at an orphan. What it passes is stamped for this
// round.
Index MaxFlow::distance_to_root(Index node) {
  Index steps = 0, at = node;
  for (;;) {
    if (stamp_[at] == time_) {
      steps += distance_[at];
      break;
    }
    if (parent_[at] == none) return none;
    ++steps;
    if (parent_[at] == kRoot) {
      stamp_[at] = time_;
      distance_[at] = 1;
      break;
    }
    at = arc_[parent_[at]].head;
  }
  Index left = steps;
  for (Index i = node; stamp_[i] != time_; i = arc_[parent_[i]].head) {
    stamp_[i] = time_;
    distance_[i] = left--;
  }
  return steps;
}

void MaxFlow::adopt(Index node) {
  const Tree tree = tree_[node];
  Index best = none, least = none;
  for (Index a = first_[node]; a != none; a = arc_[a].next) {
    const Index q = arc_[a].head;
    if (tree_[q] != tree || !(towards(a, tree) > 0)) continue;
    const Index d = distance_to_root(q);
    if (d < least) least = d, best = a;
  }
  if (best != none) {
    parent_[node] = best;
    stamp_[node] = time_;
    distance_[node] = least + 1;
    return;
  }
  for (Index a = first_[node]; a != none; a = arc_[a].next) {
    const Index q = arc_[a].head;
    if (tree_[q] != tree) continue;
    if (towards(a, tree) > 0) activate(q);
    if (parent_[q] != none && parent_[q] != kRoot && arc_[parent_[q]].head == node) {
      parent_[q] = none;
      orphans_.push_back(q);
    }
  }
  tree_[node] = Tree::none;
}

}  // namespace ts::cut
