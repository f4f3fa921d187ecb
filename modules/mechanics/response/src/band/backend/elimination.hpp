#pragma once

#include <vector>

#include <Eigen/SparseCore>

namespace scree::response {

// Adjacent unknowns that are eliminated together, and the later unknowns (ascending) to which they are
// coupled.
struct Supernode {
  int first, width;
  std::vector<int> rows;
  int parent = -1;  // the supernode of rows.front()
};

// The order in which the unknowns of a matrix with symmetric pattern are eliminated, by nested dissection.
struct Elimination {
  std::vector<int> order;  // unknown at each place
  std::vector<int> place;  // place of each unknown
  std::vector<Supernode> nodes;
};

Elimination plan_elimination(const Eigen::SparseMatrix<double>& pattern);

}  // namespace scree::response
