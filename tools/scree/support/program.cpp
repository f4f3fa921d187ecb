#include "support/program.hpp"

#include "support/verbs.hpp"

#include <cstdio>
#include <new>

#include <fmt/format.h>

#include <scree/files/program_commit.hpp>

namespace scree::tool {

namespace {

constexpr const char* footer =
    "Example:\n"
    "  scree run scenarios/david2005/quickstart.toml --out runs/first\n"
    "  scree describe linear_spring_dashpot normal_stiffness=5000 normal_damping=0.05\n"
    "Exit status: 0 done, 1 an expectation was not met or the run failed, 2 bad input (nothing written), 3 the run blew up,\n"
    "4 a stage was not reached in time (what it wrote is kept), 130 interrupted (the same).";

constexpr const char* lost_output =
    "standard output cannot be written; free disk space or redirect it elsewhere";

// Output that did not reach its file must not pass for success.
ExitStatus flushed(ExitStatus status) {
  if (std::fflush(stdout) == 0 && !std::ferror(stdout)) return status;
  throw Error(lost_output, ExitStatus::failure);
}

}  // namespace

ExitStatus guarded(const std::function<ExitStatus()>& work) {
  try {
    return flushed(work());
  } catch (const Error& error) {
    return report(error.what(), error.status());
  } catch (const std::bad_alloc&) {
    return report("out of memory; use fewer bodies, fewer samples or a computer with more",
                  ExitStatus::failure);
  } catch (const std::exception& error) {
    if (std::ferror(stdout)) return report(lost_output, ExitStatus::failure);
    return report(
        fmt::format("internal error: {}; please report it together with the scenario", error.what()),
        ExitStatus::failure);
  }
}

ExitStatus run_program(int argc, char** argv, const std::function<void(CommandLine&)>& add_verbs) {
  return guarded([&] {
    CommandLine line("scree: a discrete-element laboratory for granular matter",
                     fmt::format("scree {} (commit {})", SCREE_VERSION, files::program_commit()), footer);
    add_verbs(line);
    return line.run(argc, argv);
  });
}

}  // namespace scree::tool
