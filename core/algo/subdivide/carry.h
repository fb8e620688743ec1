// The attributes of the new elements of a subdivision: what lies within a face is linear there.
//
// Corner values (texture coordinates, normals) of a new vertex are blended within each face for itself, so seams stay;
// vertex colours are blended between the vertices; new faces have the material and group of the face they lie in.
//
// Values do not follow the masks of the places: those of vertices that are there stay, new ones are means. So a chart keeps
// its outline in the texture, and no value leaves what its face had; but where a mask moves a point to the side, as at the
// corner of a boundary, which comes inwards, its values are those of the place where it was.
#pragma once

#include "core/algo/subdivide/split_links.h"
#include "core/algo/subdivide/sqrt3_links.h"

namespace ryosen::subdivide {

// Fill the attributes of columns whose links are there.
void carry_split(const Mesh& mesh, const SplitNumbers& numbers, MeshColumns& out);
// A triangle that lies in two faces has the values of that of its number.
void carry_sqrt3(const Mesh& mesh, const Sqrt3Numbers& numbers, MeshColumns& out);

}  // namespace ryosen::subdivide
