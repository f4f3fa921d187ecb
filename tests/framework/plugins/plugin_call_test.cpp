#include "plugins/plugin_call.hpp"

#include "error_line.hpp"
#include "plugins/false_law.hpp"
#include "walls/boundaries.hpp"

#include <stdexcept>

#include <catch2/catch.hpp>

#include <scree/closed_forms.hpp>
#include <scree/probes.hpp>

using Catch::StartsWith;
using scree::test::error_line;
using scree::test::FalseLaw;

namespace {

[[noreturn]] void burst() { throw std::runtime_error("boo"); }

std::string thrown_by(const char* function) {
  return std::string("plug-in false_law: its function ") + function + " threw an exception (boo); ";
}

}  // namespace

TEST_CASE("an exception of a law is reported with the name of the plug-in") {
  FalseLaw law;
  law.law.configure = [](const scree_setup*, void*, scree_contact_instance*) -> int { burst(); };
  CHECK_THAT(error_line([&] { law.configured(); }), StartsWith(thrown_by("configure")));
  law.law.configure = [](const scree_setup*, void*, scree_contact_instance*) -> int { throw 1; };
  CHECK_THAT(error_line([&] { law.configured(); }),
             StartsWith("plug-in false_law: its function configure threw an exception (of unknown type); "));
  FalseLaw forms;
  forms.law.closed_forms = [](const void*, const scree_encounter*, scree_closed_form*,
                              std::uint32_t) -> std::uint32_t { burst(); };
  CHECK_THAT(error_line([&] {
               scree::closed_forms(forms.configured(), {1, 1, 1, 1});
             }),
             StartsWith(thrown_by("closed_forms")));
}

TEST_CASE("an exception at the start of a boundary is reported with the name of the plug-in") {
  scree_boundary boundary = {};
  boundary.struct_size = sizeof(boundary);
  boundary.configure = [](const scree_setup*, void*, scree_boundary_instance*) { return 0; };
  boundary.start = [](const void*, const scree_boundary_step*, char*, std::size_t) -> int { burst(); };
  FalseLaw base;
  base.plugin.kind = SCREE_BOUNDARY;
  base.plugin.interface = &boundary;
  const scree::Scene::Boundary entry = {"wall", 0, scree::Parameters(base.plugin)};
  CHECK_THAT(error_line([&] { scree::Boundaries({entry}, 3, {}); }), StartsWith(thrown_by("start")));
}

TEST_CASE("an exception in the columns of a probe is reported with the name of the plug-in") {
  scree_probe probe = {};
  probe.struct_size = sizeof(probe);
  probe.configure = [](const scree_setup*, void*, scree_probe_instance* instance) {
    instance->column_count = 1;
    return 0;
  };
  probe.column = [](const void*, std::uint32_t, char*, char*) { burst(); };
  FalseLaw base;
  base.plugin.kind = SCREE_PROBE;
  base.plugin.interface = &probe;
  CHECK_THAT(error_line([&] { scree::Probe(scree::Parameters(base.plugin), 3); }),
             StartsWith(thrown_by("column")));
}

TEST_CASE("a law that names columns that there are not is refused") {
  FalseLaw law;
  law.law.configure = [](const scree_setup* s, void* storage, scree_contact_instance* instance) {
    FalseLaw::configure(s, storage, instance);
    instance->sliding_column = 0;
    return 0;
  };
  CHECK_THAT(error_line([&] { law.configured(); }), StartsWith("plug-in false_law: reads "));
  law.law.configure = [](const scree_setup* s, void* storage, scree_contact_instance* instance) {
    FalseLaw::configure(s, storage, instance);
    instance->reads = ~0u;
    return 0;
  };
  CHECK_THAT(error_line([&] { law.configured(); }), StartsWith("plug-in false_law: reads 0xffffffff"));
}
