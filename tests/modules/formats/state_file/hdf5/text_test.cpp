#include "hdf5/text.hpp"

#include <string>
#include <vector>

#include <catch2/catch.hpp>

using namespace scree::state_file;

namespace {

// A file in memory.
Handle file() {
  const Handle access(H5Pcreate(H5P_FILE_ACCESS), H5Pclose, "access");
  H5Pset_fapl_core(access, 4096, false);
  return {H5Fcreate("none", H5F_ACC_TRUNC, H5P_DEFAULT, access), H5Fclose, "file"};
}

}  // namespace

TEST_CASE("The text of an attribute is read as it was written", "[text]") {
  const Handle in = file();
  const std::pair<const char*, std::string> texts[] = {{"unit", "kg m2 s-1"}, {"stone", "石"}, {"none", ""}};
  for (const auto& [name, text] : texts) {
    write_attribute(in, name, text);
    CHECK(read_attribute(in, name) == text);
  }
  CHECK(read_attribute(in, "other") == "");
}

TEST_CASE("Attributes of other kinds have no text", "[text]") {
  const Handle in = file();
  const Handle space(H5Screate(H5S_SCALAR), H5Sclose, "space");
  H5Aclose(H5Acreate2(in, "number", H5T_NATIVE_INT, space, H5P_DEFAULT, H5P_DEFAULT));
  CHECK(read_attribute(in, "number") == "");
  write_attribute(in, "long", std::string(1001, 'x'));
  CHECK(read_attribute(in, "long") == "");
}

TEST_CASE("Lines are padded to the longest", "[text]") {
  const PaddedText text({"ab", "", "cde"});
  CHECK(text.width == 3);
  CHECK(std::string(text.bytes.begin(), text.bytes.end()) == std::string("ab\0\0\0\0cde", 9));
  CHECK(PaddedText({"", ""}).width == 1);
  CHECK(PaddedText({}).bytes.empty());
}
