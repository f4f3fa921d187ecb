#include "particles_keys.hpp"
#include "readers.hpp"

#include <cmath>

#include <fmt/format.h>

#include <scree/packing/import.hpp>

namespace scree::scenario {

namespace {

packing::Packing read_file(const document::Table& particles, int dimension,
                           const std::filesystem::path& folder, const std::vector<Material>& materials) {
  packing::ImportOptions options;
  // In a three-dimensional scene the file decides, so that a two-dimensional packing is detected below.
  if (dimension == 2) options.dimension = dimension;
  options.materials = names_of(materials);
  options.timestep = particles.optional_integer(particles_keys.timestep);
  if (particles.optional(particles_keys.columns)) options.columns = particles.strings(particles_keys.columns);
  if (particles.has("columns") && options.columns.empty())
    throw particles.error("columns", "no column is named",
                          "name each, such as [\"x\", \"y\", \"z\", \"radius\"], or remove columns");
  const std::string file = read(particles, particles_keys.file);
  packing::Packing read =
      placed(particles, "file", [&] { return packing::read_packing(folder / file, options); });
  if (read.dimension != dimension)
    throw particles.error("file", "the packing has two dimensions and the scene three",
                          "set scene.dimension = 2, or give a packing with z");
  return read;
}

// Repeats a periodic packing along each axis, one period apart.
void repeat(const document::Table& particles, int dimension, packing::Packing& packing) {
  if (!particles.optional(particles_keys.repeat)) {
    if (particles.has(particles_keys.period))
      throw particles.error("period",
                            "'period' is the distance of copies, of which 'repeat' gives the number",
                            "add repeat, such as [5, 1, 5], or remove it");
    return;
  }
  const std::vector<double> times =
      particles.numbers(particles_keys.repeat, std::size_t(dimension), particles_keys.repeat.range);
  const std::vector<double> period =
      particles.numbers(particles_keys.period, std::size_t(dimension), particles_keys.period.range);
  double bodies = double(packing.bodies.size());
  for (const double n : times) {
    if (n != std::floor(n))
      throw particles.error("repeat", fmt::format("{:g} is not a whole number", n),
                            "give counts, such as [5, 1, 5]");
    bodies *= n;
  }
  check_body_memory(particles, "repeat", bodies);
  for (int k = 0; k < dimension; ++k) {
    const std::size_t original = packing.bodies.size();
    for (int n = 1; n < int(times[std::size_t(k)]); ++n)
      for (std::size_t i = 0; i < original; ++i) {
        packing::Body copy = packing.bodies[i];
        copy.id = 0;
        copy.position[k] += n * period[std::size_t(k)];
        packing.bodies.push_back(copy);
      }
    if (packing.bounds) packing.bounds->upper[k] += (times[std::size_t(k)] - 1) * period[std::size_t(k)];
  }
}

}  // namespace

packing::Packing read_packing_of_file(const document::Table& particles, int dimension,
                                      const std::filesystem::path& folder,
                                      const std::vector<Material>& materials, std::string& origin) {
  packing::Packing packing = read_file(particles, dimension, folder, materials);
  repeat(particles, dimension, packing);
  if (!read(particles, particles_keys.keep_ids))
    for (packing::Body& body : packing.bodies) body.id = 0;
  origin = fmt::format("of '{}', {}", read(particles, particles_keys.file), packing.format);
  return packing;
}

}  // namespace scree::scenario
