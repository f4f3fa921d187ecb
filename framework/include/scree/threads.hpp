#pragma once

#include <cstddef>
#include <future>
#include <memory>
#include <system_error>
#include <thread>
#include <vector>

// Work beside the calling thread that is done as well where no thread is to be had, as under a limit of
// processes.

namespace scree {

// Does work in a thread of its own; where none can be started, before this returns. Exceptions come with
// get(). has_thread: set to whether it has one.
template <class Work>
auto in_background(Work work, bool* has_thread = nullptr) {
  const auto shared = std::make_shared<Work>(std::move(work));
  const auto call = [shared] { return (*shared)(); };
  if (has_thread) *has_thread = true;
  try {
    return std::async(std::launch::async, call);
  } catch (const std::system_error&) {
    if (has_thread) *has_thread = false;
    auto done = std::async(std::launch::deferred, call);
    done.wait();
    return done;
  }
}

// Whether so many threads can be started at once beside this one.
inline bool can_start_threads(std::size_t count) {
  std::promise<void> all_started;
  const std::shared_future<void> end = all_started.get_future().share();
  std::vector<std::thread> started;
  try {
    while (started.size() < count) started.emplace_back([end] { end.wait(); });
  } catch (const std::system_error&) {
  }
  all_started.set_value();
  for (std::thread& thread : started) thread.join();
  return started.size() == count;
}

}  // namespace scree
