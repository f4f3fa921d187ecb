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

TEST_CASE("what a picture shows is read from [snapshot]", "[scenario]") {
  const auto picture = [](const std::string& keys) {
    return plan_of(discs + ("[snapshot]\n" + keys)).snapshot.picture;
  };
  const pictures::RenderOptions usual = picture("");
  CHECK(usual.show_bodies);
  CHECK(usual.show_title);
  CHECK_FALSE(usual.show_contacts);
  const pictures::RenderOptions other = picture(
      "contacts = 'strong'\nbodies = false\ntitle = false\ntime = false\nscale_bar = true\nfollow_bodies = true\n"
      "view = [1, -1, 0.5]\ncut = { x = [0, 0.03] }\ncolor_by = 'velocity_y'\n");
  CHECK(other.show_contacts);
  CHECK(other.strong_contacts);
  CHECK_FALSE(other.show_bodies);
  CHECK_FALSE(other.show_title);
  CHECK_FALSE(other.show_time);
  CHECK(other.scale_bar);
  CHECK(other.follow_bodies);
  CHECK(other.direction == std::array{1.0, -1.0, 0.5});
  CHECK(other.cut[0] == std::array{0.0, 0.03});
  CHECK(picture("contacts = true\n").show_contacts);
  const auto refused = [](const std::string& keys) {
    return scree::test::refusal(discs + ("[snapshot]\n" + keys));
  };
  CHECK_THAT(refused("contacts = 'weak'\n"), Catch::Contains("weak"));
  CHECK_THAT(refused("view = 'top'\n"), Catch::Contains("top"));
  CHECK_THAT(refused("view = [0, 0, 0]\n"), Catch::Contains("the direction has no length"));
  CHECK_THAT(refused("cut = { z = [0, 1] }\n"), Catch::Contains("a scene of two dimensions has no z"));
  CHECK_THAT(refused("shadows = true\n"), Catch::Contains("discs are flat and have no shadows"));
  CHECK_THAT(refused("cut = { x = [1, 0] }\n"), Catch::Contains("1 is not below 0"));
  CHECK_THAT(refused("cut = { w = [1, 0] }\n"), Catch::Contains("unknown key 'w'"));
}

TEST_CASE("a map of sliding work is kept if it is asked for, and can be", "[scenario]") {
  const std::string kept = "[snapshot]\nevery = 1e-4\nsliding_work = true\n";
  CHECK(plan_of(discs + kept).scene.sliding_work);
  CHECK_FALSE(plan_of(discs + std::string("[snapshot]\nevery = 1e-4\n")).scene.sliding_work);
  CHECK(plan_of(discs + kept + "color_surfaces_by = 'sliding_work'\n").snapshot.picture.color_surfaces_by ==
        "sliding_work");
  CHECK(plan_of(discs + std::string("[snapshot]\n")).snapshot.picture.color_surfaces_by == "none");
  CHECK_THAT(refusal(discs + std::string("[snapshot]\nsliding_work = true\n")),
             Catch::Contains("a map of sliding work needs files or pictures; give every"));
  CHECK_THAT(refusal(discs + std::string("[snapshot]\nevery = 1e-4\ncolor_surfaces_by = 'sliding_work'\n")),
             Catch::Contains("the run keeps no sliding work; set sliding_work = true too"));
  CHECK_THAT(
      refusal(with(discs, "plugin = 'energy'", "plugin = 'momentum'") + kept, {"time.energy_audit=false"}),
      Catch::Contains("snapshot.sliding_work needs the energy audit"));
}

TEST_CASE("pictures by group keep the bodies of all groups, and need one", "[scenario]") {
  const std::string groups =
      "[[group]]\nname = 'low'\nwhere = { y = [0, 0.02] }\nfixed = true\n"
      "[[group]]\nname = 'right'\nwhere = { x = [0.05, 1] }\n";
  const std::string colored = "[snapshot]\ncolor_by = 'group'\n";
  const Plan plan = plan_of(discs + groups + colored);
  REQUIRE(plan.scene.selections.size() == 2);
  CHECK(plan.scene.selections[0].name == "low");
  CHECK(plan.scene.selections[0].bodies == std::vector<std::uint32_t>{0, 1, 2});
  CHECK(plan.scene.selections[1].bodies == std::vector<std::uint32_t>{2, 5, 8});
  CHECK_THAT(refusal(discs + colored), Catch::Contains("the scene has no groups; add [[group]]"));
}

TEST_CASE("a film is made of pictures, at a rate", "[scenario]") {
  const auto film = [](const std::string& keys) { return discs + ("[snapshot]\n" + keys); };
  CHECK_FALSE(plan_of(film("image_every = 1e-4\n")).snapshot.film_rate);
  CHECK(plan_of(film("image_every = 1e-4\nfilm = true\n")).snapshot.film_rate == 25);
  CHECK(plan_of(film("image_every = 1e-4\nfilm = true\nfilm_rate_hz = 10\n")).snapshot.film_rate == 10);
  CHECK_THAT(refusal(film("every = 1e-4\nfilm = true\n")),
             Catch::Contains("a film needs pictures; give image_every = <s> too"));
}
