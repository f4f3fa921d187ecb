#include "assembly/contact_terms.hpp"

#include "assembly/contact_places.hpp"
#include "assembly/pair_at_rest.hpp"

#include <algorithm>
#include <span>
#include <string>
#include <vector>

#include <Eigen/Geometry>
#include <fmt/format.h>

#include <scree/contact_columns.hpp>
#include <scree/contact_jacobian.hpp>
#include <scree/error.hpp>
#include <scree/plugin/great_circle.hpp>

namespace scree::response {

namespace {

// The branch. At the limit of friction a law has two derivatives, and only the law knows on which branch it
// is: by its force without slip, its own limit and its history. So it is asked: the contact is moved a little
// along its slip (to slide) or against it (to stick) and evaluated, and its sliding column tells. The first
// motion is above the round-off of a spring at the limit, and far too small to change the derivatives. At
// rest the normal force may lack a part by velocity that it had in the last step, so that the spring is short
// of the limit, or beyond it, by that part: the motion grows until the law agrees. The force of the spring is
// monotonic in the motion, so it does, before the motion is the overlap.
constexpr double least_slip = 1e-9, largest_slip = 1, growth_of_slip = 4;  // in overlaps
// Change of the overlap, relative to it, by which loading and unloading are told apart: above round-off, and
// too small to change which contacts slide.
constexpr double depth = 1e-11;
// Relative difference above which a contact has two stiffnesses. Share of the stiffness by rotations above
// which the law integrates spins.
constexpr double least_difference = 1e-6;
// A step, relative to that of the run, so short that dashpots have their values in the limit: their error
// falls with its square, from 0.01 to 1e-12 here. Rotations by integrated spins keep eleven digits.
constexpr double short_step = 1.0 / 65536;

}  // namespace

ConfiguredLaw differentiable(const Scene::Law& law, int dimension) {
  ConfiguredLaw configured(law.parameters, dimension, no_bounds, no_bounds);
  if (!configured.instance().differentiate)
    throw Error(fmt::format(
        "contact law '{}' has no derivatives, from which a linear response follows; measure with a pulse or "
        "a sweep, or build the law with SCREE_CONTACT_LAW_PLUGIN",
        law.name));
  return configured;
}

void check_equations(const Simulation& simulation, const WallEquations& equations, const char* controls) {
  for (std::size_t w = 0; w < equations.walls.size(); ++w)
    if (equations.walls[w].free == SCREE_NO_EQUATION)
      throw Error(fmt::format(
          "wall {} turns by a program, or with others, which has no linear equation; give it spin_control = {}",
          simulation.wall_name(w), controls));
}

void check_laws(const Scene& scene, LawsNeeded needed) {
  std::size_t without = 0;
  for (const Scene::Law& law : scene.laws) try {
      differentiable(law, scene.dimension);
    } catch (const Error&) {
      if (++without == scene.laws.size() || needed == LawsNeeded::all) throw;
    }
}

namespace {

// Contacts of one law with bodies and planes, or with surfaces.
class LawContacts {
 public:
  using Partner = ContactColumns::Partner;

  LawContacts(const Simulation& simulation, const ContactList& list, std::uint32_t law, Partner partner,
              int spins, AtLimit at_limit, TimeStep time_step)
      : simulation_(simulation),
        list_(list),
        places_(simulation, list),
        partner_(partner),
        law_(differentiable(simulation.scene().laws[law], simulation.dimension())),
        jacobian_(law_, simulation.dimension()),
        spins_(spins),
        at_limit_(at_limit),
        step_(simulation.step_length() * (time_step == TimeStep::limit ? short_step : 1)) {
    const std::size_t first_surface = simulation.particles().size() + simulation.planes().size();
    for (std::size_t c = 0; c < list.size(); ++c)
      if (list.law[c] == law && (list.b[c] >= first_surface) == (partner == Partner::surface))
        contacts_.push_back(c);
  }

