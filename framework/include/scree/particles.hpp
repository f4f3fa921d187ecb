#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include <scree/body_column.hpp>
#include <scree/body_group.hpp>
#include <scree/body_order.hpp>
#include <scree/domain.hpp>
#include <scree/orientations.hpp>
#include <scree/plugin/vec.hpp>
#include <scree/strided.hpp>

namespace scree {

struct BodyRange;

// One body (particle) of a scene; in 2D z components and the x and y components of the spin are 0.
struct Body {
  std::int64_t id = 0;
  std::uint32_t material = 0;  // index into Scene::materials
  double radius = 0;           // (m)
  double mass = 0;             // (kg)
  double inertia = 0;          // (kg m²)
  Vec3 position = {};          // (m)
  Vec3 velocity = {};          // (m/s)
  Vec3 spin = {};              // (rad/s)
  // No force moves or turns it: it keeps its velocity and spin, or follows its BodyGroup, as a wall does.
  bool fixed = false;
  freedom::Mask held = 0;  // the same of some components, of a body that is not fixed
};

// Layout of a body's record and of its loads: offsets, in doubles, of parts of four doubles each.
//   3D  position (x, y, z, R), motion (v, 1/m), mid_motion (v, –), with spin: spin (ω, 1/I), mid_spin (ω, –)
//       loads (f, 0), with spin: torque (t, 0)
//   2D  position (x, y, 1/I, R), motion (v, ω, 1/m), mid_motion (v, ω, –);  loads (f, t, 0)
namespace record {
inline constexpr std::size_t position = 0, motion = 4, mid_motion = 8, spin = 12, mid_spin = 16;
inline constexpr std::size_t width(int dimension, bool with_spin) {
  return dimension == 3 && with_spin ? 20 : 12;
}
inline constexpr std::size_t load_width(int dimension, bool with_spin) {
  return dimension == 3 && with_spin ? 8 : 4;
}
}  // namespace record

// Storage of all bodies. Each has one record of its moving state, which contacts read from a single address
// and loops over bodies read in sequence, one record of loads, and entries in columns of rarely used
// properties. Spins are allocated only if the scene needs them.
class Particles {
 public:
  // Range of the components of a vector or a spin: [first, last).
  struct Axes {
    int first, last;
  };

  // What a scene carries besides positions and velocities, and whether bodies are fixed, or held in part.
  struct Features {
    bool spin = false, images = false, orientations = false, fixed = false, held = false;
  };
  // Room for bodies, which takes up no memory before it is written.
  Particles(int dimension, const Features& features, std::size_t bodies);

  Particles(int dimension, const Features& features, const std::vector<Body>& bodies);

  std::size_t size() const { return mass.size(); }
  int dimension() const { return dimension_; }
  bool has_spin() const { return has_spin_; }
  Axes axes() const { return {0, dimension_}; }
  // Components of a spin: z in 2D, x to z in 3D, none in a scene without spin.
  Axes spin_axes() const { return has_spin_ ? Axes{dimension_ == 2 ? 2 : 0, 3} : Axes{0, 0}; }
  // Components of motion that the scene carries.
  freedom::Mask components() const {
    const freedom::Mask all = freedom::of_dimension(dimension_);
    return has_spin_ ? all : freedom::Mask(all & ~freedom::rotations);
  }
  Body body(std::size_t i) const;
  std::size_t bytes_per_body() const;

  // State, written by the integrator. While forces are evaluated, velocity and spin hold the prediction for
  // the end of the step.
  Vectors<double> position() { return vectors(records_.data(), record::position); }        // (m)
  Vectors<double> velocity() { return vectors(records_.data(), record::motion); }          // (m/s)
  Vectors<double> spin() { return spins(records_.data(), record::motion, record::spin); }  // (rad/s)
  Vectors<const double> position() const { return vectors(records_.data(), record::position); }
  Vectors<const double> velocity() const { return vectors(records_.data(), record::motion); }
  Vectors<const double> spin() const { return spins(records_.data(), record::motion, record::spin); }

  // Constant during a run: (m), (1/kg); the inverse mass of a fixed body is 0, as is its inverse inertia.
  Strided<const double> radius() const { return {records_.data() + record::position + 3, width(), size()}; }
  Strided<const double> inverse_mass() const {
    return {records_.data() + record::motion + 3, width(), size()};
  }
  // (1/kg) in a contact with a wall, in which a fixed body has its own mass: of the two, no mass would be
  // left.
  double inverse_mass_at_wall(std::size_t i) const { return 1 / mass[i]; }

