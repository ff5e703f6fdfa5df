#include "cut/max_flow.h"

#include <algorithm>
#include <cmath>

#include "base/stop.h"

namespace ts::cut {

using mesh::none;

void MaxFlow::reset(std::size_t nodes) {
  arc_.clear();
  node_.assign(nodes, {});
  queue_.clear();
  orphans_.clear();
  queue_head_ = 0;
  time_ = 0;
  flow_ = 0;
}

void MaxFlow::add_terminals(Index node, double from_source, double to_sink) {
  if (node_[node].excess > 0)
    from_source += node_[node].excess;
  else
    to_sink -= node_[node].excess;
  flow_ += std::min(from_source, to_sink);
  node_[node].excess = from_source - to_sink;
}

void MaxFlow::add_edge(Index a, Index b, double there, double back) {
  arc_.push_back({b, node_[a].first, there});
  node_[a].first = static_cast<Index>(arc_.size() - 1);
  arc_.push_back({a, node_[b].first, back});
  node_[b].first = static_cast<Index>(arc_.size() - 1);
}

double MaxFlow::solve() {
  for (Index i = 0; i < node_.size(); ++i) {
    if (node_[i].excess == 0) continue;
    node_[i].tree = node_[i].excess > 0 ? Tree::source : Tree::sink;
    node_[i].parent = kRoot;
    node_[i].distance = 1;
    activate(i);
  }
  StopNowAndThen stop(1 << 6);
  for (Index middle = grow(); middle != none; middle = grow()) {
    stop();
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
  if (node_[node].active) return;
  node_[node].active = true;
  queue_.push_back(node);
}

// Grows both trees until they touch: the arc from the source's tree to the sink's, or none when they cannot.
Index MaxFlow::grow() {
  while (queue_head_ < queue_.size()) {
    const Index p = queue_[queue_head_];
    if (node_[p].tree != Tree::none) {
      const bool from_source = node_[p].tree == Tree::source;
      for (Index a = node_[p].first; a != none; a = arc_[a].next) {
        if (!(arc_[from_source ? a : a ^ 1].residual > 0)) continue;
        const Index q = arc_[a].head;
        if (node_[q].tree == Tree::none) {
          node_[q].tree = node_[p].tree;
          node_[q].parent = a ^ 1;
          node_[q].stamp = node_[p].stamp;
          node_[q].distance = node_[p].distance + 1;
          activate(q);
        } else if (node_[q].tree != node_[p].tree) {
          return from_source ? a : a ^ 1;  // p stays active
        }
      }
    }
    node_[p].active = false;
    ++queue_head_;
    if (queue_head_ > 4096 && 2 * queue_head_ > queue_.size()) {
      queue_.erase(queue_.begin(), queue_.begin() + static_cast<std::ptrdiff_t>(queue_head_));
      queue_head_ = 0;
    }
  }
  return none;
}

double MaxFlow::bottleneck(Index node, double least) const {
  while (node_[node].parent != kRoot) {
    least = std::min(least, towards(node_[node].parent, node_[node].tree));
    node = arc_[node_[node].parent].head;
  }
  return std::min(least, std::abs(node_[node].excess));
}

void MaxFlow::push(Index node, double amount) {
  const Tree tree = node_[node].tree;
  while (node_[node].parent != kRoot) {
    const Index a = node_[node].parent, with = tree == Tree::source ? a ^ 1 : a;
    arc_[with].residual -= amount;
    arc_[with ^ 1].residual += amount;
    const Index up = arc_[a].head;
    if (!(arc_[with].residual > 0)) {
      node_[node].parent = none;
      orphans_.push_back(node);
    }
    node = up;
  }
  node_[node].excess += tree == Tree::source ? -amount : amount;
  if (tree == Tree::source ? !(node_[node].excess > 0) : !(node_[node].excess < 0)) {
    node_[node].parent = none;
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
    if (node_[at].stamp == time_) {
      steps += node_[at].distance;
      break;
    }
    if (node_[at].parent == none) return none;
    ++steps;
    if (node_[at].parent == kRoot) {
      node_[at].stamp = time_;
      node_[at].distance = 1;
      break;
    }
    at = arc_[node_[at].parent].head;
  }
  Index left = steps;
  for (Index i = node; node_[i].stamp != time_; i = arc_[node_[i].parent].head) {
    node_[i].stamp = time_;
    node_[i].distance = left--;
  }
  return steps;
}

void MaxFlow::adopt(Index node) {
  const Tree tree = node_[node].tree;
  Index best = none, least = none;
  for (Index a = node_[node].first; a != none; a = arc_[a].next) {
    const Index q = arc_[a].head;
    if (node_[q].tree != tree || !(towards(a, tree) > 0)) continue;
    const Index d = distance_to_root(q);
    if (d < least) least = d, best = a;
  }
  if (best != none) {
    node_[node].parent = best;
    node_[node].stamp = time_;
    node_[node].distance = least + 1;
    return;
  }
  for (Index a = node_[node].first; a != none; a = arc_[a].next) {
    const Index q = arc_[a].head;
    if (node_[q].tree != tree) continue;
    if (towards(a, tree) > 0) activate(q);
    if (node_[q].parent != none && node_[q].parent != kRoot && arc_[node_[q].parent].head == node) {
      node_[q].parent = none;
      orphans_.push_back(q);
    }
  }
  node_[node].tree = Tree::none;
}

}  // namespace ts::cut
