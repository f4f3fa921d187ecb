#pragma once

#include <cstddef>
#include <iterator>
#include <type_traits>

namespace scree {

// View of one component of all bodies: the same offset in every record.
template <class T>
class Strided {
 public:
  class Iterator {
   public:
    using iterator_category = std::forward_iterator_tag;
    using value_type = std::remove_const_t<T>;
    using difference_type = std::ptrdiff_t;
    using pointer = T*;
    using reference = T&;

    Iterator() = default;
    Iterator(T* at, std::size_t stride) : at_(at), stride_(stride) {}
    T& operator*() const { return *at_; }
    Iterator& operator++() {
      at_ += stride_;
      return *this;
    }
    Iterator operator++(int) {
      const Iterator before = *this;
      ++*this;
      return before;
    }
    friend bool operator==(const Iterator& a, const Iterator& b) { return a.at_ == b.at_; }

   private:
    T* at_ = nullptr;
    std::size_t stride_ = 0;
  };

  Strided() = default;
  Strided(T* first, std::size_t stride, std::size_t size) : first_(first), stride_(stride), size_(size) {}

  T& operator[](std::size_t i) const { return first_[i * stride_]; }
  T* data() const { return first_; }  // null if the scene does not carry this component
  std::size_t stride() const { return stride_; }
  std::size_t size() const { return size_; }
  bool empty() const { return size_ == 0; }
  Iterator begin() const { return {first_, stride_}; }
  Iterator end() const { return {first_ + size_ * stride_, stride_}; }

 private:
  T* first_ = nullptr;
  std::size_t stride_ = 0, size_ = 0;
};

// View of a vector of all bodies by its components along x, y, z; components that the scene does not carry
// are empty.
template <class T>
class Vectors {
 public:
  // The components [first, last) are adjacent in memory, starting at `data`.
  Vectors(T* data, std::size_t stride, std::size_t size, int first, int last)
      : data_(data), stride_(stride), size_(size), first_(first), last_(last) {}

  Strided<T> operator[](int k) const {
    if (k < first_ || k >= last_) return {};
    return {data_ + (k - first_), stride_, size_};
  }

 private:
  T* data_;
  std::size_t stride_, size_;
  int first_, last_;
};

}  // namespace scree
