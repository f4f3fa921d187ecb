#pragma once

#include <cstddef>
#include <memory>

#include <scree/ranks.hpp>

namespace scree::ranks {

// Raised with every change of this interface or of Ranks.
constexpr int backend_version = 2;

// What libscree_ranks_mpi.so implements.
class RanksBackend {
 public:
  virtual ~RanksBackend() = default;

  // See join_ranks.hpp.
  virtual std::unique_ptr<Ranks> join(std::size_t piece) = 0;
};

}  // namespace scree::ranks
