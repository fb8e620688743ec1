// The selection, with a stamp by which those who follow it see at once whether it may have changed; selections around
// each entry of the history or kept under a name; and the elements that a command has added.
#pragma once

#include <array>
#include <cstdint>
#include <initializer_list>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "ryosen/algo/algorithm.h"
#include "ryosen/base/element.h"
#include "ryosen/base/enum_table.h"
#include "ryosen/mesh/mesh.h"

namespace ryosen {

// Elements in the order in which they were selected. It is read as a vector of them; equal are two of the same
// elements.
class Selection {
 public:
  using value_type = Element;
  using const_iterator = Elements::const_iterator;

  Selection() = default;
  Selection(const Selection&) = default;
  Selection(Selection&& other) noexcept : elements_(std::exchange(other.changed(), {})), stamp_(next_stamp()) {}
  Selection& operator=(const Selection&) = default;
  Selection& operator=(Selection&& other) noexcept { return *this = std::exchange(other.changed(), {}); }
  Selection& operator=(Elements elements) {
    changed() = std::move(elements);
    return *this;
  }
  Selection& operator=(std::initializer_list<Element> elements) { return *this = Elements(elements); }

  operator const Elements&() const { return elements_; }
  const_iterator begin() const { return elements_.begin(); }
  const_iterator end() const { return elements_.end(); }
  const Element* data() const { return elements_.data(); }
  std::size_t size() const { return elements_.size(); }
  bool empty() const { return elements_.empty(); }
  const Element& operator[](std::size_t i) const { return elements_[i]; }
  const Element& back() const { return elements_.back(); }
  // How many of a kind. Cost: one pass for all kinds after each change.
  std::size_t count(Element::Kind kind) const;

  void clear() {
    if (!empty()) changed().clear();
  }
  void push_back(const Element& element) { changed().push_back(element); }
  // To be written to before the next call.
  Elements& changed();

  // Never the same for two contents, in all of the program. Never 0.
  std::uint64_t stamp() const { return stamp_; }

  friend bool operator==(const Selection& a, const Selection& b) { return a.elements_ == b.elements_; }
  friend bool operator==(const Selection& a, const Elements& b) { return a.elements_ == b; }

 private:
  static std::uint64_t next_stamp();

  Elements elements_;
  std::uint64_t stamp_ = next_stamp();
  mutable std::array<std::size_t, enum_count<Element::Kind>> counts_{};
  mutable std::uint64_t counted_ = 0;  // the stamp of which that is
};

// Takes out what is deleted; is_renumbered: all columns have been replaced, so that only points and faces have kept
// their numbers.
void drop_lost(Elements& elements, const Mesh& mesh, bool is_renumbered);

// Selections around each entry of the history, and those kept under a name. Pass the mesh as it is behind the change.
// A selection that stays the same from entry to entry is held once.
class SelectionMemory {
 public:
  // A selection by its name. Members may be deleted; undo may bring them back.
  std::map<std::string, Elements, std::less<>> kept;

  // How elements go on behind an entry that has replaced all columns.
  struct Passage {
    Lineage lineage = Lineage::numbers;
    const Descent* descent = nullptr;  // where the lineage is told; none where it was not asked for
  };

  // An entry was made, on a mesh of these lengths; entries behind it are gone, and with them what they had made and was
  // kept. What it deleted is no longer selected; of what it has put in the place of other elements, that is selected
  // and kept in their place. A name under which nothing is left goes. No passage: elements keep their numbers.
  void made(std::size_t entry, Elements& selection, const Mesh& mesh, const std::optional<Passage>& passage,
            const ColumnLengths& before);
  // Undoing selects again the elements that were selected before the entry; redoing, those selected now.
  void undone(std::size_t entry, Elements& selection, const Mesh& mesh, bool is_renumbered);
  void redone(std::size_t entry, Elements& selection, const Mesh& mesh, bool is_renumbered);
  void clear() { *this = SelectionMemory(); }

 private:
  using Shared = std::shared_ptr<const Elements>;
  struct Around {
    Shared before, after;
    std::map<std::string, Elements, std::less<>> other_kept;  // on the other side of one that renumbers
  };

  Shared shared(const Elements& selection);

  std::vector<Around> around_;
  Shared last_;
};

// The elements that a command adds to a mesh, to be selected: by the slots that were free before it.
class FirstSlots {
 public:
  explicit FirstSlots(const Mesh& mesh)
      : vertices_(mesh.vertex_slots()), edges_(mesh.edge_slots()), faces_(mesh.face_slots()) {}
  // New faces, edges without a face and isolated vertices: all that was added, each once.
  std::vector<Element> added_to(const Mesh& mesh) const;

 private:
  std::uint32_t vertices_, edges_, faces_;
};

}  // namespace ryosen