  void append_terms(std::vector<ContactTerms>& terms) const {
    if (contacts_.empty()) return;
    ContactColumns columns(contacts_.size(), partner_);
    std::vector<PairVariation> variations((contacts_.size() / SCREE_LANES + 1) * SCREE_LANES);
    for (std::size_t i = 0; i < contacts_.size(); ++i) {
      fill(columns, i);
      variations[i] = places_.pair(contacts_[i]).change;
    }
    ContactColumns at_rest = columns;
    at_rest.evaluate(law_, simulation_.step_length());
    columns = at_side_of_limit(columns, at_rest);

    std::vector<double> jacobian = jacobians(columns, variations, 0);
    const std::vector<bool> one_way = take_means(columns, variations, jacobian);
    const std::vector<double> turning = jacobian_of_integrated_spins(columns, variations, jacobian);
    for (std::size_t i = 0; i < contacts_.size(); ++i) {
      const std::size_t c = contacts_[i];
      const ContactGeometry contact = geometry(c);
      const auto [f, torque, torque_b] = loads(at_rest, i, contact);
      terms.push_back(
          {list_.a[c], list_.b[c], c, law_.instance().tangential != 0 || law_.instance().writes_couple != 0,
           bool(list_.sliding[c]), one_way[i], false, reads_orientations(),
           Eigen::Vector3d(places_.place_of(list_.a[c]).component), contact.normal, f, torque, torque_b,
           contact.normal_change, contact.of_bodies(contact.displacements(jacobian_, jacobian.data(), i), f),
           contact.of_bodies(contact.velocities(jacobian_, jacobian.data(), i), Eigen::Vector3d::Zero())});
      if (turning.empty()) continue;
      const Block by_rotation =
          contact.of_bodies(contact.spins_of(jacobian_, turning.data(), i), Eigen::Vector3d::Zero());
      const auto force_by_rotation = [&](const Block& of) {
        return of.block(0, simulation_.dimension(), simulation_.dimension(), spins_).norm();
      };
      terms.back().integrates_spin =
          force_by_rotation(by_rotation) > least_difference * force_by_rotation(terms.back().stiffness);
      terms.back().stiffness += by_rotation;
      terms.back().damping -= step_ * by_rotation;
    }
  }

 private:
  struct Loads {
    Eigen::Vector3d force, torque, torque_b;  // the latter on another body
  };
  Loads loads(const ContactColumns& columns, std::size_t i, const ContactGeometry& contact) const {
    const bool flat = simulation_.dimension() == 2;
    const Vec3 force = columns.output_vector(SCREE_FORCE, i);
    const Eigen::Vector3d f(force[0], force[1], flat ? 0 : force[2]);
    Eigen::Vector3d couple = Eigen::Vector3d::Zero();
    if (law_.instance().writes_couple) {
      const Vec3 c = columns.output_vector(SCREE_COUPLE, i);
      couple = flat ? Eigen::Vector3d(0, 0, c[0]) : Eigen::Vector3d(c[0], c[1], c[2]);
    }
    const Eigen::Vector3d lever = contact.normal.cross(f);
    return {f, couple - contact.arm_a * lever, -couple - contact.arm_b * lever};
  }
  // The contacts, moved until each is on the branch that is asked for.
  ContactColumns at_side_of_limit(const ContactColumns& columns, const ContactColumns& at_rest) const {
    const bool slides = at_limit_ == AtLimit::slide;
    std::vector<double> slip(contacts_.size(), least_slip);
    while (true) {
      ContactColumns moved = columns;
      for (std::size_t i = 0; i < contacts_.size(); ++i)
        if (!slides || list_.sliding[contacts_[i]])
          move_along_slip(moved, at_rest, i, slides ? slip[i] : -slip[i]);
      if (!lengthen_slips(moved, slides, slip)) return moved;
    }
  }

