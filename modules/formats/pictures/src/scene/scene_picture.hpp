#pragma once

#include "offscreen_context.hpp"

#include <scree/pictures/arrow_field.hpp>
#include <scree/pictures/frame.hpp>
#include <scree/pictures/render_options.hpp>

namespace scree::pictures {

// Draws a frame. Throws scree::Error for invalid options or a frame that cannot be drawn.
Picture scene_picture(OffscreenContext& context, const Frame& frame, const RenderOptions& options);

// The same with an arrow at each particle, and small pale particles.
Picture arrow_picture(OffscreenContext& context, const Frame& frame, const ArrowField& arrows,
                      const RenderOptions& options);

}  // namespace scree::pictures
