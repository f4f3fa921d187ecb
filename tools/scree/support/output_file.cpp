#include "support/output_file.hpp"

#include <system_error>

#include <scree/error.hpp>

namespace scree::tool {

namespace fs = std::filesystem;

void check_output_file(const std::string& option, const fs::path& file, bool overwrite) {
  std::error_code failed;
  const fs::path folder = fs::absolute(file, failed).parent_path();
  if (!fs::is_directory(folder, failed))
    throw Error(file.string(), "there is no folder " + folder.string(),
                "create it, or give another " + option);
  const fs::file_status there = fs::symlink_status(file, failed);
  if (!fs::exists(there)) return;
  if (!fs::is_regular_file(there))
    throw Error(file.string(), "is not a regular file", "give another " + option);
  if (!overwrite)
    throw Error(file.string(), "is there already", "give another " + option + ", or --overwrite");
}

}  // namespace scree::tool
