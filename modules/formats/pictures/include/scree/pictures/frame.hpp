#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace scree::pictures {

// A flat wall; the particles are on the side to which the normal points.
struct Wall {
  std::string name;
  std::array<double, 3> point{};   // (m) any point of the plane
  std::array<double, 3> normal{};  // unit vector, towards the particles
};

// A wall of another shape, as triangles, in 2D as segments.
struct Surface {
  std::string name;
  std::vector<double> points;        // (m) (3P)
  std::vector<std::uint32_t> cells;  // three points of each triangle, in 2D two of each segment
  std::array<double, 3> force{};     // (N) of all contacts
  std::array<double, 3> torque{};    // (N m) about the origin of its frame
  // Of each cell, which has those of its facet; or empty.
  std::vector<double> normal_stress;  // (Pa) above 0 in compression
  std::vector<double> shear_stress;   // (Pa)
  std::vector<double> traction;       // (Pa) (3 each) force of the bodies over the area
  std::vector<double> sliding_work;   // (J/m²) that friction has dissipated since the start
};

// State of a scene at one time, as columns; N particles, C contacts. In 2D every z component is 0. id, radius
// and position always have N entries; the other particle columns have N entries, or none if the scene lacks
// the quantity. Contact columns have C entries each; those from contact_a on have none in files of earlier
// versions.
struct Frame {
  double time = 0;  // (s)
  std::uint64_t step = 0;
  int dimension = 3;  // 2 or 3
  std::string title;

  std::vector<std::int64_t> id;
  std::vector<double> radius;    // (m)
  std::vector<double> position;  // (m) (3N)
  std::vector<std::int32_t> material;
  std::vector<std::int32_t> coordination;  // number of contacts of the particle
  std::vector<double> velocity;            // (m/s) (3N)
  std::vector<double> spin;                // (rad/s) (3N)
  std::vector<double> force;               // (N) (3N) resultant
  std::vector<double> displacement;        // (m) (3N) since t = 0, without jumps at periodic faces
  std::vector<std::int32_t> group;         // index into groups; -1 in none
  std::vector<std::string> groups;         // names

  // A contact is a line between two centres, or between a centre and its projection onto a wall.
  std::vector<double> contact_from;              // (m) (3C)
  std::vector<double> contact_to;                // (m) (3C)
  std::vector<double> contact_normal_force;      // (N)
  std::vector<double> contact_tangential_force;  // (N)
  std::vector<double> contact_overlap;           // (m)
  std::vector<std::uint8_t> contact_sliding;     // 0 or 1
  std::vector<std::int64_t> contact_a;           // id of the body on which the force acts
  std::vector<std::int64_t> contact_b;           // id of the other body; -1 at a wall
  std::vector<std::int32_t> contact_wall;        // index into walls, then surfaces; -1 between bodies
  std::vector<double> contact_normal;            // (3C) unit vector from b to a
  std::vector<double> contact_force;             // (N) (3C) on a
  std::vector<double> contact_point;             // (m) (3C) in the middle of the overlap

  std::vector<Wall> walls;
  std::vector<Surface> surfaces;
  std::array<double, 3> lower{};  // (m) corner of the scene; fixes the camera for all frames.
  std::array<double, 3>
      upper{};  // (m) opposite corner; if upper <= lower the camera is fitted to the particles

  std::size_t particle_count() const { return radius.size(); }
  std::size_t contact_count() const { return contact_normal_force.size(); }
};

}  // namespace scree::pictures
