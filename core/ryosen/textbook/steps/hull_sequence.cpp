#include "ryosen/textbook/steps/hull_sequence.h"

#include <algorithm>
#include <array>
#include <set>
#include <span>
#include <vector>

#include "ryosen/base/sort_unique.h"
#include "ryosen/indexed/from_indexed.h"
#include "ryosen/mesh/edit.h"
#include "ryosen/mesh/journal.h"
#include "ryosen/mesh/mesh.h"
#include "ryosen/mesh/names.h"
#include "ryosen/textbook/steps/hull/hull_steps.h"
#include "ryosen/textbook/steps/players.h"
#include "ryosen/textbook/steps/sources.h"

namespace ryosen::steps {

namespace {

using forms::DcelRecords;
using Row = std::uint32_t;

// The kernel's mesh beside the DCEL of a hull that is built step by step: it does the same, as edits.
class HullKernel {
 public:
  // Of the records in the state from which it goes on. In a plane the face is a polygon.
  HullKernel(const DcelRecords& records, bool is_planar) : is_planar_(is_planar) {
    IndexedMesh list;
    std::vector<Row> rows;  // of the half-edges of all corners
    for (const DcelRecords::VertexRecord& v : records.vertices) list.positions.push_back(v.coordinates);
    for (const DcelRecords::FaceRecord& f : records.faces) {
      if (f.outer_component == no_index) continue;
      Row h = f.outer_component;
      do {
        rows.push_back(h);
        list.corners.push_back(records.half_edges[h].origin);
      } while ((h = records.half_edges[h].next) != f.outer_component);
      list.face_offsets.push_back(static_cast<std::uint32_t>(list.corners.size()));
    }
    mesh_ = from_indexed(std::move(list));
    half_.resize(records.half_edges.size());
    face_.resize(records.faces.size());
    std::size_t corner = 0;
    for (std::uint32_t f = 0; f < mesh_.face_slots(); ++f) {
      const Row first = rows[corner];
      face_[records.half_edges[first].face] = Face(f);
      Halfedge h = mesh_.halfedge(Face(f));
      while (mesh_.from(h).index != records.half_edges[first].origin) h = mesh_.next(h);
      const Halfedge start = h;
      do {
        const Row row = rows[corner++];
        half_[row] = h;
        if (is_planar) half_[records.half_edges[row].twin] = twin(h);
      } while ((h = mesh_.next(h)) != start);
    }
  }

  // By rows of the DCEL, also of elements that a step is about to take away.
  Face face(std::uint32_t row) const { return face_[row]; }
  Halfedge halfedge(std::uint32_t row) const { return half_[row]; }
  // `records`: as they are behind the step.
  void follow(const HullStep& step, const DcelRecords& records) {
    if (step.made.empty()) return;
    half_.resize(records.half_edges.size());
    face_.resize(records.faces.size());
    Edit edit(mesh_, &journal_);
    if (is_planar_) {
      follow_in_plane(edit, step, records);
    } else {
      remove_seen(edit, step);
      for (const Row f : step.made) add_face(edit, records, f);
    }
    edit.commit();
  }

  const Mesh& mesh() const { return mesh_; }
  std::size_t position() const { return journal_.position(); }
  Mesh take_mesh() { return std::move(mesh_); }
  Journal take_journal() { return std::move(journal_); }

