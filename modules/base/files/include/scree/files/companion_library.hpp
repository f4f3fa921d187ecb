#pragma once

#include <string>

#include <fmt/format.h>

#include <scree/error.hpp>

namespace scree::files {

// A shared library that comes with the program and is loaded when it is first needed.
struct CompanionLibrary {
  const char* target;   // of the build, "scree_pictures_vtk"; the file is lib<target>.so
  const char* factory;  // function of C linkage: Interface* factory(int version), null for another version
  const char* purpose;  // "snapshots and images"
  const char* without;  // what to do without it: "leave them out"
  const char* needs;    // "the VTK and OSMesa run-time libraries"
  // Whether it is built in a build tree where it is missing: tools/run builds only what a run needs.
  bool built_on_demand = false;
};

// A function of the library, from the build or install tree of the running program; null if it has no such
// function. A library that is built on demand is built first if it is missing, with a line on stderr that
// says so. The library is never unloaded. Throws Error if it is missing or broken, or if its build fails
// (failure).
void* load_factory(const CompanionLibrary& library);

// Makes the interface that the library implements. Throws Error; if the library has another version too.
template <class Interface>
Interface* load_companion(const CompanionLibrary& library, int version) {
  const auto create = reinterpret_cast<Interface* (*)(int)>(load_factory(library));
  Interface* made = create ? create(version) : nullptr;
  if (!made)
    throw Error(fmt::format("lib{}.so", library.target), "has another version than this program",
                fmt::format("rebuild the target {}", library.target));
  return made;
}

}  // namespace scree::files
