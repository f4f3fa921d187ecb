#include "seal.hpp"

#include "checksum.hpp"

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
#include <scree/files/text.hpp>

namespace scree::state_file {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view title = "scree state\nformat ";
constexpr std::string_view damaged =
    "is damaged: its bytes do not match its checksum; take another copy of it";

[[noreturn]] void refuse(const fs::path& path, std::string_view problem_and_cure) {
  throw Error(fmt::format("{}: {}", path.string(), problem_and_cure));
}

std::uint64_t size_of(int descriptor, const fs::path& path) {
  struct stat status = {};
  if (::fstat(descriptor, &status) != 0)
    refuse(path, fmt::format("cannot be read ({}); check the disk", std::strerror(errno)));
  return std::uint64_t(status.st_size);
}

void read_at(int descriptor, char* to, std::size_t bytes, std::uint64_t from, const fs::path& path) {
  while (bytes > 0) {
    const ssize_t count = ::pread(descriptor, to, bytes, off_t(from));
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0)
      refuse(path, "cannot be read to its end; check the disk, and that nothing is writing the file");
    to += count, from += std::uint64_t(count), bytes -= std::size_t(count);
  }
}

// Checksum of a file with this seal: of the seal, with 0 for the checksum itself, and of all bytes behind it.
std::uint64_t checksum_of(int descriptor, Seal seal, const fs::path& path) {
  constexpr std::size_t block_size = 1u << 20;
  Checksum checksum;
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

// Cuts the line off the text that begins with the name and a space; the rest of the line.
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
  if (!text.starts_with(title)) refuse(path, "is not a state file of scree; give one that scree has written");
  take_line(text, "");
  const auto format = number_of<int>(take_line(text, "format "), 10);
  const auto version = take_line(text, "written by scree ");
  if (!format) refuse(path, damaged);
  if (*format < Seal::oldest || *format > Seal::newest)
    refuse(
        path,
        fmt::format(
            "has format {}, and this scree reads formats {} to {}; use the version that has written it, {}",
            *format, Seal::oldest, Seal::newest,
            files::one_line(version.value_or("which it does not say"), 40)));
  const auto bytes = number_of<std::uint64_t>(take_line(text, "bytes "), 10);
  const auto checksum = number_of<std::uint64_t>(take_line(text, "checksum "), 16);
  if (!version || !bytes || !checksum) refuse(path, damaged);
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
    throw Error(
        fmt::format("{}: cannot be written ({}); check the disk", path.string(), std::strerror(errno)),
        ExitStatus::failure);
}

Seal checked_seal(int descriptor, const fs::path& path) {
  const std::uint64_t bytes = size_of(descriptor, path);
  if (bytes == 0) refuse(path, "is empty; take another copy of it");
  std::string text(std::size_t(std::min<std::uint64_t>(bytes, Seal::size)), '\0');
  read_at(descriptor, text.data(), text.size(), 0, path);
  const Seal seal = parse(text, path);
  if (bytes != seal.bytes)
    refuse(path, fmt::format("has {}, and {} when it was written; take another copy of it",
                             counted(bytes, "byte"), seal.bytes));
  if (text != seal.text() || checksum_of(descriptor, seal, path) != seal.checksum) refuse(path, damaged);
  return seal;
}

}  // namespace scree::state_file
