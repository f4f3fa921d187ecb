#include "plugins/load_check.hpp"

#include <dlfcn.h>

#include <fmt/format.h>

#include <scree/child_process.hpp>
#include <scree/plugin/abi.h>

namespace scree {

namespace {

void load(const char* library) {
  if (void* handle = dlopen(library, RTLD_NOW | RTLD_LOCAL))
    if (const auto query = reinterpret_cast<scree_query_function>(dlsym(handle, SCREE_QUERY_SYMBOL))) query();
}

}  // namespace

std::optional<std::string> fatal_load(const std::filesystem::path& library, double longest) {
  const ChildEnd end = in_child([&](const Send&) { load(library.c_str()); }, {longest, true});
  switch (end.how) {
    case ChildEnd::exited:
    case ChildEnd::signalled:
      return fmt::format("ends the program while it is loaded ({})", end.text());
    case ChildEnd::out_of_time:
      return fmt::format("holds the program while it is loaded ({})", end.text());
    default:
      return {};
  }
}

}  // namespace scree
