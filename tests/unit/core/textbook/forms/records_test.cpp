// What the forms store of an element, held to what the mesh itself says of it.
#include "ryosen/textbook/forms/records.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <map>
#include <set>

#include "ryosen/mesh/circulate.h"
#include "ryosen/mesh/copies.h"
#include "ryosen/mesh/names.h"
#include "ryosen/textbook/forms/all.h"
#include "tests/support/core/random_meshes.h"
#include "tests/support/core/shapes.h"

namespace ryosen::forms {
namespace {

using test::make_mesh;

Element none_of(Element::Kind kind) {
  Element none;
  none.kind = kind;
  return none;
}

Element face_or_none(const Mesh& mesh, Halfedge h) {
  return mesh.face(h) ? Element(mesh.face(h)) : none_of(Element::Kind::face);
}

// Where a form has halfedges on faces alone, there is none at a gap.
Element halfedge_in(const Mesh& mesh, const FormRow& row, Halfedge h) {
  const bool is_there = row.halfedges == HalfedgesOf::all || mesh.face(h);
  return is_there ? Element(h) : none_of(Element::Kind::halfedge);
}

// What a link of a halfedge must lead to.
std::map<std::string_view, Element> links_of(const Mesh& mesh, const FormRow& row, Halfedge h) {
  return {{"from", mesh.from(h)},
          {"to", mesh.to(h)},
          {"next", mesh.next(h)},
          {"prev", mesh.prev(h)},
          {"face", face_or_none(mesh, h)},
          {"edge", edge(h)},
          {"twin", halfedge_in(mesh, row, twin(h))}};
}

const Field* field_of(const ElementRecord& record, std::string_view key) {
  const auto found =
      std::find_if(record.fields.begin(), record.fields.end(), [&](const Field& field) { return field.key == key; });
  return found == record.fields.end() ? nullptr : &*found;
}

class Reader {
 public:
  Reader(const Mesh& mesh, const FormRow& row) : mesh_(mesh), row_(row), records_(mesh, row) {}

  void expect_all() {
    for (std::uint32_t i = 0; i < mesh_.halfedge_slots(); ++i)
      if (mesh_.is_alive(Halfedge(i))) expect_halfedge(Halfedge(i));
    for (std::uint32_t i = 0; i < mesh_.vertex_slots(); ++i)
      if (mesh_.is_alive(Vertex(i))) expect_vertex(Vertex(i));
    for (std::uint32_t i = 0; i < mesh_.edge_slots(); ++i)
      if (mesh_.is_alive(Edge(i))) expect_edge(Edge(i));
    for (std::uint32_t i = 0; i < mesh_.face_slots(); ++i)
      if (mesh_.is_alive(Face(i))) expect_face(Face(i));
  }

 private:
  std::string where(Element element, std::string_view key) const {
    return std::string(row_.id) + " " + slot_name(element) + " " + std::string(key);
  }
  // The record, or null where it has none, which then is told.
  const ElementRecord* record_of(Element element) {
    last_ = records_.of(element);
    EXPECT_EQ(last_.none.has_value(), last_.fields.empty()) << where(element, "");
    std::set<std::string_view> keys;
    for (const Field& field : last_.fields) {
      EXPECT_TRUE(keys.insert(field.key).second) << where(element, field.key);
      EXPECT_FALSE(field.word.empty()) << where(element, field.key);
      EXPECT_EQ(field.links.size(), field.stored.size()) << where(element, field.key);
    }
    return last_.none ? nullptr : &last_;
  }
  bool has_halfedge(const Field& field, const std::function<bool(Halfedge)>& fits) const {
    const Element link = field.links.at(0);
    return link.kind == Element::Kind::halfedge && link.index != no_index && fits(link.halfedge());
  }