 private:
  // The edges of a polygon, whose corners hold their halfedges outside of it.
  void follow_in_plane(Edit& edit, const HullStep& step, const DcelRecords& records) {
    const Row face_row = records.half_edges[step.made[0]].face;
    if (step.kind == HullStep::Kind::begin) edit.fresh(face_[face_row] = edit.add_face(Halfedge()));
    for (const Row h : step.seen) {
      edit.set_halfedge(mesh_.to(half_[h]), Halfedge());
      edit.drop(edge(half_[h]));
    }
    for (const Row row : step.made) {
      const DcelRecords::HalfEdgeRecord& h = records.half_edges[row];
      half_[row] = edit.add_edge(Vertex(h.origin), Vertex(records.half_edges[h.twin].origin));
      half_[h.twin] = twin(half_[row]);
      edit.set_face(half_[row], face_[face_row]);
      edit.fresh(edge(half_[row]));
      edit.fresh(half_[row]);
      edit.set_halfedge(Vertex(records.half_edges[h.twin].origin), half_[h.twin]);
    }
    for (const Row row : step.made) {
      const DcelRecords::HalfEdgeRecord& h = records.half_edges[row];
      edit.connect(half_[h.prev], half_[row]);
      edit.connect(half_[row], half_[h.next]);
      edit.connect(half_[h.twin], half_[records.half_edges[h.twin].next]);
      edit.connect(half_[records.half_edges[h.twin].prev], half_[h.twin]);
    }
    edit.set_halfedge(face_[face_row], half_[records.faces[face_row].outer_component]);
  }
  void remove_seen(Edit& edit, const HullStep& step) {
    std::vector<Edge> around;
    for (const Row h : step.horizon) around.push_back(edge(half_[h]));
    std::sort(around.begin(), around.end());
    std::vector<Edge> within;
    std::vector<Vertex> corners;
    for (const Row f : step.seen) {
      Halfedge h = mesh_.halfedge(face_[f]);
      for (int k = 0; k < 3; ++k, h = mesh_.next(h)) {
        corners.push_back(mesh_.from(h));
        if (!std::binary_search(around.begin(), around.end(), edge(h))) within.push_back(edge(h));
      }
    }
    sort_unique(within);
    for (const Vertex v : corners) edit.set_halfedge(v, Halfedge());
    for (const Row h : step.horizon) edit.set_halfedge(mesh_.from(half_[h]), half_[h]);
    for (const Row f : step.seen) edit.drop(face_[f]);
    for (const Edge e : within) edit.drop(e);
  }
  // Its half-edges: one beside an edge that stays, or whose twin has been entered, gets that edge; else a new one.
  void add_face(Edit& edit, const DcelRecords& records, Row f) {
    const Face face = edit.add_face(Halfedge());
    edit.fresh(face);
    face_[f] = face;
    std::array<Row, 3> rows{};
    rows[0] = records.faces[f].outer_component;
    rows[1] = records.half_edges[rows[0]].next;
    rows[2] = records.half_edges[rows[1]].next;
    for (const Row row : rows) {
      const DcelRecords::HalfEdgeRecord& h = records.half_edges[row];
      const Vertex from(h.origin), to(records.half_edges[h.next].origin);
      const Halfedge beside = half_[h.twin];
      const bool is_there = beside && beside.index < mesh_.halfedge_slots() && mesh_.is_alive(beside) &&
                            mesh_.from(beside) == to && mesh_.from(twin(beside)) == from;
      half_[row] = is_there ? twin(beside) : edit.add_edge(from, to);
      if (!is_there) edit.fresh(edge(half_[row]));
      edit.set_face(half_[row], face);
      edit.fresh(half_[row]);
      edit.set_halfedge(from, half_[row]);
    }
    for (std::size_t k = 0; k < 3; ++k) edit.connect(half_[rows[k]], half_[rows[(k + 1) % 3]]);
    edit.set_halfedge(face, half_[rows[0]]);
  }

  bool is_planar_;
  Mesh mesh_;
  Journal journal_;
  std::vector<Halfedge> half_;
  std::vector<Face> face_;
};

// Steps of a builder as the player has them, with the kernel's mesh beside.
class Telling {
 public:
  explicit Telling(HullSteps& hull) : hull_(hull), kernel_(hull.records(), hull.dimension() == 2) {}

  void tell(const HullStep& step) {
    const std::optional<Element> witness = witness_of(step);
    Step told{caption(step, witness ? slot_name(*witness) : ""), {}, {},
              step.seen.empty() ? hull_text : horizon_text,      {}, {}};
    const std::string made = std::to_string(hull_.made_so_far());
    told.caption +=
        (step.is_planar ? Text{" Edges made so far: " + made + ".", "これまでに作った稜線の数 " + made + "。"}
                        : Text{" Faces made so far: " + made + ".", "これまでに作った面の数 " + made + "。"});
    mark_what_was(told, step);
    if (witness) add_mark(told, Role::compared, *witness);
    for (const DcelChange& change : step.changes) {
      if (told.rows.size() >= RecordedSteps::most_rows) break;
      told.rows.push_back(row_of(change));
    }
    const ElementCounts before = kernel_.mesh().live();
    kernel_.follow(step, hull_.records());
    if (!step.made.empty()) told.delta = delta_of(step, before, kernel_.mesh().live());
    mark_united(told, step);
    steps_.push_back(std::move(told));
    positions_.push_back(kernel_.position());
  }

  RecordedSteps take() && {
    return {kernel_.take_mesh(), kernel_.take_journal(), std::move(steps_), std::move(positions_)};
  }

 private:
  static void add_mark(Step& step, Role role, Element element) {
    if (step.marks.size() < most_marks) step.marks.push_back({role, element});
  }

  // Follows from the sum V - E + F + B + I = 2 S of one closed surface, or one face with its boundary loop, beside
  // points by themselves, each of which is an I and an S.
  static Delta delta_of(const HullStep& step, const ElementCounts& before, const ElementCounts& after) {
    const int e = static_cast<int>(after.edges) - static_cast<int>(before.edges),
              f = static_cast<int>(after.faces) - static_cast<int>(before.faces),
              surfaces = step.kind == HullStep::Kind::begin ? 1 : 0, loops = step.is_planar ? surfaces : 0,
              alone = f - e + loops - 2 * surfaces;
    return {.v = 0, .e = e, .f = f, .b = loops, .w = 0, .i = alone, .h = 0, .s = alone + surfaces, .g = 0};
  }

