#include "ryosen/mesh/descent.h"

#include <algorithm>
#include <utility>

#include "ryosen/mesh/live_elements.h"

namespace ryosen {

namespace {

// Where elements of a kind stand in a list, by slot; no_index where they do not.
class Standing {
 public:
  Standing(std::span<const Element> elements, Element::Kind kind) {
    for (std::uint32_t i = 0; i < elements.size(); ++i) {
      if (elements[i].kind != kind) continue;
      if (at_.size() <= elements[i].index) at_.resize(std::size_t{elements[i].index} + 1, no_index);
      at_[elements[i].index] = i;
    }
  }
  std::uint32_t of(std::uint32_t slot) const { return slot < at_.size() ? at_[slot] : no_index; }

 private:
  std::vector<std::uint32_t> at_;
};

std::uint32_t count_of(const MeshColumns& columns, ElementKind kind) {
  return length_of(kind, static_cast<std::uint32_t>(columns.vertex_halfedge.size()),
                   static_cast<std::uint32_t>(columns.halfedges.size()),
                   static_cast<std::uint32_t>(columns.face_halfedge.size()));
}

constexpr ElementKind kinds[] = {ElementKind::vertex, ElementKind::edge, ElementKind::corner, ElementKind::face};

}  // namespace

bool is_there(const MeshColumns& columns, ElementKind kind, std::uint32_t index) {
  const auto is_alive = [&](std::uint32_t e) { return columns.halfedges[2 * std::size_t{e}].from != dead_from; };
  switch (kind) {
    case ElementKind::vertex:
      return columns.vertex_halfedge[index] != dead_halfedge;
    case ElementKind::edge:
      return is_alive(index);
    case ElementKind::corner:
      return is_alive(index / 2) && columns.halfedges[index].face;
    default:
      return columns.face_halfedge[index] != dead_halfedge;
  }
}

std::string name_of(ElementKind kind, std::uint32_t index) {
  constexpr const char* letters[] = {"v", "e", "corner h", "f"};
  return letters[static_cast<std::size_t>(kind)] + std::to_string(index);
}

Descent::Descent(const Mesh& mesh) : is_recording_(true) {
  for (const ElementKind kind : kinds) {
    if (!records(kind)) continue;
    const std::uint32_t count = count_of(mesh.columns(), kind);
    of(kind).origins.resize(count);
    of(kind).ended.resize(count);
    for (std::uint32_t i = 0; i < count; ++i)
      of(kind).origins[i] = is_there(mesh.columns(), kind, i) ? i : untold_origin;
  }
}

Descent Descent::for_checks(const Mesh& mesh) { return is_checked ? Descent(mesh) : Descent(); }

void Descent::set_origin(ElementKind kind, std::uint32_t index, std::uint32_t origin) {
  std::vector<std::uint32_t>& origins = of(kind).origins;
  if (index >= origins.size()) origins.resize(std::size_t{index} + 1, untold_origin);
  origins[index] = origin;
}

void Descent::lose(Edge e) {
  if (!is_recording_) return;
  end(ElementKind::edge, e.index);
  set_origin(ElementKind::edge, e.index, no_index);
}

void Descent::tell(ElementKind kind, std::uint32_t to, std::span<const std::uint32_t> sources) {
  if (!records(kind) || (kind != ElementKind::corner && is_told(kind, to))) return;
  std::uint32_t common = sources.empty() ? no_index : origin(kind, sources[0]);
  for (const std::uint32_t source : sources)
    if (origin(kind, source) != common) common = no_index;
  set_origin(kind, to, common);
}

void Descent::tell_moved(std::span<const std::pair<Halfedge, Halfedge>> to_from) {
  if (!records(ElementKind::corner)) return;
  std::vector<std::uint32_t> origins;
  for (const auto& [to, from] : to_from) origins.push_back(origin(ElementKind::corner, from.index));
  for (const auto& [to, from] : to_from) set_origin(ElementKind::corner, from.index, no_index);
  for (std::size_t i = 0; i < to_from.size(); ++i) set_origin(ElementKind::corner, to_from[i].first.index, origins[i]);
}

void Descent::end(ElementKind kind, std::uint32_t index) {
  if (const std::uint32_t ended = origin(kind, index); ended != no_index) of(kind).ended[ended] = true;
}

void Descent::follow(const Descent& next) {
  for (const ElementKind kind : kinds) {
    const Kind& then = next.kinds_[static_cast<std::size_t>(kind)];
    std::vector<std::uint32_t> origins = then.origins;
    for (std::uint32_t& each : origins)
      if (each != no_index && each != untold_origin) each = origin(kind, each);
    for (std::uint32_t i = 0; i < then.ended.size(); ++i)
      if (then.ended[i]) end(kind, i);
    of(kind).origins = std::move(origins);
  }
}

void Descent::follow(ElementKind kind, const SourceList& next) {
  std::vector<std::uint32_t> origins(next.size(), untold_origin);
  for (std::uint32_t i = 0; i < next.size(); ++i)
    if (next.is_told(i)) origins[i] = next.origin(i) == no_index ? no_index : origin(kind, next.origin(i));
  next.for_each_dropped([&](std::uint32_t source) { end(kind, source); });
  of(kind).origins = std::move(origins);
}

std::optional<std::string> Descent::untold(const MeshColumns& before, const MeshColumns& after) const {
  for (const ElementKind kind : kinds) {
    const auto& [origins, ended] = kinds_[static_cast<std::size_t>(kind)];
    std::vector<bool> lives = ended;
    lives.resize(count_of(before, kind));
    for (std::uint32_t i = 0; i < count_of(after, kind); ++i) {
      if (!is_there(after, kind, i)) continue;
      if (i >= origins.size() || origins[i] == untold_origin)
        return name_of(kind, i) + " was created without saying what its values come from";
      if (origins[i] != no_index) lives[origins[i]] = true;
    }
    if (kind == ElementKind::corner) continue;  // a corner goes with its edge or its face
    for (std::uint32_t i = 0; i < lives.size(); ++i)
      if (is_there(before, kind, i) && !lives[i])
        return name_of(kind, i) + " was removed without saying what it is united with";
  }
  return std::nullopt;
}

std::vector<Element> descended(const Mesh& mesh, const Descent& descent, std::span<const Element> elements) {
  std::vector<std::pair<std::uint32_t, Element>> found;  // with where that stands of which they come
  const auto add = [&](std::uint32_t standing, const Element& e) {
    if (standing != no_index) found.emplace_back(standing, e);
  };
  for (std::uint32_t i = 0; i < elements.size(); ++i)
    if (const Vertex v = elements[i].vertex(); elements[i].kind == Element::Kind::vertex)
      if (mesh.exists(v) && mesh.is_alive(v)) add(i, v);
  const Standing faces(elements, Element::Kind::face), edges(elements, Element::Kind::edge),
      halves(elements, Element::Kind::halfedge);
  for (const Face f : live_faces(mesh)) add(faces.of(descent.origin(f).index), f);
  for (const Edge e : live_edges(mesh)) {
    const Edge origin = descent.origin(e);
    if (!origin) continue;
    add(edges.of(origin.index), e);
    for (const unsigned side : {0u, 1u}) add(halves.of(halfedge(origin, side).index), halfedge(e, side));
  }
  std::stable_sort(found.begin(), found.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  std::vector<Element> all;
  all.reserve(found.size());
  for (const auto& [standing, e] : found) all.push_back(e);
  return all;
}

}  // namespace ryosen
