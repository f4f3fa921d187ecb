#pragma once

#include <string_view>

#include <scree/document/table.hpp>
#include <scree/packing/packing.hpp>
#include <scree/packing/random.hpp>

namespace scree::scenario {

// Bodies of [particles] with lattice and radius.
packing::Packing read_lattice_bodies(const document::Table& particles, int dimension,
                                     packing::Random& random);

// As many numbers as there are dimensions; an absent one that is not required is 0.
Vec3 read_vector(const document::Table& table, std::string_view key, int dimension, bool required);

}  // namespace scree::scenario
