// Random attributes through random operators, algorithms, undo and redo, beside a plain model of their values.
//
// Each kind of element has an attribute with an own rule that writes down what each value comes from. The model is the
// list of these notes: it computes all other attributes from them by the sentences of value_rules.h, one number at a
// time, and knows nothing of meshes.
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <set>

#include "ryosen/algo/algorithm_table.h"
#include "ryosen/algo/duplicate/part.h"
#include "ryosen/indexed/from_indexed.h"
#include "ryosen/mesh/attribute.h"
#include "ryosen/mesh/attribute_text.h"
#include "ryosen/mesh/invariants.h"
#include "ryosen/mesh/live_elements.h"
#include "tests/support/core/element_values.h"
#include "tests/support/core/long_run.h"
#include "tests/support/core/random_edits.h"
#include "tests/support/core/random_ops.h"
#include "tests/support/core/sound_value.h"

namespace ryosen {
namespace {

using namespace test;

// How a value was made. One without sources was set.
struct Note {
  Derivation derivation = Derivation::copies;
  std::vector<std::uint32_t> sources = {};  // places of notes
  std::vector<double> weights = {};
};
std::vector<Note> notes;  // the first one is the default

void write_note(const ValueSources& sources, std::uint32_t* value) {
  Note note{sources.derivation, {}, {sources.weights.begin(), sources.weights.end()}};
  for (std::size_t i = 0; i < sources.values.size(); ++i) note.sources.push_back(sources.value<std::uint32_t>(i));
  *value = static_cast<std::uint32_t>(notes.size());
  notes.push_back(std::move(note));
}

constexpr ElementKind kinds[] = {ElementKind::vertex, ElementKind::edge, ElementKind::corner, ElementKind::face};
std::string note_name(ElementKind kind) { return std::string(name_of(kind)) + ".note"; }

using Numbers = std::vector<double>;

// The values of one attribute by note.
class Model {
 public:
  explicit Model(AttributeColumn head) : head_(std::move(head)), fill_(numbers_of(head_.fill.data())) {
    values_.assign(notes.size(), fill_);
  }
  const AttributeColumn& head() const { return head_; }
  bool is_mean() const { return head_.rule == ValueRule::blend && is_floating(head_.type.scalar); }

  void set(std::uint32_t note, Numbers numbers) {
    catch_up();
    values_[note] = std::move(numbers);
  }
  const Numbers& of(std::uint32_t note) {
    catch_up();
    return values_[note];
  }
  Numbers numbers_of(const std::uint32_t* words) const {
    AttributeColumn one = head_;
    one.data.assign(words, words + head_.words());
    Numbers numbers;
    for (std::uint32_t i = 0; i < head_.type.count; ++i) numbers.push_back(number_at(one, 0, i));
    return numbers;
  }
  bool is_alike(double a, double b) const {
    if (std::isnan(b)) return true;
    if (!is_floating(head_.type.scalar)) return a == b;
    return std::abs(a - b) <= (head_.type.scalar == Scalar::float32 ? 1e-4 : 1e-9) * (1 + std::abs(b));
  }

 private:
  void catch_up() {
    while (values_.size() < notes.size()) {
      const auto place = static_cast<std::uint32_t>(values_.size());
      if (notes[place].derivation == Derivation::divides) {
        add_parts(place);
      } else {
        Numbers numbers = fill_;
        if (!notes[place].sources.empty())
          for (std::size_t i = 0; i < numbers.size(); ++i) numbers[i] = made(notes[place], i);
        values_.push_back(std::move(numbers));
      }
    }
  }

  double made(const Note& note, std::size_t i) const {
    const auto source = [&](std::size_t s) { return values_[note.sources[s]][i]; };
    const bool unites = note.derivation == Derivation::unites;
    double sum = 0, mean = 0, greatest = source(0);
    for (std::size_t s = 0; s < note.sources.size(); ++s) {
      sum += source(s);
      mean += note.weights[s] * source(s);
      greatest = std::max(greatest, source(s));
    }
    if (head_.rule == ValueRule::sum) return unites ? std::min(sum, most()) : fill_[i];
    if (head_.rule == ValueRule::greatest) return greatest;
    return is_mean() ? mean : source(0);
  }

  double most() const {
    return with_scalar(head_.type.scalar,
                       [](auto zero) { return static_cast<double>(std::numeric_limits<decltype(zero)>::max()); });
  }

