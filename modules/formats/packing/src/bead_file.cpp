#include "body_field.hpp"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include <scree/counted.hpp>
#include <scree/files/text_file.hpp>
#include <scree/packing/bead_file.hpp>

namespace scree::packing {

namespace {

struct Header {
  std::int64_t count;  // bodies
  double period;       // (m) along x and z
  double height;       // (m) between the walls
};

Header read_header(TextReader& reader) {
  if (!reader.next_words()) reader.fail(1, "the file is empty", "begin with a line 'N L H'");
  const auto& words = reader.words();
  if (words.size() != 3)
    reader.fail(1, fmt::format("{} instead of 'N L H'", counted(words.size(), "word")),
                "give number of beads, period and height");
  return {reader.positive_integer(words[0], "number of beads"), reader.positive_number(words[1], "period"),
          reader.positive_number(words[2], "height")};
}

Body read_bead(TextReader& reader) {
  constexpr BodyField columns[] = {BodyField::x, BodyField::y, BodyField::z, BodyField::radius};
  const auto& words = reader.words();
  if (words.size() != 4)
    reader.fail(1, fmt::format("{} instead of 'x y z radius'", counted(words.size(), "word")),
                "give four numbers");
  Body body;
  for (std::size_t k = 0; k < 4; ++k) set_field(body, columns[k], words[k], reader);
  return body;
}

}  // namespace

Packing parse_beads(std::string_view text, const std::string& name, const ImportOptions& options) {
  TextReader reader(text, name);
  const Header header = read_header(reader);
  Packing packing;
  packing.bounds = Bounds{{}, {{header.period, header.height, header.period}}};
  packing.periodic = options.periodic.value_or(std::array{true, false, true});
  while (reader.next_words()) {
    packing.bodies.push_back(read_bead(reader));
    packing.bodies.back().id = std::int64_t(packing.bodies.size());
  }
  const auto found = std::int64_t(packing.bodies.size());
  if (found != header.count)
    reader.fail(1,
                fmt::format("the first line gives {}, the file has {}",
                            counted(std::size_t(header.count), "bead"), found),
                "complete the file or correct its first line");
  return checked_import(std::move(packing), name);
}

Packing read_beads(const std::filesystem::path& path, const ImportOptions& options) {
  return parse_beads(files::read_text(path), path.string(), options);
}

}  // namespace scree::packing
