// Every form of the table: the way to Mesh and back is the identity, and all forms that can answer agree.
#include "ryosen/textbook/forms/all.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <map>
#include <random>
#include <set>

#include "ryosen/indexed/to_indexed.h"
#include "ryosen/io/formats.h"
#include "ryosen/mesh/circulate.h"
#include "ryosen/mesh/invariants.h"
#include "ryosen/ops/all.h"
#include "ryosen/textbook/forms/polygons.h"
#include "tests/support/core/long_run.h"
#include "tests/support/core/random_meshes.h"
#include "tests/support/core/shapes.h"

namespace ryosen::forms {
namespace {

using test::make_mesh;

// What a form must give back: the mesh without gaps, as a saved file holds it. A list of polygons says nothing of wires
// and of several fans at one vertex; such meshes come without gaps here.
Mesh as_saved(const Mesh& mesh) {
  const bool is_list = !why_unsuitable(mesh, *find_form("indexed_face_set"));
  return is_list ? from_indexed(to_indexed(mesh).mesh) : mesh;
}

// Corner lists over the coordinates, so that meshes whose vertices are numbered otherwise compare.
std::vector<std::vector<std::array<double, 3>>> places_of(const Mesh& mesh) {
  std::vector<std::vector<std::array<double, 3>>> faces;
  for (std::uint32_t i = 0; i < mesh.face_slots(); ++i) {
    if (!mesh.is_alive(Face(i))) continue;
    faces.emplace_back();
    for (const Vertex v : vertices_around(mesh, Face(i)))
      faces.back().push_back({mesh.position(v).x, mesh.position(v).y, mesh.position(v).z});
  }
  return faces;
}

struct Tally {
  std::map<std::string_view, int> converted, refused;
  std::map<std::pair<std::string_view, Relation>, int> answered;
};

void expect_same_after_conversion(const Mesh& mesh, const FormRow& row, const Form& form, const std::string& name) {
  const Mesh back = form.to_mesh();
  const auto broken = check_invariants(back);
  ASSERT_TRUE(!broken || check_invariants(mesh)) << row.id << " on " << name << ": " << broken->sentence;
  const Mesh saved = as_saved(mesh);
  EXPECT_EQ(back.live(), saved.live()) << row.id << " on " << name;
  if (row.stores_vertices)
    EXPECT_EQ(back.hash(), saved.hash()) << row.id << " on " << name;
  else
    EXPECT_EQ(places_of(back), places_of(saved)) << row.id << " on " << name;
}

// Answers come in any order but for those about the corners and sides of a face.
Answer comparable(Relation relation, Answer answer) {
  if (relation == Relation::face_vertices || relation == Relation::face_edges) return answer;
  std::sort(answer.numbers.begin(), answer.numbers.end());
  std::sort(answer.edges.begin(), answer.edges.end());
  return answer;
}

class Suitable {
 public:
  Suitable(const Mesh& mesh, Tally& tally) : tally_(tally) {
    for (const FormRow& row : all_forms()) {
      const std::optional<Text> reason = why_unsuitable(mesh, row);
      ++(reason ? tally.refused : tally.converted)[row.id];
      if (!reason) forms_.push_back({&row, row.make(mesh)});
      if (reason) {
        EXPECT_FALSE(reason->en.empty() || reason->ja.empty()) << row.id;
      }
    }
  }
  void expect_identity(const Mesh& mesh, const std::string& name) const {
    for (const auto& [row, form] : forms_) expect_same_after_conversion(mesh, *row, *form, name);
  }
  // Asks every form and holds the answers to the first one that can tell. Edges go by each form's own handle.
  void expect_agreement(Relation relation, std::uint32_t element, EdgeEnds ends, const std::string& name) {
    std::optional<Answer> expected;
    for (const auto& [row, form] : forms_) {
      Answer answer;
      const bool is_edge = relations()[static_cast<std::size_t>(relation)].asks == ElementOf::edge;
      const std::uint32_t asked = is_edge ? form->find_edge(ends.a, ends.b) : element;
      if (is_edge && asked == no_index) {
        EXPECT_FALSE(row->stores_vertices) << row->id << " on " << name << " edge " << ends.a << "-" << ends.b;
        continue;
      }
      if (!form->answer(relation, asked, answer)) continue;
      ++tally_.answered[{row->id, relation}];
      answer = comparable(relation, std::move(answer));
      if (!expected) {
        expected = answer;
        continue;
      }
      const std::string where = std::string(row->id) + ", " +
                                std::string(relations()[static_cast<std::size_t>(relation)].id) + " of " +
                                std::to_string(element) + " on " + name;
      EXPECT_EQ(answer.numbers, expected->numbers) << where;
      EXPECT_EQ(answer.edges, expected->edges) << where;
    }
  }
  const Form& find(std::string_view id) const {
    for (const auto& [row, form] : forms_)
      if (row->id == id) return *form;
    throw std::out_of_range(std::string(id));
  }

