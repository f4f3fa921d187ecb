#include "checked_import.hpp"

#include <fmt/format.h>

#include <scree/error.hpp>

namespace scree::packing {

Packing checked_import(Packing packing, const std::string& name) {
  try {
    check(packing);
  } catch (const Error& error) {
    throw Error(fmt::format("{}: {}", name, error.what()));
  }
  return packing;
}

}  // namespace scree::packing
