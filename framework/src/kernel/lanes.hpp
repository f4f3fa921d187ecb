#pragma once

#include <cstddef>
#include <cstdint>
#include <type_traits>

// Code of the hot loops is inlined whole into one function per instruction level (evaluate.cpp).
#define SCREE_HOT [[gnu::always_inline]] inline
#define SCREE_INLINE_LAMBDA __attribute__((always_inline))

namespace scree::kernel {

// Four doubles that move together: one record of a body. Two registers where there is no AVX.
typedef double Four __attribute__((vector_size(32)));
typedef float FourSingles __attribute__((vector_size(16)));

SCREE_HOT Four& four_at(double* aligned) {
  return *static_cast<Four*>(__builtin_assume_aligned(aligned, 32));
}
SCREE_HOT Four load_four(const double* aligned) {
  return *static_cast<const Four*>(__builtin_assume_aligned(aligned, 32));
}
SCREE_HOT void store_four(double* aligned, const Four& v) {
  *static_cast<Four*>(__builtin_assume_aligned(aligned, 32)) = v;
}
SCREE_HOT void add_four(double* aligned, const Four& v) { store_four(aligned, load_four(aligned) + v); }

// Counts lanes of T: of the same size, so that a loop over them takes as many at a time as without it.
template <class T>
using Count = std::conditional_t<sizeof(T) == 8, std::int64_t, std::int32_t>;

// Rows become columns.
SCREE_HOT void transpose(Four& a, Four& b, Four& c, Four& d) {
  const Four ab_low = __builtin_shufflevector(a, b, 0, 4, 2, 6),
             ab_high = __builtin_shufflevector(a, b, 1, 5, 3, 7);
  const Four cd_low = __builtin_shufflevector(c, d, 0, 4, 2, 6),
             cd_high = __builtin_shufflevector(c, d, 1, 5, 3, 7);
  a = __builtin_shufflevector(ab_low, cd_low, 0, 1, 4, 5);
  b = __builtin_shufflevector(ab_high, cd_high, 0, 1, 4, 5);
  c = __builtin_shufflevector(ab_low, cd_low, 2, 3, 6, 7);
  d = __builtin_shufflevector(ab_high, cd_high, 2, 3, 6, 7);
}

// Four neighbouring numbers of a column of double or float.
SCREE_HOT void store_lanes(double* column, const Four& v) { store_four(column, v); }
SCREE_HOT void store_lanes(float* column, const Four& v) {
  *static_cast<FourSingles*>(__builtin_assume_aligned(column, 16)) = __builtin_convertvector(v, FourSingles);
}
SCREE_HOT Four load_lanes(const double* column) { return load_four(column); }
SCREE_HOT Four load_lanes(const float* column) {
  const auto v = *static_cast<const FourSingles*>(__builtin_assume_aligned(column, 16));
  return __builtin_convertvector(v, Four);
}

}  // namespace scree::kernel
