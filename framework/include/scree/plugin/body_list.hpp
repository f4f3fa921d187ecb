#pragma once

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <scree/plugin/abi.h>
#include <scree/plugin/declaration.hpp>

namespace scree {

// Range of a parameter that is a list of ids.
inline constexpr Range body_ids{.minimum = 1, .maximum = SCREE_MAX_ID};

// Bodies that a parameter of a probe gives by their ids. They are found once, in `start`, and kept as indices
// in the state:
//
//   scree::BodyList bodies;
//   in declare   d.list("ids", bodies.ids, "", scree::body_ids, "ids of the bodies to record").required();
//   in describe  instance.state_width = std::uint32_t(bodies.size());
//   in start     return bodies.find(view, state);
//   in sample    view.mass[bodies.index(view, state, k)]
//   in mark_bodies  bodies.mark(view, state, marks);
struct BodyList {
  scree_value ids = {};
  std::uint64_t stride = 1;  // 2: only the first of each two numbers is an id

  std::uint64_t size() const { return ids.count / stride; }
  long long id(std::uint64_t k) const { return static_cast<long long>(ids.data[k * stride]); }

  // The problem and a remedy if a body is given twice, for probes that count each once; otherwise "".
  std::string repeated() const {
    std::vector<double> sorted(ids.data, ids.data + ids.count);
    std::sort(sorted.begin(), sorted.end());
    const auto twice = std::adjacent_find(sorted.begin(), sorted.end());
    if (twice == sorted.end()) return "";
    char problem[96];
    std::snprintf(problem, sizeof(problem), "the id %.16g is given twice; give each once", *twice);
    return problem;
  }

  // Writes the index of each body to size() doubles. Returns the problem and a remedy, or "" without one.
  std::string find(const scree_view& view, double* indices) const {
    std::vector<std::pair<double, std::uint64_t>> wanted;  // id and place in the list
    for (std::uint64_t k = 0; k < size(); ++k) wanted.emplace_back(ids.data[k * stride], k), indices[k] = -1;
    std::sort(wanted.begin(), wanted.end());
    for (std::uint64_t i = 0; i < view.body_count; ++i) {
      const double id = double(view.id[i]);
      auto at = std::lower_bound(wanted.begin(), wanted.end(), std::pair(id, std::uint64_t(0)));
      for (; at != wanted.end() && at->first == id; ++at) indices[at->second] = double(i);
    }
    for (const auto& [id, k] : wanted) {
      if (indices[k] >= 0) continue;
      char problem[128];
      std::snprintf(problem, sizeof(problem),
                    "a body with the id %.16g does not exist; bodies without an id are numbered from 1, "
                    "after the largest id given",
                    id);
      return problem;
    }
    return "";
  }

  // Index of the k-th body in the columns of a view. What is kept tells where to look first: a state that
  // comes from a file may hold any number. Throws if there is no such body.
  std::uint64_t index(const scree_view& view, const double* indices, std::uint64_t k) const {
    const long long wanted = id(k);
    if (indices[k] >= 0 && indices[k] < double(view.body_count))
      if (const auto kept = std::uint64_t(indices[k]); view.id[kept] == wanted) return kept;
    for (std::uint64_t i = 0; i < view.body_count; ++i)
      if (view.id[i] == wanted) return i;
    throw std::out_of_range("there is no body with the id " + std::to_string(wanted));
  }

  // Sets the mark of each of the bodies.
  void mark(const scree_view& view, const double* indices, std::uint8_t* marks) const {
    for (std::uint64_t k = 0; k < size(); ++k) marks[index(view, indices, k)] = 1;
  }
};

}  // namespace scree
