#include "document_support.hpp"

#include <cmath>
#include <limits>

#include <catch2/catch.hpp>

using namespace scree;
using namespace scree::document;
using namespace scree::test;

TEST_CASE("values of every kind are read as written") {
  const Document document = document_of(
      "title = 'heap'\nseed = 9007199254740993\nratio = 0.1\nwhole = 3\nlid = true\n"
      "gravity = [0, -9.81]\ncorners = [[0, 0], [1, 0.5]]\nparts = ['a', 'b']\n");
  const Table root = document.root();
  CHECK(root.string("title") == "heap");
  CHECK(root.integer("seed") == 9007199254740993);
  CHECK(root.number("ratio") == 0.1);
  CHECK(root.number("whole") == 3.0);
  CHECK(root.boolean("lid"));
  CHECK(root.numbers("gravity") == std::vector<double>{0, -9.81});
  CHECK(root.numbers("gravity", 2) == std::vector<double>{0, -9.81});
  CHECK(root.rows("corners", 2) == std::vector<std::vector<double>>{{0, 0}, {1, 0.5}});
  CHECK(root.strings("parts") == std::vector<std::string>{"a", "b"});
  CHECK(root.choice("title", {"heap", "box"}) == "heap");
  CHECK(root.keys().front() == "title");
  CHECK_NOTHROW(document.refuse_unused());
}

TEST_CASE("an absent key gives the fallback, a present one does not") {
  const Table root = document_of("a = 1\nb = 'x'\nc = false\nd = [1]\n").root();
  CHECK(root.number("a", 7.0) == 1);
  CHECK(root.number("absent", 7.0, Range::positive("m")) == 7);
  CHECK(root.optional_number("a") == 1.0);
  CHECK_FALSE(root.optional_number("absent"));
  CHECK(root.integer("absent", 4) == 4);
  CHECK(root.integer("a", 4) == 1);
  CHECK(root.string("absent", "y") == "y");
  CHECK(root.string("b", "y") == "x");
  CHECK_FALSE(root.optional_string("absent"));
  CHECK_FALSE(root.boolean("c", true));
  CHECK(root.boolean("absent", true));
  CHECK(root.choice("absent", {"x", "y"}, "y") == "y");
}

TEST_CASE("the kind of a value can be asked for") {
  const Table root = document_of("i = 1\nf = 1.5\nt = {a = 1}\nr = [1]\ns = 's'\nb = true\n[[e]]\n").root();
  CHECK(root.is_number("i"));
  CHECK(root.is_number("f"));
  CHECK_FALSE(root.is_number("t"));
  CHECK(root.is_table("t"));
  CHECK_FALSE(root.is_table("r"));
  CHECK(root.is_array("r"));
  CHECK(root.is_array("e"));
  CHECK(root.is_string("s"));
  CHECK_FALSE(root.is_string("b"));
  CHECK(root.has("i"));
  CHECK_FALSE(root.has("absent"));
  CHECK_FALSE(root.is_number("absent"));
}

TEST_CASE("tables are found in each spelling") {
  const Table root =
      document_of("[[contact]]\nf = 1\n[[contact]]\nf = 2\n[single]\nf = 3\n[deep]\nin = {f = 4}\n").root();
  const std::vector<Table> contacts = root.tables("contact");
  REQUIRE(contacts.size() == 2);
  CHECK(contacts[1].number("f") == 2);
  CHECK(contacts[1].path() == "contact[1]");
  CHECK(contacts[1].label() == "[[contact]]");
  REQUIRE(root.tables("single").size() == 1);
  CHECK(root.tables("single")[0].number("f") == 3);
  CHECK(root.tables("absent").empty());
  CHECK(document_of("[[wall]]\nx = 1\n").root().tables("wall")[0].path() == "wall");
  CHECK(root.table("deep").table("in").label() == "[deep.in]");
  CHECK(root.table("deep").table("in").place("f") == "scene.toml:8:11");
  CHECK_FALSE(root.optional_table("absent"));
  CHECK(root.optional_table("single")->number("f") == 3);
  CHECK(root.table_or_empty("snapshot").number("every", 0.5) == 0.5);
  CHECK(message([&] { root.table_or_empty("snapshot").number("every"); }) ==
        "scene.toml:1:1: [snapshot] has no 'every'; add every = <number>");
  CHECK(message([&] { root.table("contact"); }) ==
        "scene.toml:1:1: contact is an array of tables; keep one entry, written [contact]");
}

