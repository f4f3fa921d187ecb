#pragma once

#include <string>
#include <string_view>

#include <catch2/catch.hpp>

#include <scree/document/document.hpp>

namespace scree::test {

inline document::Document document_of(std::string_view text) {
  return document::Document::parse(text, "scene.toml");
}

// The line of the Error that the action throws, which must have the status bad_input.
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

}  // namespace scree::test
