#include <csignal>
#include <cstdlib>
#include <stdexcept>
#include <sys/wait.h>
#include <unistd.h>

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
