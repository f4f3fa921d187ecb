#pragma once

#include "offscreen_context.hpp"

#include <scree/snapshot/arrow_field.hpp>
#include <scree/snapshot/frame.hpp>
#include <scree/snapshot/render_options.hpp>

namespace scree::snapshot {

// Draws a frame. Throws scree::Error for invalid options or a frame that cannot be drawn.
Picture scene_picture(OffscreenContext& context, const Frame& frame, const RenderOptions& options);

// The same with an arrow at each particle, and small pale particles.
Picture arrow_picture(OffscreenContext& context, const Frame& frame, const ArrowField& arrows,
                      const RenderOptions& options);

}  // namespace scree::snapshot
