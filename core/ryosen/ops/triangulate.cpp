#include "ryosen/ops/triangulate.h"

#include <algorithm>
#include <cassert>

#include "ryosen/mesh/live_elements.h"
#include "ryosen/ops/op_series.h"
#include "ryosen/ops/parameters/member_values.h"
#include "ryosen/ops/rules/face_geometry.h"
#include "ryosen/ops/rules/face_lists.h"
#include "ryosen/ops/rules/face_triangles.h"
#include "ryosen/ops/rules/shares.h"

namespace ryosen {

namespace {

using namespace parameters;

constexpr OpParameter triangulate_parameters[] = {with_words(
    {"face", "Face", "面", "the face that is cut (all faces if it is left out)", "分割する面（省くとすべての面）"},
    optional(face<&Triangulate::face>("fN")))};

}  // namespace

constinit const OpInfo Triangulate::info{.id = "triangulate",
                                         .name_en = "Triangulate",
                                         .name_ja = "三角形分割",
                                         .line = {.lists = {triangulate_parameters}},
                                         .help_en = "cuts a face, or all faces, into triangles",
                                         .help_ja = "面（省くとすべての面）を三角形に分割する",
                                         .target = OpTargetKind::face,
                                         .group = OpGroup::refine,
                                         .topology = Topology::kept,
                                         .in_series = triangulations_in_series};

namespace {

constexpr std::size_t most_witnesses = 24;

bool has_more_than_three(const Mesh& m, Face f) { return m.has_rings(f) || !is_triangle(m, m.halfedge(f)); }

// Whether a face can be triangulated, and the triangles.
struct Cut {
  FacePolygon polygon;
  std::vector<CornerTriangle> triangles;
  Verdict verdict;
};

// `equal` is another face on its points, if there is one.
Cut cut_of(const Mesh& m, Face f, Face equal) {
  Cut cut;
  if (!has_more_than_three(m, f)) {
    cut.verdict.refuse(Rule::triangulated, {f});
    return cut;
  }
  if (equal) cut.verdict.refuse(Rule::loses_duplicate, {f, equal});
  cut.polygon.read(m, f);
  cut.triangles = triangles_of_face(m, cut.polygon);
  if (!cut.triangles.empty()) return cut;
  Reason reason{Rule::edge_exists, {}};
  for (Edge e : edges_across(m, cut.polygon))
    if (reason.witnesses.size() < most_witnesses) reason.witnesses.push_back(e);
  reason.witnesses.push_back(f);
  cut.verdict.reasons.push_back(std::move(reason));
  return cut;
}

Cut cut_of(const Mesh& m, Face f) { return cut_of(m, f, has_more_than_three(m, f) ? equal_face(m, f) : Face()); }

// Finds the halfedges between corners and creates new edges on first use.
class Sides {
 public:
  Sides(Edit& edit, const FacePolygon& polygon, OpEffect& effect) : edit_(edit), polygon_(polygon), effect_(effect) {}

  Halfedge between(std::uint32_t a, std::uint32_t b) {
    if (polygon_.is_side(a, b)) return polygon_.corners()[a];
    const auto made = std::find_if(open_.begin(), open_.end(), [&](const New& n) { return n.from == b && n.to == a; });
    Halfedge h;
    if (made != open_.end()) {
      h = twin(made->halfedge);
      *made = open_.back();
      open_.pop_back();
    } else {
      const Mesh& m = edit_.mesh();
      h = edit_.add_edge(m.from(polygon_.corners()[a]), m.from(polygon_.corners()[b]));
      edit_.fresh(edge(h));
      effect_.created.push_back(edge(h));
      open_.push_back({a, b, h});
    }
    edit_.derive(h, polygon_.corners()[a], Derivation::copies);
    return h;
  }

 private:
  struct New {
    std::uint32_t from, to;
    Halfedge halfedge;
  };

