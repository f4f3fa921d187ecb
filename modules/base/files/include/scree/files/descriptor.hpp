#pragma once

#include <string_view>

namespace scree::files {

// An open file descriptor, closed at the end of its scope; -1: none.
class Descriptor {
 public:
  explicit Descriptor(int number = -1) : number_(number) {}
  ~Descriptor();
  Descriptor(Descriptor&& other) noexcept : number_(other.release()) {}
  Descriptor& operator=(Descriptor&& other) noexcept;
  int get() const { return number_; }
  bool is_open() const { return number_ >= 0; }
  // The number, which is no longer closed here.
  int release();

 private:
  int number_;
};

// Opens a file for writing, created empty: what has its name is removed first, so that no link is followed.
// Closed to processes started by this one. If it cannot, the descriptor is not open, and errno has the
// reason.
Descriptor create_file(const char* path);

// The same for a file that is written on at its end, if there is one.
Descriptor append_file(const char* path);

// Whether this open file is still at a path, the last part of which is no link: false once it was removed or
// moved.
bool is_at(const Descriptor& file, const char* path);

// Writes all bytes. Returns 0, or the value of errno of the first call that failed.
int write_all(const Descriptor& file, std::string_view bytes);

}  // namespace scree::files
