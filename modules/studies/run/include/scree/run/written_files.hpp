#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <unordered_set>

namespace scree::run {

// The list of the files that runs wrote into a directory, in the directory itself: one relative path per
// line, there before the file is. Only what is listed is ever removed. Several processes may add lines, as
// `scree render` does beside a run: the list is locked meanwhile.
class WrittenFiles {
 public:
  static constexpr const char* file_name = "written.txt";
  // How many files are in this folder depends on the wall time.
  static constexpr const char* states_folder = "checkpoint";

  // Reads the list; empty if there is none. Throws Error if it cannot be read, or a line leads out of the
  // directory: it is absolute, contains "..", or leads through a symbolic link.
  explicit WrittenFiles(std::filesystem::path directory);

  bool contains(const std::string& file) const { return listed_.contains(file); }
  // Lists a file, unless it is listed. Returns its path. Throws Error (failure) if there is a file of that
  // name that is not listed, its folder is a symbolic link, or the list cannot be written. Of many states,
  // those that were removed since are no longer listed then.
  std::filesystem::path add(const std::string& file);

  // Lists a file if it is not, and writes it before another process can remove what is listed: for one that
  // does not have the directory, as `scree render` beside a run. Throws as add(), and WriteError.
  void put(const std::string& file, std::string_view text);

  bool empty() const { return listed_.empty(); }
  // Bytes of the lines so far but for those of states_folder: the same in all runs of a scene.
  std::uint64_t size() const { return steady_size_; }
  // Removes the files listed behind the line at which size() was this, and the states that follow it, and not
  // before; the last first, then folders that are empty; and cuts the list there. At 0 the list is removed
  // too. Throws Error if no line ends there, Error (failure) if a file cannot be removed.
  void return_to(std::uint64_t size);

 private:
  class OpenList;
  std::string text() const;
  void read();
  void list(const OpenList& list, const std::string& file);
  void check_new(const std::string& file) const;
  void forget_removed_states();
  std::uint64_t end_of_line_at(const std::string& all, std::uint64_t size) const;

  std::filesystem::path directory_;
  std::uint64_t size_ = 0, steady_size_ = 0;  // with and without the states; of whole lines
  std::size_t states_ = 0;                    // lines
  std::unordered_set<std::string> listed_;
};

}  // namespace scree::run