  // The parts of an element stand one after the other.
  void add_parts(std::uint32_t first) {
    const auto is_part = [&](std::uint32_t place) {
      return place < notes.size() && notes[place].derivation == Derivation::divides &&
             notes[place].sources == notes[first].sources;
    };
    std::uint32_t end = first;
    double share = 0;
    for (; is_part(end) && share < 1 - 1e-9; ++end) share += notes[end].weights[0];
    while (is_part(end) && notes[end].weights[0] < 1e-9) ++end;
    EXPECT_NEAR(share, 1, 1e-6);
    const Numbers whole = values_[notes[first].sources[0]];
    values_.insert(values_.end(), end - first, whole);
    if (head_.rule != ValueRule::sum) return;
    for (std::size_t i = 0; i < whole.size(); ++i) {
      double rest = whole[i];
      std::vector<std::pair<double, std::uint32_t>> remainders;
      for (std::uint32_t part = first; part < end; ++part) {
        const long double exact = static_cast<long double>(whole[i]) * notes[part].weights[0];
        const double own = static_cast<double>(is_floating(head_.type.scalar) ? exact : std::trunc(exact));
        values_[part][i] = own;
        remainders.emplace_back(static_cast<double>(own - exact), part);
        rest -= own;
      }
      if (is_floating(head_.type.scalar)) continue;
      std::stable_sort(remainders.begin(), remainders.end(),
                       [](const auto& a, const auto& b) { return a.first < b.first; });
      const std::size_t left = rest > 0 ? std::min(static_cast<std::size_t>(rest), remainders.size()) : 0;
      // Areas that differ by their rounding alone: the notes do not tell which part gets what is left.
      const bool is_open = head_.element == ElementKind::face && left > 0 && left < remainders.size() &&
                           remainders[left].first - remainders[left - 1].first < 1e-9;
      for (std::size_t k = 0; k < left; ++k) values_[remainders[k].second][i] += 1;
      for (std::uint32_t part = first; part < end && is_open; ++part) values_[part][i] = std::nan("");
    }
  }

  AttributeColumn head_;
  Numbers fill_;
  std::vector<Numbers> values_;
};

// A walk on one mesh.
class Walk {
 public:
  enum class Values { random, defaults };
  Walk(Mesh mesh, std::uint64_t seed, Values values = Values::random) : mesh_(std::move(mesh)), dice_(seed) {
    notes.assign(1, Note());
    {
      Edit edit(mesh_, &journal_);
      for (const ElementKind kind : kinds) edit.add_attribute(note_name(kind), kind, &write_note, std::uint32_t{0});
      edit.commit();
    }
    for (int i = 0; i < 8; ++i) declare();
    if (values == Values::random) set_values(1);
  }

  const Mesh& mesh() const { return mesh_; }
  std::size_t notes_of_several() const {
    return static_cast<std::size_t>(
        std::count_if(notes.begin(), notes.end(), [](const Note& note) { return note.sources.size() > 1; }));
  }

  // Undoes, redoes, declares, sets, or edits.
  void step() {
    random_step(mesh_, journal_, dice_, 8, [&](int thrown) {
      if (thrown == 2) return declare();
      if (thrown == 3) return set_values(6);
      if (thrown == 4) return forget();
      return apply(random_op(mesh_, dice_));
    });
  }
  bool apply(const AnyOp& op) {
    if (!try_apply(mesh_, &journal_, op)) return false;
    committed();
    constexpr ElementKind corners[] = {ElementKind::corner};
    if (info_of(op).id == "collapse") take_values(corners);
    return true;
  }
  bool run(const AlgorithmRow& row, const ParameterValues& values) {
    Progress unheard;
    {
      Edit edit(mesh_, &journal_);
      const AlgorithmResult result = row.run(edit, {values, {}, 1}, unheard);
      if (result.changed == 0) return false;
      edit.commit();
    }
    committed();
    return true;
  }
  std::size_t position() const { return journal_.position(); }
  void go_to(std::size_t position) {
    while (journal_.position() > position) journal_.undo(mesh_);
    while (journal_.position() < position) journal_.redo(mesh_);
  }

