#include "group_keys.hpp"
#include "readers.hpp"

#include <algorithm>
#include <array>

#include <fmt/format.h>

#include <scree/files/text.hpp>
#include <scree/plugin/program.hpp>

namespace scree::scenario {

namespace {

using freedom::Mask;
using Programs = BodyGroup::Programs;

constexpr std::array<const char*, freedom::count> names_of_components = {
    "x", "y", "z", "rotation_x", "rotation_y", "rotation_z"};

double at_start(const std::vector<double>& numbers, bool rate) {
  const Program program({.data = numbers.data(), .count = numbers.size()});
  return rate ? program.rate(0) : program(0);
}
bool is_constant(const std::vector<double>& program) {
  return Program::Kind(int(program[0])) == Program::constant;
}

// Functions of time of a key, of translations or rotations; constants are numbers.
void read_functions(const document::Table& group, const Key& key, bool rotations, int dimension,
                    Programs& programs) {
  if (!group.optional(key)) return;
  const auto program = [&](const std::variant<double, document::Table>& given) -> std::vector<double> {
    if (const double* number = std::get_if<double>(&given)) return {Program::constant, *number};
    return read_program_of(std::get<document::Table>(given), key.name);
  };
  if (rotations && dimension == 2) {
    programs.back() = program(group.number_or_table(key));
    return;
  }
  const auto given = group.numbers_or_tables(key, std::size_t(dimension));
  for (std::size_t k = 0; k < given.size(); ++k)
    programs[k + (rotations ? freedom::first_rotation : 0)] = program(given[k]);
}

Mask held_component(const document::Table& group, std::size_t element, const std::string& word,
                    int dimension) {
  const Mask all = freedom::of_dimension(dimension);
  if (word == "rotation") return all & freedom::rotations;
  const auto found = std::find(names_of_components.begin(), names_of_components.end(), word);
  if (found == names_of_components.end())
    throw group.error(group_keys.fixed, element, fmt::format("'{}' is no axis", files::one_line(word)),
                      "give x, y, z, rotation, or rotation_x, rotation_y, rotation_z");
  const int k = int(found - names_of_components.begin());
  if (!freedom::is_in(all, k))
    throw group.error(group_keys.fixed, element, fmt::format("a scene of two dimensions has no {}", word),
                      "remove it, or set scene.dimension = 3");
  return Mask(1u << k);
}

// The components that `fixed` names.
Mask read_held(const document::Table& group, int dimension) {
  if (!group.is_array(group_keys.fixed.name))
    return group.boolean(group_keys.fixed) ? freedom::of_dimension(dimension) : Mask(0);
  const std::vector<std::string> words = group.strings(group_keys.fixed);
  if (words.empty())
    throw group.error(group_keys.fixed, "no axis is fixed",
                      "give one, or fixed = false for bodies that move");
  Mask held = 0;
  for (std::size_t e = 0; e < words.size(); ++e) held |= held_component(group, e, words[e], dimension);
  return held;
}

class GroupMotion {
 public:
  GroupMotion(const document::Table& group, const std::string& name, int dimension)
      : group_(group), name_(name), all_(freedom::of_dimension(dimension)) {
    if (group.optional(group_keys.fixed)) held_ = read_held(group, dimension);
    read_functions(group, group_keys.velocity, false, dimension, given_.velocity);
    read_functions(group, group_keys.spin, true, dimension, given_.velocity);
    read_functions(group, group_keys.displacement, false, dimension, given_.displacement);
    read_functions(group, group_keys.force, false, dimension, given_.load);
    read_functions(group, group_keys.torque, true, dimension, given_.load);
    check_displacement();
  }

  // Sets the start of a body; moved: its components that follow a function of time.
  void apply_to(Body& body, Mask& moved) const {
    if (held_) hold(body, moved);
    for (int k = 0; k < freedom::count; ++k)
      if (const std::vector<double>& u = given_.velocity[std::size_t(k)]; !u.empty())
        move(k, u, false, body, moved);
    for (int k = 0; k < freedom::first_rotation; ++k)
      if (const std::vector<double>& d = given_.displacement[std::size_t(k)]; !d.empty() && !is_constant(d))
        move(k, d, true, body, moved);
  }

