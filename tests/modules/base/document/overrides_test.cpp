#include "document_support.hpp"

#include <string>
#include <vector>

#include <catch2/catch.hpp>

using namespace scree;
using namespace scree::document;
using scree::test::message;

namespace {

constexpr std::string_view overridden_text =
    "[time]\nstep = 1e-4\nrows = [1, 2, 3]\n\n"
    "[[contact]]\nplugin = 'hertz'\nfriction = 0.5\n\n"
    "[[stage]]\nname = 'settle'\nduration = 1\n\n"
    "[[stage]]\nname = 'cycle'\nduration = 2\nmotion = { amplitude = 1, axis = [1, 0] }\n\n"
    "[[probe]]\ntype = 'force'\n[[probe]]\ntype = 'force'\n[[probe]]\ntype = 'energy'\n";

Document set(std::vector<std::string> overrides) {
  return Document::parse(overridden_text, "scene.toml", overrides);
}

std::string refusal(const std::string& override_text) {
  return message([&] { set({override_text}); });
}

}  // namespace

TEST_CASE("an override replaces a value by its dotted path") {
  CHECK(set({"time.step=1e-5"}).root().table("time").number("step") == 1e-5);
  CHECK(set({" time . step = 1e-5 "}).root().table("time").number("step") == 1e-5);
  CHECK(set({"\"time\".'step'=1e-5"}).root().table("time").number("step") == 1e-5);
  CHECK(set({"\"a.b=c[0]\".d=1"}).root().table("a.b=c[0]").integer("d") == 1);
  CHECK(set({"time.step=1", "time.step=2"}).root().table("time").number("step") == 2);
  CHECK(set({}).root().table("time").number("step") == 1e-4);
}

TEST_CASE("an entry of an array of tables goes by index or by name") {
  for (const char* path : {"stage[1]", "stage.cycle"}) {
    const std::vector<Table> stages = set({std::string(path) + ".duration=5"}).root().tables("stage");
    CHECK(stages[0].number("duration") == 1);
    CHECK(stages[1].number("duration") == 5);
  }
  CHECK(
      set({"stage.cycle.motion.amplitude=7"}).root().tables("stage")[1].table("motion").number("amplitude") ==
      7);
  CHECK(set({"probe.energy.every=3"}).root().tables("probe")[2].number("every") == 3);
  CHECK(set({"probe[1]={type='work', every=4}"}).root().tables("probe")[1].number("every") == 4);
}

TEST_CASE("the only entry of an array of tables needs no naming") {
  for (const char* path : {"contact", "contact[0]", "contact.hertz"}) {
    CHECK(set({std::string(path) + ".friction=0.2"}).root().tables("contact")[0].number("friction") == 0.2);
  }
  CHECK(set({"time[0].step=3"}).root().table("time").number("step") == 3);
}

TEST_CASE("an entry of several is replaced as a whole under its name") {
  const Table cycle = set({"stage.cycle={ name = \"cycle\", duration = 4 }"}).root().tables("stage")[1];
  CHECK(cycle.keys() == std::vector<std::string>{"name", "duration"});
  CHECK(cycle.number("duration") == 4);
  // Of an only entry too, unless it has the name as a key.
  CHECK(set({"contact.hertz={ plugin = \"hertz\", friction = 1 }"}).root().tables("contact")[0].keys() ==
        std::vector<std::string>{"plugin", "friction"});
  CHECK(set({"contact.friction={ a = 1 }"}).root().tables("contact")[0].table("friction").integer("a") == 1);
  CHECK(refusal("stage.cycle=4") ==
        "--set stage.cycle=4: stage[1] is a table; set a key of it, as in stage.cycle.key");
}

TEST_CASE("elements of plain arrays go by index") {
  CHECK(set({"time.rows[1]=9"}).root().table("time").numbers("rows") == std::vector<double>{1, 9, 3});
  CHECK(set({"stage[1].motion.axis[0]=4"}).root().tables("stage")[1].table("motion").numbers("axis")[0] == 4);
}

TEST_CASE("the value is TOML, a bare word is a string") {
  const auto value = [](const std::string& written) {
    return set({"time.new=" + written}).root().table("time");
  };
  CHECK(value("3").integer("new") == 3);
  CHECK(value("-2.5e-3").number("new") == -2.5e-3);
  CHECK(value("true").boolean("new"));
  CHECK(value("[1, 2]").numbers("new") == std::vector<double>{1, 2});
  CHECK(value("{ a = 1 }").table("new").integer("a") == 1);
  CHECK(value("\"quoted = text\"").string("new") == "quoted = text");
  CHECK(value("hello").string("new") == "hello");
  CHECK(value("two words = three").string("new") == "two words = three");
  CHECK(value("1\nstep = 2").string("new") == "1\nstep = 2");
}