  // The notes do not tell all of the last edit for elements of these kinds, where masks make means, or corners go
  // together because their values are equal. In the next entry of the history the values of the mesh count.
  void take_values(std::span<const ElementKind> taken) {
    untold_[position()].insert(taken.begin(), taken.end());
    {
      Edit edit(mesh_, &journal_);
      for (const ElementKind kind : taken) {
        const auto note = static_cast<std::size_t>(mesh_.find_attribute(note_name(kind)));
        for_each(kind, [&](std::uint32_t index) { renote(edit, note, kind, index); });
      }
      edit.commit();
    }
    committed();
    for (const ElementKind kind : taken) {
      untold_[position()].erase(kind);
      for_each(kind, [&](std::uint32_t index) {
        for (auto& [name, model] : models_)
          if (model.head().element == kind && mesh_.find_attribute(name) >= 0)
            model.set(note_of(kind, index), model.numbers_of(words(name, index)));
      });
    }
  }

  void expect_as_modelled(const std::string& story) {
    ASSERT_FALSE(check_invariants(mesh_)) << story << ": " << check_invariants(mesh_)->sentence;
    for (auto& modelled : models_) {
      const std::string& name = modelled.first;
      Model& model = modelled.second;
      const ElementKind kind = model.head().element;
      const auto untold = untold_.find(journal_.position());
      if (mesh_.find_attribute(name) < 0 || (untold != untold_.end() && untold->second.contains(kind))) continue;
      for_each(kind, [&](std::uint32_t index) {
        const Numbers found = model.numbers_of(words(name, index)), &expected = model.of(note_of(kind, index));
        for (std::size_t i = 0; i < found.size() && !testing::Test::HasFailure(); ++i)
          EXPECT_TRUE(model.is_alike(found[i], expected[i]))
              << story << ": " << words_of(model.head()) << " of " << index << " is " << found[i] << ", not "
              << expected[i] << told(model, note_of(kind, index), i);
      });
    }
  }

 private:
  template <class Visit>
  void for_each(ElementKind kind, const Visit& visit) const {
    if (kind == ElementKind::vertex)
      for (const Vertex v : live_vertices(mesh_)) visit(v.index);
    if (kind == ElementKind::edge)
      for (const Edge e : live_edges(mesh_)) visit(e.index);
    if (kind == ElementKind::corner)
      for (const Halfedge h : live_halfedges(mesh_))
        if (!mesh_.is_outside(h)) visit(h.index);
    if (kind == ElementKind::face)
      for (const Face f : live_faces(mesh_)) visit(f.index);
  }
  const std::uint32_t* words(std::string_view name, std::uint32_t index) const {
    const AttributeColumn& column = *find_column(mesh_, name);
    return column.data.data() + std::size_t{index} * column.words();
  }
  std::uint32_t note_of(ElementKind kind, std::uint32_t index) const { return *words(note_name(kind), index); }

  // The note and its sources with their values, for a message.
  static std::string told(Model& model, std::uint32_t note, std::size_t i) {
    constexpr const char* words[] = {" copied from", " united from", " divided from"};
    std::string text = ", note " + std::to_string(note) + words[static_cast<std::size_t>(notes[note].derivation)];
    for (std::size_t s = 0; s < notes[note].sources.size(); ++s)
      text += " " + std::to_string(notes[note].sources[s]) + "=" + std::to_string(model.of(notes[note].sources[s])[i]) +
              "*" + std::to_string(notes[note].weights[s]);
    return text;
  }

  // Kinds that the notes do not tell before an edit are not told behind it.
  void committed() {
    untold_.erase(untold_.lower_bound(position()), untold_.end());
    if (const auto before = untold_.find(position() - 1); before != untold_.end())
      untold_.emplace(position(), before->second);
  }

  // A note without sources, for an element and what has the same value.
  void renote(Edit& edit, std::size_t attribute, ElementKind kind, std::uint32_t index) {
    const auto own = static_cast<std::uint32_t>(notes.size());
    notes.emplace_back();
    put(edit, attribute, kind, index, {&own, 1});
  }
  void put(Edit& edit, std::size_t attribute, ElementKind kind, std::uint32_t index,
           std::span<const std::uint32_t> value) {
    if (kind == ElementKind::vertex)
      return for_each_copy(mesh_, Vertex(index),
                           [&](Vertex copy) { edit.set_attribute(attribute, copy.index, value); });
    if (kind == ElementKind::edge) {
      for (const Halfedge sheet :
           sheets_between(mesh_, mesh_.from(halfedge(Edge(index))), mesh_.to(halfedge(Edge(index)))))
        edit.set_attribute(attribute, edge(sheet).index, value);
      return;
    }
    edit.set_attribute(attribute, index, value);
  }

