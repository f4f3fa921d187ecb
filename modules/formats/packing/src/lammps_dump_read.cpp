#include "body_field.hpp"
#include "lammps_dump_frames.hpp"
#include "material_types.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include <scree/counted.hpp>
#include <scree/files/text_file.hpp>
#include <scree/packing/lammps.hpp>

namespace scree::packing {

namespace {

enum class Scale { none, box };

// Maps a column name to a field of a body; of several columns for the same field the first is used.
struct DumpColumn {
  std::string_view name;
  BodyField field;
  Scale scale = Scale::none;
};

constexpr std::array columns_of_dumps = {
    DumpColumn{"id", BodyField::id},         DumpColumn{"type", BodyField::material},
    DumpColumn{"x", BodyField::x},           DumpColumn{"xs", BodyField::x, Scale::box},
    DumpColumn{"xu", BodyField::x},          DumpColumn{"xsu", BodyField::x, Scale::box},
    DumpColumn{"y", BodyField::y},           DumpColumn{"ys", BodyField::y, Scale::box},
    DumpColumn{"yu", BodyField::y},          DumpColumn{"ysu", BodyField::y, Scale::box},
    DumpColumn{"z", BodyField::z},           DumpColumn{"zs", BodyField::z, Scale::box},
    DumpColumn{"zu", BodyField::z},          DumpColumn{"zsu", BodyField::z, Scale::box},
    DumpColumn{"radius", BodyField::radius}, DumpColumn{"diameter", BodyField::diameter},
    DumpColumn{"mass", BodyField::mass},     DumpColumn{"density", BodyField::density},
    DumpColumn{"vx", BodyField::vx},         DumpColumn{"vy", BodyField::vy},
    DumpColumn{"vz", BodyField::vz},         DumpColumn{"omegax", BodyField::wx},
    DumpColumn{"omegay", BodyField::wy},     DumpColumn{"omegaz", BodyField::wz},
};

// A column of the file that is used.
struct Source {
  BodyField field;
  Scale scale;
  std::size_t column;
};

// True for alternative fields of one quantity: radius or diameter; mass or density.
bool same_quantity(BodyField a, BodyField b) {
  const auto size = [](BodyField f) { return f == BodyField::radius || f == BodyField::diameter; };
  const auto mass = [](BodyField f) { return f == BodyField::mass || f == BodyField::density; };
  return a == b || (size(a) && size(b)) || (mass(a) && mass(b));
}

std::vector<Source> choose_sources(const std::vector<Token>& names) {
  std::vector<Source> sources;
  for (const DumpColumn& column : columns_of_dumps) {
    const auto known = [&](const Source& source) { return same_quantity(source.field, column.field); };
    if (std::any_of(sources.begin(), sources.end(), known)) continue;
    for (std::size_t k = 0; k < names.size(); ++k) {
      if (names[k].text != column.name) continue;
      sources.push_back({column.field, column.scale, k});
      break;
    }
  }
  return sources;
}

class FrameReader {
 public:
  FrameReader(TextReader& reader, const ImportOptions& options) : reader_(reader), options_(options) {
    packing_.dimension = options.dimension.value_or(3);
  }

  Packing read() {
    while (reader_.next())
      if (read_item()) return std::move(packing_);
    fail_truncated();
  }

 private:
  bool read_item();
  Token value_line();
  void read_box();
  void read_box_flags(const std::vector<Token>& words);
  void read_atoms();
  void require_columns(const std::vector<Source>& sources);
  Body read_body(const std::vector<Source>& sources);
  void place_in_box(Body& body, const Source& source);
  [[noreturn]] void fail_truncated();

