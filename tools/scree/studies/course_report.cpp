#include "studies/course_report.hpp"

#include "support/watched_work.hpp"

#include <fmt/format.h>

#include <scree/files/text.hpp>

namespace scree::tool {

ExitStatus report_course(bool quiet,
                         const std::function<quasi_static::Course(quasi_static::FollowOptions)>& work) {
  const quasi_static::Course course = watch<quasi_static::FollowOptions>(quiet, work);
  const std::string directory = files::escaped(course.directory.string());
  if (!quiet) fmt::print("{}", files::escaped(quasi_static::text_report(course), files::Escapes::lines));
  if (course.interrupted)
    fmt::print("interrupted; results so far are saved, go on with: scree resume {}\n", directory);
  fmt::print("results in {}\n", directory);
  return course.interrupted ? ExitStatus::interrupted : ExitStatus::success;
}

}  // namespace scree::tool
