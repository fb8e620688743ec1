// Test builds find each element of which an edit says neither where its values come from nor where they go.
#include <gtest/gtest.h>

#include <functional>

#include "ryosen/mesh/circulate.h"
#include "ryosen/mesh/edit.h"
#include "tests/support/core/shapes.h"

namespace ryosen::test {
namespace {

#ifdef RYOSEN_PROVENANCE

// Whether an edit would be committed; it is rolled back.
std::optional<std::string> said(const std::function<void(Edit&)>& change) {
  Mesh mesh = make_mesh(two_quads());
  Edit edit(mesh, nullptr);
  change(edit);
  return edit.untold();
}

TEST(provenance, of_new_elements_is_asked) {
  EXPECT_EQ(said([](Edit& edit) { edit.add_vertex({}); }), "v6 was created without saying what its values come from");
  EXPECT_EQ(said([](Edit& edit) { edit.fresh(edit.add_vertex({})); }), std::nullopt);
  EXPECT_EQ(said([](Edit& edit) { edit.derive(edit.add_vertex({}), Vertex(0), Derivation::copies); }), std::nullopt);
  EXPECT_EQ(said([](Edit& edit) { edit.add_edge(Vertex(0), Vertex(5)); }),
            "e7 was created without saying what its values come from");
  EXPECT_EQ(said([](Edit& edit) { edit.fresh(edge(edit.add_edge(Vertex(0), Vertex(5)))); }), std::nullopt);
  EXPECT_EQ(said([](Edit& edit) { edit.add_face(Halfedge(0)); }),
            "f2 was created without saying what its values come from");
  EXPECT_EQ(said([](Edit& edit) {
              const Face made = edit.add_face(Halfedge(0)), parts[] = {Face(0), made};
              edit.divide<Face>(Face(0), parts, [] { return std::vector<double>{1, 1}; });
            }),
            std::nullopt);
}

TEST(provenance, of_removed_elements_is_asked) {
  EXPECT_EQ(said([](Edit& edit) { edit.remove(Vertex(1)); }), "v1 was removed without saying what it is united with");
  EXPECT_EQ(said([](Edit& edit) { edit.drop(Vertex(1)); }), std::nullopt);
  EXPECT_EQ(said([](Edit& edit) {
              edit.derive(Face(0), Face(0), Face(1), 0.5, Derivation::unites);
              edit.remove(Face(1));
            }),
            std::nullopt);
  EXPECT_EQ(said([](Edit& edit) {
              edit.derive(Face(0), Face(0), Face(1), 0.5, Derivation::copies);
              edit.remove(Face(1));
            }),
            "f1 was removed without saying what it is united with");
  EXPECT_EQ(said([](Edit& edit) {
              const Edge both[] = {Edge(0), Edge(1)};
              edit.unite<Edge>(both[0], both, [] { return std::vector<double>{1, 1}; });
              edit.remove(both[1]);
            }),
            std::nullopt);
  EXPECT_EQ(said([](Edit& edit) {
              const Vertex made = edit.add_vertex({});
              edit.remove(made);
            }),
            std::nullopt)
      << "what comes and goes within an edit";
}

// A halfedge is a corner while it has a face.
TEST(provenance, of_corners_is_asked) {
  const Mesh mesh = make_mesh(two_quads());
  Halfedge outside(0);
  while (!mesh.is_outside(outside)) ++outside.index;
  const Halfedge inside = twin(outside);
  const std::string of_outside = "corner h" + std::to_string(outside.index),
                    of_inside = "corner h" + std::to_string(inside.index);
  EXPECT_EQ(said([&](Edit& edit) { edit.set_face(outside, Face(0)); }),
            of_outside + " was created without saying what its values come from");
  EXPECT_EQ(said([&](Edit& edit) { edit.set_face(inside, Face()); }),
            of_inside + " was removed without saying what it is united with");
  EXPECT_EQ(said([&](Edit& edit) { edit.set_face(inside, Face(1)); }), std::nullopt) << "it stays a corner";
  EXPECT_EQ(said([&](Edit& edit) {
              edit.derive(outside, inside, Derivation::copies);
              edit.fresh(inside);
              edit.set_face(outside, mesh.face(inside));
              edit.set_face(inside, Face());
            }),
            std::nullopt);
}

#endif

}  // namespace
}  // namespace ryosen::test
