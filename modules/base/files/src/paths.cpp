#include <scree/files/paths.hpp>

namespace scree::files {

namespace fs = std::filesystem;

fs::path resolved(const fs::path& path) {
  std::error_code failed;
  const fs::path absolute = fs::current_path() / path;
  const fs::path whole = fs::weakly_canonical(absolute, failed);
  return failed ? absolute.lexically_normal() : whole;
}

std::string relative_to(const fs::path& folder, const fs::path& path) {
  return resolved(path).lexically_relative(resolved(folder)).generic_string();
}

}  // namespace scree::files
