#include "seal.hpp"

#include <cerrno>
#include <charconv>
#include <cstring>
#include <optional>
#include <string_view>
#include <sys/stat.h>
#include <unistd.h>
#include <vector>

#include <fmt/format.h>

#include <scree/counted.hpp>
#include <scree/error.hpp>
#include <scree/files/checksum.hpp>
#include <scree/files/text.hpp>

namespace scree::state_file {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view title = "scree state\nformat ";

[[noreturn]] void refuse_damaged(const fs::path& path) {
  throw Error(path.string(), "is damaged: its bytes do not match its checksum", "take another copy of it");
}

std::uint64_t size_of(int descriptor, const fs::path& path) {
  struct stat status = {};
  if (::fstat(descriptor, &status) != 0)
    throw Error(path.string(), fmt::format("cannot be read ({})", std::strerror(errno)), "check the disk");
  return std::uint64_t(status.st_size);
}

void read_at(int descriptor, char* to, std::size_t bytes, std::uint64_t from, const fs::path& path) {
  while (bytes > 0) {
    const ssize_t count = ::pread(descriptor, to, bytes, off_t(from));
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0)
      throw Error(path.string(), "cannot be read to its end",
                  "check the disk, and that nothing is writing the file");
    to += count;
    from += std::uint64_t(count);
    bytes -= std::size_t(count);
  }
}

// Checksum of a file with this seal: of the seal, with 0 for the checksum itself, and of all bytes after it.
std::uint64_t checksum_of(int descriptor, Seal seal, const fs::path& path) {
  constexpr std::size_t block_size = 1u << 20;
  files::Checksum checksum;
  seal.checksum = 0;
  checksum.add(seal.text().data(), Seal::size);
  std::vector<char> block(block_size);
  for (std::uint64_t at = Seal::size; at < seal.bytes; at += block_size) {
    const auto count = std::size_t(std::min<std::uint64_t>(block_size, seal.bytes - at));
    read_at(descriptor, block.data(), count, at, path);
    checksum.add(block.data(), count);
  }
  return checksum.value();
}

// Takes the first line off the text if it begins with the name. Returns the rest of the line.
std::optional<std::string_view> take_line(std::string_view& text, std::string_view name) {
  const std::size_t end = text.find('\n');
  if (!text.starts_with(name) || end == text.npos || end < name.size()) return std::nullopt;
  const std::string_view value = text.substr(name.size(), end - name.size());
  text.remove_prefix(end + 1);
  return value;
}

template <class Number>
std::optional<Number> number_of(std::optional<std::string_view> text, int base) {
  Number number = 0;
  if (!text) return std::nullopt;
  const auto [end, failed] = std::from_chars(text->data(), text->data() + text->size(), number, base);
  if (failed != std::errc() || end != text->data() + text->size()) return std::nullopt;
  return number;
}

Seal parse(std::string_view text, const fs::path& path) {
  if (!text.starts_with(title))
    throw Error(path.string(), "is not a state file of scree", "give one that scree has written");
  take_line(text, "");
  const auto format = number_of<int>(take_line(text, "format "), 10);
  const auto version = take_line(text, "written by scree ");
  if (!format) refuse_damaged(path);
  if (*format < Seal::oldest || *format > Seal::newest)
    throw Error(path.string(),
                fmt::format("has format {}, and this scree reads formats {} to {}", *format, Seal::oldest,
                            Seal::newest),
                fmt::format("use the version that has written it, {}",
                            files::one_line(version.value_or("which it does not say"), 40)));
  const auto bytes = number_of<std::uint64_t>(take_line(text, "bytes "), 10);
  const auto checksum = number_of<std::uint64_t>(take_line(text, "checksum "), 16);
  if (!version || !bytes || !checksum) refuse_damaged(path);
  return {*format, std::string(*version), *bytes, *checksum};
}

}  // namespace

std::string Seal::text() const {
  std::string text = fmt::format(
      "{}{}\nwritten by scree {}\nbytes {}\nchecksum {:016x}\n"
      "An HDF5 file begins after these {} bytes: scree describe, h5dump and h5py show what is in it.\n",
      title, format, program_version, bytes, checksum, size);
  text.resize(size, ' ');
  text.back() = '\n';
  return text;
}

void write_seal(int descriptor, const fs::path& path) {
  Seal seal = {.program_version = SCREE_VERSION, .bytes = size_of(descriptor, path)};
  seal.checksum = checksum_of(descriptor, seal, path);
  const std::string text = seal.text();
  if (::pwrite(descriptor, text.data(), text.size(), 0) != ssize_t(text.size()))
    throw Error(path.string(), fmt::format("cannot be written ({})", std::strerror(errno)), "check the disk",
                ExitStatus::failure);
}

Seal checked_seal(int descriptor, const fs::path& path) {
  const std::uint64_t bytes = size_of(descriptor, path);
  if (bytes == 0) throw Error(path.string(), "is empty", "take another copy of it");
  std::string text(std::size_t(std::min<std::uint64_t>(bytes, Seal::size)), '\0');
  read_at(descriptor, text.data(), text.size(), 0, path);
  const Seal seal = parse(text, path);
  if (bytes != seal.bytes)
    throw Error(path.string(),
                fmt::format("has {}, and {} when it was written", counted(bytes, "byte"), seal.bytes),
                "take another copy of it");
  if (text != seal.text() || checksum_of(descriptor, seal, path) != seal.checksum) refuse_damaged(path);
  return seal;
}

}  // namespace scree::state_file
