#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <fmt/format.h>

#include <scree/error.hpp>
#include <scree/run/line_file.hpp>
#include <scree/run/run_directory.hpp>

namespace scree::run {

namespace {

constexpr std::size_t buffer_size = 1u << 14;

Error unusable(const std::filesystem::path& path, const std::string& problem) {
  return Error(fmt::format("{}: {}; restore the file, or start the run again from its beginning",
                           path.string(), problem));
}

}  // namespace

LineFile::LineFile(const std::filesystem::path& path) : path_(path) {
  std::error_code failed;  // a failure is reported when the file is opened
  std::filesystem::create_directories(path.parent_path(), failed);
  file_ = files::create_file(path.c_str());
  if (!file_.is_open()) throw_unwritable(path, errno);
}

LineFile::LineFile(const std::filesystem::path& path, std::uint64_t bytes)
    : path_(path), file_(open(path.c_str(), O_RDWR | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC)), bytes_(bytes) {
  if (!file_.is_open()) throw unusable(path, fmt::format("cannot be opened ({})", std::strerror(errno)));
  struct stat now {};
  if (fstat(file_.get(), &now) != 0 || !S_ISREG(now.st_mode)) throw unusable(path, "is not a file");
  if (std::uint64_t(now.st_size) < bytes)
    throw unusable(path, "is shorter than when the checkpoint was written");
  char last = 0;
  if (bytes == 0 || pread(file_.get(), &last, 1, off_t(bytes) - 1) != 1 || last != '\n')
    throw unusable(path, "has no line that ends where the last one ended when the checkpoint was written");
  lseek(file_.get(), off_t(bytes), SEEK_SET);
}

void LineFile::cut() {
  if (ftruncate(file_.get(), off_t(bytes_)) != 0) throw_unwritable(path_, errno);
}

void LineFile::add(std::string_view line) {
  buffer_ += line;
  if (buffer_.size() >= buffer_size) flush();
}

void LineFile::flush() {
  const std::string lines = std::exchange(buffer_, {});
  if (!lines.empty() && !files::is_at(file_, path_.c_str()))
    throw Error(
        fmt::format(
            "{}: was moved or removed while it was written, and the lines that follow are lost; put it back "
            "and give scree resume, or start again",
            path_.string()),
        ExitStatus::failure);
  const int code = files::write_all(file_, lines);
  if (!code) {
    bytes_ += lines.size();
    return;
  }
  const off_t end = lseek(file_.get(), 0, SEEK_CUR);
  const std::size_t written = end < off_t(bytes_) ? 0 : std::size_t(end) - bytes_;
  bytes_ += lines.substr(0, written).rfind('\n') + 1;
  if (ftruncate(file_.get(), off_t(bytes_)) == 0) lseek(file_.get(), off_t(bytes_), SEEK_SET);
  throw_unwritable(path_, code);
}

}  // namespace scree::run
