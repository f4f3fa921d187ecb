#include "particles_keys.hpp"
#include "readers.hpp"

#include <unordered_map>

#include <fmt/format.h>

#include <scree/packing/springs.hpp>

namespace scree::scenario {

namespace {

void refuse_other_numbers(const document::Table& particles) {
  for (const Key& key : {particles_keys.repeat, Key(particles_keys.keep_ids)})
    if (particles.has(key) &&
        (key.name != particles_keys.keep_ids.name || !read(particles, particles_keys.keep_ids)))
      throw particles.error(
          key, fmt::format("springs name bodies by the ids of the file, which '{}' changes", key.name),
          "remove it, or the springs");
}

std::vector<packing::Spring> read_file(const SpringSource& source, const document::Table& springs,
                                       int dimension, const std::filesystem::path& folder) {
  packing::SpringOptions options;
  options.dimension = dimension;
  options.factor = read(springs, springs_keys.factor);
  options.timestep = source.timestep;
  if (springs.optional(springs_keys.columns)) options.columns = springs.strings(springs_keys.columns);
  const std::filesystem::path file = folder / read(springs, springs_keys.file);
  return placed(springs, springs_keys.file.name, [&] { return packing::read_springs(file, options); });
}

}  // namespace

void read_springs(const SpringSource& source, int dimension, const std::filesystem::path& folder,
                  const std::vector<Body>& bodies, std::vector<Scene::Spring>& result) {
  const document::Table& particles = source.table;
  refuse_other_numbers(particles);
  const document::Table springs = particles.table(particles_keys.springs);
  std::unordered_map<std::int64_t, std::uint32_t> index_of;
  for (std::size_t i = 0; i < bodies.size(); ++i)
    if (source.ids.contains(bodies[i].id)) index_of[bodies[i].id] = std::uint32_t(i);
  const bool cut = particles.has(particles_keys.region);
  for (const packing::Spring& spring : read_file(source, springs, dimension, folder)) {
    const auto a = index_of.find(spring.a), b = index_of.find(spring.b);
    if (a != index_of.end() && b != index_of.end())
      result.push_back({a->second, b->second, spring.displacement});
    else if (!cut)
      throw springs.error(springs_keys.file,
                          fmt::format("line {} of the springs names body {}, which is not one of the file",
                                      spring.line, a == index_of.end() ? spring.a : spring.b),
                          "give springs and bodies of the same run, and check the columns a and b");
  }
}

}  // namespace scree::scenario
