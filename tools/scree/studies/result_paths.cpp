#include "studies/result_paths.hpp"

namespace scree::tool {

namespace fs = std::filesystem;

fs::path resolved(const fs::path& path) {
  std::error_code failed;
  const fs::path absolute = fs::current_path() / path;  // the current one if it is empty
  const fs::path whole = fs::weakly_canonical(absolute, failed);
  return failed ? absolute.lexically_normal() : whole;
}

std::string relative_to(const fs::path& folder, const fs::path& path) {
  return resolved(path).lexically_relative(resolved(folder)).generic_string();
}

}  // namespace scree::tool
