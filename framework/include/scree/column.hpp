#pragma once

#include <cstddef>
#include <new>
#include <vector>

#if defined(__linux__)
#include <sys/mman.h>
#endif

namespace scree {

// Allocator of blocks aligned to a cache line (64 bytes), as batches and SIMD loads require. Blocks of half a
// large page and more have large pages of their own: processors read ahead in them without interruption, and
// contacts read bodies at scattered addresses.
template <class T>
struct CacheLineAllocator {
  using value_type = T;
  static constexpr std::size_t large_page = std::size_t(1) << 21;

  CacheLineAllocator() = default;
  template <class U>
  CacheLineAllocator(const CacheLineAllocator<U>&) {}

  T* allocate(std::size_t n) {
    void* block = ::operator new(bytes_of(n), alignment_of(n));
#if defined(__linux__)
    if (is_large(n)) ::madvise(block, bytes_of(n), MADV_HUGEPAGE);
#endif
    return static_cast<T*>(block);
  }
  void deallocate(T* p, std::size_t n) { ::operator delete(p, alignment_of(n)); }
  friend bool operator==(const CacheLineAllocator&, const CacheLineAllocator&) { return true; }

 private:
  static bool is_large(std::size_t n) { return n * sizeof(T) >= large_page / 2; }
  static std::size_t bytes_of(std::size_t n) {
    return is_large(n) ? (n * sizeof(T) + large_page - 1) / large_page * large_page : n * sizeof(T);
  }
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
