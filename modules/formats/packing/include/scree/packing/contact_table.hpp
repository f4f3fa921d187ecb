#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <scree/plugin/vec.hpp>

namespace scree::packing {

// A contact of a body with another body or with a wall.
struct Contact {
  std::int64_t a = 0, b = -1;  // ids; b only between bodies
  std::int32_t wall = -1;      // index into ContactTable::walls; -1 between bodies
  Vec3 normal{};               // unit vector from b, or the wall, to a
  Vec3 force{};                // (N) on a
  double overlap = 0;          // (m)
  bool sliding = false;
  Vec3 point{};  // (m) in the middle of the overlap
};

// Contacts at one time.
struct ContactTable {
  int dimension = 3;  // 2 or 3
  double time = 0;    // (s)
  std::vector<std::string> walls;
  std::vector<Contact> contacts;
  bool evaluated = false;  // forces were not recorded, but evaluated from positions, velocities and springs
};

// A row for each contact, behind comment lines with dimension, time and, if they were evaluated, a word on
// the forces; in 2D without z. Body a is that of the smaller id, and rows are in the order of a and b, so
// that the table does not depend on the order in memory. b is empty at a wall, and the name of the wall
// between bodies. Numbers in the shortest decimal form that reads back to the same bits.
std::string format_contacts_csv(const ContactTable& table);

}  // namespace scree::packing
