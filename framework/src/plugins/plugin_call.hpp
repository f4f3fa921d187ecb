#pragma once

#include <exception>

#include <fmt/format.h>

#include <scree/error.hpp>

namespace scree {

// Calls a function of a plug-in. The interface allows no exceptions; one that comes nevertheless becomes an
// Error with the name of the plug-in.
template <class Call>
auto plugin_call(const char* plugin, const char* function, const Call& call) {
  const auto error = [&](const char* what) {
    return Error(fmt::format("plug-in {}: its function {} threw an exception ({}); none may leave a plug-in",
                             plugin, function, what));
  };
  try {
    return call();
  } catch (const std::exception& exception) {
    throw error(exception.what());
  } catch (...) {
    throw error("of unknown type");
  }
}

}  // namespace scree
