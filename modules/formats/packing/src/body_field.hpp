#pragma once

#include <cstdint>
#include <string>
#include <unordered_map>
#include <vector>

#include <scree/files/text_reader.hpp>
#include <scree/packing/packing.hpp>

namespace scree::packing {

using files::quote_token;
using files::TextReader;
using files::Token;

// Properties of a body that a file column can hold.
enum class BodyField { id, material, x, y, z, radius, diameter, density, mass, vx, vy, vz, wx, wy, wz };

// Checks the token against the range of the field and stores it. Errors name the position and the field.
void set_field(Body& body, BodyField field, const Token& token, const TextReader& reader);

// Component of position, velocity or spin; nullptr for the other fields.
double* field_component(Body& body, BodyField field);

// Fails at the token if the field must be 0 in two dimensions and is not.
void require_planar(Body& body, BodyField field, const Token& token, const TextReader& reader);

// Words of the current line from a byte on, which may be in a comment.
std::vector<Token> words_after(const TextReader& reader, std::size_t begin);

// Returns the packing of a file after check(), whose errors then name the file.
Packing checked_import(Packing packing, const std::string& file);

// Ids that a file has used, with the line of each.
class IdRegister {
 public:
  // Fails at the token if the id was used before.
  void add(std::int64_t id, const Token& token, const TextReader& reader);

 private:
  std::unordered_map<std::int64_t, std::size_t> line_of_;
};

}  // namespace scree::packing
