#pragma once

namespace scree::kernel {

// What body a of a pair meets.
enum class Partner { body, plane, surface };

constexpr bool is_wall(Partner partner) { return partner != Partner::body; }

}  // namespace scree::kernel