  // Beside what the point lies that changes nothing.
  std::optional<Element> witness_of(const HullStep& step) const {
    if (step.kind == HullStep::Kind::equal) return Vertex(step.witness);
    if (step.kind != HullStep::Kind::on_face) return std::nullopt;
    return step.is_planar ? Element(edge(kernel_.halfedge(step.witness))) : Element(kernel_.face(step.witness));
  }

  // On the mesh before the step, which still has all that the point sees.
  void mark_what_was(Step& told, const HullStep& step) {
    told.marks.push_back({Role::asked, Vertex(step.point)});
    for (const std::uint32_t row : step.seen) {
      if (step.is_planar)
        add_mark(told, Role::visible, edge(kernel_.halfedge(row)));
      else
        add_mark(told, Role::visible, kernel_.face(row));
      if (told.gone.size() < most_marks) told.gone.push_back({Role::visible, outline(step, row)});
    }
    for (const std::uint32_t h : step.horizon) add_mark(told, Role::horizon, edge(kernel_.halfedge(h)));
  }

  // The old places of what the point sees: a triangle, or an edge.
  std::vector<glm::dvec3> outline(const HullStep& step, std::uint32_t row) const {
    const Mesh& mesh = kernel_.mesh();
    if (step.is_planar)
      return {mesh.position(mesh.from(kernel_.halfedge(row))), mesh.position(mesh.to(kernel_.halfedge(row)))};
    std::vector<glm::dvec3> places;
    Halfedge h = mesh.halfedge(kernel_.face(row));
    for (int k = 0; k < 4; ++k, h = mesh.next(h)) places.push_back(mesh.position(mesh.from(h)));
    return places;
  }

  // In front of the other marks, so that it is seen.
  void mark_united(Step& told, const HullStep& step) {
    std::set<std::uint32_t> rows;
    for (const auto& [one, other] : step.united) rows.insert({one, other});
    std::vector<Mark> marks;
    for (const std::uint32_t row : rows)
      marks.push_back({Role::united, step.is_planar ? Element(edge(kernel_.halfedge(row))) : kernel_.face(row)});
    if (told.marks.size() + marks.size() <= most_marks)
      told.marks.insert(told.marks.begin() + 1, marks.begin(), marks.end());
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

  HullSteps& hull_;
  HullKernel kernel_;
  std::vector<Step> steps_;
  std::vector<std::size_t> positions_;
};

// So many copies of the builder are kept: they are as large as the points and the hull.
std::size_t copies_for(std::size_t points) { return std::clamp<std::size_t>(1000000 / (points + 1), 1, 8); }

}  // namespace

HullSequence::HullSequence(std::vector<glm::dvec3> points, HullOrder order, std::uint64_t seed)
    : points_(std::move(points)), now_(points_, order, seed), size_(now_.step_count()) {
  keep_every_ = stretch * ((size_ / copies_for(points_.size())) / stretch + 1);
  kept_.push_back(now_.copy());
  if (size_ <= most_made) go_to(size_);
}

void HullSequence::note_count() {
  if (now_.steps_done() == made_.size() + 1) made_.push_back(static_cast<std::uint32_t>(now_.made_so_far()));
  if (now_.steps_done() == kept_.size() * keep_every_) kept_.push_back(now_.copy());
}

// Behind this step.
void HullSequence::go_to(std::size_t step) {
  if (now_.steps_done() > step) now_ = kept_[std::min(step / keep_every_, kept_.size() - 1)].copy();
  while (now_.steps_done() < step) {
    now_.next(false);
    note_count();
  }
}

RecordedSteps& HullSequence::load(std::size_t number) {
  if (loaded_ && loaded_number_ == number) return *loaded_;
  go_to(number * stretch);
  Telling telling(now_);
  for (std::size_t k = 0; k < stretch; ++k) {
    const HullStep* const step = now_.next();
    if (!step) break;
    telling.tell(*step);
    note_count();
  }
  loaded_.emplace(std::move(telling).take());
  loaded_number_ = number;
  return *loaded_;
}

Step HullSequence::at(std::size_t i) { return load(stretch_of(i)).at(i - stretch_of(i) * stretch); }

const Mesh& HullSequence::mesh_at(std::size_t i) { return load(stretch_of(i)).mesh_at(i - stretch_of(i) * stretch); }

Text HullSequence::remark() const {
  const std::string points = std::to_string(points_.size());
  const Text text{"The hull of " + points + " points", points + " 点の凸包。"};
  if (!is_known())
    return text + Text{": steps are made as they are asked for.", "手順は求められたときに作ります。"} + more_;
  const std::string made = std::to_string(made_.back());
  const Text all = now_.dimension() == 2
                       ? Text{"; all steps make " + made + " edges.", "全手順で稜線を " + made + " 本作ります。"}
                       : Text{"; all steps make " + made + " faces.", "全手順で面を " + made + " 枚作ります。"};
  return text + all + more_;
}

std::optional<Curve> HullSequence::curve() const {
  return Curve{now_.dimension() == 2 ? Text{"Edges made", "作った稜線の数"} : Text{"Faces made", "作った面の数"},
               made_};
}

}  // namespace ryosen::steps
