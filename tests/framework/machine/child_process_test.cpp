#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <fcntl.h>
#include <stdexcept>
#include <string>
#include <sys/wait.h>
#include <unistd.h>
#include <vector>

#include <catch2/catch.hpp>

#include <scree/child_process.hpp>

using scree::ChildEnd;
using scree::in_child;
using scree::Send;

TEST_CASE("work in a child process sends what it finds") {
  const std::string large(1'000'000, 'x');  // more than a pipe holds
  const ChildEnd end = in_child([&](const Send& send) {
    send("first ");
    send(large);
  });
  CHECK(end.how == ChildEnd::returned);
  CHECK(end.sent == "first " + large);
}

TEST_CASE("whatever ends work in a child process is told, with what was sent before") {
  const auto text_after = [](const auto& deed, ChildEnd::How how) {
    const ChildEnd end = in_child([&](const Send& send) {
      send("begun");
      deed();
    });
    CHECK(end.how == how);
    CHECK(end.sent == "begun");
    return end.text();
  };
  CHECK(text_after([] { _exit(0); }, ChildEnd::exited) == "status 0");
  CHECK(text_after([] { _exit(7); }, ChildEnd::exited) == "status 7");
  CHECK(text_after([] { std::raise(SIGSEGV); }, ChildEnd::signalled) == "signal 11, Segmentation fault");
  CHECK(text_after([] { std::raise(SIGABRT); }, ChildEnd::signalled) == "signal 6, Aborted");
  CHECK(text_after([] { throw std::runtime_error("boo"); }, ChildEnd::threw) == "an exception (boo)");
  CHECK(text_after([] { throw 42; }, ChildEnd::threw) == "an exception (of unknown type)");
}

TEST_CASE("work that loops, or stops its process, is ended after its time") {
  for (const bool stops : {false, true}) {
    const ChildEnd end = in_child(
        [&](const Send&) {
          if (stops) std::raise(SIGSTOP);
          for (;;) pause();
        },
        {.seconds = 0.1});
    CHECK(end.how == ChildEnd::out_of_time);
    CHECK(end.text() == "no end within 0.1 s");
  }
  CHECK(waitpid(-1, nullptr, WNOHANG) < 0);  // no child is left
}

TEST_CASE("a process that outlives its parent in a child process is not waited for") {
  const auto work = [](const Send& send) {
    if (fork() == 0) {
      sleep(6);
      _exit(0);
    }
    send("done");
  };
  const ChildEnd end = in_child(work, {.seconds = 5});
  CHECK(end.how == ChildEnd::returned);
  CHECK(end.sent == "done");
}

namespace {

// What a program writes into a pipe until all its copies of the pipe are closed.
std::string output_of(const std::vector<std::string>& words, scree::ProgramOptions options, int* status) {
  int ends[2];
  REQUIRE(pipe2(ends, O_CLOEXEC) == 0);
  options.output = ends[1];
  const scree::StartedProgram started = scree::start_program(words, options);
  close(ends[1]);
  REQUIRE(started.process > 0);
  std::string text;
  for (char c; read(ends[0], &c, 1) == 1;) text += c;
  close(ends[0]);
  *status = scree::wait_for(started.process);
  return text;
}

}  // namespace

TEST_CASE("a program is started by its path or its name, with its output in a descriptor") {
  int status = 0;
  CHECK(output_of({"/bin/sh", "-c", "echo out; echo err >&2; exit 3"}, {}, &status) == "out\nerr\n");
  CHECK(WEXITSTATUS(status) == 3);
  // Its standard input is empty, and its group has its own number: the fifth field, after the name in
  // brackets.
  const std::string group =
      output_of({"sh", "-c", "cat; set -- $(cat /proc/$$/stat); test $5 = $$ && echo own"},
                {.own_group = true}, &status);
  CHECK(group == "own\n");
}

TEST_CASE("a program that cannot be executed is told from the lack of processes, and leaves no process") {
  const scree::StartedProgram none = scree::start_program({"/no/such/program"});
  CHECK(none.process == -1);
  CHECK(none.no_process == 0);
  CHECK(none.not_executed == ENOENT);
  CHECK(waitpid(-1, nullptr, WNOHANG) < 0);
}

TEST_CASE("a program has the descriptors that it inherits, and no others") {
  int ends[2];
  REQUIRE(pipe2(ends, O_CLOEXEC) == 0);
  const std::string test = "test -e /proc/self/fd/" + std::to_string(ends[1]);
  const auto has = [&](const scree::ProgramOptions& options) {
    return WEXITSTATUS(scree::wait_for(scree::start_program({"/bin/sh", "-c", test}, options).process)) == 0;
  };
  CHECK(has({.inherited = {ends[1]}}));
  CHECK_FALSE(has({}));
  close(ends[0]);
  close(ends[1]);
}