  void expect_halfedge(Halfedge h) {
    const ElementRecord* const record = record_of(h);
    EXPECT_EQ(record != nullptr,
              row_.halfedges == HalfedgesOf::all || (row_.halfedges == HalfedgesOf::faces && mesh_.face(h)))
        << where(h, "");
    if (record == nullptr) return;
    const auto expected = links_of(mesh_, row_, h);
    for (const Field& field : record->fields)
      EXPECT_EQ(field.links.at(0), expected.at(field.key)) << where(h, field.key);
  }
  void expect_vertex(Vertex v) {
    const ElementRecord* const record = record_of(v);
    if (record == nullptr) return;
    const Vertex point = row_.holds_copies ? v : mesh_.copy_point(v);
    EXPECT_EQ(field_of(*record, "position")->places.at(0), mesh_.position(point)) << where(v, "position");
    if (const Field* const field = field_of(*record, "halfedge"); field && !mesh_.is_isolated(v)) {
      EXPECT_TRUE(has_halfedge(*field, [&](Halfedge h) { return mesh_.from(h) == v; })) << where(v, "halfedge");
    }
    if (const Field* const field = field_of(*record, "edge"); field && !mesh_.is_isolated(v)) {
      const Halfedge h = halfedge(field->links.at(0).edge());
      EXPECT_TRUE(mesh_.from(h) == v || mesh_.to(h) == v) << where(v, "edge");
    }
    if (const Field* const field = field_of(*record, "face"); field && !mesh_.is_isolated(v)) {
      const auto around = vertices_around(mesh_, field->links.at(0).face());
      EXPECT_NE(std::find(around.begin(), around.end(), v), around.end()) << where(v, "face");
    }
    if (const Field* const field = field_of(*record, "next_copy")) {
      EXPECT_EQ(field->links.at(0), Element(mesh_.next_copy(v)));
    }
  }
  void expect_edge(Edge e) {
    const ElementRecord* const record = record_of(e);
    if (record == nullptr) return;
    if (const Field* const both = field_of(*record, "halfedges")) {
      EXPECT_EQ(both->links, (std::vector<Element>{halfedge(e), twin(halfedge(e))})) << where(e, "halfedges");
      return;
    }
    Halfedge h = halfedge(e);
    if (field_of(*record, "from")->links.at(0) != Element(mesh_.from(h))) h = twin(h);
    const bool winged = field_of(*record, "left_next") != nullptr;
    const auto wing = [&](Halfedge of, Halfedge at) {
      return mesh_.face(of) ? Element(edge(at)) : none_of(Element::Kind::edge);
    };
    const Halfedge t = twin(h);
    const std::map<std::string_view, Element> expected = {
        {"from", mesh_.from(h)},
        {"to", mesh_.to(h)},
        {"left", winged ? face_or_none(mesh_, h) : halfedge_in(mesh_, row_, h)},
        {"right", winged ? face_or_none(mesh_, t) : halfedge_in(mesh_, row_, t)},
        {"left_next", wing(h, mesh_.next(h))},
        {"left_prev", wing(h, mesh_.prev(h))},
        {"right_next", wing(t, mesh_.next(t))},
        {"right_prev", wing(t, mesh_.prev(t))}};
    for (const Field& field : record->fields)
      EXPECT_EQ(field.links.at(0), expected.at(field.key)) << where(e, field.key);
  }
  void expect_face(Face f) {
    const ElementRecord* const record = record_of(f);
    ASSERT_NE(record, nullptr) << where(f, "");
    std::vector<Element> corners, across;
    std::vector<glm::dvec3> places;
    for (const Halfedge h : loop(mesh_, mesh_.halfedge(f))) {
      corners.push_back(mesh_.copy_point(mesh_.from(h)));
      across.push_back(face_or_none(mesh_, twin(h)));
      places.push_back(mesh_.position(mesh_.copy_point(mesh_.from(h))));
    }
    const auto is_side = [&](Halfedge h) { return mesh_.face(h) == f; };
    for (const Field& field : record->fields) {
      const std::string at = where(f, field.key);
      if (field.key == "vertices" || field.key == "faces") {
        EXPECT_EQ(field.links, field.key == "faces" ? across : corners) << at;
      } else if (field.key == "positions") {
        EXPECT_EQ(field.places, places) << at;
      } else if (field.key == "halfedge" || field.key == "outer") {
        EXPECT_TRUE(has_halfedge(field, is_side)) << at;
      }
      if (field.key == "inner") {
        std::vector<Element> rings;
        for (const Halfedge h : inner_loops(mesh_, f)) rings.push_back(h);
        EXPECT_EQ(field.links, rings) << where(f, field.key);
      }
      if (field.key == "edge") {
        const Halfedge h = halfedge(field.links.at(0).edge());
        EXPECT_TRUE(is_side(h) || is_side(twin(h))) << where(f, field.key);
      }
    }
  }

