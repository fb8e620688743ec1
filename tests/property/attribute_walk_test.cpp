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
    std::uint32_t end = first;
    double share = 0;
    for (; end < notes.size() && share < 1 - 1e-9; ++end) {
      ASSERT_EQ(notes[end].derivation, Derivation::divides);
      ASSERT_EQ(notes[end].sources, notes[first].sources);
      share += notes[end].weights[0];
    }
    const Numbers whole = values_[notes[first].sources[0]];
    values_.insert(values_.end(), end - first, whole);
    if (head_.rule != ValueRule::sum) return;
    for (std::size_t i = 0; i < whole.size(); ++i) {
      double rest = whole[i];
      std::vector<std::pair<double, std::uint32_t>> remainders;
      for (std::uint32_t part = first; part < end; ++part) {
        const double exact = whole[i] * notes[part].weights[0];
        const double own = is_floating(head_.type.scalar) ? exact : std::floor(exact + 1e-9);
        values_[part][i] = own;
        remainders.emplace_back(own - exact, part);
        rest -= own;
      }
      if (is_floating(head_.type.scalar)) continue;
      std::stable_sort(remainders.begin(), remainders.end(),
                       [](const auto& a, const auto& b) { return a.first < b.first - 1e-9; });
      for (std::size_t k = 0; rest > 0; ++k, --rest) values_[remainders[k % remainders.size()].second][i] += 1;
    }
  }

  AttributeColumn head_;
  Numbers fill_;
  std::vector<Numbers> values_;
};

// A walk on one mesh.
class Walk {
 public:
  Walk(Mesh mesh, std::uint64_t seed) : mesh_(std::move(mesh)), dice_(seed) {
    notes.assign(1, Note());
    {
      Edit edit(mesh_, &journal_);
      for (const ElementKind kind : kinds) edit.add_attribute(note_name(kind), kind, &write_note, std::uint32_t{0});
      edit.commit();
    }
    for (int i = 0; i < 8; ++i) declare();
    set_values(1);
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
      return try_apply(mesh_, &journal_, random_op(mesh_, dice_));
    });
  }
  bool apply(const AnyOp& op) { return try_apply(mesh_, &journal_, op); }
  bool run(const AlgorithmRow& row, const ParameterValues& values) {
    Progress unheard;
    {
      Edit edit(mesh_, &journal_);
      const AlgorithmResult result = row.run(edit, {values}, unheard);
      if (result.changed == 0) return false;
      edit.commit();
    }
    return true;
  }
  void undo() { journal_.undo(mesh_); }
  void redo() { journal_.redo(mesh_); }

  // By masks, or about points that moved, means are others than the notes say: those of the mesh count from here on.
  void take_means() {
    for (const ElementKind kind : kinds) {
      Edit edit(mesh_, &journal_);
      const auto note = static_cast<std::size_t>(mesh_.find_attribute(note_name(kind)));
      for_each(kind, [&](std::uint32_t index) { renote(edit, note, kind, index); });
      edit.commit();
      for_each(kind, [&](std::uint32_t index) {
        for (auto& [other, each] : models_)
          if (each.head().element == kind && mesh_.find_attribute(other) >= 0)
            each.set(note_of(kind, index), each.numbers_of(words(other, index)));
      });
    }
  }

  void expect_as_modelled(const std::string& story) {
    ASSERT_FALSE(check_invariants(mesh_)) << story << ": " << check_invariants(mesh_)->sentence;
    for (auto& [name, model] : models_) {
      if (mesh_.find_attribute(name) < 0) continue;
      const ElementKind kind = model.head().element;
      for_each(kind, [&](std::uint32_t index) {
        const Numbers found = model.numbers_of(words(name, index)), &expected = model.of(note_of(kind, index));
        for (std::size_t i = 0; i < found.size() && !testing::Test::HasFailure(); ++i)
          EXPECT_TRUE(model.is_alike(found[i], expected[i]))
              << story << ": " << words_of(model.head()) << " of " << index << " is " << found[i] << ", not "
              << expected[i] << " of note " << note_of(kind, index);
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

  // Of one element in so many.
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
    EXPECT_GT(derived, 5 * seeds);
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
        if (!walk.apply(op)) continue;
        done.insert(info_of(op).id);
        const std::string story = std::string(info_of(op).id) + " seed " + std::to_string(seed);
        walk.expect_as_modelled(story);
        walk.undo();
        walk.expect_as_modelled(story + " undone");
        walk.redo();
        walk.expect_as_modelled(story + " done again");
        break;
      }
    }
  for (const OpInfo& op : all_ops())
    if (!is_sample()) {
      EXPECT_TRUE(done.contains(op.id)) << op.id << " was never legal";
    }
}

TEST(attribute_walk, every_algorithm_equals_a_plain_model) {
  // Masks make the means of subdivisions, and places those of points that algorithms move.
  const std::set<std::string_view> own_means{"subdivide", "simplify", "remesh", "smooth"};
  const std::uint64_t seeds = seed_count(12, 300);
  std::set<std::string_view> done;
  for (const AlgorithmRow& row : algorithm_table())
    for (std::uint64_t seed = 1; seed <= seeds && !HasFailure(); ++seed) {
      Walk walk(seed % 2 == 0 ? random_kernel_mesh(seed) : random_complex(seed), seed);
      ParameterValues values(row.parameters);
      for (const ParameterRow& parameter : row.parameters)
        if (must_be_given(row.parameters, parameter)) values.set(parameter.id, sound_value(parameter), {});
      const auto on_mesh = values.on(walk.mesh());
      if (!on_mesh.values || !walk.run(row, *on_mesh.values)) continue;
      done.insert(row.id);
      const std::string story = std::string(row.id) + " seed " + std::to_string(seed);
      if (own_means.contains(row.id)) walk.take_means();
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
