#include "packing_support.hpp"

#include <string>

#include <catch2/catch.hpp>

#include <scree/packing/bead_file.hpp>
#include <scree/packing/csv.hpp>
#include <scree/packing/import.hpp>
#include <scree/packing/lammps.hpp>
#include <scree/packing/other_codes.hpp>

using namespace scree::packing;
using Catch::Matchers::Contains;
using Catch::Matchers::StartsWith;

namespace {

using Parser = Packing (*)(std::string_view, const std::string&, const ImportOptions&);

struct Sample {
  Parser parse;
  std::string text;
};

std::vector<Sample> samples() {
  Packing packing = awkward_packing(3, 4);
  return {{parse_csv, format_csv(packing)},
          {parse_lammps_data, format_lammps_data(packing)},
          {parse_lammps_dump, format_lammps_dump(packing)},
          {parse_beads, "2 1 1\n0.1 0.1 0.1 0.1\n0.5 0.5 0.5 0.1\n"},
          {parse_table, "#format id_x_y_z_r_matId\n0 0.5 1 2 0.1 1\n7 3 1 2 0.1 0\n"},
          {parse_table, "##PERIODIC:: 1 2 3\n0.5 1 2 0.1 -1\n0.5 1 1 0.2 -1\n"},
          {parse_table, "Radius[m] PosX[m] PosY[m] Other\n0.1 1 2 -4\n0.2 5 6 8\n"},
          {parse_mercury,
           "1 0 0 0 0 1 2 3 \n0.1 0.2 0.3 1 2 3 0.01 9 9 9 4 5 6 0\n"
           "1 0.25 0 0 1 2 \n0.4 0.5 -1 0 0.01 0 7 1\n"}};
}

// Either a valid packing, or a one-line message that begins with the file name and ends with a cure.
bool parses_or_explains(const Sample& sample, const std::string& text) {
  Packing packing;
  const std::string error = error_of([&] { packing = sample.parse(text, "file", {}); });
  if (error.empty()) return error_of([&] { check(packing); }).empty();
  return error.starts_with("file:") && error.find("; ") != std::string::npos &&
         error.find_first_of("\n\r") == std::string::npos;
}

}  // namespace

TEST_CASE("the format of a file is detected from its first lines", "[packing]") {
  CHECK(detect_format("ITEM: TIMESTEP\n0\n", "a") == FileFormat::lammps_dump);
  CHECK(detect_format("title\n\n 3 atoms\n", "a") == FileFormat::lammps_data);
  CHECK(detect_format("# note\nx,y,radius\n", "a") == FileFormat::csv);
  CHECK(detect_format("1 0.5 0.5\n", "a") == FileFormat::beads);
  CHECK(detect_format("1 0.5 0.5\n0.1 0.2 0.3 0.1\n", "a") == FileFormat::beads);
  CHECK(detect_format("1 0.5 0.5\n0.1 0.2 0.3\n", "a") == FileFormat::table);
  CHECK(detect_format("0.1 0.2 0.3 0.1\n", "a") == FileFormat::table);
  CHECK(detect_format("PosX PosY Radius\n", "a") == FileFormat::table);
  CHECK(detect_format("1 0 0 0 0 1 1 1\n1 2 3 4 5 6 7 8 9 10 11 12 13 0\n", "a") == FileFormat::mercury);
  CHECK(detect_format("1 0 0 0 1 1\n1 2 3 4 5 6 7 8\n", "a") == FileFormat::mercury);
  CHECK_THAT(error_of([] { detect_format("hello\n", "a"); }),
             StartsWith("a:1:1: ") && Contains("give CSV with a header line"));
  CHECK_THAT(error_of([] { detect_format("", "a"); }), Contains("the file is empty"));
  CHECK(file_format("lammps_dump") == FileFormat::lammps_dump);
  CHECK_THAT(error_of([] { file_format("lammps-data"); }), Contains("did you mean 'lammps_data'?"));
}

TEST_CASE("a byte order mark in front of a file of any format is passed over", "[packing]") {
  for (const std::string text :
       {"x,y,z,radius\n0.5,0.5,0.5,0.1\n", "1 1 1\n0.5 0.5 0.5 0.1\n",
        "ITEM: TIMESTEP\n0\nITEM: NUMBER OF ATOMS\n1\nITEM: BOX BOUNDS ff ff ff\n0 1\n0 1\n0 1\n"
        "ITEM: ATOMS id x y z radius\n1 0.5 0.5 0.5 0.1\n"})
    CHECK(parse_packing("\xef\xbb\xbf" + text, "packing").bodies.size() == 1);
}

TEST_CASE("columns separated by semicolons are refused with what to write", "[packing]") {
  CHECK(error_of([] {
          parse_packing("x;y;z;radius\n0,5;0,5;0,5;0,1\n", "packing");
        }).starts_with("packing:1:"));
  CHECK(error_of([] { parse_packing("x;y;z;radius\n", "packing"); }) ==
        "packing:1:1: the format of the file is not recognised; "
        "separate the columns of a CSV file by commas, and write decimal points");
}

TEST_CASE("a file cut off anywhere is refused with a message, or is complete", "[packing]") {
  for (const Sample& sample : samples()) {
    for (std::size_t length = 0; length <= sample.text.size(); ++length) {
      INFO(sample.text.substr(0, length));
      REQUIRE(parses_or_explains(sample, sample.text.substr(0, length)));
    }
  }
}

TEST_CASE("a file with any byte damaged is refused with a message, or is still valid", "[packing]") {
  Random random(11);
  for (const Sample& sample : samples()) {
    for (int round = 0; round < 5000; ++round) {
      std::string text = sample.text;
      const std::size_t changes = 1 + random.bits() % 3;
      for (std::size_t k = 0; k < changes; ++k) {
        const bool likely = random.uniform() < 0.5;
        const char likely_byte = std::string("0123456789-+.eE,; \n\t#ITEM:naif")[random.bits() % 31];
        text[random.bits() % text.size()] = likely ? likely_byte : static_cast<char>(random.bits() % 256);
      }
      INFO(text);
      REQUIRE(parses_or_explains(sample, text));
    }
  }
}

TEST_CASE("random bytes are refused with a message", "[packing]") {
  Random random(12);
  for (const Sample& sample : samples()) {
    for (int round = 0; round < 1000; ++round) {
      std::string text(random.bits() % 200, ' ');
      for (char& byte : text) byte = static_cast<char>(1 + random.bits() % 255);
      REQUIRE(parses_or_explains(sample, text));
    }
  }
}
