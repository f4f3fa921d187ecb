#pragma once

namespace scree::report {

// The style sheet of a page.
extern const char* const style;

}  // namespace scree::report
