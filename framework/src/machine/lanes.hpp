#pragma once

#include <bit>
#include <cassert>
#include <cstddef>
#include <cstdint>

// The code of the hot loops is inlined completely into one function per instruction level (evaluate.cpp).
#define SCREE_HOT [[gnu::always_inline]] inline
#define SCREE_INLINE_LAMBDA __attribute__((always_inline))

namespace scree::kernel {

// Four doubles, one part of a body's record, in one vector register; in two registers without AVX.
typedef double Four __attribute__((vector_size(32)));

inline bool is_aligned(const double* p) { return reinterpret_cast<std::uintptr_t>(p) % sizeof(Four) == 0; }

SCREE_HOT Four& four_at(double* aligned) {
  assert(is_aligned(aligned));
  return *static_cast<Four*>(__builtin_assume_aligned(aligned, 32));
}
SCREE_HOT Four load_four(const double* aligned) {
  assert(is_aligned(aligned));
  return *static_cast<const Four*>(__builtin_assume_aligned(aligned, 32));
}
SCREE_HOT void store_four(double* aligned, const Four& v) {
  assert(is_aligned(aligned));
  *static_cast<Four*>(__builtin_assume_aligned(aligned, 32)) = v;
}
SCREE_HOT void add_four(double* aligned, const Four& v) { store_four(aligned, load_four(aligned) + v); }

// For counting lanes: a narrower counter would change the vector width of loops.
using Count = std::int64_t;

// 4 × 4 transpose. The first stage uses integer shuffles: processors have two execution units for these, and
// one for the same shuffle of floating-point numbers.
SCREE_HOT void transpose(Four& a, Four& b, Four& c, Four& d) {
  typedef std::int64_t Bits __attribute__((vector_size(32)));
  const auto first = [](const Four& x, const Four& y) SCREE_INLINE_LAMBDA {
    return std::bit_cast<Four>(
        __builtin_shufflevector(std::bit_cast<Bits>(x), std::bit_cast<Bits>(y), 0, 4, 2, 6));
  };
  const auto second = [](const Four& x, const Four& y) SCREE_INLINE_LAMBDA {
    return std::bit_cast<Four>(
        __builtin_shufflevector(std::bit_cast<Bits>(x), std::bit_cast<Bits>(y), 1, 5, 3, 7));
  };
  const Four ab_first = first(a, b), ab_second = second(a, b);
  const Four cd_first = first(c, d), cd_second = second(c, d);
  a = __builtin_shufflevector(ab_first, cd_first, 0, 1, 4, 5);
  b = __builtin_shufflevector(ab_second, cd_second, 0, 1, 4, 5);
  c = __builtin_shufflevector(ab_first, cd_first, 2, 3, 6, 7);
  d = __builtin_shufflevector(ab_second, cd_second, 2, 3, 6, 7);
}

}  // namespace scree::kernel
