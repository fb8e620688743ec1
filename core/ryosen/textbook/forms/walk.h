// Generic answers for all forms with linked halfedges, based on these accessors:
//
//   from(h), next(h), prev(h)      along the loop of h
//   pair(h)                        the halfedge on the other side, or no_index
//   face(h)                        or no_index where h runs outside
//   at_vertex(v), at_face(f)       one halfedge that leaves the vertex (no_index: none), the first one of the face
//   inner(f)                       the first halfedges of inner loops
//   at_edge(e)                     a halfedge of an edge by the form's handle
//
// Vertices are circulated counter-clockwise up to a gap and, if there is one, clockwise from the start; a form with
// boundary halfedges has no gaps.
#pragma once

#include "ryosen/base/sort_unique.h"
#include "ryosen/textbook/forms/form.h"

namespace ryosen::forms {

// Calls visit(h) for every halfedge that leaves the origin of `start`.
template <class Links, class Visit>
void for_each_leaving(const Links& links, std::uint32_t start, Visit visit) {
  if (start == no_index) return;
  std::uint32_t h = start;
  do {
    visit(h);
    h = links.pair(links.prev(h));
  } while (h != start && h != no_index);
  if (h == start) return;
  for (h = links.pair(start); h != no_index; h = links.pair(h)) {
    h = links.next(h);
    visit(h);
  }
}

// Calls visit(v) for the other end of every edge at the origin of `start`. An incoming side at a gap has no outgoing
// pair.
template <class Links, class Visit>
void for_each_neighbour(const Links& links, std::uint32_t start, Visit visit) {
  for_each_leaving(links, start, [&](std::uint32_t h) {
    visit(links.from(links.next(h)));
    const std::uint32_t incoming = links.prev(h);
    if (links.pair(incoming) == no_index) visit(links.from(incoming));
  });
}

template <class Links, class Visit>
void for_each_in_loop(const Links& links, std::uint32_t start, Visit visit) {
  std::uint32_t h = start;
  do {
    visit(h);
    h = links.next(h);
  } while (h != start);
}

// All loops of a face, the outer one first.
template <class Links, class Visit>
void for_each_in_face(const Links& links, std::uint32_t f, Visit visit) {
  for_each_in_loop(links, links.at_face(f), visit);
  for (const std::uint32_t start : links.inner(f)) for_each_in_loop(links, start, visit);
}

template <class Links>
EdgeEnds ends_of(const Links& links, std::uint32_t h) {
  return edge_ends(links.from(h), links.from(links.next(h)));
}

// A halfedge of the edge a-b by a walk around a, or no_index.
template <class Links>
std::uint32_t find_side(const Links& links, std::uint32_t a, std::uint32_t b) {
  std::uint32_t found = no_index;
  for_each_leaving(links, links.at_vertex(a), [&](std::uint32_t h) {
    if (links.from(links.next(h)) == b) found = h;
    const std::uint32_t incoming = links.prev(h);
    if (links.pair(incoming) == no_index && links.from(incoming) == b) found = incoming;
  });
  return found;
}

template <class Links>
void answer_about_vertex(const Links& links, Relation relation, std::uint32_t v, Answer& out) {
  const std::uint32_t start = links.at_vertex(v);
  switch (relation) {
    case Relation::vertex_vertices:
      for_each_neighbour(links, start, [&](std::uint32_t w) { out.numbers.push_back(w); });
      return;
    case Relation::vertex_edges:
      for_each_neighbour(links, start, [&](std::uint32_t w) { out.edges.push_back(edge_ends(v, w)); });
      return;
    case Relation::vertex_faces:
      for_each_leaving(links, start, [&](std::uint32_t h) {
        if (links.face(h) != no_index) out.numbers.push_back(links.face(h));
      });
      return sort_unique(out.numbers);  // a face with a bridge is visited twice
    default: {
      std::uint32_t valence = 0;
      for_each_neighbour(links, start, [&](std::uint32_t) { ++valence; });
      out.numbers.push_back(valence);
    }
  }
}

template <class Links>
void answer_about_edge(const Links& links, Relation relation, std::uint32_t edge, Answer& out) {
  const std::uint32_t h = links.at_edge(edge), other = links.pair(h);
  const EdgeEnds ends = ends_of(links, h);
  if (relation == Relation::edge_vertices) {
    out.numbers = {ends.a, ends.b};
  } else if (relation == Relation::edge_faces) {
    if (links.face(h) != no_index) out.numbers.push_back(links.face(h));
    if (other != no_index && links.face(other) != no_index && links.face(other) != links.face(h))
      out.numbers.push_back(links.face(other));
  } else {
    const auto add_all_at = [&](std::uint32_t v, std::uint32_t leaving) {
      for_each_neighbour(links, leaving, [&](std::uint32_t w) {
        if (edge_ends(v, w) != ends) out.edges.push_back(edge_ends(v, w));
      });
    };
    add_all_at(links.from(h), h);
    add_all_at(links.from(links.next(h)), links.next(h));
  }
}

template <class Links>
void answer_about_face(const Links& links, Relation relation, std::uint32_t f, Answer& out) {
  for_each_in_face(links, f, [&](std::uint32_t h) {
    if (relation == Relation::face_vertices) {
      out.numbers.push_back(links.from(h));
    } else if (relation == Relation::face_edges) {
      out.edges.push_back(ends_of(links, h));
    } else if (const std::uint32_t other = links.pair(h); other != no_index) {
      if (links.face(other) != no_index && links.face(other) != f) out.numbers.push_back(links.face(other));
    }
  });
  if (relation == Relation::face_faces) sort_unique(out.numbers);
}

template <class Links>
bool answer_by_walk(const Links& links, Relation relation, std::uint32_t element, Answer& out) {
  return answer_by_element(
      relation, out, [&] { answer_about_vertex(links, relation, element, out); },
      [&] { answer_about_edge(links, relation, element, out); },
      [&] { answer_about_face(links, relation, element, out); });
}

// A form with these accessors. What stands here holds where the form does not say otherwise.
template <class Links>
class LinkedForm : public Form {
 public:
  std::uint32_t find_edge(std::uint32_t a, std::uint32_t b) const override { return find_side(as_links(), a, b); }
  bool answer(Relation relation, std::uint32_t element, Answer& out) const override {
    return answer_by_walk(as_links(), relation, element, out);
  }
  static std::uint32_t at_edge(std::uint32_t h) { return h; }
  static std::span<const std::uint32_t> inner(std::uint32_t) { return {}; }

 protected:
  const Links& as_links() const { return static_cast<const Links&>(*this); }
};

// A linked form of triangles with halfedges 3i+j, side j of face i; it offers corner(h) and opposite(h).
template <class Links>
class TriangleForm : public LinkedForm<Links> {
 public:
  std::uint32_t from(std::uint32_t h) const { return this->as_links().corner(h); }
  std::uint32_t pair(std::uint32_t h) const { return this->as_links().opposite(h); }
  static std::uint32_t next(std::uint32_t h) { return h % 3 == 2 ? h - 2 : h + 1; }
  static std::uint32_t prev(std::uint32_t h) { return h % 3 == 0 ? h + 2 : h - 1; }
  static std::uint32_t face(std::uint32_t h) { return h / 3; }
  static std::uint32_t at_face(std::uint32_t f) { return 3 * f; }
};

}  // namespace ryosen::forms