  bool declare() {
    AttributeColumn column;
    column.element = kinds[dice_.below(4)];
    column.type = {static_cast<Scalar>(dice_.below(static_cast<int>(enum_count<Scalar>))),
                   static_cast<std::uint32_t>(1 + dice_.below(3))};
    column.rule = static_cast<ValueRule>(dice_.below(4));
    column.name = std::string(name_of(column.element)) + ".a" + std::to_string(declared_++);
    column.fill = random_value(column.type);
    // A sum of what is new would come from nothing.
    if (column.rule == ValueRule::sum) std::fill(column.fill.begin(), column.fill.end(), 0u);
    Edit edit(mesh_, &journal_);
    edit.add_attribute(column);
    edit.commit();
    committed();
    models_.emplace(column.name, Model(column));
    return true;
  }

  bool forget() {
    if (!dice_.one_in(4)) return false;
    std::vector<std::string> there;
    for (const auto& [name, model] : models_)
      if (mesh_.find_attribute(name) >= 0) there.push_back(name);
    if (there.empty()) return false;
    Edit edit(mesh_, &journal_);
    edit.remove_attribute(static_cast<std::size_t>(
        mesh_.find_attribute(there[static_cast<std::size_t>(dice_.below(static_cast<int>(there.size())))])));
    edit.commit();
    committed();
    return true;
  }

  std::vector<std::uint32_t> random_value(ValueType type) {
    AttributeColumn one;
    std::vector<std::uint32_t> value(type.words(), 0);
    with_scalar(type.scalar, [&](auto number) {
      for (std::uint32_t i = 0; i < type.count; ++i) {
        number = static_cast<decltype(number)>(dice_.below(type.scalar == Scalar::boolean ? 2 : 100));
        std::memcpy(reinterpret_cast<std::byte*>(value.data()) + i * sizeof number, &number, sizeof number);
      }
    });
    return value;
  }

  // Sets the values of one element in so many.
  bool set_values(int one_in) {
    struct Set {
      std::string name;
      std::uint32_t note;
      std::vector<std::uint32_t> value;
    };
    std::vector<Set> all;
    Edit edit(mesh_, &journal_);
    for (const ElementKind kind : kinds) {
      const auto note = static_cast<std::size_t>(mesh_.find_attribute(note_name(kind)));
      for_each(kind, [&](std::uint32_t index) {
        if (!dice_.one_in(one_in)) return;
        renote(edit, note, kind, index);
        for (auto& [name, model] : models_) {
          const int attribute = mesh_.find_attribute(name);
          if (attribute < 0 || model.head().element != kind) continue;
          const std::vector<std::uint32_t> value = random_value(model.head().type);
          put(edit, static_cast<std::size_t>(attribute), kind, index, value);
          all.push_back({name, note_of(kind, index), value});
        }
      });
    }
    if (all.empty()) return false;
    edit.commit();
    committed();
    for (const Set& each : all) {
      Model& model = models_.at(each.name);
      model.set(each.note, model.numbers_of(each.value.data()));
    }
    return true;
  }

