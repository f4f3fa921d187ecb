#include "movie.hpp"

#include "temporary_file.hpp"

#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <fcntl.h>
#include <spawn.h>
#include <sstream>
#include <string>
#include <sys/wait.h>
#include <unistd.h>

#include <fmt/format.h>

#include <scree/error.hpp>
#include <scree/files/text.hpp>
#include <scree/files/text_file.hpp>

namespace scree::tool {

namespace fs = std::filesystem;

namespace {

// Ends of a pipe, closed in the program that is started.
struct Pipe {
  int ends[2] = {-1, -1};
  Pipe() {
    if (pipe2(ends, O_CLOEXEC) != 0)
      throw Error("no pipe to ffmpeg can be opened; close other files", ExitStatus::failure);
  }
  ~Pipe() {
    close_end(0);
    close_end(1);
  }
  Pipe(const Pipe&) = delete;
  Pipe& operator=(const Pipe&) = delete;
  void close_end(int which) {
    if (ends[which] >= 0) close(ends[which]);
    ends[which] = -1;
  }
};

// Writing to a program that has ended is an error, not the end of this one.
struct NoPipeSignal {
  void (*before)(int) = std::signal(SIGPIPE, SIG_IGN);
  NoPipeSignal() = default;
  ~NoPipeSignal() { std::signal(SIGPIPE, before); }
  NoPipeSignal(const NoPipeSignal&) = delete;
  NoPipeSignal& operator=(const NoPipeSignal&) = delete;
};

// A program that is waited for.
struct Process {
  pid_t id = -1;
  Process() = default;
  ~Process() { wait(); }
  Process(const Process&) = delete;
  Process& operator=(const Process&) = delete;
  // Its status, once.
  int wait() {
    int status = 0;
    while (id > 0 && waitpid(id, &status, 0) < 0 && errno == EINTR) {
    }
    id = -1;
    return status;
  }
};

// The pictures are its standard input; its messages go to a file.
pid_t start_ffmpeg(const Pipe& pictures, int frames_per_second, const fs::path& movie,
                   const TemporaryFile& log) {
  const std::string rate = std::to_string(frames_per_second), target = fs::absolute(movie).string();
  // Even sizes and this pixel format are what common players take.
  const char* words[] = {"ffmpeg",   "-y",         "-loglevel",    "error",
                         "-f",       "image2pipe", "-framerate",   rate.c_str(),
                         "-i",       "-",          "-vf",          "pad=ceil(iw/2)*2:ceil(ih/2)*2",
                         "-pix_fmt", "yuv420p",    target.c_str(), nullptr};
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, pictures.ends[0], STDIN_FILENO);
  posix_spawn_file_actions_adddup2(&actions, log.descriptor, STDOUT_FILENO);
  posix_spawn_file_actions_adddup2(&actions, STDOUT_FILENO, STDERR_FILENO);
  pid_t process = -1;
  const int failed = posix_spawnp(&process, words[0], &actions, nullptr, const_cast<char**>(words), environ);
  posix_spawn_file_actions_destroy(&actions);
  if (failed)
    throw Error(fmt::format("ffmpeg cannot be started ({}); install it", std::strerror(failed)),
                ExitStatus::failure);
  return process;
}

// False if the reader has ended.
bool send(int descriptor, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t written = write(descriptor, bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) return false;
    bytes.remove_prefix(std::size_t(written));
  }
  return true;
}

std::string last_line(const fs::path& log) {
  std::istringstream lines(files::read_text(log));
  std::string last;
  for (std::string line; std::getline(lines, line);)
    if (!line.empty()) last = line;
  return files::one_line(last, 300);
}

}  // namespace

void require_ffmpeg(const fs::path& movie) {
  std::error_code failed;
  if (const fs::path folder = fs::absolute(movie).parent_path(); !fs::is_directory(folder, failed))
    throw Error(fmt::format("--movie {}: there is no folder {}; create it", movie.string(), folder.string()));
  const char* path = std::getenv("PATH");
  std::istringstream folders(path ? path : "");
  for (std::string folder; std::getline(folders, folder, ':');)
    if (access((folder + "/ffmpeg").c_str(), X_OK) == 0) return;
  throw Error(
      "--movie: the program ffmpeg is not on the PATH; install it (apt install ffmpeg), or leave --movie "
      "out and join the pictures elsewhere");
}

void write_movie(const std::vector<fs::path>& pictures, int frames_per_second, const fs::path& movie) {
  const NoPipeSignal no_signal;
  const TemporaryFile log;
  Process ffmpeg;
  Pipe input;  // closed before the wait
  ffmpeg.id = start_ffmpeg(input, frames_per_second, movie, log);
  input.close_end(0);
  for (const fs::path& picture : pictures)
    if (!send(input.ends[1], files::read_text(picture))) break;
  input.close_end(1);
  const int status = ffmpeg.wait();
  const std::string message = last_line(log.path);
  if (!WIFEXITED(status) || WEXITSTATUS(status) != 0)
    throw Error(fmt::format("{}: ffmpeg failed ({}); give a name that ends in .mp4 in a folder that exists",
                            movie.string(), message.empty() ? "without a message" : message),
                ExitStatus::failure);
}

}  // namespace scree::tool
