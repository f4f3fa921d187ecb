#include <scree/response/degrees_of_freedom.hpp>

namespace scree::response {

DegreesOfFreedom::DegreesOfFreedom(int dimension, int spins, const std::vector<bool>& translates,
                                   const std::vector<bool>& rotates, const std::vector<bool>& free_walls)
    : dimension_(dimension),
      spins_(spins),
      translation_(translates.size(), none),
      rotation_(translates.size(), none),
      wall_(free_walls.size(), none) {
  for (std::size_t i = 0; i < translates.size(); ++i) {
    if (!translates[i]) continue;
    translation_[i] = size_;
    size_ += dimension;
    if (spins == 0 || !rotates[i]) continue;
    rotation_[i] = size_;
    size_ += spins;
  }
  for (std::size_t w = 0; w < free_walls.size(); ++w)
    if (free_walls[w]) wall_[w] = size_++;
}

}  // namespace scree::response