  const Mesh& mesh_;
  const FormRow& row_;
  Records records_;
  ElementRecord last_;
};

int expect_records(const Mesh& mesh) {
  int held = 0;
  for (const FormRow& row : all_forms()) {
    if (why_unsuitable(mesh, row)) {
      if (mesh.live().vertices == 0) continue;
      EXPECT_TRUE(Records(mesh, row).of(Vertex(0)).none || !mesh.is_alive(Vertex(0)));
      continue;
    }
    Reader(mesh, row).expect_all();
    ++held;
  }
  return held;
}

TEST(records, say_what_the_mesh_says_of_every_element) {
  for (const test::Polygons& faces : {test::tetrahedron(), test::cube(), test::torus_grid(3, 4), test::two_quads(),
                                      test::closed_fan(6), test::bow_tie(), test::fin(), test::moebius_strip()})
    EXPECT_GE(expect_records(make_mesh(faces)), 2);
}

TEST(records, say_what_random_meshes_say_of_every_element) {
  int held = 0;
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    const RandomMesh random = random_mesh(seed);
    test::Polygons faces;
    for (const auto& face : random.faces) faces.emplace_back(face.begin(), face.end());
    held += expect_records(make_mesh(faces, static_cast<std::size_t>(random.points)));
  }
  EXPECT_GT(held, 200);
}

// Follows the links of the records alone, without a look at the mesh.
class LinkFollower {
 public:
  LinkFollower(const Mesh& mesh, const FormRow& row) : mesh_(mesh), name_(row.id), records_(mesh, row) {}

  int follow_all() {
    for (std::uint32_t i = 0; i < mesh_.halfedge_slots(); ++i)
      if (mesh_.is_alive(Halfedge(i))) follow(Halfedge(i));
    for (std::uint32_t i = 0; i < mesh_.vertex_slots(); ++i)
      if (mesh_.is_alive(Vertex(i))) follow(Vertex(i));
    for (std::uint32_t i = 0; i < mesh_.edge_slots(); ++i)
      if (mesh_.is_alive(Edge(i))) follow(Edge(i));
    for (std::uint32_t i = 0; i < mesh_.face_slots(); ++i)
      if (mesh_.is_alive(Face(i))) follow(Face(i));
    return followed_;
  }

