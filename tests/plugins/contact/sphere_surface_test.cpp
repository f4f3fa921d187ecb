#include "sphere_values.hpp"

#include <array>
#include <functional>
#include <numbers>
#include <random>
#include <string>
#include <vector>

#include <catch2/catch.hpp>

#include <scree/pair_variation.hpp>

// `sphere_path_independent` at walls of other shapes than planes: its energy, forces and torques without slip
// against the lengths of arcs on body and wall, which are computed here from angles.

using namespace scree;
using namespace scree::test;

namespace {

constexpr double body_radius = 1;

// v turned by the unit quaternion (w, x, y, z), and back.
Vec3 turn_by(const Vec<4>& q, const Vec3& v) {
  const Vec3 u = {{q[1], q[2], q[3]}};
  return v + 2 * q[0] * cross(u, v) + 2 * cross(u, cross(u, v));
}
Vec3 turn_back(const Vec<4>& q, const Vec3& v) { return turn_by({{q[0], -q[1], -q[2], -q[3]}}, v); }

double angle_between(const Vec3& a, const Vec3& b) { return std::atan2(norm(cross(a, b)), dot(a, b)); }
// Vector of a length in the tangent plane at a unit vector, along the great circle to another one.
Vec3 along_circle(const Vec3& at, const Vec3& to, double length) {
  const Vec3 across = to - dot(at, to) * at;
  return norm(across) > 0 ? length / norm(across) * across : Vec3{};
}

// A wall in its own frame: its nearest point, and the arc on it from there to another point of it.
struct Shape {
  std::string name;
  Vec3 start;  // (m) of the body
  std::function<Vec3(const Vec3&)> nearest;
  std::function<Vec3(const Vec3& from, const Vec3& to)> arc;
  bool exact = true;
};

Shape cylinder(double radius, double distance) {
  const auto outwards = [](const Vec3& x) { return 1 / std::hypot(x[0], x[1]) * Vec3{{x[0], x[1], 0}}; };
  return {
      "cylinder of radius " + std::to_string(radius),
      {{distance * std::cos(0.4), distance * std::sin(0.4), 0.3}},
      [=](const Vec3& x) {
        return radius * outwards(x) + Vec3{{0, 0, x[2]}};
      },
      [=](const Vec3& from, const Vec3& to) {
        const Vec3 here = outwards(from), there = outwards(to);
        return along_circle(here, there, radius * angle_between(here, there)) + Vec3{{0, 0, to[2] - from[2]}};
      }};
}

Shape ball(double radius, double distance) {
  const auto outwards = [](const Vec3& x) { return 1 / norm(x) * x; };
  return {"ball of radius " + std::to_string(radius), distance / std::sqrt(3.0) * Vec3{{1, 1, -1}},
          [=](const Vec3& x) { return radius * outwards(x); },
          [=](const Vec3& from, const Vec3& to) {
            const Vec3 here = outwards(from), there = outwards(to);
            return along_circle(here, there, radius * angle_between(here, there));
          }};
}

const auto straight = [](const Vec3& from, const Vec3& to) { return to - from; };
const Shape flat = {"flat", {{0.3, 0.2, 0.9}}, [](const Vec3& x) { return Vec3{{x[0], x[1], 0}}; }, straight};
const Shape edge = {"edge", {{0.6, 0.7, 0.3}}, [](const Vec3& x) { return Vec3{{0, 0, x[2]}}; }, straight};
const Shape corner = {"corner", {{0.5, 0.6, 0.4}}, [](const Vec3&) { return Vec3{}; }, straight};

// Half angle 30 degrees, apex at 0: arcs are straight on the cone unrolled.
Shape cone() {
  const double sine = 0.5, cosine = std::sqrt(0.75);
  const auto radial = [](const Vec3& x) { return 1 / std::hypot(x[0], x[1]) * Vec3{{x[0], x[1], 0}}; };
  const auto line = [=](const Vec3& x) { return sine * radial(x) + Vec3{{0, 0, cosine}}; };
  return {"cone",
          {{0.4 * std::cos(1), 0.4 * std::sin(1), 2.4}},
          [=](const Vec3& x) { return dot(x, line(x)) * line(x); },
          [=](const Vec3& from, const Vec3& to) {
            const Vec3 here = radial(from), there = radial(to);
            const double turn = sine * std::copysign(angle_between(here, there), cross(here, there)[2]);
            const Vec3 around = {{-here[1], here[0], 0}};
            return (norm(to) * std::cos(turn) - norm(from)) * line(from) + norm(to) * std::sin(turn) * around;
          },
          false};
}

std::vector<Shape> shapes() {
  return {flat,           edge,          corner, cylinder(2, 2.93), cylinder(3, 2.06), cylinder(0.3, 1.24),
          ball(1.5, 2.4), ball(4, 3.08), cone()};
}

struct Pose {
  Vec3 a, origin;  // (m) of the body, and of the frame of the wall
  Vec<4> of_body, of_wall;

