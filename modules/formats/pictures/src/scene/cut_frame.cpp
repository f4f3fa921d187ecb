#include "cut_frame.hpp"

#include <vector>

#include <fmt/format.h>

#include <scree/error.hpp>

namespace scree::pictures {
namespace {

using Cut = std::array<std::optional<std::array<double, 2>>, 3>;

bool is_within(const Cut& cut, const double* point) {
  for (std::size_t k = 0; k < 3; ++k)
    if (cut[k] && !(point[k] >= (*cut[k])[0] && point[k] <= (*cut[k])[1])) return false;
  return true;
}

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
  for (auto* vectors : {&frame.position, &frame.velocity, &frame.spin, &frame.force})
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

}  // namespace

Frame cut_frame(const Frame& frame, const Cut& cut) {
  std::vector<char> bodies(frame.particle_count()), contacts(frame.contact_count());
  for (std::size_t i = 0; i < bodies.size(); ++i) bodies[i] = is_within(cut, frame.position.data() + 3 * i);
  for (std::size_t c = 0; c < contacts.size(); ++c)
    contacts[c] =
        is_within(cut, frame.contact_from.data() + 3 * c) && is_within(cut, frame.contact_to.data() + 3 * c);
  Frame result = frame;
  keep_bodies(result, bodies);
  keep_contacts(result, contacts);
  if (result.particle_count() == 0 && frame.particle_count() > 0)
    throw Error(fmt::format("cut: none of {} bodies lies there; give a range that holds some",
                            frame.particle_count()));
  return result;
}

}  // namespace scree::pictures
