#pragma once

namespace scree::files {

// The commit from which the program was built, 12 hexadecimal digits, with "-dirty" behind them if files that
// git knows had changed; "unknown" if the sources do not say. In the library scree_revision.
const char* program_commit();

}  // namespace scree::files
