#include "ryosen/ops/rules/face_corners.h"

#include <algorithm>
#include <vector>

#include "ryosen/mesh/circulate.h"
#include "ryosen/mesh/copies.h"
#include "ryosen/ops/op.h"

namespace ryosen {

namespace {

// The face sides that end at a point, over all its copies; only of face `only` if given.
std::vector<Halfedge> sides_into(const Mesh& mesh, Vertex v, Face only) {
  std::vector<Halfedge> sides;
  for_each_copy(mesh, v, [&](Vertex copy) {
    for (Halfedge h : outgoing(mesh, copy)) {
      const Halfedge into = mesh.prev(h);
      if (!mesh.is_outside(into) && (!only || mesh.face(into) == only)) sides.push_back(into);
    }
  });
  return sides;
}

std::vector<Face> common_faces(const Mesh& mesh, Vertex a, Vertex b) {
  std::vector<Face> found;
  const std::vector<Halfedge> at_b = sides_into(mesh, b, Face());
  for (Halfedge side : sides_into(mesh, a, Face())) {
    const Face f = mesh.face(side);
    const bool has_both = std::any_of(at_b.begin(), at_b.end(), [&](Halfedge other) { return mesh.face(other) == f; });
    if (has_both && std::find(found.begin(), found.end(), f) == found.end()) found.push_back(f);
  }
  return found;
}

// The face to use if none was named.
Face choose_face(const Mesh& mesh, Vertex a, Vertex b, ArgumentReader& in) {
  const std::vector<Face> faces = common_faces(mesh, a, b);
  // Joined points are refused in any face.
  if (faces.size() == 1 || (faces.size() > 1 && are_joined(mesh, a, b))) return faces[0];
  if (faces.empty()) return Face();
  std::string list;
  for (Face f : faces) list += (list.empty() ? "" : ", ") + name_of(mesh, f);
  const std::string pair = name_of(mesh, a) + " and " + name_of(mesh, b);
  in.fail(NameError::ambiguous, {pair + " share several faces; name one of " + list,
                                 name_of(mesh, a) + " と " + name_of(mesh, b) +
                                     " は複数の面を共有しています。次から指定してください：" + list});
  return Face();
}

}  // namespace

FaceCorners read_face_corners(const Mesh& mesh, ArgumentReader& in) {
  FaceCorners corners;
  const Vertex a = in.vertex(), b = in.vertex();
  if (in.failed()) return corners;
  const Face f = in.is_face_next() ? in.face() : choose_face(mesh, a, b, in);
  if (in.failed()) return corners;
  const std::vector<Halfedge> at_a = sides_into(mesh, a, f), at_b = sides_into(mesh, b, f);
  for (const auto& [v, sides] : {std::pair(a, &at_a), std::pair(b, &at_b)})
    if (sides->empty())
      in.fail(NameError::never_existed,
              {name_of(mesh, v) + " is no corner of " + (f ? name_of(mesh, f) : "a face"),
               name_of(mesh, v) + " は" + (f ? " " + name_of(mesh, f) + " " : "どの面") + "の角でもありません"});
  if (in.failed()) return corners;
  if (f.is_none()) return {at_a[0], at_b[0]};  // in different faces
  corners.into_a = at_a.size() > 1 || in.left() == 2 ? in.corner(a, at_a) : at_a[0];
  corners.into_b = in.corner(b, at_b);
  return corners;
}

std::string face_corners_text(const Mesh& mesh, const FaceCorners& corners) {
  if (!is_there(mesh, corners.into_a) || !is_there(mesh, corners.into_b))
    return name_of(mesh, corners.into_a) + " " + name_of(mesh, corners.into_b);
  const Vertex a = mesh.to(corners.into_a), b = mesh.to(corners.into_b);
  const Face f = mesh.face(corners.into_a);
  std::string text = name_of(mesh, a) + " " + name_of(mesh, b);
  if (f.is_none() || f != mesh.face(corners.into_b)) return text;
  text += " " + name_of(mesh, f);
  if (sides_into(mesh, a, f).size() < 2 && sides_into(mesh, b, f).size() < 2) return text;
  return text + " " + name_of(mesh, corners.into_a) + " " + name_of(mesh, corners.into_b);
}

bool are_corners_of_one_face(const Mesh& mesh, const FaceCorners& corners, Verdict& verdict) {
  if (is_gone(mesh, corners.into_a, verdict) || is_gone(mesh, corners.into_b, verdict)) return false;
  const Vertex a = mesh.to(corners.into_a), b = mesh.to(corners.into_b);
  if (same_point(mesh, a, b)) {
    verdict.refuse(Rule::same_vertex, {a});
    return false;
  }
  if (mesh.is_outside(corners.into_a) || mesh.face(corners.into_a) != mesh.face(corners.into_b)) {
    verdict.refuse(Rule::different_faces, {a, b});
    return false;
  }
  return true;
}

}  // namespace ryosen
