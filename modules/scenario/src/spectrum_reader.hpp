#pragma once

#include <optional>

#include <scree/document/table.hpp>
#include <scree/scenario/plan.hpp>

namespace scree::scenario {

// Reads [spectrum]; nothing without it. The plan has its scene and probes already. Throws Error at the wrong key.
std::optional<SpectrumPlan> read_spectrum(const document::Table& root, const Plan& plan);

}  // namespace scree::scenario
