#include "tests/support/core/proof.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <map>

#include "ryosen/analysis/figures.h"
#include "ryosen/indexed/to_indexed.h"
#include "ryosen/mesh/circulate.h"
#include "ryosen/mesh/copies.h"
#include "ryosen/mesh/invariants.h"
#include "ryosen/mesh/rings.h"
#include "ryosen/ops/rules/sheets.h"
#include "tests/support/core/kernel_sum.h"
#include "tests/support/core/shapes.h"

namespace ryosen::test {

namespace {

using Corner = std::pair<std::uint32_t, std::uint32_t>;  // face, place in it

std::vector<std::vector<Halfedge>> corners_of(const Mesh& mesh) {
  std::vector<std::vector<Halfedge>> corners(mesh.face_slots());
  for (std::uint32_t f = 0; f < mesh.face_slots(); ++f)
    if (mesh.is_alive(Face(f)))
      for (Halfedge h : halfedges_around(mesh, Face(f))) corners[f].push_back(h);
  return corners;
}

// Which corners share a vertex with the first such, and which side lies across each.
struct Structure {
  std::map<Corner, Corner> first_at_vertex, across;
};

Structure structure_of(const Mesh& mesh) {
  Structure structure;
  std::map<Halfedge, Corner> place;
  std::map<Vertex, Corner> first;
  const auto corners = corners_of(mesh);
  for (std::uint32_t f = 0; f < corners.size(); ++f)
    for (std::uint32_t i = 0; i < corners[f].size(); ++i) {
      place[corners[f][i]] = {f, i};
      structure.first_at_vertex[{f, i}] = first.try_emplace(mesh.from(corners[f][i]), f, i).first->second;
    }
  for (const auto& [h, corner] : place)
    if (const auto other = place.find(twin(h)); other != place.end()) structure.across[corner] = other->second;
  return structure;
}

std::string text_of_corner(const Corner& c) {
  return "corner " + std::to_string(c.second) + " of f" + std::to_string(c.first);
}

Mesh read_again(const Mesh& mesh) {
  IndexedMesh list;
  list.positions.assign(mesh.positions().begin(), mesh.positions().end());
  for (const std::vector<Halfedge>& face : corners_of(mesh)) {
    for (Halfedge h : face) list.corners.push_back(point(mesh, mesh.from(h)).index);
    list.face_offsets.push_back(static_cast<std::uint32_t>(list.corners.size()));
  }
  return from_indexed(std::move(list));
}

// Corner lists with places, per live face: what `changed` must account for.
using CornerPlaces = std::map<std::uint32_t, std::vector<std::pair<std::uint32_t, glm::dvec3>>>;
CornerPlaces corners_with_places(const Mesh& mesh) {
  CornerPlaces result;
  const auto corners = corners_of(mesh);
  for (std::uint32_t f = 0; f < corners.size(); ++f)
    for (Halfedge h : corners[f]) result[f].emplace_back(mesh.from(h).index, mesh.position(mesh.from(h)));
  return result;
}

void expect_effect(const Mesh& mesh, const MeshColumns& columns_before, const CornerPlaces& before,
                   const OpEffect& effect) {
  const Mesh old(columns_before);
  const CornerPlaces after = corners_with_places(mesh);
  for (const auto& [f, corners] : after) {
    const auto was = before.find(f);
    if (was != before.end() && was->second == corners) continue;
    EXPECT_TRUE(std::count(effect.changed.begin(), effect.changed.end(), Face(f)))
        << "f" << f << " is not told changed";
  }
  for (Face f : effect.changed) EXPECT_TRUE(mesh.is_alive(f)) << "f" << f.index << " is told changed but dead";
  const auto compare = [&](auto handle, std::uint32_t slots) {
    using Handle = decltype(handle);
    for (std::uint32_t i = 0; i < slots; ++i) {
      const Handle e(i);
      const bool was = old.exists(e) && old.is_alive(e), is = mesh.exists(e) && mesh.is_alive(e);
      EXPECT_EQ(std::count(effect.created.begin(), effect.created.end(), Element(e)), !was && is) << "created " << i;
      EXPECT_EQ(std::count(effect.deleted.begin(), effect.deleted.end(), Element(e)), was && !is) << "deleted " << i;
    }
  };
  compare(Vertex(), mesh.vertex_slots());
  compare(Edge(), mesh.edge_slots());
  compare(Face(), mesh.face_slots());
}

bool has_bridges(const Mesh& mesh) {
  for (std::uint32_t i = 0; i < mesh.halfedge_slots(); ++i)
    if (mesh.is_alive(Halfedge(i)) && is_bridge(mesh, Halfedge(i))) return true;
  return false;
}

}  // namespace

AnyOp op_of(const Mesh& mesh, const std::string& line) {
  const ParsedOp parsed = parse_line(mesh, line);
  EXPECT_TRUE(parsed.op) << line << ": " << parsed.sentence.en;
  return parsed.op.value_or(AnyOp());
}

std::string rules_against(const Mesh& mesh, const std::string& line) {
  std::string ids;
  for (const Reason& reason : check(mesh, op_of(mesh, line)).reasons)
    ids += (ids.empty() ? "" : " ") + std::string(text_of(reason.rule).id);
  return ids;
}

NameError parse_error(const Mesh& mesh, const std::string& line) {
  const ParsedOp parsed = parse_line(mesh, line);
  EXPECT_FALSE(parsed.op) << line;
  EXPECT_FALSE(parsed.sentence.en.empty() || parsed.sentence.ja.empty()) << line;
  return parsed.error;
}

Mesh mesh_of_exercise(const std::string& name) {
  std::ifstream in(RYOSEN_SOURCE_DIR "/assets/exercises/" + name + ".ryosen");
  EXPECT_TRUE(in) << name;
  Mesh mesh;
  for (std::string line; std::getline(in, line);) {
    if (line.empty() || line[0] == '#' || line.starts_with("expect")) continue;
    Edit edit(mesh, nullptr);
    ryosen::apply(edit, op_of(mesh, line));
    edit.commit();
  }
  return mesh;
}

std::ostream& operator<<(std::ostream& out, const Change& c) {
  return out << "V " << c.v << " E " << c.e << " F " << c.f << " H " << c.h << " S " << c.s << " G " << c.g << " B "
             << c.b;
}

std::string differs_from_reading(const Mesh& mesh) {
  if (mesh.has_rings()) return {};
  Mesh separated = mesh;
  Edit edit(separated, nullptr);
  Sheets sheets(edit);
  for (std::uint32_t v = 0; v < mesh.vertex_slots(); ++v)
    if (mesh.is_alive(Vertex(v))) sheets.separate(Vertex(v));
  edit.commit();
  const Mesh read = read_again(mesh);
  const Structure here = structure_of(separated), there = structure_of(read);
  for (const auto& [corner, first] : there.first_at_vertex)
    if (here.first_at_vertex.at(corner) != first)
      return text_of_corner(corner) + " lies in another fan than " + text_of_corner(first);
  for (const auto& [corner, first] : here.first_at_vertex)
    for (const Structure* one : {&here, &there}) {
      const Structure& other = one == &here ? there : here;
      const auto a = one->across.find(corner), b = other.across.find(corner);
      if ((a == one->across.end()) != (b == other.across.end()) || (b != other.across.end() && a->second != b->second))
        return "the side at " + text_of_corner(corner) + " is joined otherwise";
    }
  return {};
}

std::vector<std::vector<std::uint32_t>> point_polygons(const Mesh& mesh) {
  std::vector<std::vector<std::uint32_t>> polygons;
  for (const std::vector<Halfedge>& face : corners_of(mesh)) {
    if (face.empty()) continue;
    std::vector<std::uint32_t> points;
    for (Halfedge h : face) points.push_back(point(mesh, mesh.from(h)).index);
    std::rotate(points.begin(), std::min_element(points.begin(), points.end()), points.end());
    polygons.push_back(points);
  }
  std::sort(polygons.begin(), polygons.end());
  return polygons;
}

void expect_terms(const Mesh& mesh) {
  const EulerPoincare terms = euler_poincare(mesh);
  EXPECT_TRUE(terms.holds() || terms.no_genus != NoGenus::none)
      << terms.left() << " is not " << terms.right() << " on points";
  if (mesh.has_copies() || !terms.genus) return;
  const KernelSum kernel = kernel_sum(mesh);
  EXPECT_EQ(terms.outside(), kernel.boundaries);
  EXPECT_EQ(terms.parts, kernel.components);
  EXPECT_EQ(terms.genus, kernel.genus);
}

Change apply_and_prove(Mesh& mesh, const AnyOp& op) {
  const std::string line = command_of(mesh, op);
  SCOPED_TRACE(line);
  EXPECT_TRUE(check(mesh, op).legal());
  if (!check(mesh, op).legal()) return {};
  EXPECT_EQ(command_of(mesh, op_of(mesh, line)), line);
  Journal journal;
  const MeshColumns before = mesh.columns();
  const bool is_as_read = differs_from_reading(mesh).empty();
  const CornerPlaces corners_before = corners_with_places(mesh);
  const KernelSum was = kernel_sum(mesh);
  {
    Edit preview(mesh, &journal);
    apply(preview, op);
  }
  EXPECT_EQ(mesh.columns(), before) << "a preview leaves a trace";
  {
    Edit edit(mesh, &journal);
    const OpEffect effect = apply(edit, op);
    edit.commit();
    expect_effect(mesh, before, corners_before, effect);
  }
  const auto broken = check_invariants(mesh);
  EXPECT_FALSE(broken) << broken->sentence;
  if (broken) return {};
  if (is_as_read) {
    EXPECT_EQ(differs_from_reading(mesh), "");
  }
  const KernelSum is = kernel_sum(mesh);
  EXPECT_EQ(is.left(), is.right());
  expect_terms(mesh);
  EXPECT_GE(is.genus, 0);
  const MeshColumns after = mesh.columns();
  journal.undo(mesh);
  EXPECT_EQ(mesh.columns(), before) << "undo is not exact";
  journal.redo(mesh);
  EXPECT_EQ(mesh.columns(), after) << "redo is not exact";
  if (is_as_read && !mesh.has_rings() && !has_bridges(mesh)) {
    const Mesh read = from_indexed(to_indexed(mesh).mesh);
    EXPECT_EQ(read.live().faces, mesh.live().faces);
    EXPECT_EQ(compute_figures(mesh), compute_figures(read)) << "saved and read again";
  }
  return {is.vertices - was.vertices,     is.edges - was.edges, is.faces - was.faces,          is.rings - was.rings,
          is.components - was.components, is.genus - was.genus, is.boundaries - was.boundaries};
}

Change apply_and_prove(Mesh& mesh, const std::string& line) { return apply_and_prove(mesh, op_of(mesh, line)); }

}  // namespace ryosen::test
