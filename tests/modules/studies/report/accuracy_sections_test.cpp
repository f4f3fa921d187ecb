#include "report_support.hpp"

using namespace scree::test;

TEST_CASE("the page of an accuracy study has its chart, front, orders and references", "[report]") {
  const TemporaryFolder folder;
  folder.write("accuracy.json",
               R"({"version": "1", "status": "finished", "verdict": "The cheapest <setting> is a.",
    "tolerance": 0.01, "trustworthy_until": 0.5, "notes": ["a note"],
    "quantities": [{"name": "v.last", "reference": 0.125, "uncertainty": 0, "closed_form": true}],
    "orders": [{"integrator": "velocity_verlet", "order": 2.01, "longest_step": 1e-6}],
    "scenario": "[scene]\ntitle = \"Impacts\"\n"})");
  folder.write("accuracy.csv",
               "integrator,step_s,steps,wall_s,worst_error,v.last,v.last_error,problem\n"
               "velocity_verlet,1e-06,10,0.1,0.004,1,0.004,\nvelocity_verlet,2e-06,5,0.05,0.016,1,0.016,\n"
               "fourth_order,1e-06,10,0.2,0.02,1,0.02,\nfourth_order,2e-06,0,0,nan,nan,nan,\"too <long>\"\n");
  const std::string page = checked_page(folder);
  for (const char* part :
       {"<h1>Impacts</h1>", "The cheapest &lt;setting&gt; is a.",
        "velocity_verlet; fourth_order; Pareto front</desc>", "within the tolerance", "too &lt;long&gt;",
        "2.01", "1\u00A0µs", "trustworthy until 0.5\u00A0s", "closed form"})
    CHECK_THAT(page, Catch::Contains(part));
  // Slower and less accurate than another, fourth_order is in the table of all settings alone.
  const std::size_t front = page.find("The fastest settings"), all = page.find("All settings");
  CHECK(page.substr(front, all - front).find("fourth_order") == page.npos);
}
