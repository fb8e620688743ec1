// Each of the nine relations, and the valence, asked of every form by what its text stores: a search through all faces,
// or a walk along the links; with the number of records that this reads.
#include <algorithm>

#include "core/base/sort_unique.h"
#include "core/forms/all.h"
#include "core/forms/walk.h"
#include "core/mesh/copies.h"
#include "core/steps/play_texts.h"
#include "core/steps/players.h"
#include "core/steps/record_reader.h"

namespace ryosen::steps {

namespace {

using forms::Answer;
using forms::edge_ends;
using forms::EdgeEnds;
using forms::ElementOf;
using forms::Relation;
using forms::RelationRow;

// What is asked: a relation of an element; of an edge also its ends.
struct Asked {
  const RelationRow& row;
  Element element;
  EdgeEnds ends;
};

using Corners = std::vector<std::uint32_t>;

std::uint32_t behind(const Corners& corners, std::size_t i) { return corners[i + 1 < corners.size() ? i + 1 : 0]; }
std::uint32_t before(const Corners& corners, std::size_t i) { return corners[i > 0 ? i - 1 : corners.size() - 1]; }

// Adds what a face that has been read tells, by its corner list alone.
void add_from_face(const Asked& asked, std::uint32_t f, const Corners& corners, const Corners& of_asked, Answer& out) {
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const EdgeEnds side = edge_ends(corners[i], behind(corners, i));
    switch (asked.row.asks) {
      case ElementOf::vertex:
        if (side.a != asked.element.index && side.b != asked.element.index) break;
        out.edges.push_back(side);
        out.numbers.push_back(asked.row.relation == Relation::vertex_faces ? f
                              : side.a == asked.element.index              ? side.b
                                                                           : side.a);
        break;
      case ElementOf::edge:
        if (asked.row.relation == Relation::edge_faces && side == asked.ends) out.numbers.push_back(f);
        if (asked.row.relation == Relation::edge_edges && side != asked.ends &&
            (side.a == asked.ends.a || side.a == asked.ends.b || side.b == asked.ends.a || side.b == asked.ends.b))
          out.edges.push_back(side);
        break;
      case ElementOf::face:
        for (std::size_t k = 0; k < of_asked.size() && f != asked.element.index; ++k)
          if (edge_ends(of_asked[k], behind(of_asked, k)) == side) out.numbers.push_back(f);
        break;
    }
  }
}

Corners corners_of(RecordReader& reader, bool by_place, Face f) {
  Corners corners;
  if (by_place)
    for (const Vertex v : reader.corners_by_place(f)) corners.push_back(v.index);
  else
    for (const Element v : reader.links(f, "vertices")) corners.push_back(v.index);
  return corners;
}

void add_own_sides(const Asked& asked, const Corners& corners, Answer& out) {
  if (asked.row.relation == Relation::face_vertices) out.numbers = corners;
  for (std::size_t i = 0; i < corners.size() && asked.row.relation == Relation::face_edges; ++i)
    out.edges.push_back(edge_ends(corners[i], behind(corners, i)));
}

// Triangle soup, polygon set, table 2: all faces are looked through, but for what stands in the face itself.
void answer_by_search(RecordReader& reader, const Asked& asked, Answer& out) {
  const bool by_place = reader.stores(Element::Kind::face, "positions");
  Corners own;
  if (asked.row.asks == ElementOf::face) {
    own = corners_of(reader, by_place, asked.element.face());
    add_own_sides(asked, own, out);
    if (asked.row.relation != Relation::face_faces) return;
  }
  for (std::uint32_t f = 0; f < reader.mesh().face_slots(); ++f)
    if (reader.mesh().is_alive(Face(f))) add_from_face(asked, f, corners_of(reader, by_place, Face(f)), own, out);
}

// Table 3: from face to face around a vertex. visit(face, its corners, the faces across, place of the vertex).
template <class Visit>
void for_each_face_at(RecordReader& reader, std::uint32_t v, Visit visit) {
  const std::uint32_t first = reader.link(Vertex(v), "face").index;
  const auto walk = [&](std::uint32_t face, bool clockwise) {
    while (face != no_index) {
      const Corners corners = corners_of(reader, false, Face(face));
      const std::vector<Element> across = reader.links(Face(face), "faces");
      const std::size_t at = static_cast<std::size_t>(std::find(corners.begin(), corners.end(), v) - corners.begin());
      if (!clockwise || face != first) visit(face, corners, across, at);
      face = across[clockwise ? at : at > 0 ? at - 1 : corners.size() - 1].index;
      if (face == first) return true;
    }
    return false;
  };
  if (first != no_index && !walk(first, false)) walk(first, true);
}

// The other end of each edge at a vertex.
template <class Visit>
void for_each_neighbour_by_faces(RecordReader& reader, std::uint32_t v, Visit visit) {
  for_each_face_at(reader, v,
                   [&](std::uint32_t, const Corners& corners, const std::vector<Element>& across, std::size_t at) {
                     visit(behind(corners, at));
                     if (across[at > 0 ? at - 1 : corners.size() - 1].index == no_index) visit(before(corners, at));
                   });
}

void answer_by_faces(RecordReader& reader, const Asked& asked, Answer& out) {
  const std::uint32_t x = asked.element.index;
  const Relation relation = asked.row.relation;
  if (relation == Relation::vertex_faces) {
    for_each_face_at(reader, x, [&](std::uint32_t f, const Corners&, const std::vector<Element>&, std::size_t) {
      out.numbers.push_back(f);
    });
  } else if (asked.row.asks == ElementOf::vertex) {
    for_each_neighbour_by_faces(reader, x, [&](std::uint32_t w) {
      out.numbers.push_back(w);
      out.edges.push_back(edge_ends(x, w));
    });
  } else if (relation == Relation::edge_edges) {
    for (const std::uint32_t end : {asked.ends.a, asked.ends.b})
      for_each_neighbour_by_faces(reader, end, [&](std::uint32_t w) {
        if (edge_ends(end, w) != asked.ends) out.edges.push_back(edge_ends(end, w));
      });
  } else if (relation == Relation::edge_faces) {
    for_each_face_at(reader, asked.ends.a,
                     [&](std::uint32_t f, const Corners& corners, const std::vector<Element>&, std::size_t at) {
                       if (behind(corners, at) == asked.ends.b || before(corners, at) == asked.ends.b)
                         out.numbers.push_back(f);
                     });
  } else if (relation == Relation::face_faces) {
    for (const Element across : reader.links(asked.element, "faces"))
      if (across.index != no_index) out.numbers.push_back(across.index);
  } else {
    add_own_sides(asked, corners_of(reader, false, asked.element.face()), out);
  }
}

// Table 4: along the wings.
class Wings {
 public:
  explicit Wings(RecordReader& reader) : reader_(reader) {}