  Mesh mesh_;
  Journal journal_;
  Dice dice_;
  std::map<std::string, Model> models_;
  std::map<std::size_t, std::set<ElementKind>> untold_;  // by position in the history
  int declared_ = 0;
};

TEST(attribute_walk, operators_undo_and_redo_equal_a_plain_model) {
  const std::uint64_t seeds = seed_count(60, 4000);
  std::size_t derived = 0;
  for (std::uint64_t seed = 1; seed <= seeds && !HasFailure(); ++seed) {
    Walk walk(seed % 3 == 0 ? random_kernel_mesh(seed) : random_complex(seed), seed);
    const std::string story = "seed " + std::to_string(seed);
    walk.expect_as_modelled(story);
    for (int step = 0; step < 40 && !HasFailure(); ++step) {
      walk.step();
      walk.expect_as_modelled(story + " step " + std::to_string(step));
    }
    derived += walk.notes_of_several();
  }
  if (!is_sample()) {
    EXPECT_GT(derived, 4 * seeds);
  }
}

TEST(attribute_walk, every_operator_equals_a_plain_model) {
  const std::uint64_t seeds = seed_count(25, 400);
  std::set<std::string_view> done;
  for (std::size_t place = 0; place < all_ops().size(); ++place)
    for (std::uint64_t seed = 1; seed <= seeds && !HasFailure(); ++seed) {
      Walk walk(seed % 2 == 0 ? random_kernel_mesh(seed) : random_complex(seed), seed);
      Dice dice(1000 * seed + place);
      for (int tries = 0; tries < 20; ++tries) {
        const AnyOp op = random_op(walk.mesh(), place, dice);
        const std::size_t before = walk.position();
        if (!walk.apply(op)) continue;
        const std::size_t after = walk.position();
        done.insert(info_of(op).id);
        const std::string story = std::string(info_of(op).id) + " seed " + std::to_string(seed);
        walk.expect_as_modelled(story);
        walk.go_to(before);
        walk.expect_as_modelled(story + " undone");
        walk.go_to(after);
        walk.expect_as_modelled(story + " done again");
        break;
      }
    }
  for (const OpInfo& op : all_ops())
    if (!is_sample()) {
      EXPECT_TRUE(done.contains(op.id)) << op.id << " was never legal";
    }
}

// A mesh at random, all of which is flat, there twice at one place, or has a vertex without a place; or three squares,
// of which two have a common corner on a side of the third.
Mesh mesh_for_algorithms(std::uint64_t seed) {
  if (seed % 5 == 0) {
    IndexedMesh list;
    list.positions = {{0, 1, 0}, {2, 1, 0}, {2, 2, 0}, {0, 2, 0}, {0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {1, 1, 0}};
    list.corners = {0, 1, 2, 3, 4, 5, 7, 0, 5, 6, 1, 7};
    list.face_offsets = {0, 4, 8, 12};
    return from_indexed(std::move(list));
  }
  Mesh mesh = seed % 2 == 0 ? random_kernel_mesh(seed) : random_complex(seed);
  Edit edit(mesh, nullptr);
  const std::uint64_t way = seed / 2 % 4;
  if (way == 1)
    for (const Vertex v : live_vertices(mesh)) edit.set_position(v, {mesh.position(v).x, mesh.position(v).y, 0});
  if (way == 2) add_part(edit, part_of(mesh, all_elements(mesh)), true);
  if (way == 3 && mesh.live().vertices > 0)
    move_point(edit, *live_vertices(mesh).begin(), glm::dvec3(std::numeric_limits<double>::quiet_NaN()));
  edit.commit();
  return mesh;
}

TEST(attribute_walk, every_algorithm_equals_a_plain_model) {
  struct Untold {
    std::string_view id;
    std::vector<ElementKind> kinds;
  };
  // Masks make means, and these collapse edges and move points.
  const std::vector<Untold> untold{{"subdivide", {ElementKind::vertex}},
                                   {"weld_close", {ElementKind::corner}},
                                   {"simplify", {ElementKind::vertex, ElementKind::corner}},
                                   {"remesh", {ElementKind::vertex, ElementKind::corner}}};
  const std::uint64_t seeds = seed_count(16, 300);
  std::set<std::string_view> done;
  for (const AlgorithmRow& row : algorithm_table())
    for (std::uint64_t seed = 1; seed <= seeds && !HasFailure(); ++seed) {
      // Faces unite where their values are equal.
      Walk walk(mesh_for_algorithms(seed), seed, seed / 2 % 4 == 1 ? Walk::Values::defaults : Walk::Values::random);
      ParameterValues values(row.parameters);
      for (const ParameterRow& parameter : row.parameters)
        if (must_be_given(row.parameters, parameter)) values.set(parameter.id, sound_value(parameter), {});
      const auto on_mesh = values.on(walk.mesh());
      if (!on_mesh.values || !walk.run(row, *on_mesh.values)) continue;
      done.insert(row.id);
      const std::string story = std::string(row.id) + " seed " + std::to_string(seed);
      for (const Untold& each : untold)
        if (each.id == row.id) walk.take_values(each.kinds);
      walk.expect_as_modelled(story);
      for (int step = 0; step < 3; ++step) walk.step();
      walk.expect_as_modelled(story + " and further");
    }
  for (const AlgorithmRow& row : algorithm_table())
    if (!is_sample()) {
      EXPECT_TRUE(done.contains(row.id)) << row.id << " changed nothing";
    }
}

}  // namespace
}  // namespace ryosen
