#include "readers.hpp"
#include "scene_keys.hpp"

#include <algorithm>
#include <optional>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <scree/counted.hpp>
#include <scree/document/message.hpp>
#include <scree/files/text.hpp>

namespace scree::scenario {

namespace {

constexpr std::uint32_t no_law = ~0u;

void assign_pair(const document::Table& t, std::uint32_t law, Scene& scene) {
  const std::vector<std::string> names = t.strings(contact_keys.between);
  if (names.size() != 2)
    throw t.error("between", fmt::format("'between' has {}", counted(names.size(), "material")),
                  "give two, such as [\"bead\", \"wall\"]");
  const std::size_t a = find_name(t, "between", "material", names[0], scene.materials, 0);
  const std::size_t b = find_name(t, "between", "material", names[1], scene.materials, 1);
  const std::size_t n = scene.materials.size();
  if (scene.law_of[a * n + b] != no_law)
    throw t.error("between",
                  fmt::format("'{}' and '{}' already have a [[contact]]", files::one_line(names[0]),
                              files::one_line(names[1])),
                  "keep one of them");
  scene.law_of[a * n + b] = scene.law_of[b * n + a] = law;
}

// Walls do not touch each other: a pair of materials that no body has may have any law.
void fill_pairs_of_walls(Scene& scene) {
  if (scene.laws.empty()) return;
  const std::size_t n = scene.materials.size();
  std::vector<bool> of_bodies(n, false);
  for (const Body& body : scene.bodies) of_bodies[body.material] = true;
  for (std::size_t pair = 0; pair < n * n; ++pair)
    if (scene.law_of[pair] == no_law && !of_bodies[pair / n] && !of_bodies[pair % n]) scene.law_of[pair] = 0;
}

void check_pairs(const document::Table& root, const PluginHost& host, const Scene& scene) {
  const auto open = std::find(scene.law_of.begin(), scene.law_of.end(), no_law);
  if (open == scene.law_of.end()) return;
  const std::size_t pair = std::size_t(open - scene.law_of.begin()), n = scene.materials.size();
  throw root.error(
      "contact",
      fmt::format("no [[contact]] applies to '{}' and '{}'", files::one_line(scene.materials[pair / n]),
                  files::one_line(scene.materials[pair % n])),
      scene.laws.empty()
          ? fmt::format("add a [[contact]] with plugin = \"{}\"",
                        fmt::join(host.names(SCREE_CONTACT_LAW), "\" or \""))
          : "add one, or leave 'between' out of one, which then applies to all pairs without their own");
}

}  // namespace

void read_contacts(const document::Table& root, PluginHost& host, Scene& scene, Instances& instances) {
  scene.law_of.assign(scene.materials.size() * scene.materials.size(), no_law);
  std::optional<std::uint32_t> for_the_rest;
  for (const document::Table& t : root.tables("contact")) {
    const Stage::Change& read = read_instance(t, SCREE_CONTACT_LAW, host, scene, instances);
    const auto law = std::uint32_t(scene.laws.size());
    scene.laws.push_back({read.name, read.parameters});
    if (t.optional(contact_keys.between))
      assign_pair(t, law, scene);
    else if (for_the_rest)
      throw t.error("a second [[contact]] has no materials", "add between = [\"a\", \"b\"]");
    else
      for_the_rest = law;
  }
  if (for_the_rest) std::replace(scene.law_of.begin(), scene.law_of.end(), no_law, *for_the_rest);
  fill_pairs_of_walls(scene);
  check_pairs(root, host, scene);
}

}  // namespace scree::scenario
