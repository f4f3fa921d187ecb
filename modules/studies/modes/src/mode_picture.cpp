#include "mode_picture.hpp"

#include <numeric>

#include <fmt/format.h>

#include <scree/pictures/load_backend.hpp>
#include <scree/run/frame_of.hpp>

namespace scree::modes {

namespace {

constexpr double longest = 3;  // in mean radii

// Their forces are not known where nothing has asked for them.
pictures::Frame without_contacts(pictures::Frame frame) {
  for (std::vector<double>* column :
       {&frame.contact_from, &frame.contact_to, &frame.contact_normal_force, &frame.contact_tangential_force,
        &frame.contact_overlap, &frame.contact_normal, &frame.contact_force, &frame.contact_point})
    column->clear();
  frame.contact_sliding.clear();
  frame.contact_a.clear(), frame.contact_b.clear(), frame.contact_wall.clear();
  return frame;
}

}  // namespace

void draw_mode(const Simulation& simulation, const response::DegreesOfFreedom& freedom,
               const Eigen::VectorXd& q, const std::string& title, const std::string& view,
               const std::filesystem::path& png_file) {
  const pictures::Frame frame =
      without_contacts(run::frame_of(simulation, title, run::scene_box(simulation)));
  pictures::ArrowField arrows;
  arrows.vectors.assign(3 * freedom.bodies(), 0.0);
  for (std::size_t i = 0; i < freedom.bodies(); ++i)
    for (int k = 0; k < freedom.dimension(); ++k)
      if (const Eigen::Index number = freedom.translation(i, k); number != response::DegreesOfFreedom::none)
        arrows.vectors[3 * i + std::size_t(k)] = q[number];
  const double mean =
      std::accumulate(frame.radius.begin(), frame.radius.end(), 0.0) / double(frame.radius.size());
  arrows.longest = longest * mean;
  arrows.title = "over the largest";
  arrows.note = fmt::format(
      "arrows: translation of the bodies, the longest of {:g} mean radii; dots: centres", longest);
  pictures::RenderOptions options;
  options.view = view;
  pictures::load_backend()->render_arrows(frame, arrows, options, png_file);
}

}  // namespace scree::modes
