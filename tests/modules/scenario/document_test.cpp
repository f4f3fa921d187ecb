#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>
#include <string>
#include <unistd.h>

#include <catch2/catch.hpp>

#include <scree/scenario/document.hpp>
#include <scree/nearest.hpp>

using namespace scree;
using namespace scree::scenario;
namespace fs = std::filesystem;

namespace {

Document scene(std::string_view text) { return Document::parse(text, "scene.toml"); }

// The one line of the Error that the action throws; every one of them is bad input.
template <class Action>
std::string message(Action&& action) {
  try {
    action();
  } catch (const Error& error) {
    CHECK(error.status() == ExitStatus::bad_input);
    CHECK(std::string(error.what()).find('\n') == std::string::npos);
    return error.what();
  }
  return "no error";
}

std::string syntax_message(std::string_view text) {
  return message([&] { scene(text); });
}

// A folder of its own, removed at the end.
class Folder {
 public:
  Folder() : path_(fs::temp_directory_path() / ("scree_document_test_" + std::to_string(getpid()))) {
    fs::create_directories(path_);
  }
  ~Folder() { fs::remove_all(path_); }
  fs::path operator/(const std::string& name) const { return path_ / name; }
  const fs::path& path() const { return path_; }
  fs::path write(const std::string& name, const std::string& content) const {
    std::ofstream(path_ / name, std::ios::binary) << content;
    return path_ / name;
  }

 private:
  fs::path path_;
};

}  // namespace

