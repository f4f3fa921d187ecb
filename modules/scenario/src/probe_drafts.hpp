#pragma once

#include <optional>
#include <string>
#include <vector>

#include <scree/document/table.hpp>
#include <scree/formula/formula.hpp>
#include <scree/plugin/abi.h>
#include <scree/scenario/plan.hpp>

namespace scree::scenario {

// A key that names a column of another probe.
struct InputKey {
  std::string key, column;
  std::size_t probe;  // in the order of the file
};

// A quantity of [derived].
struct DerivedQuantity {
  std::string name;
  document::Table table;  // in which `key` has the formula
  std::string key;
  formula::Formula formula;
  std::vector<std::size_t> slots = {};   // of the names of the formula: see derived_plugin()
  std::vector<std::size_t> probes = {};  // whose columns it reads, also by other quantities
  std::string unit = {};
};

// A [[probe]], or the table [derived], while it is read.
struct ProbeDraft {
  document::Table table;
  ProbePlan plan;
  std::vector<InputKey> inputs = {};
  std::vector<DerivedQuantity> quantities = {};  // of [derived]
};

// derived_probe.cpp

// The plug-in, within the program, whose columns are formulas. A formula reads numbers from slots: all
// columns of the probe, the time, and the inputs of the probe, in this order.
const scree_plugin& derived_plugin();
// Sets its parameters.
void set_quantities(const std::vector<DerivedQuantity>& quantities, Parameters& parameters);

// derived_reader.cpp

// Parses the formulas of [derived], if the scene has it.
std::optional<ProbeDraft> read_derived(const document::Table& root);
// Finds the probes and quantities that they name. names: of all probes.
void find_derived_inputs(ProbeDraft& draft, const std::vector<std::string>& names);
// Reads the rest, once the probes of the inputs are read. stages: names of all.
void read_derived_probe(ProbeDraft& draft, const std::vector<ProbeDraft>& drafts, const Scene& scene,
                        const std::vector<std::string>& stages);

}  // namespace scree::scenario