TEST_CASE("a wrong type is placed at the value and names what is wanted") {
  const Table time =
      document_of("[time]\n# comment\nstep = \"2e-5\"\nname = 3\ncount = 3.0\non = 'yes'\nday = 1979-05-27\n")
          .root()
          .table("time");
  CHECK(message([&] { time.number("step", Range::any("s")); }) ==
        "scene.toml:3:8: time.step is a string (\"2e-5\"); give a number in s, such as 2e-5");
  CHECK(message([&] { time.number("on", Range::any("s")); }) ==
        "scene.toml:6:6: time.on is a string (\"yes\"); give a number in s");
  CHECK(message([&] { time.string("name"); }) ==
        "scene.toml:4:8: time.name is an integer (3); give a string in quotes");
  CHECK(message([&] { time.integer("count"); }) ==
        "scene.toml:5:9: time.count is a floating-point number (3.0); "
        "give a whole number without a decimal point or exponent, such as 3");
  CHECK(message([&] { time.boolean("on"); }) ==
        "scene.toml:6:6: time.on is a string (\"yes\"); give true or false");
  CHECK(message([&] { time.number("day"); }) ==
        "scene.toml:7:7: time.day is a date or time (1979-05-27); give a number");
  CHECK(message([&] { time.table("count"); }) ==
        "scene.toml:5:9: time.count is a floating-point number (3.0); give a table [time.count]");
  CHECK(message([&] { time.tables("name"); }) ==
        "scene.toml:4:8: time.name is an integer (3); give tables [[time.name]]");
  CHECK(message([&] { time.strings("on"); }) ==
        "scene.toml:6:6: time.on is a string (\"yes\"); give an array of strings");
}

TEST_CASE("nan and infinities are no numbers") {
  const Table root = document_of("a = nan\nb = -inf\nc = [1, +inf]\n").root();
  CHECK(message([&] { root.number("a"); }) == "scene.toml:1:5: a = nan is not finite; give a number");
  CHECK(message([&] { root.number("b", Range::any("m")); }) ==
        "scene.toml:2:5: b = -inf is not finite; give a number in m");
  CHECK(message([&] { root.numbers("c"); }) == "scene.toml:3:9: c[1] = inf is not finite; give a number");
}

TEST_CASE("a value out of range is placed, shown with its unit and cured") {
  const Table p = document_of("[particles]\nradius = -0.005\nmass = 0\nratio = 1.5\ncycles = -2\nlow = 1\n")
                      .root()
                      .table("particles");
  CHECK(message([&] { p.number("radius", Range::positive("m")); }) ==
        "scene.toml:2:10: particles.radius = -0.005 m is negative; give a radius above 0");
  CHECK(message([&] { p.number("mass", Range::positive("kg")); }) ==
        "scene.toml:3:8: particles.mass = 0 kg is zero; give a mass above 0");
  CHECK(message([&] { p.number("radius", Range::non_negative("m")); }) ==
        "scene.toml:2:10: particles.radius = -0.005 m is negative; give a radius of 0 or more");
  CHECK(message([&] { p.number("ratio", Range::between(0, 1)); }) ==
        "scene.toml:4:9: particles.ratio = 1.5 is above 1; give a ratio from 0 to 1");
  CHECK(message([&] { p.number("low", Range::between(2, 3, "s")); }) ==
        "scene.toml:6:7: particles.low = 1 s is below 2 s; give a low from 2 to 3 s");
  CHECK(message([&] { p.number("low", Range::above(1, "s")); }) ==
        "scene.toml:6:7: particles.low = 1 s is not above 1 s; give a low above 1 s");
  CHECK(message([&] { p.integer("cycles", Range::at_least(1)); }) ==
        "scene.toml:5:10: particles.cycles = -2 is below 1; give cycles of 1 or more");
  CHECK(p.number("mass", Range::non_negative("kg")) == 0);
  CHECK(p.number("ratio", Range::between(1.5, 1.5)) == 1.5);
}

