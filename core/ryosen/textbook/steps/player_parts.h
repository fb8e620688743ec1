// The parts that players of steps share: sentences, marks, and what they offer for a selection.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "ryosen/base/result.h"
#include "ryosen/mesh/name_failure.h"
#include "ryosen/textbook/forms/all.h"
#include "ryosen/textbook/steps/step.h"

namespace ryosen::steps {

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
    if (element.kind == Element(Handle()).kind && element.index != no_index && mesh.exists(Handle(element.index)) &&
        mesh.is_alive(Handle(element.index)))
      return Handle(element.index);
  return {};
}
// That, or the first live one.
template <class Handle>
std::optional<Handle> usual_of(const Mesh& mesh, std::span<const Element> selection, std::uint32_t slots) {
  if (const auto chosen = selected_of<Handle>(mesh, selection)) return chosen;
  for (std::uint32_t i = 0; i < slots; ++i)
    if (mesh.is_alive(Handle(i))) return Handle(i);
  return {};
}

}  // namespace ryosen::steps