  Vec3 in_frame() const { return turn_back(of_wall, a - origin); }
};

class BodyAtWall {
 public:
  BodyAtWall(const Shape& shape, bool hertz, const Pose& start, double friction = infinite_friction)
      : shape_(shape),
        hertz_(hertz),
        law_("sphere_path_independent", sphere_values(hertz, friction), 3, ContactColumns::Partner::surface) {
    law_.input(SCREE_RADII, 0) = body_radius;
    law_.input(SCREE_EFFECTIVE_RADIUS) = body_radius;
    move_to(start);
    const Vec3 c = shape_.nearest(start.in_frame());
    on_body_ = turn_back(start.of_body, -normal(start)), on_wall_ = c;
  }

  // First touches in a step (1 s) in which it has come here from the start without coming nearer.
  void touch_first(const Pose& start, const Pose& pose) {
    for (std::size_t k = 0; k < law_.instance().history_width; ++k) law_.history(k) = 0;
    const Vec3 n = normal(pose);
    law_.set(SCREE_TANGENTIAL_INCREMENT, spring(pose));
    law_.set(SCREE_RELATIVE_SPIN,
             turn_between(start.of_body, pose.of_body) - turn_between(start.of_wall, pose.of_wall));
    const Vec3 moved = spring(pose);
    law_.set(SCREE_RELATIVE_VELOCITY, moved - dot(moved, n) * n);
    move_to(pose);
  }
  // Distance of the painted points of the law from where they were painted (m).
  double from_painted() const {
    const auto of_law = [&](const std::string& name) {
      return Vec3{{law_.history(name + "x"), law_.history(name + "y"), law_.history(name + "z")}};
    };
    return norm(body_radius * (of_law("painted_a_") - on_body_)) + norm(of_law("painted_b_") - on_wall_);
  }

  void move_to(const Pose& pose) {
    pose_ = pose;
    law_.set(SCREE_NORMAL, normal(pose));
    law_.set(SCREE_SEPARATION, pose.a - pose.origin);
    for (int k = 0; k < 4; ++k) {
      law_.input(SCREE_ORIENTATION_A, k) = pose.of_body[k];
      law_.input(SCREE_ORIENTATION_B, k) = pose.of_wall[k];
    }
    const auto change = symmetric_components(normal_change(pose));
    for (int k = 0; k < 6; ++k) law_.input(SCREE_NORMAL_CHANGE, k) = change[std::size_t(k)];
    law_.input(SCREE_OVERLAP) = overlap(pose);
    law_.evaluate(1);
  }

