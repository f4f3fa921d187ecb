#include <catch2/catch.hpp>

#include <scree/spectrum/peak_quantity.hpp>

using namespace scree::spectrum;

namespace {

std::vector<ObservedColumn> columns(bool with_layers) {
  std::vector<ObservedColumn> all = {{0, 0, "strain.strain", "", false, "", false}};
  if (with_layers) all.push_back({1, 0, "profile.displacement_1", "m", false, "", true});
  return all;
}

}  // namespace

TEST_CASE("a number of a peak is named by method, column and its number or shape", "[spectrum]") {
  const auto third = peak_quantity("peaks.pulse.strain.strain.peak_3.quality", columns(false));
  REQUIRE(third);
  CHECK(method_names[third->method] == std::string("pulse"));
  CHECK(third->column == 0);
  CHECK(third->peak == "peak_3");
  CHECK(peak_numbers[third->number] == std::string("quality"));
  for (const char* name : {"3λ/4", "3lambda/4"}) {
    const auto shaped =
        peak_quantity(std::string("peaks.linear.strain.strain.") + name + ".frequency", columns(true));
    REQUIRE(shaped);
    CHECK(shaped->peak == "3λ/4");
  }
  CHECK(peak_quantity("peaks.sweep_down.strain.strain.lambda.frequency", columns(true))->peak == "λ");
}

TEST_CASE("a misspelt number of a peak is answered by the nearest right one", "[spectrum]") {
  const auto problem = [](const char* name, bool with_layers) {
    return peak_quantity_problem(name, columns(with_layers)).value_or("none");
  };
  CHECK(problem("peaks.pulse.strain.strain.peak_3.qualty", false)
            .find("; did you mean 'peaks.pulse.strain.strain.peak_3.quality'?") != std::string::npos);
  CHECK(problem("peaks.puls.strain.strain.3λ/4.frequency", true)
            .find("; did you mean 'peaks.pulse.strain.strain.3λ/4.frequency'?") != std::string::npos);
  CHECK(problem("peaks.pulse.strain.strain.3lambda/4.frequency", false).find("give spectrum.shape_from") !=
        std::string::npos);
  // Layers of shapes have no peaks of their own; peaks are counted from 1, and shapes by quarters of a
  // wavelength.
  for (const char* name :
       {"peaks.pulse.profile.displacement_1.peak_1.frequency", "peaks.pulse.strain.strain.peak_0.frequency",
        "peaks.pulse.strain.strain.3λ/8.frequency", "peaks.pulse.strain.strain.frequency", "peaks."}) {
    INFO(name);
    CHECK(problem(name, true).starts_with(std::string("no quantity '") + name + "'; "));
  }
}
