#pragma once

#include "contacts/contacts.hpp"
#include "surfaces/contact_spots.hpp"
#include "surfaces/placed_surface.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

namespace scree {

// The spots in which bodies of one tile touch meshes. A body and a mesh have several pairs, one for each
// spot, the nearest first; histories move from pair to pair with their spots, which pairs keep.
class MeshSpots {
 public:
  // After a neighbour search: the next evaluations are of other pairs.
  void renew() {
    std::swap(before_, surroundings_);
    surroundings_.clear();
    next_before_ = 0;
  }
  // Begins an evaluation.
  void begin() { next_ = 0; }
  // A body by its place in memory and its number, and a mesh by its number among the walls.
  struct Key {
    std::uint32_t place, wall, number;
    friend bool operator==(const Key&, const Key&) = default;
  };
  // Spots in which a body touches. Keys must be asked for in order of places and walls, the same ones in all
  // evaluations of the same pairs.
  const std::vector<NearestPoint>& find(const TriangleMesh& mesh, const SpotRule& rule, const Key& key,
                                        const SpotQuery& query);
  // The pairs of a body and a mesh.
  struct Pairs {
    PairGroup& group;
    std::size_t begin, end;
  };
  // The periodic domain in which a mesh is, and its orientation there.
  struct Surrounded {
    const Domain& domain;
    const Rotation& to_scene;
  };
  // Moves the histories of pairs to the pairs that have their spots now. The body is at x in the frame of the
  // mesh (m).
  void follow(const SpotRule& rule, const Vec3& x, const std::vector<NearestPoint>& spots, const Pairs& pairs,
              const Surrounded& by);
  // Then turns tangential springs as the normals of their spots have turned in the frame of the mesh.
  void turn_springs(const Rotation& to_scene, const std::vector<NearestPoint>& spots,
                    const Pairs& pairs) const;
  // Whether any of the pairs touched in the last evaluation.
  static bool touched(const Pairs& pairs);
  // Then: a spot in the middle of the step, in the frame of the mesh.
  NearestPoint middle(std::size_t spot, const NearestPoint& now) const;
  // Then keeps the spots.
  static void keep(const std::vector<NearestPoint>& spots, const Pairs& pairs);

 private:
  // Triangles that were near a body where it was.
  struct Surroundings {
    Key key;
    Vec3 centre;
    std::vector<NearTriangle> near;
    std::uint32_t nearest = 0;  // triangle in the last evaluation in which there was one
  };
  // What was known of a body before the last search; without triangles if nothing was.
  Surroundings known_before(const Key& key);
  std::vector<Surroundings> surroundings_, before_;  // of each body and mesh, in the order of the pairs
  std::size_t next_ = 0, next_before_ = 0;
  SpotFinder finder_;
  // Moves former spots by whole periods to where the body is, which has been folded since.
  void bring_former_near(const Vec3& x, const Surrounded& by);
  // The former spot whose history each pair has now, or -1.
  void find_origins(std::size_t pairs, std::size_t now);
  std::vector<double> numbers_;
  std::vector<int> origins_;
  std::vector<KeptSpot> former_;
  SpotMatches matches_;  // of spots and former ones
};

// Numbers of a pair in PairGroup::spots.
constexpr std::uint32_t spot_width = 7;

// Replaces `spots` by the spots of the pairs [begin, end) of a body and a mesh, as far as these touched.
void read_kept_spots(const PairGroup& group, std::size_t begin, std::size_t end,
                     std::vector<KeptSpot>& spots);

// Keeps a spot of a pair by its row, in the frame of its mesh.
void keep_spot(PairGroup& group, std::size_t row, const Vec3& point, const Vec3& normal);

// The spot that a pair has for a body (m) at x in the frame of its mesh, which may have moved since spots
// were kept; none if it does not touch there.
std::optional<NearestPoint> spot_of_pair(const TriangleMesh& mesh, const SpotRule& rule, const Vec3& x,
                                         double radius, const Contacts& contacts, const PairGroup& group,
                                         std::size_t pair);

}  // namespace scree
