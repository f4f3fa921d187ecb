#pragma once

namespace scree::tool {

// From now on a plug-in that ends the program fails it, where it gives a status that would pass for a result:
// the program itself never calls exit.
void watch_for_exit();
// Before main() returns.
void expect_exit();

}  // namespace scree::tool
