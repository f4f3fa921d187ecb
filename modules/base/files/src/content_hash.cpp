#include <cstdio>
#include <filesystem>
#include <map>
#include <memory>
#include <sys/stat.h>
#include <tuple>
#include <vector>

#include <fmt/format.h>

#include <scree/files/checksum.hpp>
#include <scree/files/content_hash.hpp>

namespace scree::files {

namespace {

// Checksum of a content and its size, since the last piece is filled with zeros.
class Hasher {
 public:
  void add(std::string_view piece) {
    size_ += piece.size();
    checksum_.add(piece.data(), piece.size());
  }
  std::string value() {
    checksum_.add(&size_, sizeof size_);
    return fmt::format("{:016x}", checksum_.value());
  }

 private:
  Checksum checksum_;
  std::uint64_t size_ = 0;
};

// What changes whenever a file is written or replaced, also by one with an older date.
using Version = std::tuple<dev_t, ino_t, off_t, time_t, long>;

std::string read_and_hash(const std::filesystem::path& path) {
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::fopen(path.c_str(), "rb"), std::fclose);
  if (!file) return "";
  Hasher hasher;
  std::vector<char> block(1u << 20);
  while (const std::size_t count = std::fread(block.data(), 1, block.size(), file.get()))
    hasher.add({block.data(), count});
  return std::ferror(file.get()) ? "" : hasher.value();
}

}  // namespace

std::string text_hash(std::string_view text) {
  Hasher hasher;
  hasher.add(text);
  return hasher.value();
}

std::string file_hash(const std::filesystem::path& path) {
  static std::map<std::filesystem::path, std::pair<Version, std::string>> known;
  struct stat found {};
  // Opening a pipe would wait for a writer.
  if (stat(path.c_str(), &found) != 0 || !S_ISREG(found.st_mode)) return "";
  const Version version = {found.st_dev, found.st_ino, found.st_size, found.st_ctim.tv_sec,
                           found.st_ctim.tv_nsec};
  auto& [of, hash] = known[path];
  if (hash.empty() || of != version) {
    of = version;
    hash = read_and_hash(path);
  }
  return hash;
}

}  // namespace scree::files
