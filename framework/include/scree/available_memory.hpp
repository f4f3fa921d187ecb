#pragma once

namespace scree {

// Memory that the program can have (bytes): all of the computer, or less where a limit is set (ulimit -v).
double available_memory();

}  // namespace scree
