#include <catch2/catch.hpp>

#include <scree/error.hpp>

using scree::Error;
using scree::ExitStatus;

TEST_CASE("the line of an error has its place, its problem and its cure") {
  const Error error("a.toml:1:2", "it is wrong", "correct it", ExitStatus::failure);
  CHECK(error.what() == std::string("a.toml:1:2: it is wrong; correct it"));
  CHECK(error.place() == "a.toml:1:2");
  CHECK(error.problem() == "it is wrong");
  CHECK(error.cure() == "correct it");
  CHECK(error.status() == ExitStatus::failure);
  CHECK(Error("", "it is wrong", "correct it").what() == std::string("it is wrong; correct it"));
  CHECK(Error("a", "it is wrong", "").what() == std::string("a: it is wrong"));
}

TEST_CASE("an error from a line is all problem") {
  const Error error("a: it is wrong; correct it");
  CHECK(error.what() == std::string("a: it is wrong; correct it"));
  CHECK(error.problem() == error.what());
  CHECK(error.place().empty());
  CHECK(error.cure().empty());
  CHECK(error.status() == ExitStatus::bad_input);
}

TEST_CASE(
    "an outer place stands before the place of an error, which keeps its status unless it gets another") {
  const Error error("", "it is wrong", "correct it", ExitStatus::blow_up);
  const Error placed = error.at("inner").at("outer");
  CHECK(placed.what() == std::string("outer: inner: it is wrong; correct it"));
  CHECK(placed.place() == "outer: inner");
  CHECK(placed.status() == ExitStatus::blow_up);
  CHECK(error.at("inner", ExitStatus::failure).status() == ExitStatus::failure);
}
