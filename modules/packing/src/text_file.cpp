#include "text_file.hpp"

#include <fstream>
#include <ios>
#include <new>
#include <stdexcept>
#include <system_error>

#include <fmt/format.h>

#include <scree/error.hpp>

namespace scree::packing {

namespace {

[[noreturn]] void fail(const std::filesystem::path& path, std::string_view message, std::string_view cure) {
  throw Error(fmt::format("{}: {}; {}", path.string(), message, cure));
}

void refuse_compressed(const std::filesystem::path& path, std::string_view text) {
  constexpr std::string_view gzip = "\x1f\x8b";
  constexpr std::string_view zstandard = "\x28\xb5\x2f\xfd";
  if (text.starts_with(gzip)) fail(path, "the file is compressed", "unpack it with gunzip");
  if (text.starts_with(zstandard)) fail(path, "the file is compressed", "unpack it with unzstd");
}

}  // namespace

std::string read_text(const std::filesystem::path& path) {
  std::error_code error;
  const auto status = std::filesystem::status(path, error);
  if (!std::filesystem::exists(status)) fail(path, "there is no such file", "check the path");
  if (!std::filesystem::is_regular_file(status)) fail(path, "is not a regular file", "give a text file");
  const auto size = std::filesystem::file_size(path, error);
  std::ifstream stream(path, std::ios::binary);
  if (error || !stream) fail(path, "cannot be opened", "check its permissions");
  std::string text;
  try {
    text.resize(size);
  } catch (const std::bad_alloc&) {
    fail(path, "does not fit into memory", "reduce it to the part that is needed");
  } catch (const std::length_error&) {
    fail(path, "does not fit into memory", "reduce it to the part that is needed");
  }
  stream.read(text.data(), std::streamsize(size));
  if (stream.gcount() != std::streamsize(size)) {
    fail(path, "cannot be read to its end", "check the disk, and that no program is writing the file");
  }
  refuse_compressed(path, text);
  return text;
}

void write_text(const std::filesystem::path& path, std::string_view text) {
  std::ofstream stream(path, std::ios::binary | std::ios::trunc);
  if (!stream) fail(path, "cannot be opened for writing", "check that its folder exists and is writable");
  stream.write(text.data(), std::streamsize(text.size()));
  stream.close();
  if (!stream) fail(path, "could not be written in full", "check the space on the disk");
}

}  // namespace scree::packing
