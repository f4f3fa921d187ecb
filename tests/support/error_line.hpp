#pragma once

#include <string>

#include <catch2/catch.hpp>

#include <scree/error.hpp>

namespace scree::test {

// The line of the Error that the action throws; "no error" without one.
template <class Action>
std::string error_line(const Action& action) {
  try {
    action();
  } catch (const Error& error) {
    return error.what();
  }
  return "no error";
}

// The same, of an Error with this exit status.
template <class Action>
std::string error_line(const Action& action, ExitStatus status) {
  return error_line([&] {
    try {
      action();
    } catch (const Error& error) {
      CHECK(error.status() == status);
      throw;
    }
  });
}

}  // namespace scree::test
