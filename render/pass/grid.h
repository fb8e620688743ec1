// The grid pass: lines on the ground below the mesh.
#pragma once

#include "render/gl/program.h"
#include "render/mesh_buffers.h"
#include "render/pass/frame.h"
#include "ryosen/base/result.h"

namespace ryosen {

// Where the ground is, and how far apart the lines on it: at whole multiples of the step in X and in Z.
struct Ground {
  double step = 1;                // in mesh units: 1, 2 or 5 times a power of ten
  double height = 0;              // Y, in buffer space as what follows
  double x = 0, z = 0;            // the middle
  double reach = 1;               // from there, where it has faded
  double step_scaled = 1;         // the step
  double line_x = 0, line_z = 0;  // how many steps the middle is from a tenth line, and from where X or Z is 0
  double zero_x = 0, zero_z = 0;
  friend bool operator==(const Ground&, const Ground&) = default;
};
// Below what has these bounds in this space; around the origin where there is nothing.
Ground ground_below(const DrawBox& bounds, const BufferSpace& space);

class GridPass {
 public:
  explicit GridPass(std::optional<Failure>& failure) : program_(failure, "grid.vert", "grid.frag") {}

  // Behind what is nearer, and over the background; from below too. Beyond the far plane as far as it reaches.
  void draw(const Frame& frame, const Ground& ground) const;

 private:
  Program program_;
  VertexArray no_attributes_{"grid"};
};

}  // namespace ryosen
