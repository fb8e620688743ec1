// Attributes of a document: adding, removing and setting them, one entry of the history each.
#include <utility>

#include "ryosen/base/count_text.h"
#include "ryosen/document/document.h"
#include "ryosen/mesh/attribute.h"
#include "ryosen/mesh/attribute_text.h"
#include "ryosen/mesh/circulate.h"
#include "ryosen/mesh/copies.h"

namespace ryosen {
namespace {

Outcome refused(Text sentence) { return failed(ExitCode::refused, std::move(sentence)); }

Outcome of_the_program(std::string_view name) {
  const std::string id(name);
  return refused({id + " is kept by the program itself; choose another name",
                  id + " はプログラムが使う属性です。別の名前にしてください"});
}

// The slots that have the values of an element.
void add_slots(const Mesh& mesh, ElementKind kind, const Element& element, std::vector<std::uint32_t>& slots) {
  const auto add_corner = [&](Halfedge h) {
    if (!mesh.is_outside(h)) slots.push_back(h.index);
  };
  const bool is_edge = element.kind == Element::Kind::edge, is_halfedge = element.kind == Element::Kind::halfedge;
  if (kind == ElementKind::vertex && element.kind == Element::Kind::vertex) {
    for_each_copy(mesh, element.vertex(), [&](Vertex copy) { slots.push_back(copy.index); });
  } else if (kind == ElementKind::edge && (is_edge || is_halfedge)) {
    const Halfedge h = is_edge ? halfedge(element.edge()) : element.halfedge();
    for (const Halfedge sheet : sheets_between(mesh, mesh.from(h), mesh.to(h))) slots.push_back(edge(sheet).index);
  } else if (kind == ElementKind::face && element.kind == Element::Kind::face) {
    slots.push_back(element.index);
  } else if (kind == ElementKind::corner && is_halfedge) {
    add_corner(element.halfedge());
  } else if (kind == ElementKind::corner && element.kind == Element::Kind::face) {
    for (const Halfedge h : halfedges_around(mesh, element.face())) add_corner(h);
  } else if (kind == ElementKind::corner && element.kind == Element::Kind::vertex) {
    for_each_copy(mesh, element.vertex(), [&](Vertex copy) {
      if (mesh.is_isolated(copy)) return;
      for (const Halfedge h : outgoing(mesh, copy)) add_corner(h);
    });
  }
}

Text elements_of(ElementKind kind) {
  constexpr struct {
    const char *en, *ja;
  } rows[] = {{"vertices", "頂点"},
              {"edges", "稜線"},
              {"corners: halfedges, faces or vertices", "角（半稜線・面・頂点）"},
              {"faces", "面"}};
  const auto& row = rows[static_cast<std::size_t>(kind)];
  return {row.en, row.ja};
}

}  // namespace

Outcome Document::add_attribute(AttributeColumn column, std::string command) {
  end_trial();
  if (is_reserved_name(column.name)) return of_the_program(column.name);
  if (element_of_attribute(column.name) != column.element)
    return failed(ExitCode::usage, {column.name + " is not an attribute name; write for example vertex.load",
                                    column.name + " は属性の名前ではありません（vertex.load など）"});
  if (mesh_.find_attribute(column.name) >= 0)
    return refused(
        {"there is an attribute " + column.name + " already; attribute remove " + column.name + " takes it away",
         "属性 " + column.name + " はすでにあります。attribute remove " + column.name + " で取り除けます"});
  if (mesh_.attributes().size() == most_attributes)
    return refused({"there are as many attributes as a mesh can have", "属性の数が上限に達しています"});
  if (command.empty()) command = "attribute add " + words_of(column);
  {
    Edit edit(writable(), &journal_);
    edit.add_attribute(std::move(column));
    make_room_in_history();
    edit.commit();
  }
  committed({std::move(command)});
  return {};
}

Outcome Document::remove_attribute(std::string_view name, std::string command) {
  end_trial();
  if (is_reserved_name(name)) return of_the_program(name);
  const int attribute = mesh_.find_attribute(name);
  if (attribute < 0) return no_attribute(name);
  if (command.empty()) command = "attribute remove " + std::string(name);
  {
    Edit edit(writable(), &journal_);
    edit.remove_attribute(static_cast<std::size_t>(attribute));
    make_room_in_history();
    edit.commit();
  }
  committed({std::move(command)});
  return {};
}

Outcome Document::set_attribute(std::string_view name, std::span<const Element> elements,
                                std::span<const std::uint32_t> value, std::string command) {
  end_trial();
  if (is_reserved_name(name)) return of_the_program(name);
  const int found = mesh_.find_attribute(name);
  if (found < 0) return no_attribute(name);
  const auto attribute = static_cast<std::size_t>(found);
  const ElementKind kind = mesh_.attributes()[attribute].element;
  assert(value.size() == mesh_.attributes()[attribute].words());
  std::vector<std::uint32_t> slots;
  std::size_t passed = 0;
  for (const Element& element : elements) {
    const std::size_t before = slots.size();
    add_slots(mesh_, kind, element, slots);
    passed += slots.size() == before ? 1 : 0;
  }
  const Text kinds = elements_of(kind);
  if (slots.empty())
    return refused({"none of these elements has a value of " + std::string(name) + "; it belongs to " + kinds.en,
                    std::string(name) + " の値を持つ要素がありません。値を持つもの：" + kinds.ja});
  bool has_changed = false;
  {
    Edit edit(writable(), &journal_);
    for (const std::uint32_t slot : slots) has_changed |= edit.set_attribute(attribute, slot, value);
    if (!has_changed) return {};
    make_room_in_history();
    edit.commit();
  }
  committed({std::move(command)});
  Outcome outcome;
  if (passed > 0)
    outcome.sentence = count_text(passed, "One element has no value of " + std::string(name) + ".",
                                  "# elements have no value of " + std::string(name) + ".",
                                  std::string(name) + " の値を持たない要素が # 個ありました。");
  return outcome;
}

}  // namespace ryosen
