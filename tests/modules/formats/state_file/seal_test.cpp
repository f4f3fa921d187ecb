#include "sample_state.hpp"
#include "temporary_folder.hpp"

#include <sys/stat.h>
#include <unistd.h>

#include <catch2/catch.hpp>

#include <scree/error.hpp>
#include <scree/state_file/description.hpp>
#include <scree/state_file/state_file.hpp>

using namespace scree;
using namespace scree::test;
using Catch::Matchers::Contains;
using Catch::Matchers::EndsWith;

namespace {

// What read_state says of a file: one line for bad input, which begins with the path and ends with a cure.
std::string refusal(const std::filesystem::path& file) {
  try {
    state_file::read_state(file);
  } catch (const Error& error) {
    const std::string line = error.what();
    CHECK(error.status() == ExitStatus::bad_input);
    CHECK(line.starts_with(file.string() + ": "));
    CHECK(line.find("; ") != line.npos);
    CHECK(line.find('\n') == line.npos);
    return line.substr(file.string().size() + 2);
  }
  FAIL("was read");
  return "";
}

struct Sample {
  TemporaryFolder folder;
  std::filesystem::path file = folder / "a.h5";
  std::string bytes;

  Sample() {
    state_file::write_state(file, sample_state());
    bytes = text_of(file);
  }
  std::string refusal_of(const std::string& other) const { return refusal(folder.write("other.h5", other)); }
  std::string refusal_with(const std::string& before, const std::string& after) const {
    std::string other = bytes;
    other.replace(other.find(before), before.size(), after);
    return refusal_of(other);
  }
};

}  // namespace

TEST_CASE("A state file is refused whichever of its bytes has one wrong bit", "[seal]") {
  const Sample sample;
  std::string other = sample.bytes;
  for (std::size_t k = 0; k < other.size(); ++k) {
    other[k] = char(other[k] ^ (1 << (k % 8)));
    const std::string line = sample.refusal_of(other);
    other[k] = sample.bytes[k];
    if (k >= 512 && line != "is damaged: its bytes do not match its checksum; take another copy of it")
      FAIL(line);
  }
}

TEST_CASE("A state file is refused whichever bit of its seal is wrong", "[seal]") {
  const Sample sample;
  std::string other = sample.bytes;
  for (std::size_t bit = 0; bit < 512 * 8; ++bit) {
    other[bit / 8] = char(other[bit / 8] ^ (1 << (bit % 8)));
    sample.refusal_of(other);
    other[bit / 8] = sample.bytes[bit / 8];
  }
}

TEST_CASE("A state file that was cut off or extended is refused", "[seal]") {
  const Sample sample;
  const std::string size = std::to_string(sample.bytes.size());
  for (std::size_t end = 97; end < sample.bytes.size(); end += 97)
    sample.refusal_of(sample.bytes.substr(0, end));
  CHECK(sample.refusal_of("") == "is empty; take another copy of it");
  CHECK(sample.refusal_of(sample.bytes.substr(0, 5000)) ==
        "has 5000 bytes, and " + size + " when it was written; take another copy of it");
  CHECK_THAT(sample.refusal_of(sample.bytes + '\0'),
             EndsWith(size + " when it was written; take another copy of it"));
}

TEST_CASE("A state file with two regions exchanged or one set to zero is refused", "[seal]") {
  const Sample sample;
  for (std::size_t at = 512; at + 128 <= sample.bytes.size(); at += 64) {
    std::string exchanged = sample.bytes, zeroed = sample.bytes;
    std::swap_ranges(exchanged.begin() + long(at), exchanged.begin() + long(at) + 64,
                     exchanged.begin() + long(at) + 64);
    std::fill_n(zeroed.begin() + long(at), 64, '\0');
    if (exchanged != sample.bytes) sample.refusal_of(exchanged);
    if (zeroed != sample.bytes) sample.refusal_of(zeroed);
  }
}

TEST_CASE("The refusal of a state file names the format and what wrote it", "[seal]") {
  const Sample sample;
  for (const char* format : {"0", "3", "17"})
    CHECK(
        sample.refusal_with("format 2", std::string("format ") + format) ==
        std::string("has format ") + format +
            ", and this scree reads formats 1 to 2; use the version that has written it, " SCREE_TEST_VERSION);
  CHECK_THAT(sample.refusal_with("scree state", "grain state"), Contains("is not a state file of scree; "));
  CHECK_THAT(sample.refusal_of(sample.bytes.substr(512)), Contains("is not a state file of scree; "));
  CHECK_THAT(sample.refusal_of("[scene]\n"), Contains("is not a state file of scree; "));
  for (const char* wrong : {"format x", "format  2", "format 02", "format +2", "format 2 ", "format \x1b"})
    sample.refusal_with("format 2", wrong);
}

TEST_CASE("What is no readable file is refused as a state and not waited for", "[seal]") {
  const TemporaryFolder folder;
  CHECK(refusal(folder / "none.h5") == "there is no such file; check the path");
  CHECK(refusal(folder.path()) == "is not a regular file; give a state file");
  REQUIRE(mkfifo((folder / "pipe").c_str(), 0600) == 0);
  CHECK(refusal(folder / "pipe") == "is not a regular file; give a state file");
  CHECK(refusal("/dev/zero") == "is not a regular file; give a state file");
  CHECK_THAT(refusal(folder.write("file", "") / "a.h5"), Contains("Not a directory"));
  if (geteuid() != 0) {  // who may read everything
    std::filesystem::permissions(folder.write("secret.h5", "x"), std::filesystem::perms::none);
    CHECK_THAT(refusal(folder / "secret.h5"), Contains("Permission denied"));
  }
}
