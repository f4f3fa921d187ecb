#include "table/method_tables.hpp"

#include <scree/scenario/table_keys.hpp>

namespace scree::spectrum {

namespace {

using scenario::Range;

const LinearSettings linear_defaults;

struct LinearKeys : scenario::TableKeys {
  LinearKeys()
      : TableKeys("spectrum.linear", "[spectrum.linear]",
                  "the linear response of the contact network is solved at each frequency") {}
  scenario::BooleanKey adaptive = boolean("adaptive", linear_defaults.adaptive,
                                          "add frequencies about maxima narrower than six steps of the grid");
  scenario::NumberKey tolerance =
      number("tolerance", Range::between(1e-9, 0.1), linear_defaults.tolerance,
             "relative error of the response of more than 300 degrees of freedom");
  scenario::IntegerKey fewest_contacts =
      integer("fewest_contacts", Range::between(1, 100), "that hold a body",
              "default 2, and one more than dimensions without tangential forces");
  scenario::ChoiceKey sliding_contacts = choice_or_first(
      "sliding_contacts", {"stick", "slide"},
      "what contacts at the limit of friction do: stick, as small oscillations make them, or slide on, one way");
  scenario::ChoiceKey step = choice_or_first(
      "step", {"limit", "run"},
      "time step: the limit of short steps, or the step of the run, which gives the response of "
      "velocity_verlet, step by step, to compare with a sweep; takes more factorisations");
};

const LinearKeys linear_keys;

}  // namespace

LinearSettings read_linear(const document::Table& spectrum) {
  const document::Table t = spectrum.table_or_empty("linear");
  LinearSettings linear;
  linear.adaptive = read(t, linear_keys.adaptive);
  linear.tolerance = read(t, linear_keys.tolerance);
  linear.fewest_contacts =
      int(t.optional_integer(linear_keys.fewest_contacts, linear_keys.fewest_contacts.range).value_or(0));
  linear.contacts_slide = read(t, linear_keys.sliding_contacts) == "slide";
  linear.step_of_run = read(t, linear_keys.step) == "run";
  return linear;
}

const scenario::TableDescription& describe_linear() { return linear_keys.description(); }

}  // namespace scree::spectrum
