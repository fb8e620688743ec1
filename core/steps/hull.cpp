// The incremental convex hull of text 004: for each point the faces that it sees, their horizon, the faces that go and
// those that come, in the records of the text's DCEL and, beside it, on the kernel.
#include <algorithm>
#include <charconv>

#include "core/hull/hull_steps.h"
#include "core/indexed/from_indexed.h"
#include "core/mesh/copies.h"
#include "core/mesh/edit.h"
#include "core/steps/play_texts.h"
#include "core/steps/players.h"
#include "core/steps/sources.h"

namespace ryosen::steps {

namespace {

using forms::DcelRecords;

// More points than this are not played: all steps are kept.
constexpr std::size_t most_points = 20000;

std::vector<glm::dvec3> points_of(const Mesh& mesh) {
  std::vector<glm::dvec3> points;
  for (std::uint32_t i = 0; i < mesh.vertex_slots(); ++i)
    if (mesh.is_alive(Vertex(i)) && point(mesh, Vertex(i)) == Vertex(i)) points.push_back(mesh.position(Vertex(i)));
  return points;
}

Mesh mesh_of_points(const std::vector<glm::dvec3>& points) {
  IndexedMesh list;
  list.positions = points;
  return from_indexed(std::move(list));
}

class HullPlay {
 public:
  HullPlay(const std::vector<glm::dvec3>& points, HullSteps& hull) : mesh_(mesh_of_points(points)), hull_(hull) {}

  std::unique_ptr<Sequence> play() && {
    while (const HullStep* const step = hull_.next()) take(*step);
    const std::string made = std::to_string(hull_.faces_made()), points = std::to_string(mesh_.live().vertices);
    return std::make_unique<RecordedSteps>(std::move(mesh_), std::move(journal_), std::move(steps_),
                                           std::move(positions_),
                                           Text{"The hull of " + points + " points; all steps make " + made + " faces.",
                                                points + " 点の凸包。全手順で面を " + made + " 枚作ります。"});
  }

 private:
  void take(const HullStep& step) {
    Step told{caption(step), {}, {}, step.seen.empty() ? hull_text : horizon_text, {}};
    told.caption = told.caption + Text{" Faces made so far: " + std::to_string(hull_.faces_made()),
                                       "これまでに作った面の数 " + std::to_string(hull_.faces_made())};
    told.marks.push_back({Role::asked, Vertex(step.point)});
    for (const std::uint32_t f : step.seen) add_mark(told, Role::visible, face_[f]);
    for (const std::uint32_t h : step.horizon) add_mark(told, Role::horizon, edge(half_[h]));
    if (step.kind == HullStep::Kind::on_face) add_mark(told, Role::compared, face_[step.witness]);
    if (step.kind == HullStep::Kind::equal) add_mark(told, Role::compared, Vertex(step.witness));
    for (const DcelChange& change : step.changes) {
      if (told.rows.size() >= RecordedSteps::most_rows) break;
      told.rows.push_back(row_of(change));
    }
    if (!step.made.empty()) follow(step);
    steps_.push_back(std::move(told));
    positions_.push_back(journal_.position());
  }

  static void add_mark(Step& step, Role role, Element element) {
    if (step.marks.size() < most_marks) step.marks.push_back({role, element});
  }

  // A cell as the text's tables have it: rows by number, v, e and f.
  static RowChange row_of(const DcelChange& change) {
    constexpr const char* letters[] = {"v", "e", "f"};
    using Field = DcelChange::Field;
    const char* const to = change.field == Field::origin ? "v" : change.field == Field::face ? "f" : "e";
    const auto value = [&](std::uint32_t link) {
      return link == no_index ? std::nullopt : std::optional(to + std::to_string(link));
    };
    return {"dcel_" + std::string(id_of(change.table)),
            letters[static_cast<std::size_t>(change.table)] + std::to_string(change.row),
            std::string(id_of(change.field)), value(change.old_value), value(change.new_value)};
  }

  // Does the same to the kernel: an edge of the horizon stays, and its other side gets the new face.
  void follow(const HullStep& step) {
    const DcelRecords& records = hull_.records();
    half_.resize(records.half_edges.size());
    face_.resize(records.faces.size());
    Edit edit(mesh_, &journal_);
    remove_seen(edit, step);
    for (const std::uint32_t f : step.made) add_face(edit, records, f);
    edit.commit();
  }

