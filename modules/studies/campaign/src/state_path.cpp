#include <cstdlib>

#include <fmt/format.h>

#include <scree/campaign/state_path.hpp>
#include <scree/error.hpp>

namespace scree::campaign {

namespace {
constexpr const char* variable = "SCREE_STATE_PATH";
}

StatePath::StatePath(const std::filesystem::path& folder) {
  if (folder.string().find(':') != std::string::npos)
    throw Error(
        fmt::format("{}: the path of a campaign with [prepare] cannot contain ':'; give another --out",
                    folder.parent_path().string()));
  if (const char* before = std::getenv(variable)) before_ = before;
  setenv(variable, (folder.string() + (before_ ? ":" + *before_ : "")).c_str(), 1);
}

StatePath::~StatePath() { before_ ? setenv(variable, before_->c_str(), 1) : unsetenv(variable); }

}  // namespace scree::campaign
