#pragma once

#include "scene_text.hpp"
#include "temporary_folder.hpp"

#include <cstdlib>
#include <string>
#include <sys/wait.h>

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

namespace scree::test {

// The chain of spheres of scenarios/sound.
inline const std::string chain = text_of(SCREE_TEST_SOURCE "/scenarios/sound/chain.toml");

inline bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

// Result of a call of the program.
struct Outcome {
  int status = -1;  // exit status; 128 + signal if killed by a signal
  std::string out, err;
};

// A temporary folder with scene.toml in which the program is called.
class Workspace {
 public:
  explicit Workspace(const std::string& scene = discs) { folder_.write("scene.toml", scene); }

  // Runs a shell command in which `scree` is the program.
  Outcome shell(const std::string& text) const {
    folder_.write("call.sh", "scree() { '" SCREE_TEST_PROGRAM "' \"$@\"; }\n" + text + "\n");
    const std::string call =
        "cd '" + folder_.path().string() + "' && exec sh call.sh > out.txt 2> err.txt < /dev/null";
    const int ended = std::system(call.c_str());
    const int status = WIFEXITED(ended) ? WEXITSTATUS(ended) : 128 + WTERMSIG(ended);
    return {status, text_of(folder_ / "out.txt"), text_of(folder_ / "err.txt")};
  }
  Outcome scree(const std::string& arguments) const { return shell("scree " + arguments); }
  Outcome run(const std::string& arguments = "") const {
    return scree("run scene.toml --out out " + arguments);
  }

  std::filesystem::path operator/(const std::string& name) const { return folder_ / name; }
  bool has(const std::string& name) const { return std::filesystem::exists(folder_ / name); }
  void write(const std::string& name, const std::string& text) const { folder_.write(name, text); }
  std::string text(const std::string& name) const { return text_of(folder_ / name); }
  nlohmann::json record(const std::string& directory = "out", const std::string& file = "run.json") const {
    return nlohmann::json::parse(text(directory + '/' + file));
  }

 private:
  TemporaryFolder folder_;
};

// Checks that the program refused its input: status 2, one line with the given beginning and end, nothing
// written.
inline void check_refused(const Workspace& w, const Outcome& outcome, const std::string& begin,
                          const std::string& end) {
  INFO(outcome.err);
  CHECK(outcome.status == 2);
  CHECK(outcome.err.starts_with("scree: " + begin));
  CHECK(outcome.err.ends_with(end + "\n"));
  CHECK(outcome.err.find('\n') == outcome.err.size() - 1);
  CHECK(outcome.out.empty());
  CHECK_FALSE(w.has("out"));
}

}  // namespace scree::test
