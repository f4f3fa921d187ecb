#include "foreign_exit.hpp"
#include "over_ranks.hpp"
#include "program_verbs.hpp"
#include "studies.hpp"
#include "support/program.hpp"

#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <fcntl.h>
#include <unistd.h>

namespace scree::tool {

namespace {

// The next file opened would otherwise get the number of a closed descriptor, and with it what is printed.
void open_closed_descriptors() {
  for (int descriptor = STDIN_FILENO; descriptor <= STDERR_FILENO; ++descriptor)
    if (fcntl(descriptor, F_GETFD) < 0 && open("/dev/null", O_RDWR) < 0) return;
}

ExitStatus main_of(int argc, char** argv) {
  if (refuses_tasks(argc, argv)) return ExitStatus::bad_input;
  const auto do_study = [argc, argv] { return run_study(argc, argv); };
  return run_program(argc, argv, [&](CommandLine& line) {
    add_run_verb(line);
    add_resume_verb(line, do_study);
    add_check_verb(line);
    add_describe_verb(line);
    add_render_verb(line);
    add_chart_verb(line);
    add_report_verb(line);
    add_export_verb(line);
    add_campaign_verb(line);
    add_bench_verb(line);
    add_study_verbs(line, do_study);
    line.moved("response", "is now scree modes, or for quasi-static loads scree quasi-static");
    add_new_plugin_verb(line);
    add_test_plugin_verb(line);
  });
}

}  // namespace

}  // namespace scree::tool

int main(int argc, char** argv) {
  scree::tool::open_closed_descriptors();
  std::signal(SIGXFSZ, SIG_IGN);  // a limit on the size of files is reported where a file is written
  scree::tool::watch_for_exit();
  const int status = int(scree::tool::main_of(argc, argv));
  scree::tool::expect_exit();
  return status;
}
