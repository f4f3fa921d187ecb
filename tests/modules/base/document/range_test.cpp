#include <limits>

#include <catch2/catch.hpp>

#include <scree/document/range.hpp>

using scree::document::Range;

TEST_CASE("a range holds its ends as declared and nothing that is not finite") {
  CHECK(Range::between(0, 1).contains(0));
  CHECK(Range::between(0, 1).contains(1));
  CHECK_FALSE(Range::positive().contains(0));
  CHECK(Range::non_negative().contains(0));
  CHECK_FALSE(Range::any().contains(std::numeric_limits<double>::quiet_NaN()));
  CHECK_FALSE(Range::any().contains(std::numeric_limits<double>::infinity()));
  CHECK(Range::any("m").unit() == "m");
}

TEST_CASE("a range says what is wrong with a value and what is accepted") {
  struct Case {
    Range range;
    double value;
    const char *fault, *wanted;
  };
  const Case cases[] = {
      {Range::positive("m"), 0, "is zero", "above 0"},
      {Range::non_negative("m"), -1, "is negative", "of 0 or more"},
      {Range::above(1, "s"), 1, "is not above 1 s", "above 1 s"},
      {Range::at_least(2), 1.5, "is below 2", "of 2 or more"},
      {Range::between(1, 2, "kg"), 3, "is above 2 kg", "from 1 to 2 kg"},
      {Range::between(1, 2, "kg"), 0, "is below 1 kg", "from 1 to 2 kg"},
  };
  for (const Case& c : cases) {
    INFO(c.wanted);
    CHECK_FALSE(c.range.contains(c.value));
    CHECK(c.range.fault(c.value) == c.fault);
    CHECK(c.range.wanted() == c.wanted);
  }
  CHECK(Range::any("m").wanted().empty());
}