 private:
  // The links of a field of the record that a link leads to; nothing where there is no such record or field.
  std::optional<std::vector<Element>> links(Element to, std::string_view key) const {
    const ElementRecord record = records_.of(to);
    const Field* const field = field_of(record, key);
    return field == nullptr ? std::nullopt : std::optional(field->links);
  }
  void expect_one_of(Element from, std::string_view key, Element to, std::initializer_list<std::string_view> back) {
    bool is_there = false, is_back = false;
    for (const std::string_view field : back) {
      const auto found = links(to, field);
      is_there |= found.has_value();
      is_back |= found && std::find(found->begin(), found->end(), from) != found->end();
    }
    if (!is_there) return;
    ++followed_;
    EXPECT_TRUE(is_back) << name_ << ' ' << slot_name(from) << ' ' << key << ' ' << slot_name(to);
  }
  // What leads back from where a link of an element leads.
  void follow_link(Element from, const Field& field, Element to) {
    using Kind = Element::Kind;
    if (to.index == no_index) return;
    const std::string_view key = field.key;
    if (key == "next") return expect_one_of(from, key, to, {"prev"});
    if (key == "prev") return expect_one_of(from, key, to, {"next"});
    if (key == "twin") return expect_one_of(from, key, to, {"twin"});
    if (from.kind == Kind::edge && to.kind == Kind::halfedge) return expect_one_of(from, key, to, {"edge"});
    if (from.kind == Kind::halfedge && to.kind == Kind::edge)
      return expect_one_of(from, key, to, {"halfedges", "left", "right"});
    if (from.kind == Kind::vertex && to.kind == Kind::halfedge) return expect_one_of(from, key, to, {"from"});
    if (from.kind == Kind::face && to.kind == Kind::halfedge) return expect_one_of(from, key, to, {"face"});
    if (from.kind == Kind::face && to.kind == Kind::face) return expect_one_of(from, key, to, {"faces"});
    if (from.kind == Kind::vertex && to.kind == Kind::face) return expect_one_of(from, key, to, {"vertices"});
    if (from.kind == Kind::vertex && to.kind == Kind::edge) return expect_one_of(from, key, to, {"from", "to"});
    if (from.kind == Kind::face && to.kind == Kind::edge) return expect_one_of(from, key, to, {"left", "right"});
    // A wing ends in a wing: it has this edge as its next or previous one on either side.
    if (from.kind == Kind::edge && to.kind == Kind::edge)
      return expect_one_of(from, key, to, {"left_next", "left_prev", "right_next", "right_prev"});
  }
  void follow(Element element) {
    const ElementRecord record = records_.of(element);
    for (const Field& field : record.fields)
      for (const Element& to : field.links) follow_link(element, field, to);
  }

  const Mesh& mesh_;
  std::string_view name_;
  Records records_;
  int followed_ = 0;
};

TEST(records, lead_to_records_that_lead_back) {
  std::map<std::string_view, int> followed;
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    const RandomMesh random = random_mesh(seed);
    test::Polygons faces;
    for (const auto& face : random.faces) faces.emplace_back(face.begin(), face.end());
    const Mesh mesh = make_mesh(faces, static_cast<std::size_t>(random.points));
    for (const FormRow& row : all_forms())
      if (!why_unsuitable(mesh, row)) followed[row.id] += LinkFollower(mesh, row).follow_all();
  }
  for (const FormRow& row : all_forms()) {
    const bool has_links_back =
        std::set<std::string_view>{"triangle_soup", "polygon_set", "indexed_face_set"}.count(row.id) == 0;
    EXPECT_EQ(followed[row.id] > 100, has_links_back) << row.id << ' ' << followed[row.id];
  }
}

// The fan of three faces around vertex 3, whose boundary is coded as the text has it.
TEST(records, keep_the_code_of_a_boundary_as_the_text_has_it) {
  const Mesh mesh = make_mesh({{0, 1, 3}, {1, 2, 3}, {2, 0, 3}});
  const Records map(mesh, *find_form("opposite_map")), array(mesh, *find_form("opposite_array"));
  const Named<Halfedge> rim = find_edge(mesh, "0-1"), spoke = find_edge(mesh, "1-3");
  const ElementRecord at_rim = map.of(rim.element), at_spoke = map.of(spoke.element);
  EXPECT_EQ(field_of(at_rim, "twin")->stored.at(0), -1);  // halfedge 0 has no opposite
  EXPECT_EQ(field_of(at_rim, "twin")->links.at(0), none_of(Element::Kind::halfedge));
  EXPECT_EQ(field_of(at_spoke, "twin")->stored.at(0), 5);  // 1-3 is number 1, its opposite 3-1 number 5
  EXPECT_EQ(field_of(array.of(rim.element), "twin")->stored.at(0), -1);
  EXPECT_EQ(map.of(twin(rim.element)).none->en, "It has no halfedge where there is no face.");
}

}  // namespace
}  // namespace ryosen::forms