  std::uint32_t get(std::uint32_t e, std::string_view key) { return reader_.link(Edge(e), key).index; }
  EdgeEnds ends(std::uint32_t e) { return edge_ends(get(e, "from"), get(e, "to")); }

  // Counter-clockwise up to a gap, then clockwise from the first edge.
  template <class Visit>
  void for_each_edge_at(std::uint32_t v, Visit visit) {
    const std::uint32_t first = reader_.link(Vertex(v), "edge").index;
    if (first == no_index) return;
    std::uint32_t e = first;
    do {
      visit(e);
      e = get(e, get(e, "from") == v ? "left_prev" : "right_prev");
    } while (e != first && e != no_index);
    if (e == first) return;
    for (e = clockwise(first, v); e != no_index; e = clockwise(e, v)) visit(e);
  }
  template <class Visit>
  void for_each_edge_of(std::uint32_t f, Visit visit) {
    const std::uint32_t first = reader_.link(Face(f), "edge").index;
    std::uint32_t e = first;
    do {
      const bool is_left = get(e, "left") == f;
      visit(e, is_left);
      e = get(e, is_left ? "left_next" : "right_next");
    } while (e != first);
  }

 private:
  std::uint32_t clockwise(std::uint32_t e, std::uint32_t v) {
    return get(e, get(e, "from") == v ? "right_next" : "left_next");
  }
  RecordReader& reader_;
};

void answer_by_wings(RecordReader& reader, const Asked& asked, Answer& out) {
  Wings wings(reader);
  const std::uint32_t x = asked.element.index;
  const Relation relation = asked.row.relation;
  const auto add_face = [&](std::uint32_t f) {
    if (f != no_index && f != (asked.row.asks == ElementOf::face ? x : no_index)) out.numbers.push_back(f);
  };
  if (asked.row.asks == ElementOf::vertex) {
    wings.for_each_edge_at(x, [&](std::uint32_t e) {
      const EdgeEnds ends = wings.ends(e);
      out.edges.push_back(ends);
      if (relation == Relation::vertex_faces)
        add_face(wings.get(e, wings.get(e, "from") == x ? "left" : "right"));
      else
        out.numbers.push_back(ends.a == x ? ends.b : ends.a);
    });
  } else if (relation == Relation::edge_faces) {
    for (const std::string_view side : {"left", "right"}) add_face(wings.get(x, side));
  } else if (relation == Relation::edge_edges) {
    for (const std::string_view end : {"from", "to"})
      wings.for_each_edge_at(wings.get(x, end), [&](std::uint32_t e) {
        if (e != x) out.edges.push_back(wings.ends(e));
      });
  } else if (asked.row.asks == ElementOf::face) {
    wings.for_each_edge_of(x, [&](std::uint32_t e, bool is_left) {
      out.edges.push_back(wings.ends(e));
      if (relation == Relation::face_vertices) out.numbers.push_back(wings.get(e, is_left ? "from" : "to"));
      if (relation == Relation::face_faces) add_face(wings.get(e, is_left ? "right" : "left"));
    });
  }
}

// The halfedges by which the form reaches an edge: what its record says, else the one that it numbers.
std::uint32_t side_of_edge(RecordReader& reader, Edge e) {
  if (reader.stores(Element::Kind::edge, "left")) return reader.link(e, "left").index;
  if (reader.stores(Element::Kind::edge, "halfedges")) return reader.links(e, "halfedges").front().index;
  const Halfedge h = halfedge(e);
  return reader.mesh().is_outside(h) ? twin(h).index : h.index;
}

// Where a point has copies: the copies one by one.
void answer_by_copies(RecordReader& reader, const RecordLinks& links, const Asked& asked, Answer& out) {
  const Mesh& mesh = reader.mesh();
  const auto point = [&](std::uint32_t v) { return mesh.copy_point(Vertex(v)).index; };
  const auto for_each_copy_read = [&](std::uint32_t v, const auto& visit) {
    Vertex copy(v);
    do {
      visit(copy.index);
      const Element next = reader.link(copy, "next_copy");
      copy = next.index == no_index ? Vertex(v) : next.vertex();
    } while (copy.index != v);
  };
  const auto add_neighbours = [&](std::uint32_t v) {
    for_each_copy_read(v, [&](std::uint32_t copy) {
      forms::for_each_neighbour(links, links.at_vertex(copy), [&](std::uint32_t w) {
        if (asked.row.asks == ElementOf::edge && edge_ends(point(v), point(w)) == asked.ends) return;
        out.numbers.push_back(point(w));
        out.edges.push_back(edge_ends(point(v), point(w)));
      });
    });
  };
  const std::uint32_t x = asked.element.index;
  if (asked.row.relation == Relation::vertex_faces) {
    for_each_copy_read(
        x, [&](std::uint32_t copy) { forms::answer_about_vertex(links, Relation::vertex_faces, copy, out); });
  } else if (asked.row.asks == ElementOf::vertex) {
    add_neighbours(x);
  } else if (asked.row.relation == Relation::edge_edges) {
    add_neighbours(asked.ends.a);
    add_neighbours(asked.ends.b);
  } else if (asked.row.relation == Relation::edge_faces || asked.row.relation == Relation::face_faces) {
    const auto add_sheets = [&](EdgeEnds ends) {
      for_each_copy_read(ends.a, [&](std::uint32_t copy) {
        forms::for_each_leaving(links, links.at_vertex(copy), [&](std::uint32_t h) {
          if (point(links.from(links.next(h))) != ends.b) return;
          for (const std::uint32_t side : {h, links.pair(h)})
            if (links.face(side) != no_index && (asked.row.asks != ElementOf::face || links.face(side) != x))
              out.numbers.push_back(links.face(side));
        });
      });
    };
    if (asked.row.asks == ElementOf::edge) return add_sheets(asked.ends);
    std::vector<EdgeEnds> sides;
    forms::for_each_in_face(links, x, [&](std::uint32_t h) {
      sides.push_back(edge_ends(point(links.from(h)), point(links.from(links.next(h)))));
    });
    for (const EdgeEnds side : sides) add_sheets(side);
  } else {
    forms::answer_by_walk(links, asked.row.relation, x, out);
    for (EdgeEnds& side : out.edges) side = edge_ends(point(side.a), point(side.b));
    for (std::uint32_t& v : out.numbers) v = point(v);
  }
}

// False where the form has no way to the answer.
bool answer_by_links(RecordReader& reader, const Asked& asked, Answer& out) {
  const RecordLinks links(reader);
  const bool needs_vertex = asked.row.asks == ElementOf::vertex;
  if (needs_vertex && !reader.stores(Element::Kind::vertex, "halfedge")) return false;
  if (reader.mesh().has_copies()) {
    answer_by_copies(reader, links, asked, out);
    return true;
  }
  const std::uint32_t element =
      asked.row.asks == ElementOf::edge ? side_of_edge(reader, asked.element.edge()) : asked.element.index;
  const Relation relation = asked.row.relation == Relation::valence ? Relation::vertex_vertices : asked.row.relation;
  forms::answer_by_walk(links, relation, element, out);
  return true;
}

// By its record, or that of a halfedge; a form without either has an edge by its ends alone, and reads nothing.
void answer_ends(RecordReader& reader, const Asked& asked, Answer& out) {
  const Edge e = asked.element.edge();
  const auto point = [&](std::uint32_t v) { return reader.mesh().copy_point(Vertex(v)).index; };
  if (reader.stores(Element::Kind::edge, "from")) {
    out.numbers = {reader.link(e, "from").index, reader.link(e, "to").index};
  } else if (reader.stores(Element::Kind::halfedge, "from")) {
    const RecordLinks links(reader);
    const std::uint32_t h = side_of_edge(reader, e);
    out.numbers = {point(links.from(h)), point(links.from(links.next(h)))};
  } else {
    out.numbers = {asked.ends.a, asked.ends.b};
  }
}

// In slots of the mesh.
bool answer_by_records(RecordReader& reader, const Asked& asked, Answer& out) {
  bool is_told = true;
  if (asked.row.relation == Relation::edge_vertices)
    answer_ends(reader, asked, out);
  else if (reader.stores(Element::Kind::vertex, "face"))
    answer_by_faces(reader, asked, out);
  else if (reader.stores(Element::Kind::vertex, "edge"))
    answer_by_wings(reader, asked, out);
  else if (reader.stores(Element::Kind::halfedge, "from"))
    is_told = answer_by_links(reader, asked, out);
  else
    answer_by_search(reader, asked, out);
  // What a face says of itself comes in its order.
  if (asked.row.relation == Relation::face_vertices || asked.row.relation == Relation::face_edges) return is_told;
  sort_unique(out.numbers);
  sort_unique(out.edges);
  return is_told;
}

std::vector<Element> elements_of(const Mesh& mesh, Relation relation, const Answer& answer) {
  std::vector<Element> all;
  switch (relation) {
    case Relation::vertex_edges:
    case Relation::edge_edges:
    case Relation::face_edges:
      for (const EdgeEnds& ends : answer.edges) {
        Edge lowest;
        for (const Halfedge h : sheets_between(mesh, Vertex(ends.a), Vertex(ends.b)))
          if (edge(h).index < lowest.index) lowest = edge(h);
        all.push_back(lowest);
      }
      break;
    case Relation::vertex_faces:
    case Relation::edge_faces:
    case Relation::face_faces:
      for (const std::uint32_t f : answer.numbers) all.push_back(Face(f));
      break;
    default:
      for (const std::uint32_t v : answer.numbers) all.push_back(Vertex(v));
  }
  return all;
}

Step step_of_form(const Mesh& mesh, const forms::FormRow& form, const Asked& asked) {
  const Text place = Text{std::string(form.en) + " (" + std::string(form.source_en) + "): ",
                          std::string(form.ja) + "（" + std::string(form.source_ja) + "）："};
  Step step;
  step.source = Source{"000", "section 2, the nine relations", "2 節 9 種類の関係"};
  step.marks.push_back({Role::asked, asked.element});
  RecordReader reader(mesh, form);
  if (reader.unsuitable()) {
    step.caption = place + *reader.unsuitable();
    return step;
  }
  Answer answer;
  if (!answer_by_records(reader, asked, answer)) {
    step.caption = place + Text{"it stores no link from a vertex to its halfedges, so it cannot tell.",
                                "頂点から半稜線へのリンクがないため答えられません。"};
    return step;
  }
  const bool is_number = asked.row.relation == Relation::valence;
  const std::vector<Element> found = elements_of(mesh, asked.row.relation, answer);
  mark_all(step, Role::answer, found);
  mark_all(step, Role::read, reader.read());
  const std::string records = std::to_string(reader.read().size()),
                    is = is_number ? std::to_string(found.size()) : names_text(found);
  const std::string question = std::string(asked.row.en) + " " + slot_name(asked.element),
                    question_ja = std::string(asked.row.ja) + " " + slot_name(asked.element);
  step.caption = place + Text{question + " reads " + records + " records and finds " + (is.empty() ? "nothing" : is),
                              question_ja + "：読むデータ " + records + " 個、答えは " + (is.empty() ? "なし" : is)};
  step.rows = {{"records_read", std::string(form.id), std::string(asked.row.id), {}, records},
               {"answer", std::string(form.id), std::string(asked.row.id), {}, is}};
  return step;
}

Result<Asked> asked_of(const Mesh& mesh, const RelationRow& row, const std::string& name) {
  if (row.asks == ElementOf::vertex) {
    const Result<Vertex> v = named_element(find_vertex(mesh, name));
    if (!v) return v.failure();
    return Asked{row, mesh.copy_point(*v), {}};
  }
  if (row.asks == ElementOf::face) {
    const Result<Face> f = named_element(find_face(mesh, name));
    if (!f) return f.failure();
    return Asked{row, *f, {}};
  }
  const Result<Halfedge> h = named_element(find_edge(mesh, name));
  if (!h) return h.failure();
  return Asked{row, edge(*h), edge_ends(mesh.copy_point(mesh.from(*h)).index, mesh.copy_point(mesh.to(*h)).index)};
}

}  // namespace

