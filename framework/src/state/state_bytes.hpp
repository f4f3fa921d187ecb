#pragma once

#include <cstddef>
#include <vector>

#include <scree/state.hpp>

namespace scree {

// A state in a row of bytes, for another process of the same program.
std::vector<std::byte> bytes_of(const State& state);
State state_of(const std::vector<std::byte>& bytes);

}  // namespace scree