  // Lengthens the motion of the contacts that are still on the other branch. Returns whether there are any.
  bool lengthen_slips(const ContactColumns& moved, bool slides, std::vector<double>& slip) const {
    const int column = law_.instance().sliding_column;
    if (column < 0) return false;
    ContactColumns after = moved;
    after.evaluate(law_, simulation_.step_length());
    bool any = false;
    for (std::size_t i = 0; i < contacts_.size(); ++i) {
      const bool concerned = !slides || list_.sliding[contacts_[i]];
      if (!concerned || (after.history(std::size_t(column), i) > 0) == slides || slip[i] >= largest_slip)
        continue;
      slip[i] *= growth_of_slip;
      any = true;
    }
    return any;
  }

  // Jacobians with all contacts deeper by a share of their overlap.
  std::vector<double> jacobians(ContactColumns columns, std::span<const PairVariation> variations,
                                double share) const {
    for (std::size_t i = 0; i < contacts_.size(); ++i) columns.input(SCREE_OVERLAP, 0, i) *= 1 + share;
    return jacobians_in(step_, columns, variations);
  }
  std::vector<double> jacobians_in(double step, ContactColumns& columns,
                                   std::span<const PairVariation> variations) const {
    std::vector<double> all;
    jacobian_.evaluate(columns.batch(step), variations, all);
    const double of_run = simulation_.step_length();
    if (step == of_run || !law_.instance().writes_couple || !reads_spins()) return all;
    std::vector<double> rolling;
    jacobian_.evaluate(columns.batch(of_run), variations, rolling);
    for (std::size_t i = 0; i < contacts_.size(); ++i) keep_rolling(rolling, i, all);
    return all;
  }
  // Rolling resistance (couples by spins, without forces) is a dashpot of at least 16 steps of the run. In
  // the limit of short steps it would stop all rolling, so it keeps the step of the run.
  void keep_rolling(const std::vector<double>& rolling, std::size_t i, std::vector<double>& all) const {
    using Rows = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
    const int force = simulation_.dimension(), rows = jacobian_.rows(), width = jacobian_.columns(),
              spin = jacobian_.first(PairMotion::spin), spins = rows - force;
    const std::size_t at = i * std::size_t(rows * width);
    Eigen::Map<Rows> of(all.data() + at, rows, width);
    if (!of.block(0, spin, force, spins).isZero(0)) return;
    of.block(force, spin, spins, spins) =
        Eigen::Map<const Rows>(rolling.data() + at, rows, width).block(force, spin, spins, spins);
  }
  bool reads_spins() const { return law_.instance().reads & (1u << SCREE_RELATIVE_SPIN); }

  // Growth of the Jacobians with the step (1/s); empty if the law reads no spins. The derivatives of a law
  // that adds spin × step to its spring grow with the step: they are a stiffness, not a dashpot.
  std::vector<double> jacobian_of_integrated_spins(ContactColumns& columns,
                                                   std::span<const PairVariation> variations,
                                                   const std::vector<double>& jacobian) const {
    if (!reads_spins()) return {};
    std::vector<double> growth = jacobians_in(2 * step_, columns, variations);
    for (std::size_t k = 0; k < growth.size(); ++k) growth[k] = (growth[k] - jacobian[k]) / step_;
    return growth;
  }

  // Laws that remember how deep a contact was may have one derivative for loading and one for unloading.
  // Where these differ, their mean replaces the one that round-off has chosen. Returns for which contacts.
  std::vector<bool> take_means(const ContactColumns& columns, std::span<const PairVariation> variations,
                               std::vector<double>& jacobian) const {
    std::vector<bool> differ(contacts_.size(), false);
    if (law_.instance().history_width == 0) return differ;
    const std::vector<double> loading = jacobians(columns, variations, depth),
                              unloading = jacobians(columns, variations, -depth);
    const Eigen::Index size = jacobian_.rows() * jacobian_.columns();
    for (std::size_t i = 0; i < contacts_.size(); ++i) {
      const auto of = [&](const std::vector<double>& all) {
        return Eigen::Map<const Eigen::ArrayXd>(all.data() + Eigen::Index(i) * size, size);
      };
      const Eigen::ArrayXd up = of(loading), down = of(unloading);
      if (!((up - down).abs().maxCoeff() > least_difference * up.abs().maxCoeff())) continue;
      differ[i] = true;
      const Eigen::ArrayXd mean = 0.5 * (up + down);
      std::copy_n(mean.data(), size, jacobian.begin() + Eigen::Index(i) * size);
    }
    return differ;
  }