TEST_CASE("values of every kind are read as written") {
  const Document document = scene(
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
  const Table root = scene("a = 1\nb = 'x'\nc = false\nd = [1]\n").root();
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
  CHECK(root.numbers_or("absent", {0, 1}) == std::vector<double>{0, 1});
  CHECK(root.numbers_or("d", {0}) == std::vector<double>{1});
}

TEST_CASE("the kind of a value can be asked for") {
  const Table root = scene("i = 1\nf = 1.5\nt = {a = 1}\nr = [1]\ns = 's'\nb = true\n[[e]]\n").root();
  CHECK(root.is_number("i"));
  CHECK(root.is_number("f"));
  CHECK_FALSE(root.is_number("t"));
  CHECK(root.is_table("t"));
  CHECK_FALSE(root.is_table("r"));
  CHECK(root.is_array("r"));
  CHECK(root.is_array("e"));
  CHECK(root.is_string("s"));
  CHECK_FALSE(root.is_string("b"));
  CHECK(root.is_boolean("b"));
  CHECK(root.has("i"));
  CHECK_FALSE(root.has("absent"));
  CHECK_FALSE(root.is_number("absent"));
}

TEST_CASE("a wrong type is placed at the value and names what is wanted") {
  const Table time =
      scene("[time]\n# comment\nstep = \"2e-5\"\nname = 3\ncount = 3.0\non = 'yes'\nday = 1979-05-27\n")
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
  const Table root = scene("a = nan\nb = -inf\nc = [1, +inf]\n").root();
  CHECK(message([&] { root.number("a"); }) == "scene.toml:1:5: a = nan is not finite; give a number");
  CHECK(message([&] { root.number("b", Range::any("m")); }) ==
        "scene.toml:2:5: b = -inf is not finite; give a number in m");
  CHECK(message([&] { root.numbers("c"); }) == "scene.toml:3:9: c[1] = inf is not finite; give a number");
}

TEST_CASE("a value out of range is placed, shown with its unit and cured") {
  const Table p = scene("[particles]\nradius = -0.005\nmass = 0\nratio = 1.5\ncycles = -2\nlow = 1\n")
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

TEST_CASE("a range holds its ends as declared and nothing that is not finite") {
  CHECK(Range::between(0, 1).contains(0));
  CHECK(Range::between(0, 1).contains(1));
  CHECK_FALSE(Range::positive().contains(0));
  CHECK(Range::non_negative().contains(0));
  CHECK_FALSE(Range::any().contains(std::numeric_limits<double>::quiet_NaN()));
  CHECK_FALSE(Range::any().contains(std::numeric_limits<double>::infinity()));
  CHECK(Range::any("m").unit() == "m");
}

TEST_CASE("arrays are checked for length and for each element") {
  const Table root =
      scene("v = [1, 2, 3]\nw = [1,\n  'x']\ns = ['a', 1]\nr = [[1, 2], [3]]\nn = [-1]\none = 5\n").root();
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
  CHECK(message([&] {
          root.numbers_or("v", {0, 0});
        }) == "scene.toml:1:5: v has 3 elements; give an array of 2 numbers");
}

TEST_CASE("a wrong choice names the nearest and all") {
  const Table root = scene("integrator = 'velocty_verlet'\nother = 'zzz'\n").root();
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
  const Table root = scene("[a]\nx = 1\n\n  [time]\nstp = 1\n[[stage]]\n[[stage]]\n").root();
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

TEST_CASE("tables are found in each spelling") {
  const Table root =
      scene("[[contact]]\nf = 1\n[[contact]]\nf = 2\n[single]\nf = 3\n[deep]\nin = {f = 4}\n").root();
  const std::vector<Table> contacts = root.tables("contact");
  REQUIRE(contacts.size() == 2);
  CHECK(contacts[1].number("f") == 2);
  CHECK(contacts[1].path() == "contact[1]");
  CHECK(contacts[1].label() == "[[contact]]");
  REQUIRE(root.tables("single").size() == 1);
  CHECK(root.tables("single")[0].number("f") == 3);
  CHECK(root.tables("absent").empty());
  CHECK(scene("[[wall]]\nx = 1\n").root().tables("wall")[0].path() == "wall");
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

TEST_CASE("an unknown key is refused with the nearest and all known keys") {
  const Document document =
      scene("[time]\nstep = 1\n\n[[contact]]\nplugin = 'p'\n\nfrction = 0.5\nzzz = 1\n");
  const Table root = document.root();
  root.table("time").number("step");
  const Table contact = root.tables("contact").front();
  contact.string("plugin");
  contact.number("friction", 0.0);
  const std::string line =
      "scene.toml:7:1: unknown key 'frction' in [[contact]]; did you mean 'friction'? known keys: plugin, "
      "friction";
  CHECK(message([&] { document.refuse_unused(); }) == line);
  CHECK(message([&] { contact.refuse_unused(); }) == line);
  CHECK_NOTHROW(root.table("time").refuse_unused());
  contact.has("frction");
  CHECK(message([&] { document.refuse_unused(); }) ==
        "scene.toml:8:1: unknown key 'zzz' in [[contact]]; known keys: plugin, friction, frction");
  contact.accept("zzz");
  CHECK_NOTHROW(document.refuse_unused());
}

TEST_CASE("the first unknown key in file order is the one refused") {
  const Document document = scene("[b]\nx = 1\n[a]\ny = 2\n[b.inner]\nz = 3\n");
  document.root().table("a");
  const Table b = document.root().table("b");
  b.table("inner");
  CHECK(message([&] { document.refuse_unused(); }).starts_with("scene.toml:2:1: unknown key 'x' in [b]; "));
  b.number("x");
  CHECK(message([&] { document.refuse_unused(); }) ==
        "scene.toml:4:1: unknown key 'y' in [a]; remove it, no key is read here");
  document.root().accept("a");
  CHECK(message([&] {
          document.refuse_unused();
        }).starts_with("scene.toml:6:1: unknown key 'z' in [b.inner]; "));
}

TEST_CASE("an unknown table and an unknown key of an inline table are placed at the key") {
  const Document document = scene("[tme]\nstep = 1\n[wall]\nmove = { amplitude = 1, frequncy = 2 }\n");
  const Table wall = document.root().table("wall");
  wall.table("move").number("amplitude");
  wall.table("move").number("frequency", 0.0);
  document.root().optional_table("time");
  CHECK(message([&] { document.refuse_unused(); }) ==
        "scene.toml:1:2: unknown key 'tme' in the file; did you mean 'time'? known keys: wall, time");
  document.root().accept("tme");
  CHECK(message([&] { document.refuse_unused(); }) ==
        "scene.toml:4:25: unknown key 'frequncy' in [wall.move]; did you mean 'frequency'? "
        "known keys: amplitude, frequency");
}

TEST_CASE("errors of the builder are placed") {
  const Table root = scene("a = 1\n[t]\n  b = [1, 2]\n").root();
  const Table t = root.table("t");
  CHECK(std::string(t.error("b", "is odd", "make it even").what()) == "scene.toml:3:7: is odd; make it even");
  CHECK(std::string(t.error("b", 1, "is odd", "make it even").what()) ==
        "scene.toml:3:11: is odd; make it even");
  CHECK(std::string(t.error("b", 9, "is odd", "make it even").what()) ==
        "scene.toml:3:7: is odd; make it even");
  CHECK(std::string(t.error("absent", "is odd", "make it even").what()) ==
        "scene.toml:2:1: is odd; make it even");
  CHECK(std::string(t.error("is odd", "make it even").what()) == "scene.toml:2:1: is odd; make it even");
  CHECK(root.place("a") == "scene.toml:1:5");
  CHECK(root.place() == "scene.toml:1:1");
}

TEST_CASE("places hold behind a byte order mark, CRLF ends, tabs and letters of several bytes") {
  const Table root = scene("\xEF\xBB\xBFtop = 1\r\n\tnext = 2\r\nword = ['\xC3\xA9', 3]\r\n").root();
  CHECK(root.place("top") == "scene.toml:1:7");
  CHECK(root.place("next") == "scene.toml:2:9");
  CHECK(message([&] { root.strings("word"); }).starts_with("scene.toml:3:14: word[1] "));
}

TEST_CASE("a syntax error is one line with place and cure") {
  struct Case {
    std::string text, start, cure;
  };
  const Case cases[] = {
      {"a = 1\na = 2\n", "scene.toml:2:", "; keep one of the two"},
      {"[a]\n[a]\n",
       "scene.toml:2:1: ", "; merge the two tables, or write [[name]] for each entry of a list"},
      {"\na = \n", "scene.toml:2:5: ", "; give the value behind the = on the same line"},
      {"a = 'x\n", "scene.toml:1:7: ", "; close the quote on the same line, or use \"\"\" for several lines"},
      {"a = tru\n", "scene.toml:1:8: ", "; write true or false, or put the word in quotes"},
      {"a 1\n", "scene.toml:1:3: ", "; write key = value"},
      {"a = [1,2\n", "scene.toml:", "; close the bracket, brace or quote that is open there"},
      {"a = 01\n", "scene.toml:1:", "; write the number without leading zeros"},
      {"a = .5\n", "scene.toml:1:5: ", "; put a digit on both sides of the decimal point, such as 0.5"},
      {"a = 1.\n", "scene.toml:1:7: ", "; put a digit behind the decimal point or exponent, such as 1.0"},
      {"a = 2e400\n", "scene.toml:1:", "; give a number of magnitude below 1.8e308"},
      {"a = 99999999999999999999\n", "scene.toml:1:", "; give a number that fits 64 bits"},
      {"a = 2 mm\n", "scene.toml:1:7: ", "; put each key = value on a line of its own"},
      {"a = 2mm\n",
       "scene.toml:1:6: ", "; write a plain number such as 2.5e-3, without a unit (all units are SI)"},
      {"a = 1,5\n", "scene.toml:1:6: ", "; use a decimal point, one value for each key, and [ ] for several"},
      {"a = glass\n",
       "scene.toml:1:5: ", "; give a number, true, false, an [array] or a \"string\" in quotes"},
      {"a = \"\xFF\"\n", "scene.toml:1:5: ", "; save the file as UTF-8 text"},
      {"a = \"\\q\"\n", "scene.toml:1:7: ", "; write \\\\ for a backslash, or use 'single quotes'"},
      {"a = {b = 1,\nc = 2}\n", "scene.toml:1:", "; write an inline table on one line, { a = 1, b = 2 }"},
      {"[a\n", "scene.toml:1:3: ", "; write [name] or [[name]] on a line of its own"},
  };
  for (const Case& wrong : cases) {
    INFO(wrong.text);
    const std::string line = syntax_message(wrong.text);
    INFO(line);
    CHECK(line.starts_with(wrong.start));
    CHECK(line.find(": not valid TOML: ") != std::string::npos);
    CHECK(line.ends_with(wrong.cure));
  }
}

TEST_CASE("nesting without end is refused, not followed") {
  const auto nested = [](int parts) {
    std::string header = "x = 1\n[a";
    for (int i = 0; i < parts; ++i) header += ".a";
    return header + "]\n";
  };
  CHECK(syntax_message(nested(60)) == "no error");
  CHECK(syntax_message(nested(100)) == "scene.toml:2:1: tables or arrays more than 64 deep; flatten them");
  CHECK(syntax_message(nested(300000)) == "scene.toml:2:1: tables or arrays more than 64 deep; flatten them");
  CHECK(syntax_message("a = " + std::string(100000, '[')).ends_with("; flatten the arrays"));
  std::string table_of_numbers = "# 0.5";
  for (int i = 0; i < 5000; ++i) table_of_numbers += " 0.5";
  CHECK(syntax_message(table_of_numbers) == "no error");
  std::string numbers = "v = [0.5";
  for (int i = 0; i < 5000; ++i) numbers += " ,\t0.5";
  CHECK(scene(numbers + "] # " + std::string(5000, '.') + "\n").root().numbers("v").size() == 5001);
}

TEST_CASE("long and odd text stays one readable line") {
  const Table root =
      scene("a = '''l1\nl2'''\nb = '" + std::string(5000, 'x') + "'\n\"odd\\nkey\" = 1\n").root();
  CHECK(message([&] { root.number("a"); }) == "scene.toml:1:5: a is a string (\"l1\\nl2\"); give a number");
  CHECK(message([&] { root.number("b"); }).size() < 200);
  CHECK(message([&] {
          root.refuse_unused();
        }).starts_with("scene.toml:4:1: unknown key 'odd\\nkey' in the file; "));
}

TEST_CASE("a file that cannot be a scene is refused with the reason and a cure") {
  const Folder folder;
  const std::string good = folder.write("david_sweep.toml", "a = 1\n").string();
  CHECK(Document::load(good).root().place("a") == good + ":1:5");

  const auto load = [](const fs::path& path) { return message([&] { Document::load(path); }); };
  for (const char* name : {"david_swep.toml", "david_sweep", "David_Sweep.tml"}) {
    const std::string path = (folder / name).string();
    CHECK(load(path) == path + ": cannot be read (No such file or directory); did you mean '" + good + "'?");
  }
  CHECK(
      load(folder / "other.toml").ends_with(": cannot be read (No such file or directory); check the path"));
  CHECK(load(folder.path()) ==
        folder.path().string() + ": cannot be read (Is a directory); give a file in it, such as " + good);
  CHECK(load(good + "/x.toml").ends_with(": cannot be read (Not a directory); check the path"));
  CHECK(load("").starts_with("'': cannot be read ("));

  using namespace std::string_literals;
  CHECK(load(folder.write("binary.toml", "a = 1\n\0\x01"s))
            .ends_with("(a binary file); give a scene as TOML text"));
  CHECK(load(folder.write("wide.toml", "\xFF\xFE"s + "a\0"s)).ends_with("(UTF-16 text); save it as UTF-8"));
  for (const char* nothing : {"", "\n\n# only a comment\n", "\xEF\xBB\xBF"}) {
    const std::string path = folder.write("empty.toml", nothing).string();
    CHECK(load(path) ==
          path + ":1:1: the file holds no key; write a scene: [scene], [time], [particles], ...");
  }
}

TEST_CASE("a huge file is refused at once") {
  const Folder folder;
  const fs::path huge = folder.write("huge.toml", "a = 1\n");
  fs::resize_file(huge, 100u << 20);
  CHECK(message([&] { Document::load(huge); }) ==
        huge.string() +
            ": cannot be read (larger than 16 MiB); give a scene; many particles belong in a packing file");
}

TEST_CASE("the resolved text reads back to the same values and to itself") {
  const Document document = scene(
      "z = 1\nf = 2.0\ntiny = 5e-324\nthird = 0.3333333333333333\nbig = 1e22\nday = 1979-05-27T07:32:00Z\n"
      "[t]\ns = \"q\\\" b\\\\ n\\n t\\t \xC3\xA9 \\u0001\"\n\"odd key\" = {a = [1, [2.5, 'x']], b = "
      "{}}\nempty = []\n"
      "[t.u.v]\nw = -0.0\n[[e]]\nn = 1\n[e.sub]\nk = true\n[[e]]\n[lonely]\n");
  const std::string text = document.resolved_text();
  const Document again = Document::parse(text, "again.toml");
  CHECK(again.resolved_text() == text);
  const Table root = again.root();
  CHECK(root.is_number("f"));
  CHECK(root.number("tiny") == std::numeric_limits<double>::denorm_min());
  CHECK(root.number("third") == 0.3333333333333333);
  CHECK(root.number("big") == 1e22);
  CHECK(root.table("t").string("s") == "q\" b\\ n\n t\t \xC3\xA9 \x01");
  CHECK(root.table("t").table("odd key").table("b").keys().empty());
  CHECK(std::signbit(root.table("t").table("u").table("v").number("w")));
  CHECK(root.tables("e").size() == 2);
  CHECK(root.tables("e")[0].table("sub").boolean("k"));
  CHECK(root.has("lonely"));
  CHECK(text.find("\"odd key\" = { a = [1, [2.5, \"x\"]], b = {} }\n") != std::string::npos);
  CHECK(message([&] { root.integer("f"); }).find("(2.0)") != std::string::npos);
  CHECK(text.starts_with("z = 1\nf = 2.0\ntiny = 5e-324\nthird = 0.3333333333333333\nbig = 1e+22\nday = "));
}

TEST_CASE("the nearest word is found among near ones only") {
  const std::vector<std::string> keys = {"friction", "restitution", "youngs_modulus", "plugin", "a", "step"};
  CHECK(nearest_word("frction", keys) == "friction");
  CHECK(nearest_word("rfiction", keys) == "friction");
  CHECK(nearest_word("Youngs-Modulus", keys) == "youngs_modulus");
  CHECK(nearest_word("youngs", keys) == "youngs_modulus");
  CHECK(nearest_word("friction_coefficient", keys) == "friction");
  CHECK(nearest_word("setp", keys) == "step");
  CHECK(nearest_word("friction", keys) == "friction");
  CHECK_FALSE(nearest_word("damping", keys));
  CHECK_FALSE(nearest_word("b", keys));
  CHECK_FALSE(nearest_word("", keys));
  CHECK_FALSE(nearest_word("friction", {}));
  CHECK(nearest_word("bact", {"cat", "bat", "bait"}) == "bat");
}
