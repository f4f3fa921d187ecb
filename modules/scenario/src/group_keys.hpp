#pragma once

#include <scree/scenario/table_keys.hpp>

namespace scree::scenario {

struct GroupKeys : TableKeys {
  GroupKeys() : TableKeys("group", "[[group]]", "bodies that are fixed, or start with a velocity") {}
  StringKey name = string("name", "unique, for messages");
  Key where = other("where", "table", Range::any(), "required", "which bodies, see group.where");
  Key fixed = other("fixed", "true or false", Range::any(), "optional",
                    "true: they neither move nor turn; false: those that a state has fixed move again");
  Key velocity = other("velocity", "[x, y, z]", Range::any("m/s"), "optional",
                       "at the start, in place of the one that they have");
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