  Edit& edit_;
  const FacePolygon& polygon_;
  OpEffect& effect_;
  std::vector<New> open_;  // new edges with one side used
};

void apply_cut(Edit& edit, Face f, const Cut& cut, OpEffect& effect) {
  const Mesh& m = edit.mesh();
  while (m.has_rings(f)) edit.remove_ring(f, m.first_ring(f));
  Sides sides(edit, cut.polygon, effect);
  bool is_first = true;
  std::vector<Face> parts;
  for (const CornerTriangle& t : cut.triangles) {
    const Halfedge a = sides.between(t[0], t[1]), b = sides.between(t[1], t[2]), c = sides.between(t[2], t[0]);
    const Face face = is_first ? f : edit.add_face(a);
    if (is_first)
      edit.set_halfedge(f, a);
    else
      effect.created.push_back(face);
    parts.push_back(face);
    is_first = false;
    edit.connect(a, b);
    edit.connect(b, c);
    edit.connect(c, a);
    for (Halfedge h : {a, b, c}) edit.set_face(h, face);
    effect.changed.push_back(face);
  }
  edit.divide<Face>(f, parts, [&] { return areas_of(m, parts); });
}

}  // namespace

Verdict Triangulate::check(const Mesh& mesh) const {
  Verdict verdict;
  if (face) {
    if (is_gone(mesh, face, verdict)) return verdict;
    return cut_of(mesh, face).verdict;
  }
  // Legal if any face can be triangulated; else report the reasons of the first non-triangle.
  EqualFaceIndex equal(mesh);
  for (const Face f : live_faces(mesh)) {
    if (!has_more_than_three(mesh, f)) continue;
    if (!verdict.legal() && equal.has_equal(f)) continue;
    const Verdict own = cut_of(mesh, f).verdict;
    if (own.legal()) return {};
    if (verdict.legal()) verdict = own;
  }
  if (verdict.legal()) verdict.refuse(Rule::triangulated, {});
  return verdict;
}

std::vector<Reason> Triangulate::warnings(const Mesh& mesh) const {
  if (!face) return {};
  const Cut cut = cut_of(mesh, face);
  if (!cut.polygon.is_finite()) return {};
  const std::vector<glm::dvec3>& p = cut.polygon.places();
  std::vector<FaceGeometry> parts;
  for (const CornerTriangle& t : cut.triangles) parts.push_back(FaceGeometry({p[t[0]], p[t[1]], p[t[2]]}));
  return warnings_of_parts(face, FaceGeometry(cut.polygon.keyhole_walk()), parts);
}

OpEffect Triangulate::apply(Edit& edit) const {
  const Mesh& m = edit.mesh();
  assert(check(m).legal());
  OpEffect effect;
  if (face) {
    apply_cut(edit, face, cut_of(m, face), effect);
    return effect;
  }
  const std::uint32_t slots = m.face_slots();
  EqualFaceIndex equal(m);
  for (std::uint32_t i = 0; i < slots; ++i) {
    if (!m.is_alive(Face(i)) || !has_more_than_three(m, Face(i)) || equal.has_equal(Face(i))) continue;
    const Cut cut = cut_of(m, Face(i), Face());
    if (cut.verdict.legal()) apply_cut(edit, Face(i), cut, effect);
  }
  return effect;
}

namespace {

class Triangulations : public OneByOne {
 public:
  explicit Triangulations(Edit& edit) : OneByOne(edit), equal_(edit.mesh()) {}
  std::optional<Rule> broken_rule(const AnyOp& op) override {
    const Mesh& m = edit_.mesh();
    const Face f = std::get<Triangulate>(op).face;
    if (!is_there(m, f)) return Rule::deleted;
    if (has_more_than_three(m, f) && equal_.has_equal(f)) return Rule::loses_duplicate;
    cut_ = cut_of(m, f, Face());
    return first_rule_of(cut_.verdict);
  }
  void apply(const AnyOp& op) override {
    OpEffect effect;
    apply_cut(edit_, std::get<Triangulate>(op).face, cut_, effect);
  }

 private:
  EqualFaceIndex equal_;
  Cut cut_;
};

}  // namespace

std::unique_ptr<OpSeries> triangulations_in_series(Edit& edit) { return std::make_unique<Triangulations>(edit); }

}  // namespace ryosen
