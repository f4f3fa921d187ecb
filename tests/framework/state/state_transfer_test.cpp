#include "numbers.hpp"
#include "state/heap.hpp"

#include <cmath>

#include <catch2/catch.hpp>
#include <fmt/format.h>

#include <scree/scene_record.hpp>
#include <scree/state_transfer.hpp>

// States that others have written: any number, shape and unit may be in them.

using namespace scree;
using scree::test::error_line;
using scree::test::heap;
using scree::test::infinite;

namespace {

template <class T>
std::string refusal_of(const std::vector<T>& values, const StoredRange& range) {
  State state;
  state.put("group/numbers", {values, {values.size()}, "m"});
  std::vector<T> read;
  return error_line(
      [&] { StateTransfer::restoring_from(state).below("group").rows("numbers", "m", read, 1, range); });
}

}  // namespace

TEST_CASE("what is restored is finite, unless its owner says otherwise", "[state]") {
  for (const double wrong : {infinite, -infinite, std::nan("")}) {
    CHECK(refusal_of<double>({1, wrong}, stored::finite)
              .starts_with("'group/numbers' has the number " + fmt::format("{}", wrong) +
                           ", which is not finite; "));
    CHECK(refusal_of<float>({float(wrong)}, stored::finite) != "no error");
    CHECK(refusal_of<double>({wrong}, stored::positive) != "no error");
    CHECK(refusal_of<double>({1, wrong}, stored::any) == "no error");
  }
  CHECK(refusal_of<double>({1e308, -1e308, 0}, stored::finite) == "no error");
}

TEST_CASE("what is restored lies in the range that its owner gives", "[state]") {
  CHECK(refusal_of<double>({0}, stored::positive).find("which is not above 0 and finite") !=
        std::string::npos);
  CHECK(refusal_of<double>({5e-324}, stored::positive) == "no error");
  CHECK(refusal_of<double>({-5e-324}, stored::non_negative).find("which is not finite and 0 or more") !=
        std::string::npos);
  CHECK(refusal_of<double>({0, -0.0}, stored::non_negative) == "no error");
  CHECK(refusal_of<std::uint64_t>({7, 8}, stored::at_most(7)).find("8, which is not from 0 to 7") !=
        std::string::npos);
  CHECK(refusal_of<std::uint64_t>({~0ull}, stored::at_most(7)) != "no error");
  CHECK(refusal_of<std::int32_t>({-1}, stored::at_most(7)) != "no error");
  CHECK(refusal_of<std::uint64_t>({0, 7}, stored::at_most(7)) == "no error");
  State state;
  state.put("truth", {std::vector<std::uint8_t>{2}, {}, ""});
  bool truth = false;
  CHECK(error_line([&] { StateTransfer::restoring_from(state).value("truth", "", truth); }) != "no error");
}

TEST_CASE("what is restored has the unit and the shape with which it is saved", "[state]") {
  State state;
  state.put("x", {std::vector<double>{1, 2, 3, 4}, {2, 2}, "m"});
  const StateTransfer from = StateTransfer::restoring_from(state);
  std::vector<double> x, four(4), three(3);
  from.rows("x", "m", x, 2);
  CHECK(x == std::vector<double>{1, 2, 3, 4});
  CHECK(error_line([&] { from.rows("x", "m", x); }).find("has the shape (2, 2) instead of (4)") !=
        std::string::npos);
  CHECK(error_line([&] { from.rows("x", "m", x, 4); }) != "no error");
  CHECK(error_line([&] { from.rows("x", "mm", x, 2); }).find("has another unit than \"mm\"") !=
        std::string::npos);
  CHECK(error_line([&] { from.sized_rows("x", "m", three, 2); }).find("has 4 values instead of 3") !=
        std::string::npos);
  CHECK(error_line([&] { from.numbers("x", "m", four.data(), 4); }) != "no error");
}

TEST_CASE(
    "an infinite number anywhere in the state of a simulation is refused, but in what may have no value",
    "[state]") {
  Scene scene = heap(3, GENERATE(false, true));
  scene.orientations = true;
  scene.pair_forces = true;
  scene.integration = GENERATE(Integration::position_verlet, Integration::predictor_corrector);
  Simulation whole(scene);
  scree::test::run(whole, 20);
  const State sound = whole.state();
  // Energies, and what plug-ins keep.
  const auto may_have_none = [](const std::string& path) {
    return path.starts_with("audit/") || path.starts_with("sums/") || path == "start/lengths" ||
           path.ends_with("/history") || path == "contacts/force" ||
           (path.starts_with("walls/") && (path.ends_with("/state") || path.ends_with("/kinetic") ||
                                           path.ends_with("/work") || path.ends_with("/dissipated")));
  };
  std::size_t tried = 0;
  for (const auto& [path, array] : sound.arrays()) {
    StateArray wrong = array;
    auto* numbers = std::get_if<std::vector<double>>(&wrong.values);
    if (!numbers || numbers->empty() || may_have_none(path)) continue;
    numbers->back() = infinite;
    State changed = sound;
    changed.put(path, wrong);
    changed.put("state_hash", {std::vector<std::uint64_t>{0}, {}, ""});
    INFO(path);
    CHECK(error_line([&] {
            scene.bodies = bodies_at_start(changed);
            Simulation(scene, changed);
          }).find("; ") != std::string::npos);
    ++tried;
  }
  CHECK(tried > 20);
}

TEST_CASE("a state with the planes, the periods or the orientations of no simulation is refused", "[state]") {
  const bool periodic = GENERATE(false, true);
  Scene scene = heap(3, periodic);
  scene.orientations = true;
  Simulation whole(scene);
  const State sound = whole.state();
  scene.bodies = bodies_at_start(sound);
  const auto refusal_with = [&](const std::string& path, auto number) {
    State changed = sound;
    StateArray array = sound.at(path);
    std::get<std::vector<decltype(number)>>(array.values)[0] = number;
    changed.put(path, array);
    changed.put("state_hash", {std::vector<std::uint64_t>{0}, {}, ""});
    return error_line([&] { Simulation(scene, changed); });
  };
  CHECK(refusal_with("bodies/orientation", 3.0).find("has a quaternion whose length is not 1") !=
        std::string::npos);
  CHECK(refusal_with("walls/0/first_plane", std::uint64_t(7)).find("is not that of the boundary here") !=
        std::string::npos);
  CHECK(refusal_with("walls/0/plane_count", std::uint64_t(1) << 60) != "no error");
  CHECK(refusal_with("walls/domain_lower", -7.0).find("is not that of the periodic boundaries here") !=
        std::string::npos);
  CHECK(refusal_with("clock/steps", ~std::uint64_t(0)) != "no error");
  CHECK(refusal_with("clock/forces_at", std::uint8_t(2)) != "no error");
  CHECK(refusal_with("neighbours/body_travel", -1.0) != "no error");
  if (!periodic)
    CHECK(refusal_with("walls/planes/normal", 2.0).find("has a vector whose length is not 1") !=
          std::string::npos);
}
