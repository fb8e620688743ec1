#include "ryosen/ops/preview/preview.h"

#include <algorithm>

#include "ryosen/mesh/circulate.h"
#include "ryosen/ops/rules/crossings.h"

namespace ryosen {

namespace {

// What is looked at while the operator is done, and compared with what was there before.
struct Seen {
  std::vector<Face> faces;
  std::vector<Vertex> vertices;
  std::vector<Crossing> crossings;
  PointPairs at_one_place;
};

// The same operator at the lowest halfedge of the cycle, where it is about one.
AnyOp at_start_of_cycle(const Mesh& mesh, AnyOp op) {
  if (info_of(op).subject != Subject::cycle) return op;
  std::visit(
      [&](auto& o) {
        if constexpr (requires { Halfedge(o.halfedge); })
          for (Halfedge h : loop(mesh, o.halfedge)) o.halfedge = std::min(o.halfedge, h);
      },
      op);
  return op;
}

void run_and_roll_back(Mesh& mesh, Journal& journal, const AnyOp& op, std::size_t face_limit, Preview& result,
                       Seen& seen) {
  Edit edit(mesh, &journal);
  OpEffect effect = apply(edit, op);
  result.created = std::move(effect.created);
  result.deleted = std::move(effect.deleted);
  result.outline_only = effect.changed.size() > face_limit;
  if (result.outline_only) return;
  result.faces.reserve(effect.changed.size());
  for (Face f : effect.changed) {
    result.faces.push_back({f, FacePolygon(mesh, f)});
    GhostFace& ghost = result.faces.back();
    for (Halfedge h : ghost.polygon.corners()) ghost.vertices.push_back(mesh.from(h));
  }
  seen.faces = std::move(effect.changed);
  for (const Element& element : result.created)
    if (element.kind == Element::Kind::vertex) seen.vertices.push_back(element.vertex());
  if (const auto* move = std::get_if<MoveVertex>(&op)) seen.vertices.push_back(move->vertex);
  seen.crossings = crossings_near(mesh, seen.faces);
  seen.at_one_place = points_at_one_place(mesh, seen.faces, seen.vertices);
}

// Warns of the pairs that were not so before, by those of the two that have a name already.
template <class Pair, class WasSo>
void warn_of_news(const Mesh& mesh, Rule rule, const std::vector<Pair>& pairs, const WasSo& was_so, Preview& result) {
  std::vector<Element> witnesses;
  for (const Pair& pair : pairs) {
    if (was_so(pair)) continue;
    for (const auto element : {pair.first, pair.second})
      if (mesh.exists(element) && mesh.is_alive(element) &&
          std::find(witnesses.begin(), witnesses.end(), Element(element)) == witnesses.end())
        witnesses.push_back(element);
  }
  if (!witnesses.empty()) result.warnings.push_back({rule, witnesses});
}

}  // namespace

Preview preview(Mesh& mesh, Journal& journal, const AnyOp& asked, std::size_t face_limit) {
  Preview result;
  result.verdict = check(mesh, asked);
  if (!result.verdict.legal()) return result;
  const AnyOp op = at_start_of_cycle(mesh, asked);
  result.warnings = warnings(mesh, op);
  Seen seen;
  run_and_roll_back(mesh, journal, op, face_limit, result, seen);
  if (result.outline_only) return result;
  for (Reason& reason : shape_warnings(mesh, result.faces, result.warnings))
    result.warnings.push_back(std::move(reason));
  const auto is_known = [&](Vertex v) { return mesh.exists(v) && mesh.is_alive(v); };
  const auto were_at_one_place = [&](const std::pair<Vertex, Vertex>& pair) {
    return is_known(pair.first) && is_known(pair.second) && mesh.position(pair.first) == mesh.position(pair.second);
  };
  warn_of_news(mesh, Rule::same_place, seen.at_one_place, were_at_one_place, result);
  if (seen.crossings.empty()) return result;
  const std::vector<Crossing> before = crossings_near(mesh, seen.faces);
  const auto crossed = [&](const Crossing& pair) { return std::binary_search(before.begin(), before.end(), pair); };
  warn_of_news(mesh, Rule::intersects, seen.crossings, crossed, result);
  return result;
}

}  // namespace ryosen
