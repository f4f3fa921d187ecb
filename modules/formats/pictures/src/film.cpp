#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <sstream>
#include <string>
#include <unistd.h>

#include <fmt/format.h>

#include <scree/child_process.hpp>
#include <scree/error.hpp>
#include <scree/files/temporary_file.hpp>
#include <scree/files/text.hpp>
#include <scree/files/text_file.hpp>
#include <scree/pictures/film.hpp>

namespace scree::pictures {

namespace fs = std::filesystem;

namespace {

// A folder with links to the pictures that ffmpeg reads in order, removed at the end of its scope.
struct NumberedPictures {
  std::string path = (fs::temp_directory_path() / "scree-XXXXXX").string();

  explicit NumberedPictures(const std::vector<fs::path>& pictures) {
    if (!mkdtemp(path.data()))
      throw Error(fmt::format("{}: cannot be created ({}); free space there", path, std::strerror(errno)),
                  ExitStatus::failure);
    for (std::size_t k = 0; k < pictures.size(); ++k)
      fs::create_symlink(fs::absolute(pictures[k]), fmt::format("{}/{:06}.png", path, k));
  }
  ~NumberedPictures() {
    std::error_code failed;
    fs::remove_all(path, failed);
  }
  NumberedPictures(const NumberedPictures&) = delete;
  NumberedPictures& operator=(const NumberedPictures&) = delete;
};

// In a child process: becomes ffmpeg, whose messages go to a file.
void become_ffmpeg(const std::string& folder, int frames_per_second, const std::string& film, int log) {
  dup2(log, STDOUT_FILENO);
  dup2(log, STDERR_FILENO);
  const std::string rate = std::to_string(frames_per_second);
  // Even sizes and this pixel format are what common players take.
  const char* words[] = {"ffmpeg",
                         "-nostdin",
                         "-y",
                         "-loglevel",
                         "error",
                         "-framerate",
                         rate.c_str(),
                         "-i",
                         "%06d.png",
                         "-vf",
                         "pad=ceil(iw/2)*2:ceil(ih/2)*2",
                         "-pix_fmt",
                         "yuv420p",
                         film.c_str(),
                         nullptr};
  if (chdir(folder.c_str()) == 0) execvp(words[0], const_cast<char**>(words));
  throw Error(fmt::format("cannot be started, {}", std::strerror(errno)));
}

std::string last_line(const fs::path& log) {
  std::istringstream lines(files::read_text(log));
  std::string last;
  for (std::string line; std::getline(lines, line);)
    if (!line.empty()) last = line;
  return files::one_line(last, 300);
}

}  // namespace

bool has_ffmpeg() {
  const char* path = std::getenv("PATH");
  std::istringstream folders(path ? path : "");
  for (std::string folder; std::getline(folders, folder, ':');)
    if (access((folder + "/ffmpeg").c_str(), X_OK) == 0) return true;
  return false;
}

void write_film(const std::vector<fs::path>& pictures, int frames_per_second, const fs::path& film) {
  const NumberedPictures numbered(pictures);
  const files::TemporaryFile log;
  const std::string target = fs::absolute(film).string();
  const ChildEnd end =
      in_child([&](const Send&) { become_ffmpeg(numbered.path, frames_per_second, target, log.descriptor); });
  if (end.how == ChildEnd::exited && end.number == 0) return;
  const std::string message = last_line(log.path);
  throw Error(fmt::format("{}: ffmpeg failed ({}); give a name that ends in .mp4 in a folder that exists",
                          film.string(),
                          !message.empty()             ? message
                          : end.how == ChildEnd::threw ? end.exception
                                                       : end.text()),
              ExitStatus::failure);
}

}  // namespace scree::pictures
