// The functions of the table of steps, one file each, and what these share: sentences, marks, and what they offer for a
// selection.
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "ryosen/base/result.h"
#include "ryosen/mesh/find_element.h"
#include "ryosen/mesh/live_elements.h"
#include "ryosen/mesh/names.h"
#include "ryosen/ops/all.h"
#include "ryosen/textbook/forms/all.h"
#include "ryosen/textbook/steps/all.h"
#include "ryosen/textbook/steps/step.h"

namespace ryosen::steps {

using Arguments = std::span<const std::string>;
using Selected = std::span<const Element>;

// script.cpp: operators, and `expect` with a term of the sum. The steps end behind a line that is refused, or an
// `expect` that is not so.
Made play_script(const Mesh& mesh, Arguments lines);
Choices choices_of_script(const Mesh& mesh, Selected selection);
// The history of a mesh as a script: the journal with the line of each transaction. Both may have been undone in part.
std::unique_ptr<Sequence> play_history(const Mesh& mesh, const Journal& journal, Arguments lines);
// build.cpp
Made play_build(const Mesh& mesh, Arguments arguments);
Choices choices_of_build(const Mesh& mesh, Selected selection);
// pair.cpp
Made play_pair(const Mesh& mesh, Arguments arguments);
Choices choices_of_pair(const Mesh& mesh, Selected selection);
// listing.cpp
Made play_collapse(const Mesh& mesh, Arguments arguments);
Choices choices_of_collapse(const Mesh& mesh, Selected selection);
Made play_swap(const Mesh& mesh, Arguments arguments);
Choices choices_of_swap(const Mesh& mesh, Selected selection);
// split3.cpp
Made play_split3(const Mesh& mesh, Arguments arguments);
Choices choices_of_split3(const Mesh& mesh, Selected selection);
// walk.cpp
Made play_walk(const Mesh& mesh, Arguments arguments);
Choices choices_of_walk(const Mesh& mesh, Selected selection);
Made play_loop(const Mesh& mesh, Arguments arguments);
Choices choices_of_loop(const Mesh& mesh, Selected selection);
// relation.cpp
Made play_relation(const Mesh& mesh, Arguments arguments);
Choices choices_of_relation(const Mesh& mesh, Selected selection);
// hull.cpp: of all points; refused where these lie on a line.
Made play_hull(const Mesh& mesh, Arguments arguments);
Choices choices_of_hull(const Mesh& mesh, Selected selection);

inline Failure usage_of(Text sentence) { return make_failure(ExitCode::usage, "bad_arguments", std::move(sentence)); }
inline Failure refusal_of(Text sentence) { return make_failure(ExitCode::refused, "refused", std::move(sentence)); }

// The named element, or the failure about its name.
template <class Handle>
Result<Handle> named_element(Named<Handle> named) {
  if (named.ok()) return named.element;
  return failure_of_name(named.error, std::move(named.sentence));
}

// "v1 v2 v3"; of many the first ones and how many there are.
template <class Elements>
std::string names_text(const Elements& elements) {
  constexpr std::size_t most = 16;
  std::string text;
  std::size_t count = 0;
  for (const Element element : elements)
    if (count++ < most) text += (text.empty() ? "" : " ") + slot_name(element);
  return count > most ? text + " ... (" + std::to_string(count) + ")" : text;
}

// Whether to offer what takes this form of the mesh. Of a large mesh that is not asked, since it takes too long for a
// list of choices; to play it then says why not.
inline constexpr std::uint32_t most_faces_asked = 5000;
inline bool may_offer(const Mesh& mesh, std::string_view form) {
  if (mesh.live().faces == 0) return false;
  return mesh.live().faces > most_faces_asked || !forms::why_unsuitable(mesh, *forms::find_form(form));
}

// Marks of one role, at most so many.
inline constexpr std::size_t most_marks = 1000;
template <class Elements>
void mark_all(Step& step, Role role, const Elements& elements) {
  for (const Element element : elements) {
    if (step.marks.size() >= most_marks) return;
    if (element.index != no_index) step.marks.push_back({role, element});
  }
}

// The first selected element of a kind that is alive.
template <class Handle>
std::optional<Handle> selected_of(const Mesh& mesh, std::span<const Element> selection) {
  for (const Element element : selection)
    if (element.kind == Element(Handle()).kind && is_alive(mesh, element)) return Handle(element.index);
  return {};
}
// That, or the first live one.
template <class Handle>
std::optional<Handle> usual_of(const Mesh& mesh, std::span<const Element> selection) {
  if (const auto chosen = selected_of<Handle>(mesh, selection)) return chosen;
  for (const Handle element : LiveElements<Handle>(mesh)) return element;
  return {};
}

// Base of a player of edits: steps as they are made, on a mesh of its own.
class EditPlay {
 public:
  std::unique_ptr<Sequence> done() && {
    return std::make_unique<RecordedSteps>(std::move(mesh_), std::move(journal_), std::move(steps_),
                                           std::move(positions_));
  }

 protected:
  explicit EditPlay(const Mesh& mesh) : mesh_(mesh) {}

  // A step behind which the mesh is as it is now.
  Step& add(Step step) {
    steps_.push_back(std::move(step));
    positions_.push_back(journal_.position());
    return steps_.back();
  }
  void apply(const AnyOp& op) {
    Edit edit(mesh_, &journal_);
    ryosen::apply(edit, op);
    edit.commit();
  }

  Mesh mesh_;
  Journal journal_;
  std::vector<Step> steps_;

 private:
  std::vector<std::size_t> positions_;  // of the journal, behind each step
};

}  // namespace ryosen::steps
