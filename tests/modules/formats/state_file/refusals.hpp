#pragma once

#include <filesystem>
#include <string>

#include <catch2/catch.hpp>

#include <scree/error.hpp>
#include <scree/state_file/state_file.hpp>

namespace scree::test {

// What write_state says: one line for a failure, with a cure.
inline std::string failure(const std::filesystem::path& file, const State& state) {
  try {
    state_file::write_state(file, state);
  } catch (const Error& error) {
    const std::string line = error.what();
    CHECK(error.status() == ExitStatus::failure);
    CHECK(line.starts_with(file.string() + ": cannot be written ("));
    CHECK(line.find("; ") != line.npos);
    CHECK(line.find('\n') == line.npos);
    return line;
  }
  return "";
}

}  // namespace scree::test