  static Vec3 normal(const Shape& shape, const Pose& p) {
    const Vec3 x = p.in_frame(), away = x - shape.nearest(x);
    return turn_by(p.of_wall, 1 / norm(away) * away);
  }
  double overlap(const Pose& p) const {
    const Vec3 x = p.in_frame();
    return body_radius - norm(x - shape_.nearest(x));
  }
  Vec3 spring(const Pose& p) const {
    const Vec3 contact = -normal(p), painted = turn_by(p.of_body, on_body_);
    const Vec3 on_body = along_circle(contact, painted, body_radius * angle_between(contact, painted));
    return on_body - turn_by(p.of_wall, shape_.arc(shape_.nearest(p.in_frame()), on_wall_));
  }
  // (J) stored.
  double energy(const Pose& p) const {
    const double d = overlap(p), square = dot(spring(p), spring(p));
    if (!hertz_) return 0.5 * 100 * d * d + 0.5 * 80 * square;
    const double young = 300, poisson = 0.3, shear = young / (2 * (1 + poisson));
    const double effective = young / (2 * (1 - poisson * poisson)), of_shear = shear / (2 * (2 - poisson));
    return 8.0 / 15 * effective * std::sqrt(body_radius) * std::pow(d, 2.5) +
           0.5 * 8 * of_shear * std::sqrt(body_radius * d) * square;
  }
  Vec3 law_spring() const {
    return {{law_.history("spring_x"), law_.history("spring_y"), law_.history("spring_z")}};
  }
  Vec3 force() const { return law_.force(); }
  Vec3 torque_on_body() const {
    const Vec3 couple = {
        {law_.output(SCREE_COUPLE, 0), law_.output(SCREE_COUPLE, 1), law_.output(SCREE_COUPLE, 2)}};
    return couple - (body_radius - 0.5 * overlap(pose_)) * cross(normal(pose_), force());
  }
  // About the origin of its frame, as the kernel has it.
  Vec3 torque_on_wall() const { return -cross(pose_.a - pose_.origin, force()) - torque_on_body(); }
  double law_energy() const {
    return law_.output(SCREE_ELASTIC_NORMAL) + law_.output(SCREE_ELASTIC_TANGENTIAL);
  }

 private:
  Vec3 normal(const Pose& p) const { return normal(shape_, p); }
  // By differences of fourth order: 1e-12.
  Matrix3 normal_change(const Pose& p) const {
    constexpr double h = 1e-3;
    Matrix3 change = {};
    for (int axis = 0; axis < 3; ++axis) {
      const auto at = [&](double along) {
        Pose moved = p;
        moved.a[axis] += along;
        return normal(moved);
      };
      const Vec3 column = 1 / (12 * h) * (8 * (at(h) - at(-h)) - (at(2 * h) - at(-2 * h)));
      for (std::size_t k = 0; k < 3; ++k) change[k][axis] = column[int(k)];
    }
    return change;
  }

  const Shape& shape_;
  bool hertz_;
  LawBatch law_;
  Pose pose_ = {};
  Vec3 on_body_ = {}, on_wall_ = {};
};

class Poses {
 public:
  // Of any orientation.
  Pose start(const Shape& shape) {
    const Pose p = {{}, vector(1), quaternion_of(vector(2)), quaternion_of(vector(2))};
    return {p.origin + turn_by(p.of_wall, shape.start), p.origin, p.of_body, p.of_wall};
  }
  // By arcs below 0.1 rad.
  Pose moved(Pose p, double size) {
    p.a += vector(size), p.origin += vector(size);
    p.of_body = after(quaternion_of(vector(size)), p.of_body);
    p.of_wall = after(quaternion_of(vector(0.2 * size)), p.of_wall);
    return p;
  }

 private:
  Vec3 vector(double size) {
    std::uniform_real_distribution<double> component(-size, size);
    return {{component(random_), component(random_), component(random_)}};
  }
  std::mt19937_64 random_{5};
};

// Derivatives of the energy with body and wall moved and turned; of fourth order.
double slope(const BodyAtWall& body, const Pose& pose, const std::function<void(Pose&, double)>& change) {
  constexpr double h = 2e-4;
  const auto energy = [&](double amount) {
    Pose p = pose;
    change(p, amount);
    return body.energy(p);
  };
  return (8 * (energy(h) - energy(-h)) - (energy(2 * h) - energy(-2 * h))) / (12 * h);
}

}  // namespace

