#include "ryosen/ops/poke.h"

#include <algorithm>
#include <cassert>

#include "ryosen/geometry/is_finite.h"
#include "ryosen/mesh/face_polygon.h"
#include "ryosen/ops/op_series.h"
#include "ryosen/ops/parameters/member_values.h"
#include "ryosen/ops/rules/face_geometry.h"
#include "ryosen/ops/rules/face_lists.h"
#include "ryosen/ops/rules/shares.h"

namespace ryosen {

namespace {

using namespace parameters;

constexpr OpParameter poke_parameters[] = {
    with_words({"face", "Face", "面", "the face that gets a vertex", "頂点を置く面"},
               required(face<&Poke::face>("fN"))),
    with_words({"at", "Position", "座標", "where the vertex lies (in the middle of the corners if it is left out)",
                "頂点の座標（省くと角の中央）"},
               optional(position<&Poke::target>()))};

}  // namespace

constinit const OpInfo Poke::info{.id = "poke",
                                  .name_en = "Poke face",
                                  .name_ja = "面の放射分割",
                                  .line = {.lists = {poke_parameters}},
                                  .help_en = "puts a vertex into the face and joins it to all corners",
                                  .help_ja = "面の中に頂点を置き、すべての角と結ぶ",
                                  .target = OpTargetKind::face,
                                  .group = OpGroup::refine,
                                  .topology = Topology::kept,
                                  .in_series = pokes_in_series};

glm::dvec3 Poke::position(const Mesh& mesh) const {
  if (target) return *target;
  std::vector<glm::dvec3> places;
  for (Vertex v : vertices_around(mesh, face))
    if (is_finite(mesh.position(v))) places.push_back(mesh.position(v));
  glm::dvec3 mean{};
  for (const glm::dvec3& p : places) mean += p / static_cast<double>(places.size());
  return mean;
}

Verdict Poke::check(const Mesh& mesh) const {
  Verdict verdict;
  if (is_gone(mesh, face, verdict)) return verdict;
  refuse_rings(mesh, face, verdict);
  if (const Face other = equal_face(mesh, face)) verdict.refuse(Rule::loses_duplicate, {face, other});
  return verdict;
}

std::vector<Reason> Poke::warnings(const Mesh& mesh) const {
  const glm::dvec3 p = position(mesh);
  const FacePolygon polygon(mesh, face);
  const std::vector<glm::dvec3>& places = polygon.places();
  std::vector<FaceGeometry> parts;
  for (std::size_t i = 0; i < places.size(); ++i)
    parts.push_back(FaceGeometry({places[i], places[(i + 1) % places.size()], p}));
  return warnings_of_parts(face, FaceGeometry(places), parts);
}

OpEffect Poke::apply(Edit& edit) const {
  assert(check(edit.mesh()).legal());
  return poke(edit, face, position(edit.mesh()));
}

OpEffect poke(Edit& edit, Face face, const glm::dvec3& place) {
  const Mesh& m = edit.mesh();
  const FacePolygon polygon(m, face);
  const std::vector<Halfedge>& sides = polygon.corners();
  const std::size_t n = sides.size();
  OpEffect effect;
  const Vertex centre = edit.add_vertex(place);
  effect.created.push_back(centre);
  std::vector<Vertex> around;
  for (Halfedge h : sides) around.push_back(m.from(h));
  const std::vector<double> equal_weights(n, 1 / static_cast<double>(n));
  edit.derive<Vertex>(centre, around, equal_weights, Derivation::copies);

  std::vector<Halfedge> spokes;  // from corner i to the centre
  for (Halfedge h : sides) {
    spokes.push_back(edit.add_edge(m.from(h), centre));
    edit.fresh(edge(spokes.back()));
  }
  edit.derive<Halfedge>(twin(spokes[0]), sides, equal_weights, Derivation::copies);
  for (std::size_t i = 0; i < n; ++i) {
    edit.derive(spokes[i], sides[i], Derivation::copies);
    if (i > 0) edit.derive(twin(spokes[i]), twin(spokes[0]), Derivation::copies);
  }
  std::vector<Face> parts;
  for (std::size_t i = 0; i < n; ++i) {
    const Face f = i == 0 ? face : edit.add_face(sides[i]);
    parts.push_back(f);
    const Halfedge in = spokes[(i + 1) % n], out = twin(spokes[i]);
    edit.connect(sides[i], in);
    edit.connect(in, out);
    edit.connect(out, sides[i]);
    for (Halfedge h : {sides[i], in, out}) edit.set_face(h, f);
    effect.created.push_back(edge(spokes[i]));
    if (i > 0) effect.created.push_back(f);
    effect.changed.push_back(f);
  }
  edit.set_halfedge(centre, twin(spokes[0]));
  edit.divide<Face>(face, parts, [&] { return areas_of(m, parts); });
  return effect;
}

namespace {

class Pokes : public OneByOne {
 public:
  explicit Pokes(Edit& edit) : OneByOne(edit), equal_(edit.mesh()) {}
  std::optional<Rule> broken_rule(const AnyOp& op) override {
    const Face f = std::get<Poke>(op).face;
    Verdict verdict;
    if (!is_gone(edit_.mesh(), f, verdict)) refuse_rings(edit_.mesh(), f, verdict);
    if (!verdict.legal()) return verdict.reasons[0].rule;
    return equal_.has_equal(f) ? std::optional(Rule::loses_duplicate) : std::nullopt;
  }

 private:
  EqualFaceIndex equal_;
};

}  // namespace

std::unique_ptr<OpSeries> pokes_in_series(Edit& edit) { return std::make_unique<Pokes>(edit); }

}  // namespace ryosen