  ContactGeometry geometry(std::size_t c) const {
    return places_.pair(c).geometry(simulation_.dimension(), spins_, scree_arms(law_.instance().arms));
  }

  // A contact of bodies at rest.
  void fill(ContactColumns& columns, std::size_t i) const {
    const Particles& p = simulation_.particles();
    const std::size_t c = contacts_[i];
    places_.pair(c).set_inputs(p, p.orientations, law_.instance().reads, columns, i);
    // The overlap of the list has no round-off of a difference.
    columns.input(SCREE_OVERLAP, 0, i) = list_.overlap[c];
    for (std::uint32_t k = 0; k < law_.instance().history_width; ++k)
      columns.history(k, i) = simulation_.contact_history(list_.pair[c], k);
  }

  bool reads_orientations() const { return law_.instance().reads & (1u << SCREE_ORIENTATION_A); }

  // Moves a contact along its slip, which is opposite to the tangential force on a. share: of the overlap.
  // The velocity keeps a dashpot on the same side of the limit as the spring.
  void move_along_slip(ContactColumns& columns, const ContactColumns& at_rest, std::size_t i,
                       double share) const {
    const std::size_t c = contacts_[i];
    const Vec3 normal = {{list_.normal[3 * c], list_.normal[3 * c + 1], list_.normal[3 * c + 2]}};
    Vec3 force = at_rest.output_vector(SCREE_FORCE, i);
    if (simulation_.dimension() == 2) force[2] = 0;
    const Vec3 along = force - dot(force, normal) * normal;
    const double length = norm(along);
    if (!(length > 0)) return;
    const Vec3 moved = -share * list_.overlap[c] / length * along;
    columns.set(SCREE_TANGENTIAL_INCREMENT, moved, i);
    columns.set(SCREE_RELATIVE_VELOCITY, 1 / simulation_.step_length() * moved, i);
    if (reads_orientations())
      turn(columns, i, 1 / simulation_.particles().radius()[list_.a[c]] * cross(moved, normal));
  }

  // Turns a by a small rotation vector (rad).
  void turn(ContactColumns& columns, std::size_t i, const Vec3& rotation) const {
    if (simulation_.dimension() == 2) {
      columns.input(SCREE_ORIENTATION_A, 0, i) += rotation[2];
      return;
    }
    Vec<4> quaternion;
    for (int k = 0; k < 4; ++k) quaternion[k] = columns.input(SCREE_ORIENTATION_A, k, i);
    const Vec<4> change = quaternion_change(quaternion, rotation);
    for (int k = 0; k < 4; ++k) columns.input(SCREE_ORIENTATION_A, k, i) += change[k];
  }

  const Simulation& simulation_;
  const ContactList& list_;
  ContactPlaces places_;
  Partner partner_;
  ConfiguredLaw law_;
  ContactJacobian jacobian_;
  int spins_;
  AtLimit at_limit_;
  double step_;                        // (s)
  std::vector<std::size_t> contacts_;  // indices into the list
};

}  // namespace

std::vector<ContactTerms> linearise_contacts(const Simulation& simulation, int spins, AtLimit at_limit,
                                             TimeStep time_step) {
  const ContactList list = simulation.contact_list();
  std::vector<ContactTerms> terms;
  for (std::uint32_t law = 0; law < simulation.scene().laws.size(); ++law)
    if (std::find(list.law.begin(), list.law.end(), law) != list.law.end())
      for (const auto partner : {ContactColumns::Partner::body_or_plane, ContactColumns::Partner::surface})
        LawContacts(simulation, list, law, partner, spins, at_limit, time_step).append_terms(terms);
  return terms;
}

}  // namespace scree::response
