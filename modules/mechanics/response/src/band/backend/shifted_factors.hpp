#pragma once

#include "band/backend/band_backend.hpp"
#include "band/backend/shift_backend.hpp"

#include <memory>

namespace scree::response {

// stiffness: symmetric, with both halves; mass: diagonal.
std::unique_ptr<ShiftBackend> make_shifts(const SparseView& stiffness, const double* mass);

}  // namespace scree::response