TEST_CASE("a new key is added where its table is, or with plain tables above it") {
  CHECK(set({"time.end=2"}).root().table("time").number("end") == 2);
  CHECK(set({"snapshot.image.width=640"}).root().table("snapshot").table("image").integer("width") == 640);
  CHECK(set({"seed=4"}).root().integer("seed") == 4);
  CHECK(Document::parse("", "scene.toml", {"a.b=1", "a.c=2"}).root().table("a").keys() ==
        std::vector<std::string>{"b", "c"});
}

TEST_CASE("what the reader finds wrong in an override is placed at the override") {
  const Document wrong = set({"time.step=fast", "contact.frction=0.2", "stage[0].duration=-1"});
  const Table root = wrong.root();
  CHECK(message([&] { root.table("time").number("step", Range::any("s")); }) ==
        "--set time.step=fast: time.step is a string (\"fast\"); give a number in s");
  CHECK(message([&] { root.tables("stage")[0].number("duration", Range::positive("s")); }) ==
        "--set stage[0].duration=-1: stage[0].duration = -1 s is negative; give a duration above 0");
  const Table contact = root.tables("contact")[0];
  contact.string("plugin");
  contact.number("friction");
  CHECK(message([&] { contact.refuse_unused(); }) ==
        "--set contact.frction=0.2: unknown key 'frction' in [[contact]]; did you mean 'friction'? "
        "known keys: plugin, friction");
  CHECK(contact.place("frction") == "--set contact.frction=0.2");
  CHECK(contact.place("friction") == "scene.toml:7:12");
  CHECK(message([&] { set({"tme.step=1"}).root().number("tme"); }) ==
        "--set tme.step=1: tme is a table; give a number");
  CHECK(message([&] { set({"snapshot.x=1"}).root().table("snapshot").number("every", Range::any("s")); }) ==
        "--set snapshot.x=1: [snapshot] has no 'every'; add every = <number> (s)");
}

TEST_CASE("an unknown key of the file comes before one of an override") {
  const Document document = set({"aaa=1"});
  for (const char* key : {"time", "contact", "stage"}) document.root().accept(key);
  CHECK(message([&] {
          document.refuse_unused();
        }).starts_with("scene.toml:18:3: unknown key 'probe' in the file; "));
  document.root().accept("probe");
  CHECK(
      message([&] { document.refuse_unused(); }).starts_with("--set aaa=1: unknown key 'aaa' in the file; "));
}

TEST_CASE("an override that fits several entries lists them") {
  CHECK(refusal("stage.duration=3") ==
        "--set stage.duration=3: stage has 2 entries and 'duration' names none of them; "
        "choose one: stage[0] (settle), stage[1] (cycle)");
  CHECK(refusal("stage.cycel.duration=3") ==
        "--set stage.cycel.duration=3: stage has 2 entries and 'cycel' names none of them; did you mean "
        "'cycle'? "
        "choose one: stage[0] (settle), stage[1] (cycle)");
  CHECK(refusal("probe.force.every=3") ==
        "--set probe.force.every=3: 2 entries of probe have type 'force'; "
        "choose one by index: probe[0] (force), probe[1] (force)");
  CHECK(refusal("stage[2].duration=3") ==
        "--set stage[2].duration=3: stage has 2 entries, so there is no entry 2; "
        "count from 0: stage[0] (settle), stage[1] (cycle)");
}

TEST_CASE("a misspelt name of the only entry of a list is taken for its name, not for a key") {
  const Document wrong = set({"contact.hertx.range.at_most=2"});
  const Table contact = wrong.root().tables("contact")[0];
  for (const char* key : {"plugin", "friction", "her"}) contact.accept(key);
  CHECK(
      message([&] { contact.refuse_unused(); }) ==
      "--set contact.hertx.range.at_most=2: unknown key 'hertx' in [[contact]]; did you mean 'hertz'? known keys: "
      "plugin, friction, her");
  // The name itself is no cure.
  const Document twice = set({"contact.hertz.hertz=2"});
  const Table named = twice.root().tables("contact")[0];
  for (const char* key : {"plugin", "friction"}) named.accept(key);
  CHECK(message([&] { named.refuse_unused(); }) ==
        "--set contact.hertz.hertz=2: unknown key 'hertz' in [[contact]]; known keys: plugin, friction");
  // A key of the file is no name.
  const Document file = Document::parse("[[contact]]\nplugin = 'hertz'\nhertx = 1\n", "scene.toml");
  const Table other = file.root().tables("contact")[0];
  other.accept("plugin");
  CHECK(message([&] { other.refuse_unused(); }) ==
        "scene.toml:3:1: unknown key 'hertx' in [[contact]]; known keys: plugin");
}

