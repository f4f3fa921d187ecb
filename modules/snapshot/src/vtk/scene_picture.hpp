#pragma once

#include "offscreen_context.hpp"

#include <scree/snapshot/frame.hpp>
#include <scree/snapshot/render_options.hpp>

namespace scree::snapshot {

// Throws scree::Error where an option or the frame cannot be drawn.
Picture scene_picture(OffscreenContext& context, const Frame& frame, const RenderOptions& options);

}  // namespace scree::snapshot
