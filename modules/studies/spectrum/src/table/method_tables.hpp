#pragma once

#include <scree/document/table.hpp>
#include <scree/scenario/keys.hpp>
#include <scree/spectrum/spectrum_plan.hpp>

namespace scree::spectrum {

// The tables of the methods in [spectrum], each declared, read and checked in its own source. `spectrum`: the
// table [spectrum]; `plan` has the keys of it; `step`: the time step (s). Throw Error at the wrong key.
SweepSettings read_sweep(const document::Table& spectrum, const SpectrumPlan& plan, double step);
PulseSettings read_pulse(const document::Table& spectrum, const SpectrumPlan& plan, double step);
LinearSettings read_linear(const document::Table& spectrum);

const scenario::TableDescription& describe_sweep();
const scenario::TableDescription& describe_pulse();
const scenario::TableDescription& describe_linear();

}  // namespace scree::spectrum
