#include "ryosen/textbook/forms/records.h"

#include <utility>

#include "ryosen/mesh/live_elements.h"

namespace ryosen::forms {

namespace {

std::size_t at(Element::Kind kind) { return static_cast<std::size_t>(kind); }

// The slots by number, the first of those that share one.
std::vector<std::uint32_t> inverse(const std::vector<std::uint32_t>& numbers) {
  std::vector<std::uint32_t> slots;
  for (std::uint32_t slot = 0; slot < numbers.size(); ++slot) {
    const std::uint32_t number = numbers[slot];
    if (number == no_index) continue;
    if (number >= slots.size()) slots.resize(std::size_t{number} + 1, no_index);
    if (slots[number] == no_index) slots[number] = slot;
  }
  return slots;
}

std::vector<std::uint32_t> number_halfedges(const Mesh& mesh, const Numbering& numbering, HalfedgesOf halfedges) {
  std::vector<std::uint32_t> numbers(mesh.halfedge_slots(), no_index);
  std::uint32_t corners = 0;
  if (halfedges == HalfedgesOf::faces)
    for (const Halfedge h : corner_halfedges(mesh)) numbers[h.index] = corners++;
  if (halfedges == HalfedgesOf::all)
    for (const Halfedge h : live_halfedges(mesh)) numbers[h.index] = numbering.halfedge(h).index;
  return numbers;
}

Text nothing_of(Element::Kind kind) {
  switch (kind) {
    case Element::Kind::vertex:
      return {"It stores nothing of a vertex.", "頂点のデータを持ちません。"};
    case Element::Kind::halfedge:
      return {"It stores nothing of a halfedge.", "半稜線のデータを持ちません。"};
    case Element::Kind::edge:
      return {"It stores nothing of an edge.", "稜線のデータを持ちません。"};
    default:
      return {"It stores nothing of a face.", "面のデータを持ちません。"};
  }
}

}  // namespace

Records::Records(const Mesh& mesh, const FormRow& row) : row_(&row), unsuitable_(why_unsuitable(mesh, row)) {
  if (unsuitable_) return;
  form_ = row.make(mesh);
  Numbering numbering(mesh);
  numbers_[at(Element::Kind::halfedge)] = number_halfedges(mesh, numbering, row.halfedges);
  numbers_[at(Element::Kind::vertex)] = std::move(row.holds_copies ? numbering.vertex : numbering.point);
  numbers_[at(Element::Kind::edge)] = std::move(numbering.edge);
  numbers_[at(Element::Kind::face)] = std::move(numbering.face);
  for (std::size_t kind = 0; kind < 4; ++kind) slots_[kind] = inverse(numbers_[kind]);
}

std::uint32_t Records::number_of(Element element) const { return numbers_[at(element.kind)][element.index]; }

Element Records::element_of(Element own) const {
  if (own.index != no_index) own.index = slots_[at(own.kind)][own.index];
  return own;
}

ElementRecord Records::of(Element element) const {
  if (unsuitable_) return {unsuitable_, {}};
  Element own = element;
  own.index = number_of(element);
  if (own.index == no_index && row_->halfedges == HalfedgesOf::faces)
    return {Text{"It has no halfedge where there is no face.", "面のない側には半稜線を持ちません。"}, {}};
  if (own.index == no_index) return {nothing_of(element.kind), {}};
  Fields fields = form_->record(own);
  if (fields.empty()) return {nothing_of(element.kind), {}};
  for (Field& field : fields)
    for (Element& link : field.links) link = element_of(link);
  return {{}, std::move(fields)};
}

}  // namespace ryosen::forms