// The bound of sphere_potential_test: truncation 6e-10 N, round-off 1e-12 N. On a cone the law leaves out the
// third order of the angle φ = 0.02/0.7 between the points: 80 N/m · 0.03 m · φ³ = 5e-5 N at most.
TEST_CASE("forces and torques on spheres at curved walls are the gradient of the energy of arcs",
          "[sphere]") {
  Poses poses;
  for (const bool hertz : {false, true})
    for (const Shape& shape : shapes())
      for (int k = 0; k < 20; ++k) {
        const Pose start = poses.start(shape), pose = poses.moved(start, 0.01);
        BodyAtWall body(shape, hertz, start);
        body.move_to(pose);
        INFO((hertz ? "hertz, " : "linear, ") << shape.name << ", " << k);
        const double bound = shape.exact ? 1e-8 : 5e-5;
        CHECK(norm(body.spring(pose)) > 1e-4);
        CHECK(norm(body.law_spring() - body.spring(pose)) < (shape.exact ? 1e-14 : 1e-6));
        CHECK(std::abs(body.law_energy() - body.energy(pose)) < (shape.exact ? 1e-13 : 1e-6));
        for (int axis = 0; axis < 3; ++axis) {
          Vec3 unit = {};
          unit[axis] = 1;
          CHECK(std::abs(body.force()[axis] +
                         slope(body, pose, [&](Pose& p, double s) { p.a += s * unit; })) < bound);
          CHECK(std::abs(body.torque_on_body()[axis] + slope(body, pose, [&](Pose& p, double s) {
                           p.of_body = after(quaternion_of(s * unit), p.of_body);
                         })) < bound);
          CHECK(std::abs(body.torque_on_wall()[axis] + slope(body, pose, [&](Pose& p, double s) {
                           p.of_wall = after(quaternion_of(s * unit), p.of_wall);
                         })) < bound);
        }
      }
}

// To second order of the step: motions of 1e-4 m, and overlaps of 4e-4 m, over curvatures of up to 20/m.
TEST_CASE("at first touch spheres are painted where they touched a curved wall first", "[sphere]") {
  Poses poses;
  for (const Shape& shape : shapes())
    for (int k = 0; k < 10; ++k) {
      Pose start = poses.start(shape);
      start.a += (BodyAtWall(shape, false, start).overlap(start) - 4e-4) * BodyAtWall::normal(shape, start);
      const Pose pose = poses.moved(start, 1e-4);
      BodyAtWall body(shape, false, start), before(shape, false, start);
      body.touch_first(start, pose);
      before.move_to(pose);
      INFO(shape.name << ", " << k);
      CHECK(norm(body.law_spring() - body.spring(pose)) < 1e-8);
      CHECK(body.from_painted() < 5e-6);
      // 80 N/m times the arcs, 1e-4 m, times what the points differ by.
      CHECK(norm(body.force() - before.force()) < 4e-8);
      CHECK(norm(body.torque_on_body() - before.torque_on_body()) < 4e-8);
    }
}

TEST_CASE("a closed path at a curved wall stores no energy in the spring of spheres", "[sphere]") {
  Poses poses;
  for (const bool hertz : {false, true})
    for (const Shape& shape : shapes()) {
      const Pose start = poses.start(shape);
      BodyAtWall body(shape, hertz, start);
      double largest = 0;
      for (int k = 0; k < 200; ++k) {
        body.move_to(poses.moved(start, 0.01));
        largest = std::max(largest, norm(body.law_spring()));
      }
      body.move_to(start);
      INFO((hertz ? "hertz, " : "linear, ") << shape.name);
      CHECK(largest > 0.01);
      // Places of up to 5 m are rounded to 4e-16 m.
      CHECK(norm(body.law_spring()) < 4e-15);
    }
}

