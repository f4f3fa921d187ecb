#include "cut_frame.hpp"

#include <cmath>
#include <vector>

namespace scree::pictures {
namespace {

// Leaves the rows of a column, if it has any, for which `kept` is not 0.
template <class T>
void keep_rows(std::vector<T>& column, const std::vector<char>& kept, std::size_t width) {
  if (column.empty()) return;
  std::size_t rows = 0;
  for (std::size_t k = 0; k < kept.size(); ++k) {
    if (!kept[k]) continue;
    for (std::size_t part = 0; part < width; ++part) column[width * rows + part] = column[width * k + part];
    ++rows;
  }
  column.resize(width * rows);
}

void keep_bodies(Frame& frame, const std::vector<char>& kept) {
  keep_rows(frame.id, kept, 1);
  keep_rows(frame.radius, kept, 1);
  keep_rows(frame.material, kept, 1);
  keep_rows(frame.coordination, kept, 1);
  keep_rows(frame.group, kept, 1);
  for (auto* vectors : {&frame.position, &frame.velocity, &frame.spin, &frame.force, &frame.displacement})
    keep_rows(*vectors, kept, 3);
}

void keep_contacts(Frame& frame, const std::vector<char>& kept) {
  for (auto* vectors : {&frame.contact_from, &frame.contact_to, &frame.contact_normal, &frame.contact_force,
                        &frame.contact_point})
    keep_rows(*vectors, kept, 3);
  for (auto* numbers : {&frame.contact_normal_force, &frame.contact_tangential_force, &frame.contact_overlap})
    keep_rows(*numbers, kept, 1);
  keep_rows(frame.contact_sliding, kept, 1);
  keep_rows(frame.contact_a, kept, 1);
  keep_rows(frame.contact_b, kept, 1);
  keep_rows(frame.contact_wall, kept, 1);
}

// Leaves the part of a bar that lies in the half-spaces; false if there is none.
bool shorten(double* from, double* to, const std::vector<HalfSpace>& spaces) {
  for (const auto& [normal, offset] : spaces) {
    const double height_from = dot(normal, {from[0], from[1], from[2]}) - offset;
    const double height_to = dot(normal, {to[0], to[1], to[2]}) - offset;
    if (height_from < 0 && height_to < 0) return false;
    if (height_from >= 0 && height_to >= 0) continue;
    const double share = height_from / (height_from - height_to);
    double* const outside = height_from < 0 ? from : to;
    for (int k = 0; k < 3; ++k) outside[k] = std::lerp(from[k], to[k], share);
  }
  return true;
}

}  // namespace

Frame cut_frame(const Frame& frame, const std::vector<HalfSpace>& spaces, ColorField& field) {
  Frame result = frame;
  std::vector<char> bodies(frame.particle_count()), contacts(frame.contact_count());
  for (std::size_t i = 0; i < bodies.size(); ++i)
    bodies[i] = reaches_into(spaces, frame.position.data() + 3 * i, frame.radius[i]);
  for (std::size_t c = 0; c < contacts.size(); ++c)
    contacts[c] = shorten(result.contact_from.data() + 3 * c, result.contact_to.data() + 3 * c, spaces);
  keep_bodies(result, bodies);
  keep_rows(field.values, bodies, 1);
  keep_contacts(result, contacts);
  return result;
}

}  // namespace scree::pictures
