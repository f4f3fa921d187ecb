#include <algorithm>
#include <cerrno>
#include <cstring>
#include <sstream>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <fmt/format.h>

#include <scree/files/descriptor.hpp>
#include <scree/files/place_error.hpp>
#include <scree/files/text.hpp>
#include <scree/files/text_file.hpp>
#include <scree/run/run_directory.hpp>
#include <scree/run/written_files.hpp>

namespace scree::run {

namespace fs = std::filesystem;

namespace {

// Of states in the list, beyond which those that were removed are dropped from it.
constexpr std::size_t most_states = 64;

std::vector<std::string> lines_of(const std::string& text) {
  std::istringstream stream(text);
  std::vector<std::string> lines;
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

// Whether the path is relative and stays below its directory by its text alone.
bool stays_below(const std::string& file) {
  const fs::path path(file);
  const auto is_odd = [](const fs::path& part) { return part.empty() || part == "." || part == ".."; };
  const bool is_plain = std::none_of(file.begin(), file.end(), [](unsigned char c) { return c < 0x20; });
  return is_plain && !file.empty() && path.is_relative() && std::none_of(path.begin(), path.end(), is_odd);
}

bool leads_through_link(const fs::path& directory, const fs::path& folder) {
  std::error_code failed;
  fs::path path = directory;
  return std::any_of(folder.begin(), folder.end(), [&](const fs::path& part) {
    return fs::is_symlink(fs::symlink_status(path /= part, failed));
  });
}

bool is_state(const std::string& file) {
  return file.starts_with(std::string(WrittenFiles::states_folder) + '/');
}

void check_lines(const fs::path& directory, const std::vector<std::string>& lines) {
  std::unordered_set<std::string> checked;
  for (std::size_t k = 0; k < lines.size(); ++k) {
    const std::string folder = fs::path(lines[k]).parent_path().string();
    if (stays_below(lines[k]) && (!checked.insert(folder).second || !leads_through_link(directory, folder)))
      continue;
    throw files::PlaceError(fmt::format("{}:{}", (directory / WrittenFiles::file_name).string(), k + 1),
                            fmt::format("'{}' leads out of the directory", files::one_line(lines[k])),
                            "remove the line or the link");
  }
}

void remove_file(const fs::path& path) {
  if (unlink(path.c_str()) == 0 || errno == ENOENT || errno == ENOTDIR) return;
  throw files::PlaceError(path.string(), fmt::format("cannot be removed ({})", std::strerror(errno)),
                          "check its permissions", ExitStatus::failure);
}

void remove_empty_folders(const fs::path& directory, const fs::path& file) {
  for (fs::path folder = file.parent_path(); !folder.empty(); folder = folder.parent_path())
    rmdir((directory / folder).c_str());
}

}  // namespace

// The list, created if it is not there, open at its end, and locked until this object is destroyed.
class WrittenFiles::OpenList {
 public:
  // Throws Error (failure).
  explicit OpenList(const fs::path& path) : path_(path) {
    // Another process may have replaced or removed it before it was locked.
    constexpr int max_attempts = 100;
    for (int k = 0; k == 0 || (k < max_attempts && !files::is_at(file_, path.c_str())); ++k) {
      file_ = files::append_file(path.c_str());
      if (!file_.is_open()) throw_unwritable(path, errno);
      while (flock(file_.get(), LOCK_EX) != 0 && errno == EINTR) {
      }
    }
  }

  std::uint64_t size() const {
    struct stat now {};
    return fstat(file_.get(), &now) == 0 ? std::uint64_t(now.st_size) : 0;
  }
  // Shorter only: a file of which lines were lost is not to be filled with zeros.
  void cut(std::uint64_t size) const {
    if (size < this->size() && ftruncate(file_.get(), off_t(size)) != 0) throw_unwritable(path_, errno);
  }
  void append(const std::string& line) const {
    if (const int code = files::write_all(file_, line)) throw_unwritable(path_, code);
  }

