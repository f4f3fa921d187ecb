#include "contacts/kernel/orientations.hpp"

namespace scree::kernel {

template <bool planes, class T>
void gather_orientations(const EvaluationInput& input, std::size_t begin, std::uint32_t count,
                         BlockColumns<T>& block) {
  const int components = input.orientations.components();
  const double* const values = input.orientations.data();
  const std::size_t stride = input.orientations.stride();
  for (int k = 0; k < components; ++k) {
    // The identity: angle 0, quaternion (1, 0, 0, 0).
    const T of_plane = components > 1 && k == 0 ? T(1) : T(0);
    for (std::uint32_t i = 0; i < count; ++i) {
      block.orientation[0][k][i] = T(values[input.contacts.a[begin + i] * stride + std::size_t(k)]);
      block.orientation[1][k][i] =
          planes ? of_plane : T(values[input.contacts.b[begin + i] * stride + std::size_t(k)]);
    }
    block.batch.input[SCREE_ORIENTATION_A + k] = block.orientation[0][k];
    block.batch.input[SCREE_ORIENTATION_B + k] = block.orientation[1][k];
  }
}

template void gather_orientations<false>(const EvaluationInput&, std::size_t, std::uint32_t,
                                         BlockColumns<double>&);
template void gather_orientations<true>(const EvaluationInput&, std::size_t, std::uint32_t,
                                        BlockColumns<double>&);
template void gather_orientations<false>(const EvaluationInput&, std::size_t, std::uint32_t,
                                         BlockColumns<float>&);
template void gather_orientations<true>(const EvaluationInput&, std::size_t, std::uint32_t,
                                        BlockColumns<float>&);

}  // namespace scree::kernel