TEST_CASE("arrays are checked for length and for each element") {
  const Table root =
      document_of("v = [1, 2, 3]\nw = [1,\n  'x']\ns = ['a', 1]\nr = [[1, 2], [3]]\nn = [-1]\none = 5\n")
          .root();
  CHECK(message([&] { root.numbers("v", 2, Range::any("m")); }) ==
        "scene.toml:1:5: v has 3 elements; give an array of 2 numbers in m");
  CHECK(message([&] { root.numbers("w"); }) == "scene.toml:3:3: w[1] is a string (\"x\"); give a number");
  CHECK(message([&] { root.strings("s"); }) ==
        "scene.toml:4:11: s[1] is an integer (1); give a string in quotes");
  CHECK(message([&] { root.rows("r", 2); }) ==
        "scene.toml:5:14: r[1] has 1 element; give an array of 2 numbers");
  CHECK(message([&] { root.numbers("n", Range::positive("m")); }) ==
        "scene.toml:6:6: n[0] = -1 m is negative; give numbers above 0");
  CHECK(message([&] { root.numbers("one", 2); }) ==
        "scene.toml:7:7: one is an integer (5); give an array of 2 numbers");
  CHECK(message([&] { root.numbers("v", 2); }) ==
        "scene.toml:1:5: v has 3 elements; give an array of 2 numbers");
}

TEST_CASE("a wrong choice names the nearest and all") {
  const Table root = document_of("integrator = 'velocty_verlet'\nother = 'zzz'\n").root();
  const std::vector<std::string> allowed = {"velocity_verlet", "leapfrog", "euler"};
  CHECK(message([&] { root.choice("integrator", allowed); }) ==
        "scene.toml:1:14: integrator = \"velocty_verlet\" is none of the choices; did you mean "
        "'velocity_verlet'? "
        "give \"velocity_verlet\", \"leapfrog\" or \"euler\"");
  CHECK(message([&] { root.choice("other", allowed, "euler"); }) ==
        "scene.toml:2:9: other = \"zzz\" is none of the choices; give \"velocity_verlet\", \"leapfrog\" or "
        "\"euler\"");
}

TEST_CASE("a missing key is placed at its table and shown as it is to be written") {
  const Table root = document_of("[a]\nx = 1\n\n  [time]\nstp = 1\n[[stage]]\n[[stage]]\n").root();
  const Table time = root.table("time");
  CHECK(message([&] { time.number("step", Range::any("s")); }) ==
        "scene.toml:4:3: [time] has no 'step'; add step = <number> (s), "
        "or correct 'stp' (scene.toml:5:1) if that is meant");
  CHECK(message([&] { root.table("a").integer("count"); }) ==
        "scene.toml:1:1: [a] has no 'count'; add count = <whole number>");
  CHECK(message([&] { root.table("particles"); }) ==
        "scene.toml:1:1: the file has no 'particles'; add a table [particles]");
  CHECK(message([&] { time.table("pulse"); }) ==
        "scene.toml:4:3: [time] has no 'pulse'; add a table [time.pulse]");
  CHECK(message([&] { root.tables("stage").at(1).numbers("axis", 2, Range::any("m")); }) ==
        "scene.toml:7:1: [[stage]] has no 'axis'; add axis = [<number>, <number>] (m)");
  CHECK(message([&] {
          time.choice("kind", {"a", "b"});
        }) == "scene.toml:4:3: [time] has no 'kind'; add kind = \"a\" or \"b\"");
  CHECK(message([&] { time.boolean("lid"); }) ==
        "scene.toml:4:3: [time] has no 'lid'; add lid = <true or false>");
  CHECK(message([&] { time.string("text"); }) ==
        "scene.toml:4:3: [time] has no 'text'; add text = \"<text>\"");
}

TEST_CASE("lists of whole numbers are read with their range") {
  const Table root = document_of("good = [1, 2]\nbad = [1, -2]\nworse = [1.5]\n").root();
  CHECK(root.integers("good") == std::vector<std::int64_t>{1, 2});
  CHECK(message([&] {
          root.integers("bad", Range::non_negative());
        }).starts_with("scene.toml:2:11: bad[1] = -2 "));
  CHECK(
      message([&] { root.integers("worse"); }).starts_with("scene.toml:3:10: worse[0] is a floating-point "));
}
