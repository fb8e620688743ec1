#include "ryosen/textbook/steps/hull_sequence.h"

#include <algorithm>
#include <set>

#include "ryosen/mesh/names.h"
#include "ryosen/textbook/steps/hull_kernel.h"
#include "ryosen/textbook/steps/player_parts.h"
#include "ryosen/textbook/steps/sources.h"

namespace ryosen::steps {

namespace {

// Steps of a builder as the player has them, with the kernel's mesh beside.
class Telling {
 public:
  explicit Telling(HullSteps& hull) : hull_(hull), kernel_(hull.records(), hull.dimension() == 2) {}

  void tell(const HullStep& step) {
    const std::optional<Element> witness = witness_of(step);
    Step told{caption(step, witness ? slot_name(*witness) : ""), {}, {},
              step.seen.empty() ? hull_text : horizon_text,      {}, {}};
    const std::string made = std::to_string(hull_.made_so_far());
    told.caption =
        told.caption + (step.is_planar
                            ? Text{" Edges made so far: " + made + ".", "これまでに作った稜線の数 " + made + "。"}
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