  // The functions of time that last, and loads.
  BodyGroup lasting(std::vector<std::uint32_t> bodies) const {
    BodyGroup group = given_;
    group.name = name_;
    group.bodies = std::move(bodies);
    for (Programs* programs : {&group.velocity, &group.displacement})
      for (std::vector<double>& program : *programs)
        if (!program.empty() && is_constant(program)) program.clear();
    for (std::vector<double>& load : group.load)
      if (!load.empty() && is_constant(load) && load[1] == 0) load.clear();
    return group;
  }

 private:
  std::string shown() const { return files::one_line(name_); }
  const char* key_of(int component) const {
    return component < freedom::first_rotation ? group_keys.velocity.name.c_str()
                                               : group_keys.spin.name.c_str();
  }

  void check_displacement() const {
    for (std::size_t k = 0; k < freedom::first_rotation; ++k) {
      const std::vector<double>& d = given_.displacement[k];
      if (d.empty()) continue;
      if (!given_.velocity[k].empty())
        throw group_.error(group_keys.displacement, "velocity and displacement are both given",
                           "keep one of them");
      if (is_constant(d) && d[1] != 0)
        throw group_.error(group_keys.displacement, k, "a displacement that does not change moves nothing",
                           "give 0, or a function of time");
    }
  }

  void hold(Body& body, Mask& moved) const {
    refuse_moved(body, moved);
    body.fixed = *held_ == all_;
    body.held = body.fixed ? Mask(0) : *held_;
    for (int k = 0; k < freedom::count; ++k)
      if (freedom::is_in(*held_, k)) velocity(body, k) = 0;
  }

  void move(int k, const std::vector<double>& program, bool displacement, Body& body, Mask& moved) const {
    const bool follows = !is_constant(program);
    const double start = at_start(program, displacement);
    const std::string key = displacement ? group_keys.displacement.name : key_of(k);
    const bool held = body.fixed || freedom::is_in(body.held, k), here = held_ && freedom::is_in(*held_, k);
    if (follows && !here)
      throw group_.error(
          key, fmt::format("{} is a function of time along an axis that is not fixed", key),
          fmt::format("add fixed = true, or fixed = [\"{}\"]", names_of_components[std::size_t(k)]));
    if (held && !here && start != 0)
      throw group_.error(
          key, fmt::format("particle {} of group '{}' is fixed and cannot move", body.id, shown()),
          fmt::format("remove {}, leave the body out of the group that is fixed, or give {} there", key,
                      key));
    velocity(body, k) = start;
    if (follows) moved |= Mask(1u << k);
  }

  void refuse_moved(const Body& body, Mask moved) const {
    if (moved)
      throw group_.error(
          group_keys.fixed,
          fmt::format("particle {} of group '{}' already follows a function of time", body.id, shown()),
          "leave it out of one of the groups");
  }

  static double& velocity(Body& body, int k) {
    return k < freedom::first_rotation ? body.velocity[k] : body.spin[k - freedom::first_rotation];
  }

  const document::Table& group_;
  std::string name_;
  Mask all_;
  std::optional<Mask> held_;
  BodyGroup given_;
};

}  // namespace

void read_group_motion(const document::Table& group, const std::string& name,
                       const std::vector<std::uint32_t>& bodies, std::vector<freedom::Mask>& moved,
                       Scene& scene) {
  const GroupMotion motion(group, name, scene.dimension);
  for (const std::uint32_t i : bodies) motion.apply_to(scene.bodies[i], moved[i]);
  BodyGroup lasting = motion.lasting(bodies);
  if (any_given(lasting.velocity) || any_given(lasting.displacement) || any_given(lasting.load))
    scene.groups.push_back(std::move(lasting));
}

}  // namespace scree::scenario