namespace {

// Rolls without slip and twist as the place of a body turns about an axis through the origin, and climbs
// along it (m/rad); calls each() after each step.
void roll(const Shape& shape, Pose& pose, BodyAtWall& body, const Vec3& axis, double climb,
          const std::function<void()>& each) {
  constexpr int steps = 40000;
  const double turn = 4 * std::numbers::pi / steps;
  for (int k = 0; k < steps; ++k) {
    const Vec3 next = turned(turn * axis, pose.a) + climb * turn * axis, middle = 0.5 * (pose.a + next);
    const auto normal = [&](const Vec3& x) {
      return 1 / norm(x - shape.nearest(x)) * (x - shape.nearest(x));
    };
    // On the wall c moves, and on the body −R n; without slip ω × (−R n) = −(c′ + R n′) and ω·n = 0.
    const Vec3 moved =
        (shape.nearest(next) - shape.nearest(pose.a)) + body_radius * (normal(next) - normal(pose.a));
    pose.a = next;
    pose.of_body = after(quaternion_of(1 / body_radius * cross(normal(middle), moved)), pose.of_body);
    body.move_to(pose);
    each();
  }
}

}  // namespace

// Along a straight line of the wall, and along a great circle of the body, so far that points are painted
// anew a hundred times.
TEST_CASE("a sphere that rolls far along a curved wall has no spring", "[sphere]") {
  struct Rolling {
    Shape shape;
    Vec3 axis;     // of the way round, through the origin
    double climb;  // (m/rad) along it
  };
  const Vec3 z = {{0, 0, 1}};
  for (const Rolling& c : {Rolling{cylinder(3, 2.06), z, 0}, Rolling{cylinder(3, 2.06), z, 2},
                           Rolling{cylinder(0.3, 1.24), z, 0.1}, Rolling{ball(4, 3.08), {{1, -1, 0}}, 0},
                           Rolling{ball(1.5, 2.4), {{1, -1, 0}}, 0}, Rolling{edge, z, 0.2}}) {
    Pose pose = {c.shape.start, {}, quaternion_of({}), quaternion_of({})};
    BodyAtWall body(c.shape, false, pose);
    double largest = 0;
    roll(c.shape, pose, body, 1 / norm(c.axis) * c.axis, c.climb,
         [&] { largest = std::max(largest, norm(body.law_spring())); });
    // Steps of turn t leave t²/24 of the way in each direction: 1e-8 · 40 m; the body turns about its contact
    // by as much.
    INFO(c.shape.name << ", climb " << c.climb << ": " << largest << " m");
    CHECK(largest < 1e-6);
  }
}

// A spring across the way, which the arcs of body and wall stretch; painting anew takes out as much, and a
// little more.
TEST_CASE("a spring across straight rolling in and on a ball does not grow", "[sphere]") {
  for (const Shape& shape : {ball(1.5, 2.4), ball(4, 3.08), ball(1.3, 0.36)}) {
    constexpr double across = 1e-4;
    Pose pose = {shape.start, {}, quaternion_of({}), quaternion_of({})};
    BodyAtWall body(shape, false, pose);
    const Vec3 axis = 1 / std::sqrt(2.0) * Vec3{{1, -1, 0}}, along = cross(axis, 1 / norm(pose.a) * pose.a);
    const Vec3 aside = across / norm(pose.a) * along;
    pose.a = turned(aside, pose.a);
    body.move_to(pose);
    const double before = norm(body.law_spring());
    double largest = 0, least = 1;
    roll(shape, pose, body, turned(aside, axis), 0, [&] {
      largest = std::max(largest, norm(body.law_spring()));
      least = std::min(least, norm(body.law_spring()));
    });
    INFO(shape.name << ": " << least / before << " to " << largest / before);
    // Until they are painted anew arcs stretch it by φ²/6 of each half.
    CHECK(largest < (1 + 0.01 / 6 + 1e-3) * before);
    CHECK(least > 0.99 * before);
  }
}
