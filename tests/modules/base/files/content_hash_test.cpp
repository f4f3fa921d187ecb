#include "temporary_folder.hpp"

#include <set>

#include <catch2/catch.hpp>

#include <scree/files/content_hash.hpp>

using namespace scree::files;
using scree::test::TemporaryFolder;

TEST_CASE("texts that differ in a bit, in length or in zeros at the end have different hashes", "[files]") {
  const std::string block(1u << 20, 'x');
  const std::set<std::string> hashes = {
      text_hash(""),         text_hash(std::string("\0", 1)),         text_hash("12345678"),
      text_hash("12345679"), text_hash(std::string("12345678\0", 9)), text_hash(block),
      text_hash(block + "x")};
  CHECK(hashes.size() == 7);
  CHECK(text_hash("a").size() == 16);
}

TEST_CASE("a file has the hash of its text, also after it was replaced by one as large and older",
          "[files]") {
  const TemporaryFolder folder;
  namespace fs = std::filesystem;
  // Longer than the block that is read at once.
  std::string text((1u << 20) + 13, 'x');
  const fs::path file = folder.write("file", text);
  CHECK(file_hash(file) == text_hash(text));
  const auto date = fs::last_write_time(file);
  text.back() = 'y';
  fs::rename(folder.write("other", text), file);
  fs::last_write_time(file, date);
  CHECK(file_hash(file) == text_hash(text));
  fs::remove(file);
  CHECK(file_hash(file).empty());
  CHECK(file_hash(folder.path()).empty());
}
