#include <cmath>

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include <scree/report/record.hpp>

using namespace scree::report;

TEST_CASE("a record may be anything", "[report]") {
  CHECK(parse_record("{ \"a\": [1, 2] }").dump() == "{\"a\":[1,2]}");
  CHECK(parse_record("no record").is_discarded());
  const std::string deep(100'000, '[');
  CHECK(parse_record("{ \"a\": 1, \"b\": " + deep + std::string(100'000, ']') + " }")["a"] == 1);
}

TEST_CASE("an entry of another type is as one that is missing", "[report]") {
  const auto record =
      parse_record(R"({"text": "a", "number": 2.5, "yes": true, "list": [1], "object": {"b": 1}})");
  CHECK(text_in(record, "text") == "a");
  CHECK(text_in(record, "number").empty());
  CHECK(number_in(record, "number") == 2.5);
  CHECK(std::isnan(number_in(record, "text")));
  CHECK(is_true_in(record, "yes"));
  CHECK_FALSE(is_true_in(record, "number"));
  CHECK(list_in(record, "list").size() == 1);
  CHECK(list_in(record, "object").empty());
  CHECK(object_in(record, "object").size() == 1);
  CHECK(object_in(record, "none").empty());
  CHECK(text_in(parse_record("[1]"), "text").empty());
}
