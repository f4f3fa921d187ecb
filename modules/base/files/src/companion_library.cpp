#include <array>
#include <cstdio>
#include <dlfcn.h>
#include <fcntl.h>
#include <filesystem>
#include <spawn.h>
#include <string>
#include <sys/file.h>
#include <sys/wait.h>
#include <unistd.h>

#include <scree/files/companion_library.hpp>
#include <scree/files/descriptor.hpp>

namespace scree::files {
namespace {

namespace fs = std::filesystem;

// The build or install tree of the running program.
fs::path program_tree() { return fs::canonical("/proc/self/exe").parent_path().parent_path(); }

// The file of a library; empty if there is none.
fs::path find(const CompanionLibrary& library) {
  const fs::path tree = program_tree();
  const std::array candidates = {tree / "lib", tree / "lib" / "scree",
                                 tree / SCREE_INSTALL_LIBRARY_DIRECTORY / "scree"};
  const std::string name = fmt::format("lib{}.so", library.target);
  for (const fs::path& directory : candidates)
    if (fs::exists(directory / name)) return directory / name;
  return {};
}

// Runs `ninja -C <tree> <target>`, whose output goes to stderr. Returns whether it succeeded.
bool run_build(const fs::path& tree, const char* target) {
  const std::string folder = tree.string();
  const char* words[] = {"ninja", "-C", folder.c_str(), target, nullptr};
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, STDERR_FILENO, STDOUT_FILENO);
  pid_t process = -1;
  const int failed = posix_spawnp(&process, words[0], &actions, nullptr, const_cast<char**>(words), environ);
  posix_spawn_file_actions_destroy(&actions);
  int status = -1;
  return failed == 0 && waitpid(process, &status, 0) == process && WIFEXITED(status) &&
         WEXITSTATUS(status) == 0;
}

// One process at a time builds; the others find the library when it is their turn. Does nothing outside a build tree.
void build(const CompanionLibrary& library) {
  const fs::path tree = program_tree();
  const Descriptor build_file(open((tree / "build.ninja").c_str(), O_RDONLY | O_CLOEXEC));
  if (!build_file.is_open()) return;
  flock(build_file.get(), LOCK_EX);
  if (!find(library).empty()) return;
  std::fputs(fmt::format("scree: building {}, which is required for {}; this takes some minutes, once\n",
                         library.target, library.purpose)
                 .c_str(),
             stderr);
  if (!run_build(tree, library.target))
    throw Error(
        fmt::format("{}: the build of {} failed; see its output above", tree.string(), library.target),
        ExitStatus::failure);
}

fs::path find_or_build(const CompanionLibrary& library) {
  if (const fs::path file = find(library); !file.empty()) return file;
  if (library.built_on_demand) build(library);
  if (const fs::path file = find(library); !file.empty()) return file;
  throw Error(fmt::format("{}/lib{}.so: not found; it is required for {}: build the target {}, or {}",
                          (program_tree() / "lib").string(), library.target, library.purpose, library.target,
                          library.without));
}

}  // namespace

void* load_factory(const CompanionLibrary& library) {
  const fs::path file = find_or_build(library);
  // Never unloaded: VTK, Mesa and HDF5 leave thread-local data and exit handlers behind.
  void* handle = dlopen(file.c_str(), RTLD_NOW | RTLD_LOCAL | RTLD_NODELETE);
  if (!handle)
    throw Error(
        fmt::format("{}: cannot be loaded ({}); install {}", file.string(), dlerror(), library.needs));
  return dlsym(handle, library.factory);
}

}  // namespace scree::files
