#pragma once

#include <filesystem>
#include <string>

#include <Eigen/Core>

#include <scree/response/degrees_of_freedom.hpp>
#include <scree/simulation.hpp>

namespace scree::modes {

// Draws the translations of a motion q as arrows at the bodies, the longest of three mean radii.
void draw_mode(const Simulation& simulation, const response::DegreesOfFreedom& freedom,
               const Eigen::VectorXd& q, const std::string& title, const std::string& view,
               const std::filesystem::path& png_file);

}  // namespace scree::modes
