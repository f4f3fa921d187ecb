// A library whose constructor never returns.
#include <unistd.h>

namespace {

struct Wait {
  Wait() {
    for (;;) pause();
  }
} for_ever;

}  // namespace
