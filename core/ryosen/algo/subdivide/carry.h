// The attributes of the elements of the next level of a subdivision.
//
// Means of vertices (colours) and the values of pools (texture coordinates, normals) go by the masks of the places:
// where a mask moves a point, its values are those of the place that it comes to, but across a seam, along which each
// chart keeps an outline of its own. Seams stay, and no value leaves what the faces around it had. All else is what the
// rules make of the elements that the new ones come from (step_sources.h).
#pragma once

#include "ryosen/algo/subdivide/creases.h"
#include "ryosen/algo/subdivide/level_links.h"
#include "ryosen/algo/subdivide/subdivide.h"

namespace ryosen::subdivide {

// Fill the attributes of columns whose links and places are there.
void carry_split(const Mesh& mesh, const Creases& creases, Scheme scheme, const SplitNumbers& numbers,
                 MeshColumns& out);
void carry_sqrt3(const Mesh& mesh, const Creases& creases, bool cuts_creases, const Sqrt3Numbers& numbers,
                 MeshColumns& out);
// Moves the values of a mesh to where its vertices come to in the end.
void carry_to_limit(const Mesh& mesh, const Creases& creases, Scheme scheme, MeshColumns& out);

}  // namespace ryosen::subdivide
