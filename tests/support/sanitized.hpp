#pragma once

namespace scree::test {

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
inline constexpr bool sanitized = true;
#else
inline constexpr bool sanitized = false;
#endif

// A number of steps, a fifth of it under sanitizers, where a step takes ten times as long: they look for
// faults of memory and of threads, which a few steps show.
constexpr int fewer_if_sanitized(int steps) { return sanitized ? steps / 5 : steps; }

}  // namespace scree::test
