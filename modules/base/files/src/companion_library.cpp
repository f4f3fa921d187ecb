#include <array>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <dlfcn.h>
#include <elf.h>
#include <fcntl.h>
#include <filesystem>
#include <fstream>
#include <string>
#include <sys/file.h>
#include <sys/wait.h>
#include <unistd.h>

#include <scree/child_process.hpp>
#include <scree/files/companion_library.hpp>
#include <scree/files/descriptor.hpp>

namespace scree::files {
namespace {

namespace fs = std::filesystem;

// The build or install tree of the running program. Throws Error if its file is gone, as after a new build.
fs::path program_tree() {
  std::error_code failed;
  const fs::path program = fs::canonical("/proc/self/exe", failed);
  if (failed)
    throw Error("", "the file of this program was replaced or removed while it runs",
                "repeat the command, which goes on with the new one");
  return program.parent_path().parent_path();
}

// The file of a library; empty if there is none.
fs::path find(const CompanionLibrary& library) {
  const fs::path tree = program_tree();
  const std::array candidates = {tree / "lib", tree / "lib" / "scree",
                                 tree / SCREE_INSTALL_LIBRARY_DIRECTORY / "scree"};
  const std::string name = fmt::format("lib{}.so", library.target);
  std::error_code ignored;
  for (const fs::path& directory : candidates)
    if (fs::exists(fs::symlink_status(directory / name, ignored))) return directory / name;
  return {};
}

// Whether a library is a regular file with all its sections, which stand at its end. The dynamic loader
// trusts them: where they are missing, the process ends with SIGBUS.
bool is_whole(const fs::path& library) {
  std::error_code failed;
  if (!fs::is_regular_file(library, failed)) return false;
  std::ifstream file(library, std::ios::binary);
  Elf64_Ehdr head = {};
  if (!file.read(reinterpret_cast<char*>(&head), sizeof(head))) return false;
  const std::uintmax_t end = head.e_shoff + std::uintmax_t(head.e_shentsize) * head.e_shnum;
  return std::memcmp(head.e_ident, ELFMAG, SELFMAG) == 0 && head.e_shoff > 0 &&
         fs::file_size(library, failed) >= end;
}

// Runs `ninja -C <tree> <target>`, whose output goes to stderr. Returns whether it succeeded; throws if there
// is no ninja. ninja and the compilers that it starts inherit the lock: if this process ends before them, no
// other process builds until they have ended too.
bool run_build(const std::string& tree, const char* target, const Descriptor& lock) {
  // SIGKILL, since ninja would end its compilers after another signal.
  const StartedProgram ninja =
      start_program({"ninja", "-C", tree, target},
                    {.output = STDERR_FILENO, .inherited = {lock.get()}, .end_signal = SIGKILL});
  if (ninja.process < 0)
    throw Error(
        "ninja",
        fmt::format("cannot be started ({}), and {} is not built yet",
                    std::strerror(ninja.not_executed ? ninja.not_executed : ninja.no_process), target),
        "install ninja-build");
  const int status = wait_for(ninja.process);
  return WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

void say(const std::string& what) { std::fputs(fmt::format("scree: {}\n", what).c_str(), stderr); }

// One process at a time builds; the others then find the library. Does nothing outside a build tree.
void build(const CompanionLibrary& library) {
  const fs::path tree = program_tree();
  const Descriptor build_file(open((tree / "build.ninja").c_str(), O_RDONLY | O_CLOEXEC));
  if (!build_file.is_open()) return;
  if (flock(build_file.get(), LOCK_EX | LOCK_NB) != 0) {
    say(fmt::format("waiting for {}, which another process builds", library.target));
    flock(build_file.get(), LOCK_EX);
  }
  if (!find(library).empty()) return;
  say(fmt::format("building {}, which is required for {}; this takes some minutes, once", library.target,
                  library.purpose));
  if (!run_build(tree.string(), library.target, build_file))
    throw Error(tree.string(), fmt::format("the build of {} failed", library.target), "see its output above",
                ExitStatus::failure);
}

fs::path find_or_build(const CompanionLibrary& library) {
  if (const fs::path file = find(library); !file.empty()) return file;
  if (library.built_on_demand) build(library);
  if (const fs::path file = find(library); !file.empty()) return file;
  throw Error(fmt::format("{}/lib{}.so", (program_tree() / "lib").string(), library.target), "not found",
              fmt::format("it is required for {}: build the target {}, or {}", library.purpose,
                          library.target, library.without));
}

}  // namespace

void* load_factory(const CompanionLibrary& library) {
  const fs::path file = find_or_build(library);
  if (!is_whole(file))
    throw Error(
        file.string(), "is no whole library",
        fmt::format("remove it and build the target {} again, or install scree again", library.target));
  // Never unloaded, since VTK, Mesa and HDF5 leave thread-local data and exit handlers.
  void* handle = dlopen(file.c_str(), RTLD_NOW | RTLD_LOCAL | RTLD_NODELETE);
  if (!handle)
    throw Error(file.string(), fmt::format("cannot be loaded ({})", dlerror()),
                fmt::format("install {}", library.needs));
  return dlsym(handle, library.factory);
}

}  // namespace scree::files
