#include "body_field.hpp"

#include "packing_support.hpp"

#include <string>
#include <utility>

#include <catch2/catch.hpp>

using namespace scree::packing;
using Catch::Matchers::Contains;
using Catch::Matchers::StartsWith;

namespace {

// Sets a field to a word of a file; the message if it is refused.
std::string set(Body& body, BodyField field, const std::string& word) {
  TextReader reader(word, "f");
  reader.next();
  return error_of([&] { set_field(body, field, reader.words().at(0), reader); });
}

}  // namespace

TEST_CASE("each field of a file goes to one number of a body", "[packing]") {
  const std::pair<BodyField, double Body::*> scalars[] = {{BodyField::radius, &Body::radius},
                                                          {BodyField::density, &Body::density},
                                                          {BodyField::mass, &Body::mass}};
  for (const auto& [field, member] : scalars) {
    Body body;
    CHECK(set(body, field, "2.5").empty());
    CHECK(body.*member == 2.5);
    CHECK_THAT(set(body, field, "-1"), StartsWith("f:1:1: ") && Contains("'-1' is not positive; "));
  }
  const std::pair<BodyField, scree::Vec3 Body::*> vectors[] = {
      {BodyField::x, &Body::position}, {BodyField::vx, &Body::velocity}, {BodyField::wx, &Body::spin}};
  for (const auto& [first, member] : vectors)
    for (int k = 0; k < 3; ++k) {
      Body body;
      CHECK(set(body, BodyField(int(first) + k), "-3").empty());
      scree::Vec3 expected{};
      expected[k] = -3;
      CHECK(body.*member == expected);
    }
  Body body;
  CHECK(set(body, BodyField::diameter, "5").empty());
  CHECK(body.radius == 2.5);
  CHECK(set(body, BodyField::id, "1000000000000000").empty());
  CHECK_THAT(set(body, BodyField::id, "1000000000000001"), Contains(" is above 1000000000000000; "));
}

TEST_CASE("in two dimensions only z, its velocity and spins in the plane must be 0", "[packing]") {
  TextReader reader("0.5", "f");
  reader.next();
  for (int k = int(BodyField::x); k <= int(BodyField::wz); ++k) {
    const BodyField field{k};
    Body body;
    double* const component = field_component(body, field);
    const auto refusal = [&] {
      return error_of([&] { require_planar(body, field, reader.words().at(0), reader); });
    };
    CHECK(refusal().empty());
    if (component) *component = 0.5;
    CAPTURE(k);
    const bool spatial =
        field == BodyField::z || field == BodyField::vz || field == BodyField::wx || field == BodyField::wy;
    CHECK(refusal().empty() == !spatial);
  }
}

TEST_CASE("an id that a file uses twice is refused with the line of the first", "[packing]") {
  TextReader reader("7\n8\n 7\n", "f");
  IdRegister ids;
  const auto add_next = [&] {
    reader.next();
    const Token token = reader.words().at(0);
    return error_of([&] { ids.add(token.text == "7" ? 7 : 8, token, reader); });
  };
  CHECK(add_next().empty());
  CHECK(add_next().empty());
  CHECK_THAT(add_next(), StartsWith("f:3:2: id 7 was used before, in line 1; "));
}
