// A boundary that breaks the interface, for tests: its wall moves further with each call, whoever calls.

#include <atomic>

#include <scree/plugin/boundary.hpp>

namespace {

std::atomic<int> calls = 0;

struct Wandering {
  static constexpr scree::About about = {"wandering", "moves further with each call of any rank", "", "—"};

  void declare(scree::Declaration&) {}
  void describe(scree::BoundaryLayout& layout) const { layout.walls = 1; }

  const char* start(const scree::BoundaryStep& s) const {
    s.walls[0] = {};
    s.walls[0].point[1] = -10;
    s.walls[0].normal[1] = 1;
    return nullptr;
  }
  void begin_step(const scree::BoundaryStep& s) const { s.walls[0].point[1] = -10 - 0.01 * ++calls; }
  void finish_step(const scree::BoundaryStep&) const {}
};

}  // namespace

SCREE_BOUNDARY_PLUGIN(Wandering)
