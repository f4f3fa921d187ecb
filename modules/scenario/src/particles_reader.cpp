#include "particles_keys.hpp"
#include "readers.hpp"

#include <algorithm>
#include <iterator>

#include <fmt/format.h>

#include <scree/spatial_order.hpp>

namespace scree::scenario {

namespace {

// Refuses keys that select or copy bodies of a file.
void refuse_keys_of_files(const document::Table& particles) {
  for (const Key& key : {Key(particles_keys.timestep), particles_keys.columns, particles_keys.repeat,
                         particles_keys.period, Key(particles_keys.keep_ids), particles_keys.springs})
    if (particles.has(key))
      throw particles.error(key, fmt::format("'{}' needs 'file', which is not given", key.name),
                            "add file = \"<path>\", or remove it; the size of a lattice is its count");
}

void refuse_without_state(const document::Table& particles) {
  if (particles.has(particles_keys.leave_out))
    throw particles.error(particles_keys.leave_out, "'leave_out' needs 'state', which is not given",
                          "add state = \"<path>\", or remove it");
}

// The velocity that [particles] adds to its bodies.
class AddedVelocity {
 public:
  AddedVelocity(const document::Table& particles, int dimension)
      : velocity_(read_vector(particles, particles_keys.velocity, dimension, false)),
        gradient_(read_vector(particles, particles_keys.velocity_gradient, dimension, false)),
        deviation_(read(particles, particles_keys.random_velocity)),
        dimension_(dimension) {}

  // At a position (m).
  Vec3 at(const Vec3& position, packing::Random& random) const {
    Vec3 added = velocity_;
    for (int k = 0; k < dimension_; ++k) {
      added[k] += gradient_[k] * position[k];
      if (deviation_ > 0) added[k] += deviation_ * random.normal();
    }
    return added;
  }

