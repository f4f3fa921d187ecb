#include <array>
#include <dlfcn.h>
#include <filesystem>

#include <scree/files/companion_library.hpp>

namespace scree::files {
namespace {

std::filesystem::path find(const CompanionLibrary& library) {
  const std::filesystem::path prefix =
      std::filesystem::canonical("/proc/self/exe").parent_path().parent_path();
  const std::array candidates = {prefix / "lib", prefix / "lib" / "scree",
                                 prefix / SCREE_INSTALL_LIBRARY_DIRECTORY / "scree"};
  const std::string name = fmt::format("lib{}.so", library.target);
  for (const auto& directory : candidates)
    if (std::filesystem::exists(directory / name)) return directory / name;
  throw Error(fmt::format("{}/{}: not found; it is required for {}: build the target {}, or {}",
                          candidates[0].string(), name, library.purpose, library.target, library.without));
}

}  // namespace

void* load_factory(const CompanionLibrary& library) {
  const std::filesystem::path file = find(library);
  // Never unloaded: VTK, Mesa and HDF5 leave thread-local data and exit handlers behind.
  void* handle = dlopen(file.c_str(), RTLD_NOW | RTLD_LOCAL | RTLD_NODELETE);
  if (!handle)
    throw Error(
        fmt::format("{}: cannot be loaded ({}); install {}", file.string(), dlerror(), library.needs));
  return dlsym(handle, library.factory);
}

}  // namespace scree::files
