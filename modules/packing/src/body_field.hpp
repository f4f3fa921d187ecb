#pragma once

#include "scree/packing/packing.hpp"
#include "text_reader.hpp"

#include <cstdint>
#include <unordered_map>
#include <vector>

namespace scree::packing {

// What a column of a file can say about a body.
enum class BodyField { id, material, x, y, z, radius, diameter, density, mass, vx, vy, vz, wx, wy, wz };

// Checks the token against the field's range and stores it. Errors name the place and the field.
void set_field(Body& body, BodyField field, const Token& token, const TextReader& reader);

// Component of position, velocity or spin; nullptr for the other fields.
double* field_component(Body& body, BodyField field);

// Fails at the token if the field must vanish in two dimensions and does not.
void require_planar(Body& body, BodyField field, const Token& token, const TextReader& reader);

// Which ids a file has used, and where.
class IdRegister {
 public:
  // Fails at the token if the id was used before.
  void add(std::int64_t id, const Token& token, const TextReader& reader);

 private:
  std::unordered_map<std::int64_t, std::size_t> line_of_;
};

}  // namespace scree::packing
