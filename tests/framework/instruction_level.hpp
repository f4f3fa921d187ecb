#pragma once

#include <cstdlib>
#include <optional>
#include <string>

namespace scree::test {

// Whether the host finds that this processor supports the level x86-64-v<level>.
inline bool is_supported(int level) {
#if defined(__x86_64__) && !defined(__clang__)  // clang 14 knows no levels
  if (level == 3) return __builtin_cpu_supports("x86-64-v3");
  if (level == 4) return __builtin_cpu_supports("x86-64-v4");
#endif
  return level == 1;
}

// Selects the build of plug-ins that a host loads, during its lifetime; null: chosen by the host.
class InstructionLevel {
 public:
  explicit InstructionLevel(const char* name) {
    if (const char* value = std::getenv("SCREE_LEVEL")) before_ = value;
    set(name);
  }
  ~InstructionLevel() { set(before_ ? before_->c_str() : nullptr); }
  InstructionLevel(const InstructionLevel&) = delete;
  InstructionLevel& operator=(const InstructionLevel&) = delete;

 private:
  static void set(const char* name) { name ? setenv("SCREE_LEVEL", name, 1) : unsetenv("SCREE_LEVEL"); }

  std::optional<std::string> before_;
};

}  // namespace scree::test
