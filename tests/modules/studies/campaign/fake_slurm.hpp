#pragma once

#include "temporary_folder.hpp"

#include <cstdlib>
#include <string>
#include <vector>

namespace scree::test {

// Commands of Slurm in front of PATH that do what files in a folder say, and keep how they were called.
class FakeSlurm {
 public:
  FakeSlurm() {
    const char* before = std::getenv("PATH");
    path_ = before ? before : "";
    setenv("PATH", (folder_.path().string() + ":" + path_).c_str(), 1);
    write("config", "MaxArraySize            = 1001\n");
    write("queue", "");
    write("states", "");
    // Jobs 101, 102, ...; after as many as `allowed` says, the last line of sbatch is `reason`.
    command("sbatch",
            "n=$(($(ls calls | wc -l) + 1))\n"
            "if [ -e allowed ] && [ $n -gt $(cat allowed) ]; then cat reason >&2; exit 1; fi\n"
            "printf '%s\\n' \"$@\" > calls/$n; if [ -e kept ]; then cp \"$(cat kept)\" kept-$n; fi\n"
            "echo 'sbatch: the site says good morning' >&2; echo $((100 + n))\n");
    command("squeue", "if [ -e closed ]; then echo 'squeue: error: no answer' >&2; exit 1; fi\ncat queue\n");
    command("scontrol", "case $* in *config) cat config ;; *) cat states ;; esac\n");
    std::filesystem::create_directory(folder_ / "calls");
  }
  ~FakeSlurm() { setenv("PATH", path_.c_str(), 1); }
  FakeSlurm(const FakeSlurm&) = delete;
  FakeSlurm& operator=(const FakeSlurm&) = delete;

  void write(const std::string& name, const std::string& text) const { folder_.write(name, text); }
  // Keeps a copy of a file whenever sbatch is called.
  void keep(const std::filesystem::path& file) const { write("kept", file.string()); }
  std::string kept(std::size_t call) const { return text_of(folder_ / ("kept-" + std::to_string(call))); }
  void remove(const std::string& name) const { std::filesystem::remove(folder_ / name); }
  // From the call `number` on, counted from 1, sbatch refuses with this reason.
  void refuse(std::size_t number, const std::string& reason) const {
    write("allowed", std::to_string(number - 1));
    write("reason", reason + "\n");
  }
  std::size_t calls() const {
    std::size_t count = 0;
    for ([[maybe_unused]] const auto& call : std::filesystem::directory_iterator(folder_ / "calls")) ++count;
    return count;
  }
  // Words of a call of sbatch, counted from 1, each between line breaks.
  std::string call(std::size_t number) const {
    return "\n" + text_of(folder_ / ("calls/" + std::to_string(number)));
  }
  bool has(std::size_t number, const std::string& word) const {
    return call(number).find("\n" + word + "\n") != std::string::npos;
  }

 private:
  void command(const std::string& name, const std::string& text) const {
    write(name, "#!/bin/sh\ncd " + folder_.path().string() + "\n" + text);
    std::filesystem::permissions(folder_ / name, std::filesystem::perms::owner_all);
  }

  TemporaryFolder folder_;
  std::string path_;
};

}  // namespace scree::test
