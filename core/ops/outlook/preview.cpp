#include "core/ops/outlook/preview.h"

#include <algorithm>

#include "core/ops/rules/crossings.h"

namespace ryosen {

namespace {

constexpr std::size_t most_faces_tested = 200;  // beyond that the search for crossings would be felt

void run_and_roll_back(Mesh& mesh, Journal& journal, const AnyOp& op, std::size_t face_limit, Preview& result,
                       std::vector<Face>& changed, std::vector<Crossing>& crossings) {
  Edit edit(mesh, &journal);
  OpEffect effect = apply(edit, op);
  result.created = std::move(effect.created);
  result.deleted = std::move(effect.deleted);
  result.outline_only = effect.changed.size() > face_limit;
  if (result.outline_only) return;
  result.faces.reserve(effect.changed.size());
  for (Face f : effect.changed) {
    result.faces.push_back({f, FacePolygon(mesh, f)});
  }
  changed = std::move(effect.changed);
  if (changed.size() <= most_faces_tested) crossings = crossings_near(mesh, changed);
}

}  // namespace

Preview preview(Mesh& mesh, Journal& journal, const AnyOp& op, std::size_t face_limit) {
  Preview result;
  result.verdict = check(mesh, op);
  if (!result.verdict.legal()) return result;
  result.warnings = warnings(mesh, op);
  std::vector<Face> changed;
  std::vector<Crossing> crossings;
  run_and_roll_back(mesh, journal, op, face_limit, result, changed, crossings);
  if (crossings.empty()) return result;
  // Faces that cut through each other already are no news.
  const std::vector<Crossing> before = crossings_near(mesh, changed);
  std::vector<Element> witnesses;
  for (const auto& [f, g] : crossings) {
    if (std::binary_search(before.begin(), before.end(), Crossing(f, g))) continue;
    for (Face face : {f, g})
      if (mesh.exists(face) && std::find(witnesses.begin(), witnesses.end(), Element(face)) == witnesses.end())
        witnesses.push_back(face);
  }
  if (!witnesses.empty()) result.warnings.push_back({Rule::intersects, witnesses});
  return result;
}

}  // namespace ryosen
