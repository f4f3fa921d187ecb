#include "body_field.hpp"

#include <algorithm>
#include <array>
#include <string_view>

#include <fmt/format.h>

#include <scree/error.hpp>
#include <scree/plugin/abi.h>

namespace scree::packing {

namespace {

constexpr std::array<std::string_view, 15> field_names = {
    "id",   "material", "x",  "y",  "z",      "radius", "diameter", "density",
    "mass", "vx",       "vy", "vz", "spin_x", "spin_y", "spin_z"};

std::string_view name_of(BodyField field) { return field_names[std::size_t(field)]; }

}  // namespace

double* field_component(Body& body, BodyField field) {
  switch (field) {
    case BodyField::x:
      return &body.position[0];
    case BodyField::y:
      return &body.position[1];
    case BodyField::z:
      return &body.position[2];
    case BodyField::vx:
      return &body.velocity[0];
    case BodyField::vy:
      return &body.velocity[1];
    case BodyField::vz:
      return &body.velocity[2];
    case BodyField::wx:
      return &body.spin[0];
    case BodyField::wy:
      return &body.spin[1];
    case BodyField::wz:
      return &body.spin[2];
    default:
      return nullptr;
  }
}

void set_field(Body& body, BodyField field, const Token& token, const TextReader& reader) {
  const std::string_view name = name_of(field);
  if (double* component = field_component(body, field)) {
    *component = reader.number(token, name);
    return;
  }
  switch (field) {
    case BodyField::id:
      body.id = reader.positive_integer(token, name);
      if (body.id > SCREE_MAX_ID)
        reader.fail(token.column, fmt::format("id {} is above {}", body.id, SCREE_MAX_ID),
                    "number the bodies anew, or leave out the ids");
      break;
    case BodyField::material:
      body.material = token.text;
      break;
    case BodyField::diameter:
      body.radius = 0.5 * reader.positive_number(token, name);
      break;
    case BodyField::density:
      body.density = reader.positive_number(token, name);
      break;
    case BodyField::mass:
      body.mass = reader.positive_number(token, name);
      break;
    default:
      body.radius = reader.positive_number(token, name);
      break;
  }
  if (body.radius == 0.0 && field == BodyField::diameter)
    reader.fail(token.column, "half the diameter is 0 in double precision", "check the unit");
}

void require_planar(Body& body, BodyField field, const Token& token, const TextReader& reader) {
  const bool spatial =
      field == BodyField::z || field == BodyField::vz || field == BodyField::wx || field == BodyField::wy;
  if (!spatial || *field_component(body, field) == 0.0) return;
  reader.fail(token.column,
              fmt::format("{} {} is not 0 in two dimensions", name_of(field), quote_token(token.text)),
              "set it to 0, or read the file in three dimensions");
}

std::vector<Token> words_after(const TextReader& reader, std::size_t begin) {
  const std::string_view line = reader.line();
  std::vector<Token> words;
  while (begin < line.size()) {
    const std::size_t end = std::min(line.find_first_of(" \t", begin), line.size());
    if (end > begin) words.push_back({line.substr(begin, end - begin), begin + 1});
    begin = end + 1;
  }
  return words;
}

Packing checked_import(Packing packing, const std::string& file) {
  try {
    check(packing);
  } catch (const Error& error) {
    throw error.at(file);
  }
  return packing;
}

void IdRegister::add(std::int64_t id, const Token& token, const TextReader& reader) {
  const auto [known, is_new] = line_of_.emplace(id, reader.line_number());
  if (is_new) return;
  reader.fail(token.column, fmt::format("id {} was used before, in line {}", id, known->second),
              "give every body its own id");
}

}  // namespace scree::packing
