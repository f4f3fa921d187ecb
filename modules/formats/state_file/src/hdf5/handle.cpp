#include "handle.hpp"

#include <fmt/format.h>

namespace scree::state_file {
namespace {

// The first entry comes from the innermost function, which names the cause.
herr_t keep_first(unsigned, const H5E_error2_t* entry, void* text) {
  auto& kept = *static_cast<std::string*>(text);
  if (kept.empty() && entry->desc) kept = entry->desc;
  return 0;
}

// The cause of a failed call of the system, "No space left on device", from "file write failed: ..., error
// message = 'No space left on device', ..."; empty for other failures.
std::string system_cause(const std::string& entry) {
  constexpr std::string_view before = "error message = '";
  const std::size_t begin = entry.find(before);
  if (begin == entry.npos) return "";
  const std::size_t end = entry.find('\'', begin + before.size());
  return entry.substr(begin + before.size(), end - begin - before.size());
}

}  // namespace

void fail_of_hdf5(std::string_view what) {
  std::string entry;
  H5Ewalk2(H5E_DEFAULT, H5E_WALK_UPWARD, keep_first, &entry);
  H5Eclear2(H5E_DEFAULT);
  const std::string cause = system_cause(entry);
  if (!cause.empty()) throw Error(cause);
  throw Error(entry.empty() ? std::string(what) : fmt::format("{}: {}", what, entry));
}

}  // namespace scree::state_file