 private:
  Vec3 velocity_, gradient_;
  double deviation_;
  int dimension_;
};

// What the readers of all tables need.
struct Source {
  int dimension;
  const std::vector<Material>& materials;
  const std::filesystem::path& folder;
};

// The bodies of lots that have been read.
std::vector<Sphere> spheres_of(const std::vector<BodyLot>& lots) {
  std::vector<Sphere> spheres;
  for (const BodyLot& lot : lots)
    for (const Body& body : lot.bodies) spheres.push_back({body.position, body.radius});
  return spheres;
}

// Only a random cloud looks at the bodies of other lots.
packing::Packing read_packing(BodyLot& lot, const Source& source, packing::Random& random,
                              const std::vector<BodyLot>& lots) {
  const document::Table& particles = lot.table;
  const bool at_random = particles.optional(particles_keys.random);
  if (particles.optional(particles_keys.file)) {
    for (const Key& key : {particles_keys.lattice, particles_keys.random})
      if (particles.optional(key))
        throw particles.error("file", fmt::format("both a file and a {} are given", key.name),
                              "keep one of them");
    return read_packing_of_file(particles, source.dimension, source.folder, source.materials, lot.origin);
  }
  refuse_keys_of_files(particles);
  if (!at_random) return read_lattice_bodies(particles, source.dimension, random, lot.origin);
  if (particles.optional(particles_keys.lattice))
    throw particles.error(particles_keys.random, "both a lattice and random are given", "keep one of them");
  return read_random_bodies(particles, source.dimension, random, spheres_of(lots), lot.origin);
}

// Leaves out bodies of a lattice or a file that do not lie wholly in the region.
void cut_to_region(const document::Table& particles, int dimension, packing::Packing& packing) {
  if (!particles.optional(particles_keys.region)) return;
  const packing::Region region = read_region(particles.table(particles_keys.region), dimension);
  std::erase_if(packing.bodies, [&](const packing::Body& body) {
    return !packing::holds(region, dimension, body.position, body.radius);
  });
  if (packing.bodies.empty())
    throw particles.error(particles_keys.region, "no body lies wholly in the region",
                          "give a larger one, or another place");
  packing.bounds.reset();  // its periodic faces are cut
}

void read_table(BodyLot& lot, const Source& source, packing::Random random,
                const std::vector<BodyLot>& lots) {
  const document::Table& particles = lot.table;
  refuse_without_state(particles);
  const bool shares = particles.is_table(particles_keys.material);
  const std::string material = shares ? "" : read(particles, particles_keys.material);
  const AddedVelocity added(particles, source.dimension);
  packing::Packing packing = read_packing(lot, source, random, lots);
  if (!particles.has(particles_keys.random)) cut_to_region(particles, source.dimension, packing);
  lot.timestep = packing.timestep;
  if (packing.bounds) lot.box = {packing.periodic, packing.bounds->lower, packing.bounds->upper};
  if (shares)
    share_materials(particles.table(particles_keys.material), source.materials, random, packing.bodies);
  lot.own_ids = packing.own_ids;
  lot.bodies.reserve(packing.bodies.size());
  for (packing::Body& from : packing.bodies) {
    if (from.material.empty()) from.material = material;
    from.velocity += added.at(from.position, random);
    lot.bodies.push_back(complete_body(particles, from, source.dimension, source.materials));
  }
}

void read_state_table(BodyLot& lot, const Source& source, packing::Random random, ReadBodies& read_bodies) {
  const document::Table& particles = lot.table;
  for (const Key& key : {Key(particles_keys.file), particles_keys.lattice, particles_keys.random,
                         particles_keys.region, Key(particles_keys.radius), Key(particles_keys.timestep),
                         particles_keys.repeat, particles_keys.period, particles_keys.columns,
                         Key(particles_keys.keep_ids), particles_keys.springs, Key(particles_keys.material)})
    if (particles.has(key))
      throw particles.error(key, fmt::format("both state and {} are given", key.name), "keep one of them");
  if (read_bodies.state)
    throw particles.error(particles_keys.state, "two tables [[particles]] begin from a state",
                          "keep one, and take the bodies of the other from its final_packing.csv");
  read_bodies.state = read_state(particles, source.folder);
  read_bodies.branching = read_branching(particles);
  lot.origin = fmt::format("of the state '{}'", read(particles, particles_keys.state));
  lot.own_ids = true;
  lot.bodies = bodies_of(particles, *read_bodies.state, source.materials);
  const AddedVelocity added(particles, source.dimension);
  for (Body& body : lot.bodies) body.velocity += added.at(body.position, random);
}

// Each table has random numbers of its own, so that none changes with another; the first uses the
// numbers of the seed itself.
packing::Random random_of(std::uint64_t seed, std::size_t table) {
  packing::Random seeds(seed);
  std::uint64_t own = seed;
  for (std::size_t k = 0; k < table; ++k) own = seeds.bits();
  return packing::Random(own);
}

std::vector<SpringSource> spring_sources(const std::vector<BodyLot>& lots) {
  std::vector<SpringSource> sources;
  for (const BodyLot& lot : lots) {
    if (!lot.table.path().starts_with("particles") || !lot.table.optional(particles_keys.springs)) continue;
    sources.push_back({lot.table, {}, lot.timestep});
    for (const Body& body : lot.bodies) sources.back().ids.insert(body.id);
  }
  return sources;
}

// Smaller scenes fit into the caches anyway, and keep the order of the file.
constexpr std::size_t min_bodies_to_sort = 1024;

void sort_in_space(std::vector<Body>& bodies, int dimension) {
  if (bodies.size() < min_bodies_to_sort) return;
  std::vector<Body> sorted;
  for (const std::uint32_t i : spatial_order(bodies, dimension)) sorted.push_back(bodies[i]);
  bodies = std::move(sorted);
}

}  // namespace

ReadBodies read_bodies(const document::Table& root, int dimension, const std::vector<Material>& materials,
                       std::uint64_t seed, const std::filesystem::path& folder) {
  const Source source = {dimension, materials, folder};
  ReadBodies result;
  std::vector<BodyLot> lots = body_lots(root);
  const std::size_t tables = root.tables("particles").size();
  const auto read_tables = [&](bool at_random) {
    for (std::size_t k = 0; k < tables; ++k) {
      if (lots[k].table.has(particles_keys.random) != at_random) continue;
      if (lots[k].table.optional(particles_keys.state))
        read_state_table(lots[k], source, random_of(seed, k), result);
      else
        read_table(lots[k], source, random_of(seed, k), lots);
    }
  };
  read_tables(false);
  for (std::size_t k = tables; k < lots.size(); ++k) {
    lots[k].bodies = {read_single_body(lots[k].table, dimension, materials)};
    lots[k].own_ids = true;
  }
  read_tables(true);  // last, clear of all others
  // The contacts of a state refer to its bodies by number, so that these keep their order and come first.
  if (result.state)
    std::stable_partition(lots.begin(), lots.end(),
                          [](const BodyLot& lot) { return lot.table.has(particles_keys.state); });
  number_bodies(root, lots, tables == 1);
  result.sources = sources_of(lots);
  const std::vector<SpringSource> springs = spring_sources(lots);
  for (BodyLot& lot : lots) {
    if (lot.box.any_periodic()) result.boxes.push_back({tables == 1 ? "" : lot.name, lot.box});
    std::move(lot.bodies.begin(), lot.bodies.end(), std::back_inserter(result.bodies));
  }
  if (!result.state) sort_in_space(result.bodies, dimension);
  for (const SpringSource& table : springs)
    read_springs(table, dimension, folder, result.bodies, result.springs);
  if (result.bodies.empty())
    throw root.error("the scene has no bodies",
                     "add [particles] with lattice and radius, random, file or state, or [[particle]]");
  return result;
}

}  // namespace scree::scenario