Made play_relation(const Mesh& mesh, Arguments arguments) {
  std::string ids;
  const RelationRow* row = nullptr;
  for (const RelationRow& one : forms::relations()) {
    ids.append(ids.empty() ? "" : ", ").append(one.id);
    if (!arguments.empty() && one.id == arguments[0]) row = &one;
  }
  if (!row || arguments.size() != 2)
    return usage_of({"'relation R X' takes one of " + ids + " and a vertex vN, edge A-B or face fN.",
                     "relation R X の R は " + ids + "、X は頂点 vN、稜線 A-B、面 fN です。"});
  const Result<Asked> asked = asked_of(mesh, *row, arguments[1]);
  if (!asked) return asked.failure();
  std::vector<Step> steps;
  for (const forms::FormRow& form : forms::all_forms()) steps.push_back(step_of_form(mesh, form, *asked));
  return std::unique_ptr<Sequence>(std::make_unique<RecordedSteps>(mesh, std::move(steps)));
}

// All relations, of what is selected or of the first element of the kind.
Choices choices_of_relation(const Mesh& mesh, Selected selection) {
  const auto v = usual_of<Vertex>(mesh, selection, mesh.vertex_slots());
  const auto e = usual_of<Edge>(mesh, selection, mesh.edge_slots());
  const auto f = usual_of<Face>(mesh, selection, mesh.face_slots());
  Choices choices;
  const auto offer = [&](const RelationRow& row, const auto& element) {
    if (element) choices.push_back({std::string(row.id), slot_name(*element)});
  };
  for (const RelationRow& row : forms::relations()) {
    if (row.asks == ElementOf::vertex) offer(row, v);
    if (row.asks == ElementOf::edge) offer(row, e);
    if (row.asks == ElementOf::face) offer(row, f);
  }
  return choices;
}

}  // namespace ryosen::steps
