#pragma once

#include <hdf5.h>
#include <string>
#include <string_view>
#include <utility>

#include <scree/error.hpp>

namespace scree::state_file {

// Throws Error "what: reason" with the last failure of HDF5, or only the reason of a failed system call.
[[noreturn]] void fail_of_hdf5(std::string_view what);

// Result of a call of HDF5, which is below 0 after a failure.
template <class Result>
Result checked(Result result, std::string_view what) {
  if (result < 0) fail_of_hdf5(what);
  return result;
}

// An open object of HDF5, closed at the end.
class Handle {
 public:
  using Close = herr_t (*)(hid_t);

  Handle(hid_t id, Close closing, std::string_view what) : id_(checked(id, what)), close_(closing) {}
  Handle(Handle&& other) noexcept : id_(std::exchange(other.id_, -1)), close_(other.close_) {}
  Handle& operator=(Handle&&) = delete;
  ~Handle() {
    if (id_ >= 0) close_(id_);
  }

  operator hid_t() const { return id_; }
  // Closes it now. Throws Error if the rest cannot be written.
  void close(std::string_view what) { checked(close_(std::exchange(id_, -1)), what); }

 private:
  hid_t id_;
  Close close_;
};

}  // namespace scree::state_file
