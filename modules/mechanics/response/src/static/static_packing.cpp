#include "static/static_packing.hpp"

#include <algorithm>

#include <Eigen/Geometry>

#include <scree/error.hpp>
#include <scree/response/found_modes.hpp>

namespace scree::response {

StaticPacking::StaticPacking(const Simulation& simulation, const AssemblyOptions& options,
                             const std::function<bool()>& proceed)
    : system_(assemble(simulation, options)),
      undamped_(system_),
      inverse_(undamped_.factorise(-undamped_.rounding())),
      list_(simulation.contact_list()),
      terms_(linearise_contacts(simulation, system_.freedom.spins(), options.at_limit)),
      equations_(simulation.linear_walls()) {
  const FoundModes found = find_modes(undamped_, {.count = 0, .proceed = proceed});
  if (!proceed()) throw Error("interrupted while floppy modes were counted", ExitStatus::interrupted);
  floppy_ = found.shape.middleCols(Eigen::Index(found.first_floppy),
                                   Eigen::Index(found.first_vibrating - found.first_floppy));
}

PackingMotion StaticPacking::displace(const Eigen::VectorXd& walls) const {
  return solve(-(system_.wall_stiffness * walls), walls);
}

PackingMotion StaticPacking::load(std::size_t wall) const {
  return solve(Eigen::VectorXd::Unit(system_.freedom.size(), system_.freedom.wall(wall)),
               Eigen::VectorXd::Zero(system_.wall_stiffness.cols()));
}

PackingMotion StaticPacking::solve(const Eigen::VectorXd& force, const Eigen::VectorXd& walls) const {
  StaticSolution solution = solve_static(undamped_, *inverse_, floppy_, force);
  return {.motion = std::move(solution.displacement), .walls = walls, .residual = solution.residual};
}

bool StaticPacking::is_held(std::uint32_t end) const {
  return end >= system_.freedom.bodies() ||
         !std::binary_search(system_.rattlers.begin(), system_.rattlers.end(), end);
}

double StaticPacking::component(const PackingMotion& motion, std::uint32_t end, int k) const {
  const DegreesOfFreedom& freedom = system_.freedom;
  const int dimension = freedom.dimension();
  if (end >= freedom.bodies()) {
    if (k >= dimension) return 0;
    const std::size_t wall = end - freedom.bodies();
    const Eigen::Index number = freedom.wall(wall);
    const double along = number == DegreesOfFreedom::none ? 0 : motion.motion[number];
    return motion.walls[Eigen::Index(wall) * dimension + k] + along * equations_.walls[wall].direction[k];
  }
  const Eigen::Index number =
      k < dimension ? freedom.translation(end, k) : freedom.rotation(end, k - dimension);
  return number == DegreesOfFreedom::none ? 0 : motion.motion[number];
}

bool StaticPacking::turns(const ContactTerms& contact) const {
  const std::size_t bodies = system_.freedom.bodies();
  return contact.b >= bodies && system_.freedom.turn(contact.b - bodies) != DegreesOfFreedom::none;
}

double StaticPacking::angle(const PackingMotion& motion, const ContactTerms& contact) const {
  return motion.motion[system_.freedom.turn(contact.b - system_.freedom.bodies())];
}

TurnedContact StaticPacking::turned(const ContactTerms& contact) const {
  return turned_contact(contact, equations_.walls[contact.b - system_.freedom.bodies()],
                        system_.freedom.dimension(), system_.freedom.spins());
}

// A wall that turns takes the normal with it, and the body stays behind.
Eigen::Vector3d StaticPacking::normal_change(const PackingMotion& motion, const ContactTerms& contact) const {
  Eigen::Vector3d apart = Eigen::Vector3d::Zero();
  for (int k = 0; k < system_.freedom.dimension(); ++k)
    apart[k] = component(motion, contact.a, k) - component(motion, contact.b, k);
  if (!turns(contact)) return contact.normal_change * apart;
  const TurnedContact of = turned(contact);
  const Eigen::Vector3d turn = angle(motion, contact) * of.axis,
                        normal(list_.normal.data() + 3 * contact.contact);
  return contact.normal_change * (apart - turn.cross(of.arm)) + turn.cross(normal);
}

Eigen::VectorXd StaticPacking::force_change(const PackingMotion& motion, const ContactTerms& contact) const {
  const int dimension = system_.freedom.dimension(), of_body = dimension + system_.freedom.spins();
  Eigen::VectorXd moved(2 * of_body);
  for (int k = 0; k < of_body; ++k) {
    moved[k] = component(motion, contact.a, k);
    moved[of_body + k] = component(motion, contact.b, k);
  }
  const Eigen::VectorXd change = -contact.stiffness.topRows(dimension) * moved;
  if (!turns(contact)) return change;
  const TurnTerms terms = turn_terms(contact.stiffness.topLeftCorner(of_body, of_body), turned(contact));
  return change - angle(motion, contact) * terms.by_turn.head(dimension);
}

}  // namespace scree::response
