#pragma once

#include <string_view>

#include <scree/document/table.hpp>
#include <scree/packing/packing.hpp>
#include <scree/packing/random.hpp>

namespace scree::scenario {

// Reads the bodies of [particles] with lattice and radius.
packing::Packing read_lattice_bodies(const document::Table& particles, int dimension,
                                     packing::Random& random);

// Reads a vector of `dimension` numbers; 0 if it is absent and not required.
Vec3 read_vector(const document::Table& table, std::string_view key, int dimension, bool required);

}  // namespace scree::scenario
