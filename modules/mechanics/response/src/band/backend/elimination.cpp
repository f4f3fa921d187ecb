#include "band/backend/elimination.hpp"

#include <algorithm>
#include <csignal>
#include <metis.h>
#include <numeric>

#include <scree/kept_handlers.hpp>

namespace scree::response {

namespace {

// The neighbours of each unknown, itself excluded.
struct Graph {
  std::vector<idx_t> start = {0}, neighbours;
};

Graph graph_of(const Eigen::SparseMatrix<double>& pattern) {
  Graph graph;
  for (int j = 0; j < pattern.cols(); ++j) {
    for (Eigen::SparseMatrix<double>::InnerIterator entry(pattern, j); entry; ++entry)
      if (entry.row() != j) graph.neighbours.push_back(idx_t(entry.row()));
    graph.start.push_back(idx_t(graph.neighbours.size()));
  }
  return graph;
}

// Order of elimination by nested dissection, and the place of each unknown in it.
struct Dissection {
  std::vector<idx_t> order, place;
};

Dissection dissected(Graph& graph, idx_t unknowns) {
  Dissection d = {std::vector<idx_t>(std::size_t(unknowns)), std::vector<idx_t>(std::size_t(unknowns))};
  // What stops METIS is SIGTERM, a request to the program, after which it works again.
  for (int attempt = 0; attempt < 2 && !graph.neighbours.empty(); ++attempt) {
    int status = METIS_OK;
    {
      const KeptHandlers kept;
      status = METIS_NodeND(&unknowns, graph.start.data(), graph.neighbours.data(), nullptr, nullptr,
                            d.order.data(), d.place.data());
    }
    if (status == METIS_OK) return d;
    if (status == METIS_ERROR) raise(SIGTERM);
  }
  std::iota(d.order.begin(), d.order.end(), idx_t(0));
  d.place = d.order;
  return d;
}

// Parent of each place in the elimination tree (Liu 1990), -1 for roots.
std::vector<int> elimination_tree(const Graph& graph, const std::vector<int>& order,
                                  const std::vector<int>& place) {
  std::vector<int> parent(order.size(), -1), ancestor(order.size(), -1);
  for (int j = 0; j < int(order.size()); ++j)
    for (idx_t e = graph.start[order[j]]; e < graph.start[order[j] + 1]; ++e)
      for (int i = place[graph.neighbours[e]]; i != -1 && i < j;) {
        const int next = ancestor[i];
        ancestor[i] = j;
        if (next == -1) parent[i] = j;
        i = next;
      }
  return parent;
}

// Places such that all descendants of one lie directly before it.
std::vector<int> postorder(const std::vector<int>& parent) {
  const int n = int(parent.size());
  std::vector<int> first_child(n, -1), sibling(n, -1), sorted, stack;
  for (int j = n - 1; j >= 0; --j) {
    if (parent[j] < 0) continue;
    sibling[j] = first_child[parent[j]];
    first_child[parent[j]] = j;
  }
  for (int root = 0; root < n; ++root) {
    if (parent[root] >= 0) continue;
    stack.push_back(root);
    while (!stack.empty()) {
      const int at = stack.back(), child = first_child[at];
      if (child < 0) {
        sorted.push_back(at);
        stack.pop_back();
      } else {
        first_child[at] = sibling[child];
        stack.push_back(child);
      }
    }
  }
  return sorted;
}

// Unknowns with the same later neighbours form a supernode.
std::vector<Supernode> find_supernodes(const Graph& graph, const Elimination& plan,
                                       const std::vector<int>& parent) {
  const int n = int(parent.size());
  std::vector<std::vector<int>> children(n);
  for (int j = 0; j < n; ++j)
    if (parent[j] >= 0) children[parent[j]].push_back(j);
  std::vector<Supernode> nodes;
  std::vector<int> node_of(n), mark(n, -1);
  for (int j = 0; j < n; ++j) {
    std::vector<int> rows;
    const auto add = [&](int i) {
      if (i <= j || mark[i] == j) return;
      mark[i] = j;
      rows.push_back(i);
    };
    for (idx_t e = graph.start[plan.order[j]]; e < graph.start[plan.order[j] + 1]; ++e)
      add(plan.place[graph.neighbours[e]]);
    for (const int child : children[j])
      for (const int i : nodes[node_of[child]].rows) add(i);
    if (j > 0 && parent[j - 1] == j && nodes[node_of[j - 1]].rows.size() == rows.size() + 1) {
      Supernode& node = nodes[node_of[j] = node_of[j - 1]];
      ++node.width;
      node.rows.erase(std::find(node.rows.begin(), node.rows.end(), j));
    } else {
      node_of[j] = int(nodes.size());
      nodes.push_back({j, 1, std::move(rows)});
    }
  }
  return nodes;
}

// Whether storing and computing with zeros costs less than small supernodes; limits found by measurement.
bool worth_merging(double zeros, double width, double rows) {
  const double share = zeros / (width * width / 2 + width * rows);
  return width <= 16 || (width <= 48 && share < 0.3) || share < 0.08;
}

std::vector<Supernode> merge_supernodes(std::vector<Supernode> nodes) {
  std::vector<Supernode> merged;
  std::vector<double> zeros;
  for (Supernode& node : nodes) {
    double added = 0;
    while (!merged.empty()) {
      const Supernode& child = merged.back();
      if (child.rows.empty() || child.first + child.width != node.first) break;
      if (*std::min_element(child.rows.begin(), child.rows.end()) >= node.first + node.width) break;
      const double all =
          added + zeros.back() + child.width * double(node.width + node.rows.size() - child.rows.size());
      if (!worth_merging(all, child.width + node.width, double(node.rows.size()))) break;
      node.first = child.first;
      node.width += child.width;
      added = all;
      merged.pop_back();
      zeros.pop_back();
    }
    merged.push_back(std::move(node));
    zeros.push_back(added);
  }
  return merged;
}

void link_supernodes(std::vector<Supernode>& nodes, std::size_t unknowns) {
  std::vector<int> node_of(unknowns);
  for (std::size_t k = 0; k < nodes.size(); ++k)
    std::fill_n(node_of.begin() + nodes[k].first, nodes[k].width, int(k));
  for (Supernode& node : nodes) {
    std::sort(node.rows.begin(), node.rows.end());
    if (!node.rows.empty()) node.parent = node_of[node.rows.front()];
  }
}

}  // namespace

Elimination plan_elimination(const Eigen::SparseMatrix<double>& pattern) {
  const int n = int(pattern.rows());
  Graph graph = graph_of(pattern);
  Elimination plan = {std::vector<int>(n), std::vector<int>(n), {}};
  const auto [order, place] = dissected(graph, idx_t(n));
  const std::vector<int> sorted =
      postorder(elimination_tree(graph, {order.begin(), order.end()}, {place.begin(), place.end()}));
  for (int i = 0; i < n; ++i) plan.place[plan.order[i] = int(order[sorted[i]])] = i;
  plan.nodes =
      merge_supernodes(find_supernodes(graph, plan, elimination_tree(graph, plan.order, plan.place)));
  link_supernodes(plan.nodes, std::size_t(n));
  return plan;
}

}  // namespace scree::response
