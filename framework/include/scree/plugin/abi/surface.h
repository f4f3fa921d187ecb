/* Surfaces of boundaries. Part of abi.h, which plug-ins include. */
#ifndef SCREE_ABI_SURFACE_H
#define SCREE_ABI_SURFACE_H

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

enum scree_shape {
  SCREE_FLAT = 0,     /* in the plane z = 0; in 2D on the line y = 0 */
  SCREE_REVOLVED = 1, /* a straight line that is turned about the axis z: cylinder, cone, disc, ring; 3D */
  SCREE_BALL = 2,     /* a sphere about the origin; in 2D a circle */
  SCREE_MESH = 3      /* triangles; 3D */
};

/* From which side bodies touch a surface. With one side they are pushed back to it even if their centre has passed the
 * surface; with both, to the side on which their centre is. At an edge a body is pushed away from the nearest point of it. */
enum scree_side {
  SCREE_BOTH_SIDES = 0,
  SCREE_OUTSIDE = 1, /* z > 0 of a flat one (in 2D y > 0), away from the axis or the origin of others */
  SCREE_INSIDE = 2
};

/* A surface in its own frame. size (m), of
 *   SCREE_FLAT      half lengths along x and y, in 2D along x; may be infinite
 *   SCREE_REVOLVED  radius and z of the start of the line, radius and z of its end: radii >= 0 and finite, z of the end not
 *                   below z of the start; both z may be infinite if the radii are equal. If z are equal, `outside`
 *                   is z > 0 if the radius decreases from start to end
 *   SCREE_BALL      radius, and limits along z, in 2D along y, which may be infinite
 *   SCREE_MESH      factor of its points, and the angle (rad) below which two spots count as one, as seen from the centre
 *                   of a body. A body touches a mesh in each spot where the distance has a local minimum. A mesh with
 *                   one side must be closed; `outside` is where it encloses nothing */
typedef struct scree_surface {
  uint32_t shape, side;
  double size[4];
  const double*
      mesh; /* (optional) of SCREE_MESH: numbers as of a parameter of the type SCREE_MESH_FILE, which the host copies */
  uint64_t mesh_size; /* number of them */
} scree_surface;

/* Where the frame of a surface is, and how it moves. */
typedef struct scree_frame {
  double position[3];     /* (m) of its origin */
  double orientation[4];  /* unit quaternion w, x, y, z; in 2D turns about z */
  double velocity[3];     /* (m/s) of the origin at the end of the step */
  double spin[3];         /* (rad/s) at the end of the step; in 2D about z */
  double mid_velocity[3]; /* (m/s) displacement of the origin in the step / step */
  double mid_spin[3];     /* (rad/s) rotation vector of the turn in the step / step */
} scree_frame;

typedef struct scree_frame_load { /* of all contacts */
  double force[3];                /* (N) */
  double torque[3];               /* (N m) about the origin of the frame; in 2D about z */
} scree_frame_load;

#ifdef __cplusplus
}
#endif
#endif
