#pragma once

#include <algorithm>
#include <cstring>
#include <new>
#include <sys/mman.h>
#include <type_traits>
#include <utility>
#include <vector>

#include <scree/column.hpp>

namespace scree {

// As CacheLineAllocator, but elements of new memory are 0 without being written, and large blocks take up
// memory only where they are written: by the thread that uses a part first, and of a rank for its own bodies.
template <class T>
struct UntouchedAllocator {
  using value_type = T;
  static constexpr std::size_t large_page = CacheLineAllocator<T>::large_page;

  UntouchedAllocator() = default;
  template <class U>
  UntouchedAllocator(const UntouchedAllocator<U>&) {}

  T* allocate(std::size_t n) {
    static_assert(std::is_trivially_copyable_v<T>);
    if (!is_large(n)) {
      T* const block = small_.allocate(n);
      std::memset(static_cast<void*>(block), 0, n * sizeof(T));
      return block;
    }
    return static_cast<T*>(map_pages(bytes_of(n)));
  }
  void deallocate(T* p, std::size_t n) {
    is_large(n) ? void(::munmap(p, bytes_of(n))) : small_.deallocate(p, n);
  }
  // Leaves new elements as they are.
  template <class U>
  void construct(U*) {}
  template <class U, class... Arguments>
  void construct(U* at, Arguments&&... arguments) {
    ::new (static_cast<void*>(at)) U(std::forward<Arguments>(arguments)...);
  }
  friend bool operator==(const UntouchedAllocator&, const UntouchedAllocator&) { return true; }

 private:
  static bool is_large(std::size_t n) { return n * sizeof(T) >= large_page / 2; }
  static std::size_t bytes_of(std::size_t n) {
    return (n * sizeof(T) + large_page - 1) / large_page * large_page;
  }
  // A multiple of large pages, aligned to them.
  static void* map_pages(std::size_t bytes) {
    char* const all = static_cast<char*>(::mmap(nullptr, bytes + large_page, PROT_READ | PROT_WRITE,
                                                MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0));
    if (all == MAP_FAILED) throw std::bad_alloc();
    const std::size_t before = (large_page - reinterpret_cast<std::size_t>(all) % large_page) % large_page;
    if (before > 0) ::munmap(all, before);
    ::munmap(all + before + bytes, large_page - before);
    ::madvise(all + before, bytes, MADV_HUGEPAGE);
    return all + before;
  }

  CacheLineAllocator<T> small_;
};

// One property of all bodies, by place: contiguous, 64-byte aligned, 0 when it is made.
template <class T>
using BodyColumn = std::vector<T, UntouchedAllocator<T>>;

// Whether all bytes are 0.
inline bool is_zero(const void* memory, std::size_t bytes) {
  const char* const first = static_cast<const char*>(memory);
  return *first == 0 && std::memcmp(first, first + 1, bytes - 1) == 0;
}

// Resizes a column. When it must grow it reserves an eighth more, and copies only what is not 0.
template <class T>
void resize_with_room(BodyColumn<T>& column, std::size_t size) {
  if (size <= column.capacity()) return column.resize(size);
  BodyColumn<T> grown;
  grown.reserve(size + size / 8);
  grown.resize(size);
  constexpr std::size_t block = 512;
  for (std::size_t begin = 0; begin < column.size(); begin += block) {
    const T* const from = column.data() + begin;
    const std::size_t count = std::min(block, column.size() - begin);
    if (!is_zero(from, count * sizeof(T))) std::copy_n(from, count, grown.data() + begin);
  }
  column = std::move(grown);
}

}  // namespace scree
