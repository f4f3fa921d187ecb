#include "follower.hpp"

#include <scree/error.hpp>
#include <scree/files/place_error.hpp>

namespace scree::quasi_static {

using run::RunDirectory;

Course follow(const scenario::Plan& plan, const FollowOptions& options) {
  if (options.increments == 0) throw Error("0 increments; give at least 1");
  RunDirectory directory = RunDirectory::of_results(options.out, options.overwrite, plan.source, plan.inputs,
                                                    RunDirectory::Kind::response);
  directory.report_lock(options.on_warning);
  return Follower(plan, options, directory).begin();
}

bool is_response(const std::filesystem::path& directory) {
  return run::has_results(directory, Follower::results);
}

Course resume_following(const FollowOptions& options, PluginHost& host) {
  return files::in_place([&] {
    RunDirectory directory = run::directory_of(options.out, Follower::results, options.on_warning);
    const run::Unfinished from = run::unfinished_in(directory, Follower::results, host, options.on_warning);
    return Follower(from.plan, options, directory).resume(from.state);
  });
}

}  // namespace scree::quasi_static
