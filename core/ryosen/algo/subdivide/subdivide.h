// Subdivision surfaces: finer meshes that tend to a smooth surface.
//
// Schemes and their masks: masks.h; creases and corners: creases.h. Boundaries are creases. Non-manifold and
// misoriented edges are too, and points with copies or several fans, and ends of wires, are corners: copies stay
// together. Steps add exactly: into_four V + E vertices, 2 E + 3 F edges, 4 F faces; into quads V + E + F, 2 E + C, C
// with C corners; sqrt(3) V + F, E + 3 F, 3 F, and at each kept edge that is cut two vertices and edges more, but one
// vertex and edge less for each face at it.
#pragma once

#include <optional>
#include <vector>

#include "ryosen/base/element.h"
#include "ryosen/base/message.h"
#include "ryosen/base/progress.h"
#include "ryosen/mesh/descent.h"

namespace ryosen::subdivide {

enum class Scheme { loop, catmull_clark, midpoint, sqrt3 };

struct Options {
  Scheme scheme = Scheme::loop;
  std::size_t steps = 1;
  std::optional<double> crease_angle_rad = {};  // edges whose faces bend by at least this are sharp
  std::vector<Element> sharp = {};              // edges that are sharp, vertices that are corners
  std::optional<double> sharp_steps = {};       // for so many steps; for ever without it
  bool to_limit = false;                        // vertices are put where they would come to in the end, and corners get
                                                // the normals there (limit_normals.h)
};

struct Subdivided {
  MeshColumns columns;
  std::size_t cut_faces = 0;  // were cut into triangles first
  std::size_t seams = 0;      // edges kept as creases by sqrt3 because the texture is torn there
  bool is_cancelled = false;
  std::optional<Text> fault = {};  // why there is no result: a clause
};

// Subdivides the mesh. Old elements keep their numbers, new ones come behind them. The result is the same for any
// number of threads, and after an affine map of the mesh that map of the result, but for rounding and where faces with
// rings are cut. Where it would take more memory than there is it throws std::bad_alloc before it begins. `descent`:
// told where elements come from, as an edit tells it; an edge that sqrt(3) swaps is new. O(size of the result).
Subdivided subdivided(const Mesh& mesh, const Options& options, Progress& progress, Descent* descent = nullptr);

}  // namespace ryosen::subdivide
