#include "discs_tables.hpp"

#include <catch2/catch.hpp>

using namespace scree;
using namespace scree::scenario;
using namespace scree::test;

TEST_CASE("impossible output is refused", "[scenario]") {
  CHECK(refusal(with(discs, "every = 2e-5", "every = 1e-9")) ==
        "scene.toml:26:9: every = 1e-09 s is shorter than the time step of 1e-05 s; increase it, or decrease "
        "time.step");
  CHECK(refusal_of_override("probe.name=a/b") ==
        "--set probe.name=a/b: 'a/b' cannot be used as a file name; use at most 100 letters, digits, '_' and "
        "'-'");
  CHECK(refusal_of_override("chart={name='..',probe='energy',y='work'}")
            .find("cannot be used as a file name") != std::string::npos);
  CHECK(refusal_of_override("chart={name='c',probe='energi',y='work'}")
            .ends_with("no probe 'energi'; did you mean 'energy'?"));
  CHECK(refusal_of_override("chart={name='c',probe='energy',y='wrk'}")
            .ends_with("no column 'wrk'; did you mean 'work'?"));
  CHECK(refusal_of_override("expect={requirement='r',quantity='energy_residul',at_most=1}")
            .ends_with("no quantity 'energy_residul'; did you mean 'energy_residual'?"));
  CHECK(refusal_of_override("expect={requirement='r',quantity='energy.work.last',reference=1}")
            .ends_with("reference and tolerance must both be given; give both, or at_most / at_least"));
  CHECK(refusal_of_override("expect={requirement='r',quantity='steps'}").find("has no required value") !=
        std::string::npos);
}
