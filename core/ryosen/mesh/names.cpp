#include "ryosen/mesh/names.h"

#include <algorithm>
#include <charconv>
#include <iterator>
#include <optional>
#include <vector>

#include "ryosen/mesh/circulate.h"
#include "ryosen/mesh/copies.h"
#include "ryosen/mesh/find_element.h"

namespace ryosen {

namespace {

constexpr char slot_letters[] = {'v', 'h', 'e', 'f'};  // by Element::Kind

std::optional<Element> parse_slot(std::string_view word) {
  if (word.size() < 2) return std::nullopt;
  Element e;
  const char* const end = word.data() + word.size();
  const auto [behind, error] = std::from_chars(word.data() + 1, end, e.index);
  if (error != std::errc() || behind != end) return std::nullopt;
  for (std::size_t kind = 0; kind < std::size(slot_letters); ++kind)
    if (word[0] == slot_letters[kind]) {
      e.kind = static_cast<Element::Kind>(kind);
      return e;
    }
  return std::nullopt;
}

std::string number(std::uint32_t n) { return std::to_string(n); }

std::string ends_of(const Mesh& m, Halfedge h) {
  return number(point(m, m.from(h)).index) + "-" + number(point(m, m.to(h)).index);
}

std::string name_of_vertex(const Mesh& m, Vertex v) {
  return "v" + number(m.exists(v) && m.is_alive(v) ? point(m, v).index : v.index);
}

std::string name_of_edge(const Mesh& m, Edge e) {
  const Halfedge h = named_side(m, e);
  return has_several_sheets(m, h) ? name_with_face(m, h) : ends_of(m, h);
}

std::optional<std::uint32_t> parse_number(std::string_view text) {
  std::uint32_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (text.empty() || error != std::errc() || end != text.data() + text.size() || value == no_index)
    return std::nullopt;
  return value;
}

template <class Handle>
Named<Handle> fail(NameError error, std::string en, std::string ja) {
  return {Handle(), error, {std::move(en), std::move(ja)}};
}

template <class Handle>
Named<Handle> malformed(std::string_view name, const Text& expected) {
  const std::string n(name);
  return fail<Handle>(NameError::malformed, "'" + n + "' is not a name; expected " + expected.en,
                      "「" + n + "」は名前ではありません。" + expected.ja + "の形で書いてください");
}

Named<Halfedge> no_edge_name(std::string_view name) {
  return malformed<Halfedge>(name, {"A-B, A-B@f5, h12 or e6", "A-B、A-B@f5、h12、e6 のいずれか"});
}

template <class Handle>
Named<Handle> check_slot(const Mesh& m, Handle handle, const std::string& name) {
  if (!m.exists(handle))
    return fail<Handle>(NameError::never_existed, name + " does not exist", name + " は存在しません");
  if (!m.is_alive(handle))
    return fail<Handle>(NameError::deleted, name + " is no longer in the mesh", name + " はメッシュに含まれていません");
  return {handle, NameError::none, {}};
}

// The copy of a point that belongs to a face.
Named<Vertex> copy_in_face(const Mesh& m, Vertex v, Face f, const std::string& name) {
  for (Vertex corner : vertices_around(m, f))
    if (same_point(m, corner, v)) return {corner, NameError::none, {}};
  return fail<Vertex>(NameError::never_existed, name + ": face f" + number(f.index) + " does not touch it",
                      name + "：面 f" + number(f.index) + " に属していません");
}

// The side of face f that joins the two points, as the halfedge of that face.
Halfedge side_of_face(const Mesh& m, Face f, Vertex a, Vertex b) {
  for (Halfedge h : halfedges_around(m, f)) {
    const Vertex from = m.from(h), to = m.to(h);
    if ((same_point(m, from, a) && same_point(m, to, b)) || (same_point(m, from, b) && same_point(m, to, a))) return h;
  }
  return Halfedge();
}

Named<Halfedge> no_such_edge(std::string_view name) {
  const std::string n(name);
  return fail<Halfedge>(NameError::never_existed, "there is no edge " + n, "稜線 " + n + " は存在しません");
}

Named<Halfedge> choose_sheet(const Mesh& m, Vertex a, Vertex b, std::string_view name) {
  const std::vector<Halfedge> sheets = sheets_between(m, a, b);
  if (sheets.empty()) return no_such_edge(name);
  if (sheets.size() == 1) return {sheets[0], NameError::none, {}};
  std::string list;
  for (Halfedge h : sheets) list += (list.empty() ? "" : ", ") + name_to_choose(m, h);
  const std::string n(name);
  return fail<Halfedge>(NameError::ambiguous, n + " has several sheets; choose one of " + list,
                        n + " は複数のシートにあります。次から選んでください：" + list);
}

Named<Halfedge> find_by_slot(const Mesh& m, std::string_view name) {
  const auto slot = parse_number(name.substr(1));
  if (!slot) return no_edge_name(name);
  const Halfedge h = name[0] == 'h' ? Halfedge(*slot) : halfedge(Edge(*slot));
  if (*slot > no_index / 2) return no_such_edge(name);
  return check_slot(m, h, std::string(name));
}

}  // namespace

Halfedge named_side(const Mesh& m, Edge e) {
  const Halfedge h = halfedge(e);
  return point(m, m.from(h)) > point(m, m.to(h)) ? twin(h) : h;
}

std::string name_of_copy(const Mesh& m, Vertex v) {
  std::string name = name_of(m, v);
  if (!m.exists(v) || !m.is_alive(v) || !has_copies(m, v)) return name;
  Face lowest;
  for (Face f : faces_around(m, v)) lowest = std::min(lowest, f);  // none compares largest
  return lowest ? name + "@f" + number(lowest.index) : "v" + number(v.index);
}

std::string name_with_face(const Mesh& m, Halfedge h) {
  const bool outside = m.is_outside(h);
  if (outside && m.is_outside(twin(h))) return "h" + number(h.index);
  const Face f = outside ? m.face(twin(h)) : m.face(h);
  return (outside ? "~" : "") + ends_of(m, outside ? twin(h) : h) + "@f" + number(f.index);
}

std::string name_to_choose(const Mesh& m, Halfedge h) {
  const Face f = m.is_outside(h) ? m.face(twin(h)) : m.face(h);
  if (!has_several_sheets(m, h) || !f) return name_of(m, h);
  return ends_of(m, h) + "@f" + number(f.index);
}

std::string name_of(const Mesh& m, Element element) {
  switch (element.kind) {
    case Element::Kind::vertex:
      return name_of_vertex(m, element.vertex());
    case Element::Kind::face:
      return "f" + number(element.index);
    case Element::Kind::edge:
      return m.exists(element.edge()) && m.is_alive(element.edge()) ? name_of_edge(m, element.edge())
                                                                    : "e" + number(element.index);
    case Element::Kind::halfedge:
      break;
  }
  const Halfedge h = element.halfedge();
  if (!m.exists(h) || !m.is_alive(h)) return "h" + number(h.index);
  return has_several_sheets(m, h) ? name_with_face(m, h) : ends_of(m, h);
}

std::string slot_name(Element element) {
  return slot_letters[static_cast<std::size_t>(element.kind)] + std::to_string(element.index);
}

std::string name_and_slot(const Mesh& m, Element element) {
  const std::string name = name_of(m, element), slot = slot_name(element);
  return name == slot ? name : name + " (" + slot + ")";
}

std::string name_to_select(const Mesh& m, Element element) {
  return element.kind == Element::Kind::halfedge ? "h" + number(element.index) : name_of(m, element);
}

Named<Face> find_face(const Mesh& m, std::string_view name) {
  const auto slot = name.starts_with('f') ? parse_number(name.substr(1)) : std::nullopt;
  if (!slot) return malformed<Face>(name, {"f3", "f3 "});
  return check_slot(m, Face(*slot), std::string(name));
}

Named<Vertex> find_vertex(const Mesh& m, std::string_view name) {
  const std::string whole(name);
  std::string_view rest = name.starts_with('v') ? name.substr(1) : name;
  const std::size_t at = rest.find('@');
  const auto slot = parse_number(rest.substr(0, at));
  if (!slot) return malformed<Vertex>(name, {"v7 or v7@f5", "v7 または v7@f5 "});
  const Named<Vertex> v = check_slot(m, Vertex(*slot), "v" + number(*slot));
  if (!v.ok() || at == std::string_view::npos) return v;
  const Named<Face> f = find_face(m, rest.substr(at + 1));
  if (!f.ok()) return {Vertex(), f.error, f.sentence};
  return copy_in_face(m, v.element, f.element, whole);
}

Named<Halfedge> find_edge(const Mesh& m, std::string_view name) {
  if (name.starts_with('h') || name.starts_with('e')) return find_by_slot(m, name);
  const bool twin_side = name.starts_with('~');
  std::string_view rest = twin_side ? name.substr(1) : name;
  const std::size_t at = rest.find('@');
  const std::string_view pair = rest.substr(0, at);
  const std::size_t dash = pair.find('-');
  const auto a = dash == std::string_view::npos ? std::nullopt : parse_number(pair.substr(0, dash));
  const auto b = dash == std::string_view::npos ? std::nullopt : parse_number(pair.substr(dash + 1));
  if (!a || !b || (twin_side && at == std::string_view::npos)) return no_edge_name(name);
  for (const std::uint32_t slot : {*a, *b}) {
    const Named<Vertex> v = check_slot(m, Vertex(slot), "v" + number(slot));
    if (!v.ok()) return {Halfedge(), v.error, v.sentence};
  }
  const Vertex va(*a), vb(*b);
  if (at == std::string_view::npos) return choose_sheet(m, va, vb, name);
  const Named<Face> f = find_face(m, rest.substr(at + 1));
  if (!f.ok()) return {Halfedge(), f.error, f.sentence};
  Halfedge h = side_of_face(m, f.element, va, vb);
  if (h.is_none()) return no_such_edge(name);
  if (!same_point(m, m.from(h), va)) h = twin(h);
  return {twin_side ? twin(h) : h, NameError::none, {}};
}

Failure failure_of_name(NameError error, Text sentence) {
  if (error == NameError::deleted) return make_failure(ExitCode::refused, "refused", std::move(sentence));
  const Code code = error == NameError::never_existed ? Code("element_unknown")
                    : error == NameError::ambiguous   ? Code("name_ambiguous")
                                                      : Code("line_malformed");
  return make_failure(ExitCode::usage, code, std::move(sentence));
}

std::string slot_ranges(std::span<const Element> elements) {
  std::string text;
  for (std::size_t i = 0; i < elements.size();) {
    std::size_t end = i + 1;
    while (end < elements.size() && elements[end].kind == elements[i].kind &&
           elements[end].index == elements[end - 1].index + 1)
      ++end;
    text += " " + slot_name(elements[i]);
    if (end > i + 1) text += ".." + slot_name(elements[end - 1]);
    i = end;
  }
  return text;
}

std::optional<SlotRange> parse_slot_range(std::string_view word) {
  const std::size_t dots = word.find("..");
  if (dots == std::string_view::npos) return std::nullopt;
  const auto first = parse_slot(word.substr(0, dots)), last = parse_slot(word.substr(dots + 2));
  if (!first || !last || first->kind != last->kind || last->index < first->index || last->index == no_index)
    return std::nullopt;
  return SlotRange{*first, last->index};
}

void add_living(const Mesh& mesh, const SlotRange& range, Elements& elements) {
  const ColumnLengths lengths = mesh.lengths();
  for (Element e = range.first; e.index <= range.last && has_slot(lengths, e); ++e.index)
    if (is_alive(mesh, e)) elements.push_back(e);
}

}  // namespace ryosen
