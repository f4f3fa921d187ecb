#include <utility>

#include <scree/response/degrees_of_freedom.hpp>

namespace scree::response {

DegreesOfFreedom::DegreesOfFreedom(int dimension, int spins, const std::vector<bool>& translates,
                                   const std::vector<bool>& rotates, const std::vector<bool>& free_walls,
                                   std::vector<freedom::Mask> held, const std::vector<bool>& turning_walls)
    : dimension_(dimension),
      spins_(spins),
      translation_(translates.size(), none),
      rotation_(translates.size(), none),
      wall_(free_walls.size(), none),
      turn_(free_walls.size(), none),
      held_(std::move(held)) {
  for (std::size_t i = 0; i < translates.size(); ++i) {
    if (!translates[i]) continue;
    if (const Eigen::Index free = count(i, 0, dimension); free > 0) {
      translation_[i] = size_;
      size_ += free;
    }
    if (!rotates[i]) continue;
    if (const Eigen::Index free = count(i, first_rotation(), spins); free > 0) {
      rotation_[i] = size_;
      size_ += free;
    }
  }
  for (std::size_t w = 0; w < free_walls.size(); ++w)
    if (free_walls[w]) wall_[w] = size_++;
  for (std::size_t w = 0; w < turning_walls.size(); ++w)
    if (turning_walls[w]) turn_[w] = size_++;
}

}  // namespace scree::response