  TextReader& reader_;
  const ImportOptions& options_;
  Packing packing_;
  std::optional<std::int64_t> expected_;
  IdRegister ids_;
};

void FrameReader::fail_truncated() {
  reader_.fail(1,
               fmt::format("the frame is cut off after {} of {}", packing_.bodies.size(),
                           counted(std::size_t(expected_.value_or(0)), "atom")),
               "complete the file, or choose an earlier timestep");
}

// Returns true after the atoms, the last item of a frame.
bool FrameReader::read_item() {
  const std::string_view line = reader_.line();
  if (line.starts_with("ITEM: ATOMS")) {
    read_atoms();
    return true;
  }
  if (line.starts_with("ITEM: TIMESTEP") || line.starts_with("ITEM: UNITS")) {
    value_line();
  } else if (line.starts_with("ITEM: TIME")) {
    packing_.time = reader_.number(value_line(), "time");
  } else if (line.starts_with("ITEM: NUMBER OF ATOMS")) {
    expected_ = reader_.positive_integer(value_line(), "number of atoms");
  } else if (line.starts_with("ITEM: BOX BOUNDS")) {
    read_box();
  } else {
    reader_.fail(1, fmt::format("unknown item {}", quote_token(line)), "give the output of dump custom");
  }
  return false;
}

Token FrameReader::value_line() {
  if (!reader_.next()) fail_truncated();
  return reader_.trimmed(0, reader_.line().size());
}

void FrameReader::read_box_flags(const std::vector<Token>& words) {
  if (words.size() > 3 && words[3].text == "xy")
    reader_.fail(words[3].column, "the box is tilted", "give a packing in an axis-parallel box");
  for (std::size_t k = 3; k < std::min<std::size_t>(words.size(), 6); ++k)
    packing_.periodic[k - 3] = words[k].text == "pp";
}

void FrameReader::read_box() {
  read_box_flags(reader_.words());
  packing_.bounds = Bounds{};
  for (int k = 0; k < 3; ++k) {
    if (!reader_.next()) fail_truncated();
    const auto& words = reader_.words();
    if (words.size() != 2)
      reader_.fail(1,
                   fmt::format("{} instead of the two bounds of {}", counted(words.size(), "word"), "xyz"[k]),
                   "give a packing in an axis-parallel box");
    packing_.bounds->lower[k] = reader_.number(words[0], "lower bound");
    packing_.bounds->upper[k] = reader_.number(words[1], "upper bound");
    if (packing_.bounds->lower[k] < packing_.bounds->upper[k]) continue;
    reader_.fail(1, fmt::format("the upper bound of {} is not above the lower one", "xyz"[k]),
                 "correct the box");
  }
  if (options_.periodic) packing_.periodic = *options_.periodic;
  if (packing_.dimension == 2) packing_.periodic[2] = false;
}

void FrameReader::require_columns(const std::vector<Source>& sources) {
  const auto has = [&](BodyField field) {
    return std::any_of(sources.begin(), sources.end(),
                       [&](const Source& source) { return same_quantity(source.field, field); });
  };
  if (!expected_ || !packing_.bounds)
    reader_.fail(1, "the number of atoms or the box is missing before the atoms",
                 "give the output of dump custom");
  if (!has(BodyField::x) || !has(BodyField::y) || (packing_.dimension == 3 && !has(BodyField::z)))
    reader_.fail(1, "there are no positions", "write the dump with columns x y z, or xs ys zs, or xu yu zu");
  if (!has(BodyField::radius))
    reader_.fail(1, "there is neither a column radius nor diameter",
                 "write the dump with 'dump custom ... radius'");
}

void FrameReader::read_atoms() {
  std::vector<Token> names = reader_.words();
  names.erase(names.begin(), names.begin() + std::min<std::ptrdiff_t>(2, std::ssize(names)));
  const std::vector<Source> sources = choose_sources(names);
  require_columns(sources);
  packing_.own_ids = std::any_of(sources.begin(), sources.end(),
                                 [](const Source& source) { return source.field == BodyField::id; });
  const auto count = std::size_t(*expected_);
  constexpr std::size_t shortest_line = 8;  // bytes of "0 0 0 1\n"
  packing_.bodies.reserve(std::min(count, reader_.size() / shortest_line));
  for (std::size_t k = 0; k < count; ++k) {
    if (!reader_.next() || reader_.line().starts_with("ITEM:")) fail_truncated();
    if (reader_.words().size() != names.size())
      reader_.fail(1,
                   fmt::format("{} under {}", counted(reader_.words().size(), "word"),
                               counted(names.size(), "column")),
                   "complete the line, or choose another timestep");
    packing_.bodies.push_back(read_body(sources));
  }
  while (reader_.next() && !reader_.line().starts_with("ITEM:")) {
    if (reader_.words().empty()) continue;
    reader_.fail(1, fmt::format("the frame header gives {}, and there are more", counted(count, "atom")),
                 "correct the number of atoms");
  }
}

Body FrameReader::read_body(const std::vector<Source>& sources) {
  const std::vector<Token>& words = reader_.words();
  Body body;
  body.id = std::int64_t(packing_.bodies.size()) + 1;
  Token id = words[0];
  for (const Source& source : sources) {
    const Token& token = words[source.column];
    if (source.field == BodyField::material) {
      body.material = material_of_type(token, options_.materials, reader_);
      continue;
    }
    set_field(body, source.field, token, reader_);
    place_in_box(body, source);
    if (packing_.dimension == 2) require_planar(body, source.field, token, reader_);
    if (source.field == BodyField::id) id = token;
  }
  ids_.add(body.id, id, reader_);
  return body;
}

void FrameReader::place_in_box(Body& body, const Source& source) {
  if (source.field < BodyField::x || source.field > BodyField::z) return;
  const int axis = int(source.field) - int(BodyField::x);
  const double lower = packing_.bounds->lower[axis];
  const double length = packing_.bounds->upper[axis] - lower;
  double& x = body.position[axis];
  if (source.scale == Scale::box) x = lower + x * length;
  const bool outside = x < lower || x > packing_.bounds->upper[axis];
  if (packing_.periodic[axis] && outside) x -= length * std::floor((x - lower) / length);
}

}  // namespace

Packing parse_lammps_dump(std::string_view text, const std::string& name, const ImportOptions& options) {
  TextReader reader(text, name);
  const std::vector<DumpFrame> frames = find_frames(reader);
  const DumpFrame frame = choose_frame(frames, options.timestep, reader);
  reader.seek(frame.start);
  Packing packing = checked_import(FrameReader(reader, options).read(), name);
  packing.timestep = frame.timestep;
  return packing;
}

Packing read_lammps_dump(const std::filesystem::path& path, const ImportOptions& options) {
  return parse_lammps_dump(files::read_text(path), path.string(), options);
}

}  // namespace scree::packing