 private:
  const fs::path path_;
  files::Descriptor file_;
};

WrittenFiles::WrittenFiles(fs::path directory) : directory_(std::move(directory)) { read(); }

void WrittenFiles::read() {
  const std::string all = text();
  const std::vector<std::string> lines = lines_of(all);
  check_lines(directory_, lines);
  size_ = all.size();
  steady_size_ = states_ = 0;
  for (const std::string& line : lines) is_state(line) ? ++states_ : steady_size_ += line.size() + 1;
  listed_ = {lines.begin(), lines.end()};
}

// Up to the last line that is complete.
std::string WrittenFiles::text() const {
  const fs::path path = directory_ / file_name;
  std::error_code failed;
  const fs::file_status status = fs::symlink_status(path, failed);
  if (status.type() == fs::file_type::not_found) return "";
  if (!fs::is_regular_file(status)) throw files::PlaceError(path.string(), "is not a file", "remove it");
  std::string text = files::read_text(path);
  text.resize(text.rfind('\n') + 1);
  return text;
}

fs::path WrittenFiles::add(const std::string& file) {
  const fs::path path = directory_ / file;
  if (contains(file)) return path;
  if (is_state(file) && states_ >= most_states) forget_removed_states();
  list(OpenList(directory_ / file_name), file);
  return path;
}

void WrittenFiles::put(const std::string& file, std::string_view text) {
  const fs::path path = directory_ / file;
  const OpenList open_list(directory_ / file_name);
  read();  // it may have been dropped from the list
  list(open_list, file);
  std::error_code failed;  // a folder that is missing is reported with the file
  fs::create_directory(path.parent_path(), failed);
  files::write_atomically(path, text);
}

void WrittenFiles::list(const OpenList& list, const std::string& file) {
  // Another process may have added lines meanwhile, or one that was killed half of one.
  if (list.size() != size_) read();
  if (contains(file)) return;
  check_new(file);
  list.cut(size_);
  list.append(file + '\n');
  size_ += file.size() + 1;
  is_state(file) ? ++states_ : steady_size_ += file.size() + 1;
  listed_.insert(file);
}

void WrittenFiles::check_new(const std::string& file) const {
  const fs::path path = directory_ / file;
  std::error_code failed;
  if (!stays_below(file) || fs::exists(fs::symlink_status(path, failed)))
    throw files::PlaceError(path.string(), "is there and was not written by a run", "move it elsewhere",
                            ExitStatus::failure);
  if (leads_through_link(directory_, fs::path(file).parent_path()))
    throw files::PlaceError(path.string(), "its folder is a symbolic link, which is not followed",
                            "remove it", ExitStatus::failure);
}

void WrittenFiles::forget_removed_states() {
  const fs::path path = directory_ / file_name;
  const OpenList list(path);
  const auto is_there = [this](const std::string& file) {
    std::error_code failed;
    return fs::exists(fs::symlink_status(directory_ / file, failed));
  };
  std::string kept;
  for (const std::string& line : lines_of(text()))
    if (!is_state(line) || is_there(line) || is_there(line + files::part_suffix)) kept += line + '\n';
  files::write_atomically(path, kept);
  read();
}

// In bytes, of the line at which size() was this and of the states that follow it.
std::uint64_t WrittenFiles::end_of_line_at(const std::string& all, std::uint64_t size) const {
  if (size == 0) return 0;
  std::uint64_t end = 0, steady = 0;
  for (const std::string& line : lines_of(all)) {
    if (!is_state(line) && steady >= size) break;
    steady += is_state(line) ? 0 : line.size() + 1;
    end += line.size() + 1;
  }
  if (steady != size)
    throw Error(fmt::format(
        "{}: has no line that ends where the state says; the directory was changed, start the run again",
        (directory_ / file_name).string()));
  return end;
}

void WrittenFiles::return_to(std::uint64_t size) {
  const fs::path list = directory_ / file_name;
  const OpenList open_list(list);
  const std::string all = text();
  const std::uint64_t end = end_of_line_at(all, size);
  const std::vector<std::string> kept = lines_of(all.substr(0, end)), dropped = lines_of(all.substr(end));
  check_lines(directory_, dropped);
  std::unordered_set<std::string> remaining(kept.begin(), kept.end());
  for (auto file = dropped.rbegin(); file != dropped.rend(); ++file) {
    if (remaining.contains(*file)) continue;
    remove_file(directory_ / *file);
    remove_file(directory_ / (*file + files::part_suffix));
    remove_empty_folders(directory_, *file);
  }
  if (size == 0)
    remove_file(list);
  else
    open_list.cut(end);
  size_ = end;
  steady_size_ = size;
  states_ = std::size_t(std::count_if(remaining.begin(), remaining.end(), is_state));
  listed_ = std::move(remaining);
}

}  // namespace scree::run
