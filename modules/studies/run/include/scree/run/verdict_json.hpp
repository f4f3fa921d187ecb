#pragma once

#include <vector>

#include <nlohmann/json.hpp>

#include <scree/run/verdict.hpp>

namespace scree::run {

// "expect" of a record.
nlohmann::ordered_json json_of(const std::vector<Verdict>& verdicts);

}  // namespace scree::run