 private:
  std::vector<std::pair<const FormRow*, std::unique_ptr<Form>>> forms_;
  Tally& tally_;
};

// At most `most` elements of each kind, spread evenly.
void expect_all_agree(const Mesh& mesh, const std::string& name, Tally& tally, std::uint32_t most = 50) {
  Suitable forms(mesh, tally);
  forms.expect_identity(mesh, name);
  const Mesh saved = as_saved(mesh);
  const std::uint32_t points = Numbering(saved).points, faces = saved.live().faces;
  for (const RelationRow& row : relations()) {
    if (row.asks == ElementOf::edge) continue;
    const std::uint32_t count = row.asks == ElementOf::vertex ? points : faces, step = std::max(1u, count / most);
    for (std::uint32_t i = 0; i < count; i += step) forms.expect_agreement(row.relation, i, {}, name);
  }
  const Form& ryosen = forms.find("ryosen");
  Answer sides;
  for (std::uint32_t f = 0; f < faces; f += std::max(1u, faces / most)) {
    ASSERT_TRUE(ryosen.answer(Relation::face_edges, f, sides));
    for (const EdgeEnds ends : std::vector(sides.edges))
      for (const RelationRow& row : relations())
        if (row.asks == ElementOf::edge) forms.expect_agreement(row.relation, 0, ends, name);
  }
}

void expect_nothing_idle(const Tally& tally) {
  for (const FormRow& row : all_forms()) {
    EXPECT_GT(tally.converted.count(row.id), 0u) << row.id << " was never made";
    if (row.needs & (triangles | one_vertex_per_point)) {
      EXPECT_GT(tally.refused.count(row.id), 0u) << row.id << " never refused a mesh";
    }
  }
}

TEST(forms, shapes_come_back_and_all_agree) {
  Tally tally;
  const std::vector<std::pair<const char*, Mesh>> shapes = {
      {"tetrahedron", make_mesh(test::tetrahedron())},
      {"cube", make_mesh(test::cube())},
      {"torus", make_mesh(test::torus_grid(5, 6))},
      {"two quads", make_mesh(test::two_quads())},
      {"closed fan", make_mesh(test::closed_fan(7))},
      {"open fan", make_mesh({{0, 1, 2}, {0, 2, 3}, {0, 3, 4}})},
      {"two faces on a vertex of two edges", make_mesh({{0, 1, 2, 3}, {2, 1, 0, 4}})},
      {"bow tie", make_mesh(test::bow_tie())},
      {"fin", make_mesh(test::fin())},
      {"moebius strip", make_mesh(test::moebius_strip())},
      {"two tetrahedra", make_mesh(test::two_tetrahedra_on_an_edge())},
      {"isolated vertices", make_mesh(test::tetrahedron(), 6)},
      {"nothing", make_mesh({})},
  };
  for (const auto& [name, mesh] : shapes) expect_all_agree(mesh, name, tally);
  expect_nothing_idle(tally);
}

TEST(forms, random_meshes_come_back_and_all_agree) {
  Tally tally;
  for (std::uint64_t seed = 0; seed < test::seed_count(50, 300); ++seed) {
    const test::SeededMesh random = test::seeded_mesh(seed);
    expect_all_agree(make_mesh(random.faces, random.points), "seed " + std::to_string(seed), tally);
  }
  for (std::uint64_t seed = 0; seed < test::seed_count(10, 60); ++seed) {
    const RandomMesh random = random_manifold(seed, 30);
    test::Polygons faces;
    for (const auto& face : random.faces) faces.emplace_back(face.begin(), face.end());
    expect_all_agree(make_mesh(faces, static_cast<std::size_t>(random.points)), "manifold " + std::to_string(seed),
                     tally);
  }
  expect_nothing_idle(tally);
  // What a form can tell is a property of the form: it answers a relation on all meshes or on none.
  for (const FormRow& row : all_forms()) {
    for (const RelationRow& relation : relations()) {
      EXPECT_EQ(tally.answered.count({row.id, relation.relation}) > 0, row.stores_vertices)
          << row.id << ", " << relation.id;
    }
  }
}

TEST(forms, edited_meshes_come_back_without_gaps) {
  Tally tally;
  for (std::uint64_t seed = 0; seed < 12; ++seed) {
    Mesh mesh = make_mesh(test::torus_grid(5, 6));
    Dice dice(seed);
    Journal journal;
    const auto try_op = [&](const auto& op) {
      if (!mesh.is_alive(op.halfedge) || !op.check(mesh).legal()) return;
      Edit edit(mesh, &journal);
      op.apply(edit);
      edit.commit();
    };
    for (int i = 0; i < 40; ++i) {
      const Halfedge h(dice.below(static_cast<int>(mesh.halfedge_slots())));
      if (dice.one_in(3))
        try_op(SplitEdge{h});
      else
        try_op(CollapseEdge{h});
    }
    ASSERT_LT(mesh.live().faces, mesh.face_slots());
    expect_all_agree(mesh, "edited " + std::to_string(seed), tally);
  }
  EXPECT_EQ(tally.refused.size(), 0u);
}

// Larger meshes, open and closed, of the folder beside the project.
TEST(forms, shared_meshes_come_back_and_all_agree) {
  namespace fs = std::filesystem;
  const fs::path folder = fs::path(RYOSEN_SHARED_DIR) / "meshes";
  if (!fs::exists(folder)) return;
  Tally tally;
  std::size_t read = 0;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    if (!entry.is_regular_file() || entry.file_size() > (test::is_long_run() ? 400'000u : 40'000u)) continue;
    Result<MeshFile> file = read_mesh_file(entry.path());
    if (!file || file->mesh.face_count() > 4000) continue;
    IndexedMesh plain;
    plain.positions = std::move(file->mesh.positions);
    plain.corners = std::move(file->mesh.corners);
    plain.face_offsets = std::move(file->mesh.face_offsets);
    plain.quarantine = std::move(file->mesh.quarantine);
    ++read;
    expect_all_agree(from_indexed(std::move(plain)), entry.path().filename().string(), tally, 12);
  }
  EXPECT_GT(read, 20u);
  expect_nothing_idle(tally);
}

// A square with a triangular hole that another face fills.
Mesh square_with_ring() {
  MeshColumns c = make_mesh({{0, 1, 2, 3}, {4, 5, 6}}).columns();
  Halfedge start;
  for (std::uint32_t h = 0; h < c.halfedges.size(); ++h) {
    if (c.halfedges[h].face || c.halfedges[h].from.index < 4) continue;
    c.halfedges[h].face = Face(0);
    start = Halfedge(h);
  }
  c.first_ring = {0, no_index};
  c.rings = {{start, no_index}};
  c.live.rings = 1;
  return Mesh(std::move(c));
}

// The same with the ring joined to the outer loop by a bridge from 0 to 4.
Mesh square_with_bridge() {
  MeshColumns c = square_with_ring().columns();
  const Halfedge out = c.face_halfedge[0], in = c.halfedges[out.index].prev;
  Halfedge ring_out = c.rings[0].halfedge;
  while (c.halfedges[ring_out.index].from != Vertex(4)) ring_out = c.halfedges[ring_out.index].next;
  const Halfedge ring_in = c.halfedges[ring_out.index].prev;
  const Halfedge bridge(c.halfedges.size()), back = twin(bridge);
  c.halfedges.push_back({c.halfedges[out.index].from, ring_out, in, Face(0)});
  c.halfedges.push_back({Vertex(4), out, ring_in, Face(0)});
  c.halfedges[in.index].next = bridge;
  c.halfedges[ring_out.index].prev = bridge;
  c.halfedges[ring_in.index].next = back;
  c.halfedges[out.index].prev = back;
  c.first_ring.clear();
  c.rings.clear();
  c.live.rings = 0;
  ++c.live.edges;
  return Mesh(std::move(c));
}

// A triangle, an edge beside it without a face, and one from its vertex 2 to vertex 5.
Mesh triangle_with_wires() {
  MeshColumns c = make_mesh({{0, 1, 2}}, 6).columns();
  const Halfedge leaves_2 = c.vertex_halfedge[2], enters_2 = c.halfedges[leaves_2.index].prev;
  c.halfedges.push_back({Vertex(3), Halfedge(7), Halfedge(7), Face()});
  c.halfedges.push_back({Vertex(4), Halfedge(6), Halfedge(6), Face()});
  c.halfedges.push_back({Vertex(2), Halfedge(9), enters_2, Face()});
  c.halfedges.push_back({Vertex(5), leaves_2, Halfedge(8), Face()});
  c.halfedges[enters_2.index].next = Halfedge(8);
  c.halfedges[leaves_2.index].prev = Halfedge(9);
  c.vertex_halfedge[3] = Halfedge(6);
  c.vertex_halfedge[4] = Halfedge(7);
  c.vertex_halfedge[5] = Halfedge(9);
  c.live.edges += 2;
  return Mesh(std::move(c));
}

// Two triangles that share vertex 0 as one vertex, not as two copies.
Mesh two_fans_at_a_vertex() {
  MeshColumns c = make_mesh({{0, 1, 2}, {3, 4, 5}}).columns();
  const Halfedge out_a = c.vertex_halfedge[0], in_a = c.halfedges[out_a.index].prev;
  const Halfedge out_b = c.vertex_halfedge[5], in_b = c.halfedges[out_b.index].prev;
  const auto link = [&](Halfedge h, Halfedge next) {
    c.halfedges[h.index].next = next;
    c.halfedges[next.index].prev = h;
  };
  link(in_a, out_b);
  link(in_b, out_a);
  for (HalfedgeLinks& links : c.halfedges)
    if (links.from == Vertex(5)) links.from = Vertex(0);
  c.vertex_halfedge[5] = dead_halfedge;
  --c.live.vertices;
  return Mesh(std::move(c));
}

std::set<std::string_view> suitable_ids(const Mesh& mesh) {
  std::set<std::string_view> ids;
  for (const FormRow& row : all_forms())
    if (!why_unsuitable(mesh, row)) ids.insert(row.id);
  return ids;
}

TEST(forms, rings_wires_and_several_fans) {
  Tally tally;
  const std::vector<std::pair<const char*, Mesh>> meshes = {{"ring", square_with_ring()},
                                                            {"wires", triangle_with_wires()},
                                                            {"two fans", two_fans_at_a_vertex()},
                                                            {"bridge", square_with_bridge()}};
  for (const auto& [name, mesh] : meshes) {
    const auto broken = check_invariants(mesh);
    // A bridge is passed by an operator on its way between two forms of a face; its ends are visited twice.
    if (name != std::string_view("bridge")) {
      ASSERT_FALSE(broken) << name << ": " << broken->sentence;
    }
    expect_all_agree(mesh, name, tally);
  }
  using Ids = std::set<std::string_view>;
  EXPECT_EQ(suitable_ids(meshes[0].second), (Ids{"dcel", "ryosen"}));
  const Ids with_outside{"dcel", "halfedge_loop", "halfedge_outside", "halfedge_outside_edges", "ryosen"};
  EXPECT_EQ(suitable_ids(meshes[1].second), with_outside);
  EXPECT_EQ(suitable_ids(meshes[2].second), with_outside);
  Ids with_bridge = with_outside;
  with_bridge.insert({"halfedge", "halfedge_edges"});
  EXPECT_EQ(suitable_ids(meshes[3].second), with_bridge);

  Answer answer;
  const std::unique_ptr<Form> dcel = find_form("dcel")->make(meshes[0].second);
  ASSERT_TRUE(dcel->answer(Relation::face_vertices, 0, answer));
  EXPECT_EQ(answer.numbers.size(), 7u) << "the inner component belongs to the face";
  ASSERT_TRUE(dcel->answer(Relation::face_faces, 0, answer));
  EXPECT_EQ(answer.numbers, std::vector<std::uint32_t>{1});
  ASSERT_TRUE(find_form("halfedge_outside")->make(meshes[1].second)->answer(Relation::valence, 2, answer));
  EXPECT_EQ(answer.numbers, std::vector<std::uint32_t>{3});
}

TEST(forms, bunny_comes_back) {
  Result<MeshFile> file = read_mesh_file(RYOSEN_SOURCE_DIR "/assets/stanford_bunny.obj");
  ASSERT_TRUE(file);
  Tally tally;
  expect_all_agree(from_indexed(std::move(file->mesh)), "bunny", tally, 5);
  EXPECT_EQ(tally.converted.size(), all_forms().size());
}

TEST(forms, refusal_names_the_element) {
  const auto reason = [](std::string_view id, const Mesh& mesh) {
    const std::optional<Text> text = why_unsuitable(mesh, *find_form(id));
    return text ? text->en : std::string();
  };
  EXPECT_EQ(reason("opposite_map", make_mesh({{0, 1, 2}, {2, 1, 3, 4}})),
            "It holds triangles alone; f1 has 4 corners.");
  EXPECT_EQ(reason("halfedge", make_mesh(test::bow_tie())),
            "It holds one sheet of faces at each point; at v0 there are several.");
  EXPECT_EQ(reason("triangle_soup", make_mesh(test::tetrahedron(), 5)),
            "It holds vertices of faces alone; v4 has none.");
  IndexedMesh twice = test::indexed(test::tetrahedron());
  twice.positions[3] = twice.positions[1];
  EXPECT_EQ(reason("triangle_soup", from_indexed(twice)),
            "It tells points apart by their coordinates; v1 and v3 have the same.");
  twice.positions[3].y = std::numeric_limits<double>::infinity();
  EXPECT_EQ(reason("triangle_soup", from_indexed(twice)),
            "It tells points apart by their coordinates; those of v3 are not finite.");
  EXPECT_EQ(reason("halfedge", make_mesh(test::cube())), "");
}

TEST(forms, bytes_are_those_of_the_records) {
  const Mesh mesh = make_mesh(test::torus_grid(20, 20));  // 400 vertices, 1200 edges, 800 faces
  const auto bytes = [&](std::string_view id) { return find_form(id)->make(mesh)->bytes(); };
  EXPECT_EQ(bytes("triangle_soup"), 800u * 72);
  EXPECT_EQ(bytes("indexed_face_set"), 400u * 24 + 2400 * 4 + 801 * 4);
  EXPECT_EQ(bytes("face_adjacency"), 400u * 28 + 2400 * 8 + 801 * 4);
  EXPECT_EQ(bytes("winged_edge"), 400u * 28 + 1200 * 32 + 800 * 4);
  EXPECT_EQ(bytes("halfedge"), 400u * 28 + 2400 * 20 + 800 * 4);
  EXPECT_EQ(bytes("halfedge_edges"), 400u * 28 + 2400 * 24 + 1200 * 16 + 800 * 4);
  EXPECT_EQ(bytes("opposite_array"), 400u * 28 + 2400 * 8);
  EXPECT_EQ(bytes("ryosen"), 400u * 28 + 2400 * 16 + 800 * 4);
  EXPECT_GT(bytes("opposite_map"), 400u * 24 + 800 * 12 + 2400 * (12 + 3 * sizeof(void*)));
  const Mesh open = make_mesh({{0, 1, 2}});
  EXPECT_EQ(find_form("halfedge_outside")->make(open)->bytes() - find_form("halfedge")->make(open)->bytes(), 3u * 20);
}

TEST(forms, table_is_complete) {
  std::set<std::string_view> ids;
  for (const FormRow& row : all_forms()) {
    EXPECT_TRUE(ids.insert(row.id).second) << row.id;
    EXPECT_FALSE(row.en.empty() || row.ja.empty() || row.source_en.empty() || row.source_ja.empty()) << row.id;
    EXPECT_EQ(find_form(row.id), &row);
  }
  EXPECT_EQ(find_form("wireframe"), nullptr);
  for (std::size_t i = 0; i < relations().size(); ++i) EXPECT_EQ(static_cast<std::size_t>(relations()[i].relation), i);
}

}  // namespace
}  // namespace ryosen::forms