  // Mid-step velocity (m/s) and spin (rad/s): displacement / step. Written by the integrator, used within a
  // step.
  Vectors<double> mid_velocity() { return vectors(records_.data(), record::mid_motion); }
  Vectors<double> mid_spin() { return spins(records_.data(), record::mid_motion, record::mid_spin); }
  Vectors<const double> mid_velocity() const { return vectors(records_.data(), record::mid_motion); }
  Vectors<const double> mid_spin() const {
    return spins(records_.data(), record::mid_motion, record::mid_spin);
  }

  // Written by the force evaluation.
  Vectors<double> force() { return loads_of(loads_.data(), axes(), 0); }                              // (N)
  Vectors<double> torque() { return loads_of(loads_.data(), spin_axes(), dimension_ == 2 ? 2 : 4); }  // (N m)
  Vectors<const double> force() const { return loads_of(loads_.data(), axes(), 0); }
  Vectors<const double> torque() const {
    return loads_of(loads_.data(), spin_axes(), dimension_ == 2 ? 2 : 4);
  }

  // Direct access to the records: (size, width) and (size or more, load_width) doubles. Rows of loads behind
  // the rows of bodies are scratch space of the force evaluation.
  double* records() { return records_.data(); }
  const double* records() const { return records_.data(); }
  double* loads() { return loads_.data(); }
  const double* loads() const { return loads_.data(); }
  std::size_t width() const { return record::width(dimension_, has_spin_); }
  std::size_t load_width() const { return record::load_width(dimension_, has_spin_); }
  void set_load_rows(std::size_t rows) { resize_with_room(loads_, rows * load_width()); }

  // The present state; all else follows from the bodies with which these were made. mid_step: velocities of
  // mid-step are kept too.
  void transfer(const class StateTransfer& state, bool mid_step);

  // Where the bodies are in memory; all views and columns are by place.
  const BodyOrder& order() const { return order_; }
  // Moves the bodies in memory: each place takes the body at the place `from[place]`. Only the bodies of
  // these ranges of places are kept.
  void rearrange(const std::vector<std::uint32_t>& from, std::span<const BodyRange> kept);
  // Copies rearranged bodies to where each is at the place of its number, into an earlier copy of them.
  void copy_in_scene_order(Particles& copy) const;
  // The same for bodies of some numbers.
  void copy_in_scene_order(Particles& copy, const std::vector<std::uint32_t>& numbers) const;

  // Sends the state of bodies to other ranks; and what is constant.
  void send(class Ranks& ranks, const class RowRoutes& routes);
  void send_constants(class Ranks& ranks, const class RowRoutes& routes);
  // Calls visit(column, width) for all columns with constants: records and what is listed below.
  template <class Visit>
  void each_constant(const Visit& visit) {
    visit(records_, width());
    visit(mass, 1), visit(inertia, 1), visit(id, 1), visit(material, 1), visit(fixed, 1), visit(held, 1);
  }

  // Moves the bodies to centres (m) without jumps at periodic faces, at rest and without loads.
  void come_to_rest(std::span<const Vec3> centres, const Domain& domain);

  // Advanced with the mid-step spin; carried only if the scene needs them.
  Orientations orientations;

  BodyColumn<std::int32_t> image[3];  // net periods crossed along each axis; empty without periodic axes

  // Constant during a run.
  BodyColumn<double> mass, inertia;  // (kg), (kg m²); inertia is empty without spin
  BodyColumn<std::int64_t> id;
  BodyColumn<std::uint32_t> material;
  BodyColumn<std::uint8_t> fixed;  // 1 for fixed bodies, 0 for others; empty if none is fixed
  BodyColumn<freedom::Mask> held;  // held components of bodies that are not fixed; empty if none is held
  bool is_fixed(std::size_t i) const { return !fixed.empty() && fixed[i]; }
  bool is_held(std::size_t i, int component) const {
    return is_fixed(i) || (!held.empty() && freedom::is_in(held[i], component));
  }

 private:
  void transfer_images(const class StateTransfer& state);
  // Calls visit(column of one, column of the other, width) for all that is kept per body, but orientations.
  template <class One, class Other, class Visit>
  static void each_column(One& one, Other& other, const Visit& visit);
  template <class T>
  Vectors<T> vectors(T* records, std::size_t part) const {
    return {records + part, width(), size(), 0, dimension_};
  }
  template <class T>
  Vectors<T> spins(T* records, std::size_t flat, std::size_t part) const {
    const Axes axes = spin_axes();
    return {records + (dimension_ == 2 ? flat + 2 : part), width(), size(), axes.first, axes.last};
  }
  template <class T>
  Vectors<T> loads_of(T* loads, Axes axes, std::size_t offset) const {
    return {loads + offset, load_width(), size(), axes.first, axes.last};
  }

  int dimension_;
  bool has_spin_;
  BodyOrder order_;
  BodyColumn<double> records_, loads_;
};

}  // namespace scree
