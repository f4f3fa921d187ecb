#pragma once

#include <scree/scenario/table_keys.hpp>

namespace scree::scenario {

struct GroupKeys : TableKeys {
  GroupKeys()
      : TableKeys("group", "[[group]]",
                  "bodies that are held, moved or loaded together, or start with a velocity") {}
  StringKey name =
      string("name", "unique, for messages, for groups and leave_out of probes, and for pictures");
  Key where = other("where", "table", Range::any(), "required", "which bodies, see group.where");
  Key fixed = other(
      "fixed", "true, false or an array of x, y, z, rotation, rotation_x, ...", Range::any(), "optional",
      "true: no force moves or turns them; an array: not along these axes, nor about them; false: those "
      "that a state holds move again");
  Key velocity =
      other("velocity", "[x, y, z]", Range::any("m/s"), "optional",
            "at the start, in place of the one that they have; it lasts along fixed axes (without it 0), "
            "where each component may be a function of time");
  Key spin =
      other("spin", "[x, y, z], in 2D a number", Range::any("rad/s"), "optional", "the same of rotations");
  Key displacement =
      other("displacement", "[x, y, z]", Range::any("m"), "optional",
            "along fixed axes, in place of velocity: functions of time, of which increments count");
  Key force = other("force", "[x, y, z]", Range::any("N"), "optional",
                    "on each of them, besides all others; each component may be a function of time");
  Key torque =
      other("torque", "[x, y, z], in 2D a number", Range::any("N m"), "optional", "the same of torques");
};

struct GroupWhereKeys : TableKeys {
  GroupWhereKeys()
      : TableKeys("group.where", "where = { }",
                  "the bodies of a group meet all conditions; regions are of centres, at the start") {}
  Key ids = other("ids", "[1, 2, ...]", Range::any(), "optional", "of the bodies");
  StringKey particles = string("particles", "name of a [[particles]]", "optional");
  StringKey material = string("material", "name of a [[material]]", "optional");
  Key x = other("x", "[low, high]", Range::any("m"), "optional", "both ends included");
  Key y = other("y", "[low, high]", Range::any("m"), "optional", "both ends included");
  Key z = other("z", "[low, high]", Range::any("m"), "optional, in 3D", "both ends included");
  Key sphere = other("sphere", "table", Range::any(), "optional", "see group.where.sphere");
  Key cylinder = other("cylinder", "table", Range::any(), "optional", "see group.where.cylinder");
};

struct SphereKeys : TableKeys {
  SphereKeys() : TableKeys("group.where.sphere", "sphere = { }", "a sphere, in 2D a circle") {}
  Key centre = other("centre", "[x, y, z]", Range::any("m"), "required", "of the sphere");
  NumberKey radius = number("radius", Range::positive("m"), "of the sphere");
};

struct CylinderKeys : TableKeys {
  CylinderKeys()
      : TableKeys("group.where.cylinder", "cylinder = { }",
                  "a cylinder between two points, in 2D a rectangle") {}
  Key from = other("from", "[x, y, z]", Range::any("m"), "required", "one end of its axis");
  Key to = other("to", "[x, y, z]", Range::any("m"), "required", "the other end");
  NumberKey radius = number("radius", Range::positive("m"), "of the cylinder");
};

inline const GroupKeys group_keys;
inline const GroupWhereKeys group_where_keys;
inline const SphereKeys sphere_keys;
inline const CylinderKeys cylinder_keys;

}  // namespace scree::scenario
