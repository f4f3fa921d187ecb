#pragma once

#include <filesystem>
#include <string>

#include <scree/state_file/state_file.hpp>

namespace scree::test {

// Changes an array of a state file, as others can: the file has a right seal again, and its hash says
// nothing. change: takes a StateArray, and may change it.
template <class Change>
void change_state(const std::filesystem::path& file, const std::string& path, const Change& change) {
  State state = state_file::read_state(file);
  StateArray array = state.at(path);
  change(array);
  state.put(path, std::move(array));
  state.put("state_hash", {std::vector<std::uint64_t>{0}, {}, ""});
  state_file::write_state(file, state);
}

// Leaves out an array, likewise.
inline void remove_array(const std::filesystem::path& file, const std::string& path) {
  const State state = state_file::read_state(file);
  State rest;
  for (const auto& [name, array] : state.arrays())
    if (name != path) rest.put(name, array);
  rest.put("state_hash", {std::vector<std::uint64_t>{0}, {}, ""});
  state_file::write_state(file, rest);
}

// Changes one number of an array, likewise.
template <class Number>
void change_number(const std::filesystem::path& file, const std::string& path, std::size_t at,
                   Number number) {
  change_state(file, path,
               [&](StateArray& array) { std::get<std::vector<Number>>(array.values).at(at) = number; });
}

// Leaves out the last number, or the last of many.
inline void shorten(StateArray& array) {
  std::visit([](auto& values) { values.pop_back(); }, array.values);
  array.shape = {array.size()};
}

}  // namespace scree::test