TEST_CASE("a number beyond the range of numbers is no text") {
  for (const char* beyond : {"1e400", "-1e400"})
    CHECK(refusal(std::string("time.step=") + beyond)
              .starts_with(std::string("--set time.step=") + beyond + ": not valid TOML: "));
  CHECK(refusal("time.step=99999999999999999999").ends_with("; give a number that fits 64 bits"));
  CHECK(set({"time.name=01"}).root().table("time").string("name") == "01");
  CHECK(set({"time.name=1e5x"}).root().table("time").string("name") == "1e5x");
}

TEST_CASE("a text with a character 0 is refused, which would hide the rest of a path") {
  CHECK(refusal("time.name=\"a\\u0000b\"") ==
        "--set time.name=\"a\\u0000b\": the text \"a\\x00b\" has a character U+0000; remove it");
  CHECK(message([] { Document::parse("[a]\nfile = ['x', \"s.toml\\u0000x\"]\n", "scene.toml"); }) ==
        "scene.toml:2:14: the text \"s.toml\\x00x\" has a character U+0000; remove it");
}

TEST_CASE("an override that leads nowhere is refused") {
  CHECK(refusal("probe[0][0].every=1") ==
        "--set probe[0][0].every=1: probe[0] is a table, so it has no entry 0; leave the index out");
  CHECK(refusal("time[0][0].step=1") ==
        "--set time[0][0].step=1: time is a table, so it has no entry 0; leave the index out");
  CHECK(refusal("time.step.x=2") ==
        "--set time.step.x=2: time.step is a floating-point number (0.0001), so it has no 'x'; "
        "give time.step itself a value or correct the path");
  CHECK(refusal("stagee[0].duration=2") ==
        "--set stagee[0].duration=2: the file has no 'stagee' to take an entry of; did you mean 'stage'? "
        "an override adds no entries to a list");
  CHECK(refusal("time.rows[3]=2") ==
        "--set time.rows[3]=2: time.rows has 3 entries, so there is no entry 3; count from 0");
  CHECK(refusal("time.step[1]=2") ==
        "--set time.step[1]=2: time.step is a floating-point number (0.0001), so it has no entry 1; "
        "leave the index out");
}

TEST_CASE("a malformed override is refused with the way to write it") {
  const std::string form = "; write the key as in table.key, table[0].key or table.\"odd name\".key";
  CHECK(refusal("time.step") == "--set time.step: has no '='; write --set key=value");
  CHECK(refusal("") == "--set : has no '='; write --set key=value");
  CHECK(refusal("time.step=") == "--set time.step=: has no value; write --set key='\"\"' for an empty text");
  CHECK(refusal("=3") == "--set =3: a part of the key is empty" + form);
  CHECK(refusal("time..step=3") == "--set time..step=3: a part of the key is empty" + form);
  CHECK(refusal("stage[1.duration=3") ==
        "--set stage[1.duration=3: a bracket in the key is not closed" + form);
  CHECK(refusal("stage[-1].duration=3") == "--set stage[-1].duration=3: '-1' is no index from 0" + form);
  CHECK(refusal("stage[].duration=3") == "--set stage[].duration=3: '' is no index from 0" + form);
  CHECK(refusal("stage[\t\x1b].duration=3") ==
        "--set stage[\\t\\x1B].duration=3: '\\x1B' is no index from 0" + form);
  CHECK(refusal("time.rows=[1, 2") ==
        "--set time.rows=[1, 2: not valid TOML: array: encountered end-of-file; "
        "close the bracket, brace or quote that is open there");
  CHECK(refusal("title=\xC3(").ends_with(": is not UTF-8 text; encode it as UTF-8"));
  CHECK(set({"title=\xC3\xA9"}).root().string("title") == "\xC3\xA9");
  std::string deep = "a";
  for (int i = 0; i < 100; ++i) deep += ".a";
  CHECK(refusal(deep + "=1").ends_with(": the key has too many parts" + form));
}

TEST_CASE("the resolved text holds the overrides") {
  const Document document =
      set({"time.step=2e-5", "stage.cycle.duration=7", "extra.word=hello", "time.rows[0]={a=1}"});
  const std::string resolved = document.resolved_text();
  CHECK(resolved.starts_with("[time]\nstep = 2e-5\nrows = [{ a = 1 }, 2, 3]\n\n[[contact]]\n"));
  const Table root = Document::parse(resolved, "again.toml").root();
  CHECK(root.tables("stage")[1].number("duration") == 7);
  CHECK(root.tables("stage")[1].table("motion").numbers("axis", 2) == std::vector<double>{1, 0});
  CHECK(root.table("extra").string("word") == "hello");
}
