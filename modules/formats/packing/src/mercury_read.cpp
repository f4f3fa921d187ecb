#include "body_field.hpp"
#include "material_types.hpp"

#include <algorithm>
#include <array>
#include <span>
#include <vector>

#include <fmt/format.h>

#include <scree/counted.hpp>
#include <scree/packing/other_codes.hpp>

namespace scree::packing {

namespace {

// A column that is not read, as no field of a body.
struct MercuryColumn {
  BodyField field;
  bool read = true;
};

constexpr MercuryColumn unused = {BodyField::id, false};
constexpr std::array<MercuryColumn, 14> columns_3d = {{{BodyField::x},
                                                       {BodyField::y},
                                                       {BodyField::z},
                                                       {BodyField::vx},
                                                       {BodyField::vy},
                                                       {BodyField::vz},
                                                       {BodyField::radius},
                                                       unused,
                                                       unused,
                                                       unused,
                                                       {BodyField::wx},
                                                       {BodyField::wy},
                                                       {BodyField::wz},
                                                       {BodyField::material}}};
constexpr std::array<MercuryColumn, 8> columns_2d = {{{BodyField::x},
                                                      {BodyField::y},
                                                      {BodyField::vx},
                                                      {BodyField::vy},
                                                      {BodyField::radius},
                                                      unused,
                                                      {BodyField::wz},
                                                      {BodyField::material}}};

class MercuryReader {
 public:
  MercuryReader(std::string_view text, const std::string& name, const ImportOptions& options)
      : reader_(text, name), options_(options) {}

  Packing read() {
    const std::vector<TextReader::Position> frames = find_frames();
    const std::size_t last = frames.size() - 1;
    const std::int64_t frame = options_.timestep.value_or(std::int64_t(last));
    if (frame < 0 || std::size_t(frame) > last)
      reader_.fail(1, fmt::format("there is no frame {} in {}", frame, counted(frames.size(), "frame")),
                   fmt::format("give timestep = 0 to {}", last));
    reader_.seek(frames[std::size_t(frame)]);
    reader_.next_words();
    read_header();
    packing_.bodies.reserve(std::min(count_, reader_.size() / 16));
    for (std::size_t k = 0; k < count_; ++k) read_body(k);
    packing_.format = fmt::format("a .data file of MercuryDPM, frame {} of 0 to {}, t = {:g} s", frame, last,
                                  packing_.time);
    return std::move(packing_);
  }

 private:
  std::vector<TextReader::Position> find_frames();
  void read_header();
  std::span<const MercuryColumn> columns();
  void read_body(std::size_t number);
  std::string material(const Token& info) const;

  TextReader reader_;
  const ImportOptions& options_;
  Packing packing_;
  std::size_t count_ = 0;
};

std::vector<TextReader::Position> MercuryReader::find_frames() {
  std::vector<TextReader::Position> frames;
  while (reader_.next_words()) {
    frames.push_back(reader_.position());
    read_header();
    for (std::size_t k = 0; k < count_; ++k)
      if (!reader_.next())
        reader_.fail(1,
                     fmt::format("the frame is cut off after {} of {}", k, counted(count_, "body", "bodies")),
                     "complete the file, or remove the frame");
  }
  if (frames.empty()) reader_.fail(1, "the file is empty", "give a .data file of MercuryDPM");
  return frames;
}

// Reads the current line.
void MercuryReader::read_header() {
  const auto& words = reader_.words();
  if (words.size() != 6 && words.size() != 8)
    reader_.fail(
        1, fmt::format("{} instead of 'N time xmin ymin zmin xmax ymax zmax'", counted(words.size(), "word")),
        "give a .data file of MercuryDPM");
  count_ = std::size_t(reader_.positive_integer(words[0], "number of bodies"));
  packing_.time = reader_.number(words[1], "time");
  const std::size_t axes = words.size() / 2 - 1;
  Bounds box;
  for (std::size_t k = 0; k < axes; ++k) {
    box.lower[int(k)] = reader_.number(words[2 + k], "lower limit");
    box.upper[int(k)] = reader_.number(words[2 + axes + k], "upper limit");
  }
  packing_.bounds.reset();
  if (box.lower[0] <= box.upper[0] && box.lower[1] <= box.upper[1] && box.lower[2] <= box.upper[2])
    packing_.bounds = box;
}

// By the number of words in the current line.
std::span<const MercuryColumn> MercuryReader::columns() {
  const std::size_t words = reader_.words().size();
  if (words == columns_3d.size()) return columns_3d;
  if (words == columns_2d.size()) return columns_2d;
  reader_.fail(1, fmt::format("{} in a line of a body", counted(words, "column")),
               "write the data file with its 14 columns, or 8 in two dimensions");
}

void MercuryReader::read_body(std::size_t number) {
  reader_.next();
  const std::span<const MercuryColumn> all = columns();
  if (number == 0) packing_.dimension = all.size() == columns_2d.size() ? 2 : options_.dimension.value_or(3);
  if (packing_.dimension == 3 && all.size() == columns_2d.size())
    reader_.fail(1, "8 columns in a frame that begins with 14", "correct the line");
  Body body;
  body.id = std::int64_t(number) + 1;
  const auto& words = reader_.words();
  for (std::size_t k = 0; k < all.size(); ++k) {
    if (!all[k].read) continue;
    if (all[k].field == BodyField::material) {
      body.material = material(words[k]);
      continue;
    }
    set_field(body, all[k].field, words[k], reader_);
    if (packing_.dimension == 2) require_planar(body, all[k].field, words[k], reader_);
  }
  packing_.bodies.push_back(std::move(body));
}

std::string MercuryReader::material(const Token& info) const {
  if (options_.materials.size() == 1) return options_.materials[0];
  return material_of_number(info, "species", options_.materials, reader_);
}

}  // namespace

Packing parse_mercury(std::string_view text, const std::string& name, const ImportOptions& options) {
  return checked_import(MercuryReader(text, name, options).read(), name);
}

}  // namespace scree::packing
