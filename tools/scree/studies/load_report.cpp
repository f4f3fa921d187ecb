#include "studies/load_report.hpp"

#include "support/watched_work.hpp"

#include <fmt/format.h>

#include <scree/files/text.hpp>

namespace scree::tool {

ExitStatus report_load(bool quiet,
                       const std::function<quasi_static::FollowedLoad(quasi_static::FollowOptions)>& work) {
  const quasi_static::FollowedLoad load = watch<quasi_static::FollowOptions>(quiet, work);
  const std::string directory = files::escaped(load.directory.string());
  if (!quiet) fmt::print("{}", files::escaped(quasi_static::text_report(load), files::Escapes::lines));
  if (load.interrupted)
    fmt::print("interrupted; results so far are saved, go on with: scree resume {}\n", directory);
  fmt::print("results in {}\n", directory);
  return load.interrupted ? ExitStatus::interrupted : ExitStatus::success;
}

}  // namespace scree::tool
