#include <bit>
#include <cstring>

#include <scree/files/checksum.hpp>

namespace scree::files {
namespace {

// Bytes as a number with the lowest first, whatever the order of the processor.
std::uint64_t word_at(const unsigned char* bytes) {
  std::uint64_t word;
  std::memcpy(&word, bytes, sizeof word);
  return std::endian::native == std::endian::little ? word : __builtin_bswap64(word);
}

}  // namespace

void Checksum::add(const void* data, std::size_t bytes) {
  const auto* at = static_cast<const unsigned char*>(data);
  constexpr std::size_t row = sizeof(std::uint64_t) * 4;
  auto [a, b, c, d] = hashes_;
  for (; bytes >= row; at += row, bytes -= row) {
    a.add(word_at(at));
    b.add(word_at(at + 8));
    c.add(word_at(at + 16));
    d.add(word_at(at + 24));
  }
  hashes_ = {a, b, c, d};
  if (bytes == 0) return;
  unsigned char rest[row] = {};
  std::memcpy(rest, at, bytes);
  add(rest, row);
}

std::uint64_t Checksum::value() const {
  StateHash all;
  for (const StateHash& hash : hashes_) all.add(hash.value());
  return all.value();
}

}  // namespace scree::files