  void remove_seen(Edit& edit, const HullStep& step) {
    std::vector<Edge> around;
    for (const std::uint32_t h : step.horizon) around.push_back(edge(half_[h]));
    std::sort(around.begin(), around.end());
    std::vector<Edge> within;
    std::vector<Vertex> corners;
    for (const std::uint32_t f : step.seen) {
      Halfedge h = mesh_.halfedge(face_[f]);
      for (int k = 0; k < 3; ++k, h = mesh_.next(h)) {
        corners.push_back(mesh_.from(h));
        if (!std::binary_search(around.begin(), around.end(), edge(h))) within.push_back(edge(h));
      }
    }
    std::sort(within.begin(), within.end());
    within.erase(std::unique(within.begin(), within.end()), within.end());
    for (const Vertex v : corners) edit.set_halfedge(v, Halfedge());
    for (const std::uint32_t h : step.horizon) edit.set_halfedge(mesh_.from(half_[h]), half_[h]);
    for (const std::uint32_t f : step.seen) edit.remove(face_[f]);
    for (const Edge e : within) edit.remove(e);
  }

  // Its half-edges: one beside an edge that stays, or whose twin has been entered, gets that edge; else a new one.
  void add_face(Edit& edit, const DcelRecords& records, std::uint32_t f) {
    const Face face = edit.add_face(Halfedge());
    face_[f] = face;
    std::array<std::uint32_t, 3> rows{};
    rows[0] = records.faces[f].outer_component;
    rows[1] = records.half_edges[rows[0]].next;
    rows[2] = records.half_edges[rows[1]].next;
    for (const std::uint32_t row : rows) {
      const DcelRecords::HalfEdgeRecord& h = records.half_edges[row];
      const Vertex from(h.origin), to(records.half_edges[h.next].origin);
      const Halfedge beside = half_[h.twin];
      const bool is_there = beside && beside.index < mesh_.halfedge_slots() && mesh_.is_alive(beside) &&
                            mesh_.from(beside) == to && mesh_.from(twin(beside)) == from;
      half_[row] = is_there ? twin(beside) : edit.add_edge(from, to);
      edit.set_face(half_[row], face);
      edit.set_halfedge(from, half_[row]);
    }
    for (std::size_t k = 0; k < 3; ++k) edit.connect(half_[rows[k]], half_[rows[(k + 1) % 3]]);
    edit.set_halfedge(face, half_[rows[0]]);
  }

  Mesh mesh_;
  HullSteps& hull_;
  Journal journal_;
  std::vector<Step> steps_;
  std::vector<std::size_t> positions_;
  std::vector<Halfedge> half_;  // of the kernel, by row of the DCEL
  std::vector<Face> face_;
};

Failure no_such_order() {
  return usage_of(
      {"'hull [ORDER [SEED]]' takes random, as_given or farthest, and a number for random.",
       "hull [ORDER [SEED]] の ORDER は random、as_given、farthest のいずれか、SEED は random の番号です。"});
}

}  // namespace

Made play_hull(const Mesh& mesh, Arguments arguments) {
  HullOrder order = HullOrder::random;
  std::uint64_t seed = 0;
  if (arguments.size() > 2) return no_such_order();
  if (!arguments.empty()) {
    const auto rows = hull_orders();
    const auto row =
        std::find_if(rows.begin(), rows.end(), [&](const HullOrderRow& r) { return r.id == arguments[0]; });
    if (row == rows.end()) return no_such_order();
    order = row->order;
  }
  if (arguments.size() == 2) {
    const char* const end = arguments[1].data() + arguments[1].size();
    const auto [behind, error] = std::from_chars(arguments[1].data(), end, seed);
    if (error != std::errc() || behind != end || order != HullOrder::random) return no_such_order();
  }
  const std::vector<glm::dvec3> points = points_of(mesh);
  if (points.size() > most_points)
    return refusal_of({"There are more than " + std::to_string(most_points) + " points; select or keep fewer of them.",
                       "点が " + std::to_string(most_points) + " 個を超えています。点を減らしてください。"});
  HullSteps hull(points, order, seed);
  if (hull.dimension() < 3)
    return refusal_of({"The points do not span space (dimension " + std::to_string(hull.dimension()) +
                           "), and the steps are those of a solid; ryosen hull gives their hull.",
                       "点が空間を張りません（次元 " + std::to_string(hull.dimension()) +
                           "）。手順は立体だけです。凸包は ryosen hull で得られます。"});
  return HullPlay(points, hull).play();
}

Choices choices_of_hull(const Mesh& mesh, Selected) {
  std::vector<glm::dvec3> some;  // enough to see in most meshes that they span space
  for (std::uint32_t i = 0; i < mesh.vertex_slots() && some.size() < 256; ++i)
    if (mesh.is_alive(Vertex(i))) some.push_back(mesh.position(Vertex(i)));
  if (mesh.live().vertices > most_points || HullSteps(some, HullOrder::as_given).dimension() < 3) return {};
  Choices choices;
  for (const HullOrderRow& row : hull_orders()) choices.push_back({std::string(row.id)});
  return choices;
}

}  // namespace ryosen::steps
