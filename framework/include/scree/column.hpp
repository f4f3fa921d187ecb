#pragma once

#include <cstddef>
#include <new>
#include <vector>

#if defined(__linux__)
#include <sys/mman.h>
#endif

namespace scree {

// Allocator of blocks aligned to a cache line (64 bytes), as batches and SIMD loads require. Blocks of 4 MiB
// and more are aligned to large pages and marked for them, because contacts read bodies at scattered
// addresses.
template <class T>
struct CacheLineAllocator {
  using value_type = T;
  static constexpr std::size_t large_page = std::size_t(1) << 21;

  CacheLineAllocator() = default;
  template <class U>
  CacheLineAllocator(const CacheLineAllocator<U>&) {}

  T* allocate(std::size_t n) {
    void* block = ::operator new(n * sizeof(T), alignment_of(n));
#if defined(__linux__)
    if (is_large(n)) ::madvise(block, n * sizeof(T), MADV_HUGEPAGE);
#endif
    return static_cast<T*>(block);
  }
  void deallocate(T* p, std::size_t n) { ::operator delete(p, alignment_of(n)); }
  friend bool operator==(const CacheLineAllocator&, const CacheLineAllocator&) { return true; }

 private:
  static bool is_large(std::size_t n) { return n * sizeof(T) >= 2 * large_page; }
  static std::align_val_t alignment_of(std::size_t n) {
    return std::align_val_t(is_large(n) ? large_page : 64);
  }
};

// One property of all bodies or all pairs: contiguous and 64-byte aligned.
template <class T>
using Column = std::vector<T, CacheLineAllocator<T>>;

// Resizes a column. When it must grow, it reserves an eighth more, so that lists whose length changes
// slightly at each neighbour search do not reallocate every time.
template <class T>
void resize_with_room(Column<T>& column, std::size_t size) {
  if (size > column.capacity()) column.reserve(size + size / 8);
  column.resize(size);
}

}  // namespace scree
