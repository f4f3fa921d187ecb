// A boundary that asks for loads of its wall after displacements, and fails on one rank, between two of them.

#include <atomic>
#include <stdexcept>

#include <scree/plugin/boundary.hpp>

namespace {

std::atomic<int> calls = 0;

struct Asking {
  static constexpr scree::About about = {"asking", "fails in a call, counted over ranks", "", "—"};

  double fatal_call = 0;

  void declare(scree::Declaration& d) {
    d.number("fatal_call", fatal_call, "", scree::positive, "the call that fails").required();
  }
  void describe(scree::BoundaryLayout& layout) const {
    layout.walls = 1;
    layout.displacement_speed = 1;
  }

  const char* start(const scree::BoundaryStep& s) const {
    s.walls[0] = {};
    s.walls[0].point[0] = -1;
    s.walls[0].normal[0] = 1;
    calls = 0;
    return nullptr;
  }
  void begin_step(const scree::BoundaryStep& s) const {
    const bool fails = ++calls == int(fatal_call);
    s.load_after(0, {});
    if (fails) throw std::runtime_error("no more");
    s.load_after(0, {});
    s.load_after(0, {});
  }
  void finish_step(const scree::BoundaryStep&) const {}
};

}  // namespace

SCREE_BOUNDARY_PLUGIN(Asking)
