#include <cstring>
#include <string>
#include <vector>

#include <catch2/catch.hpp>

#include <scree/files/checksum.hpp>

using scree::files::Checksum;

namespace {

std::uint64_t checksum_of(const std::string& bytes) {
  Checksum sum;
  sum.add(bytes.data(), bytes.size());
  return sum.value();
}

}  // namespace

TEST_CASE("a checksum sees every bit that changes and words that change places", "[files]") {
  std::string bytes(136, '\0');  // four rows of 32 bytes and a rest
  for (std::size_t k = 0; k < bytes.size(); ++k) bytes[k] = char(7 * k + 1);
  const std::uint64_t sound = checksum_of(bytes);
  for (std::size_t bit = 0; bit < 8 * bytes.size(); ++bit) {
    std::string changed = bytes;
    changed[bit / 8] = char(changed[bit / 8] ^ (1 << bit % 8));
    CHECK(checksum_of(changed) != sound);
  }
  for (std::size_t word = 1; word < bytes.size() / 8; ++word) {
    std::string changed = bytes.substr(8 * word, 8) + bytes.substr(8, 8 * (word - 1)) + bytes.substr(0, 8) +
                          bytes.substr(8 * (word + 1));
    CHECK(checksum_of(changed) != sound);
  }
}

TEST_CASE("a checksum is the same in one piece and in several, wherever they are in memory", "[files]") {
  const std::string bytes(200, 'x');
  const std::uint64_t whole = checksum_of(bytes);
  for (const std::size_t first : {32, 64, 160}) {
    // One byte behind a word.
    std::vector<char> odd(1 + bytes.size());
    std::memcpy(odd.data() + 1, bytes.data(), bytes.size());
    Checksum sum;
    sum.add(odd.data() + 1, first);
    sum.add(odd.data() + 1 + first, bytes.size() - first);
    CHECK(sum.value() == whole);
  }
}
