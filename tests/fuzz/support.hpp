#pragma once

#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <string_view>

#include <scree/error.hpp>

// What all fuzz targets share. A target calls one reader; any end but success or a refusal is a finding.

namespace scree::fuzz {

inline std::string_view text_of(const std::uint8_t* data, std::size_t size) {
  return {reinterpret_cast<const char*>(data), size};
}

// A refusal is one printable line with a cure, for the status of bad input.
inline void check_refusal(const Error& error) {
  const std::string_view line = error.what();
  bool plain = !line.empty() && line.find("; ") != std::string_view::npos;
  for (const unsigned char c : line) plain &= c >= 0x20 && c != 0x7F;
  if (plain && error.status() == ExitStatus::bad_input) return;
  std::fprintf(stderr, "not a refusal of bad input: status %d, '%s'\n", int(error.status()), error.what());
  std::abort();
}

// Calls a reader, which may return or refuse; other exceptions leave and stop the fuzzer.
template <class Read>
int accept_or_refuse(const Read& read) {
  try {
    read();
  } catch (const Error& error) {
    check_refusal(error);
  }
  return 0;
}

}  // namespace scree::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);
