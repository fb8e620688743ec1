#include "ryosen/algo/subdivide/subdivide.h"

#include <algorithm>
#include <cmath>
#include <new>

#include "ryosen/algo/features.h"
#include "ryosen/algo/preparation.h"
#include "ryosen/algo/subdivide/carry.h"
#include "ryosen/algo/subdivide/limit_normals.h"
#include "ryosen/algo/subdivide/masks.h"
#include "ryosen/algo/subdivide/prepare.h"
#include "ryosen/algo/subdivide/step_sources.h"
#include "ryosen/base/resource_limits.h"
#include "ryosen/geometry/is_finite.h"
#include "ryosen/mesh/copies.h"
#include "ryosen/mesh/live_elements.h"

namespace ryosen::subdivide {

namespace {

// How large a level is; doubles, since it is asked of levels that cannot be.
struct LevelSize {
  double vertices, edges, corners;

  LevelSize refined(Scheme scheme) const {
    const double faces = corners / 3;  // at least, of triangles
    if (scheme == Scheme::sqrt3) return {vertices + faces, edges + corners, 3 * corners};
    return {vertices + edges, 2 * edges + corners, 4 * corners};
  }
  double bytes() const { return 28 * vertices + 32 * edges + 1.4 * corners; }
};

constexpr double most_halfedges = 4294967000.0;  // handles have 32 bits

Text too_large(std::size_t steps, std::size_t possible) {
  const std::string all = std::to_string(steps), most = std::to_string(possible);
  return {all + " steps would make more elements than a mesh can number; " +
              (possible == 0 ? std::string("none is possible here") : "at most " + most + " are possible here"),
          all + " 回では要素の数がメッシュの上限を超えます。" +
              (possible == 0 ? std::string("このメッシュでは一回もできません")
                             : "このメッシュでは " + most + " 回までです")};
}

// Throws where the last level and the one before it do not fit.
std::optional<Text> fault_of_size(const Mesh& mesh, const Options& options) {
  LevelSize size{double(mesh.vertex_slots()), double(mesh.edge_slots()), 2.0 * mesh.edge_slots()}, before = size;
  for (std::size_t step = 0; step < options.steps; ++step) {
    before = size;
    size = size.refined(options.scheme);
    if (2 * size.edges > most_halfedges) return too_large(options.steps, step);
  }
  if (!may_fit_in_memory(size.bytes() + 2 * before.bytes())) throw std::bad_alloc();
  return std::nullopt;
}

bool has_outside(const Mesh& mesh) {
  for (const Halfedge h : live_halfedges(mesh))
    if (mesh.is_outside(h)) return true;
  return false;
}

std::optional<Text> fault_of_limit(const Mesh& mesh, const Creases& creases, const Options& options) {
  if (!options.to_limit || options.scheme == Scheme::midpoint) return std::nullopt;
  // Beside boundaries and wires.
  const bool is_sharp = std::any_of(creases.sharpness.begin(), creases.sharpness.end(), [](float s) { return s > 0; });
  if (is_sharp && options.sharp_steps && *options.sharp_steps > static_cast<double>(options.steps))
    return Text{
        "the limit is known once no edge is sharp for a number of steps any more; take as many steps, or let the "
        "edges stay sharp",
        "極限位置は、段数を限った折り目がなくなってから求まります。段数をそれ以上にするか、常に鋭くしてください"};
  if (options.scheme == Scheme::sqrt3 && options.steps % 2 != 0 && (is_sharp || has_outside(mesh)))
    return Text{"at boundaries and creases the sqrt(3) scheme has a limit after an even number of steps; take one more",
                "sqrt(3) の境界や折り目での極限位置は偶数回で求まります。もう一回増やしてください"};
  return std::nullopt;
}

// Old copies stay what they are; new vertices on the sheets of one edge become copies. `on_sheet(h, i)` is the i-th of
// `count` new vertices on a halfedge, in its direction.
template <class OnSheet>
void link_copies(const Mesh& mesh, unsigned count, const OnSheet& on_sheet, MeshColumns& out) {
  if (!mesh.has_copies()) return;
  out.next_copy = mesh.columns().next_copy;
  out.copy_point = mesh.columns().copy_point;
  for (std::size_t i = out.next_copy.size(); i < out.vertex_halfedge.size(); ++i) {
    out.next_copy.emplace_back(i);
    out.copy_point.emplace_back(i);
  }
  sheet_groups(mesh).for_each([&](std::span<const Edge> sheets) {
    for (unsigned i = 0; i < count; ++i) {
      std::vector<Vertex> copies;
      for (const Edge e : sheets) {
        Halfedge h = halfedge(e);
        if (point(mesh, mesh.from(h)) > point(mesh, mesh.to(h))) h = twin(h);
        copies.push_back(on_sheet(h, i));
      }
      std::sort(copies.begin(), copies.end());
      for (std::size_t k = 0; k < copies.size(); ++k) {
        out.next_copy[copies[k].index] = copies[(k + 1) % copies.size()];
        out.copy_point[copies[k].index] = copies[0];
      }
    }
  });
}

// Passes on what is known of elements to the next level, and tells the descent where those come from.
template <class Numbers>
void pass_on(const Mesh& mesh, const Numbers& numbers, MeshColumns& next, Creases& creases, Descent* descent) {
  if (!creases.sharpness.empty() || descent) {
    const SourceList edges = edge_sources(mesh, numbers);
    std::vector<float> sharpness(creases.sharpness.empty() ? 0 : edges.size(), 0);
    if (!sharpness.empty())
      edges.for_each_origin(
          [&](std::uint32_t e, std::uint32_t before) { sharpness[e] = std::max(0.0f, creases.sharpness[before] - 1); });
    creases.sharpness = std::move(sharpness);
    if (descent) descent->follow(ElementKind::edge, edges);
  }
  if (descent) descent->follow(ElementKind::face, face_sources(mesh, numbers, next, false));
  if (descent && Descent::records(ElementKind::vertex))
    descent->follow(ElementKind::vertex, vertex_sources(mesh, numbers));
  if (descent && Descent::records(ElementKind::corner))
    descent->follow(ElementKind::corner, corner_sources(mesh, numbers, next));
  if (creases.corners.empty()) return;
  creases.corners.resize(next.vertex_halfedge.size(), 0);
  for (std::size_t i = mesh.vertex_slots(); i < next.next_copy.size(); ++i)
    creases.corners[i] = next.next_copy[i] != Vertex(i);
}

MeshColumns split_step(const Mesh& mesh, Creases& creases, Scheme scheme, Split split, Descent* descent) {
  MeshColumns next;
  const SplitNumbers numbers(mesh, split);
  link_split(mesh, numbers, next);
  next.positions = split_places(mesh, creases, scheme, numbers);
  carry_split(mesh, creases, scheme, numbers, next);
  link_copies(
      mesh, 1, [&](Halfedge h, unsigned) { return numbers.on_edge(h); }, next);
  pass_on(mesh, numbers, next, creases, descent);
  return next;
}

MeshColumns sqrt3_step(const Mesh& mesh, Creases& creases, bool cuts_creases, Descent* descent) {
  MeshColumns next;
  const Sqrt3Numbers numbers(mesh, creases, cuts_creases);
  link_sqrt3(mesh, numbers, next);
  next.positions.resize(numbers.vertex_slots());
  sqrt3_places(mesh, creases, cuts_creases, next.positions);
  for (std::uint32_t i = 0; i < mesh.face_slots(); ++i) {
    const Face f(i);
    if (!numbers.has_centre(f)) continue;
    glm::dvec3 sum(0);
    for (const Vertex v : vertices_around(mesh, f)) sum += mesh.position(v) / 3.0;
    next.positions[numbers.centre(f).index] = sum;
  }
  for (std::uint32_t e = 0; e < mesh.edge_slots(); ++e) {
    const Halfedge h = halfedge(Edge(e));
    if (!numbers.is_cut(h)) continue;
    for (const Halfedge side : {h, twin(h)})
      next.positions[numbers.third(side, 0).index] = third_of_crease(mesh, creases, mesh.from(side), mesh.to(side));
  }
  carry_sqrt3(mesh, creases, cuts_creases, numbers, next);
  link_copies(
      mesh, cuts_creases ? 2 : 0, [&](Halfedge h, unsigned i) { return numbers.third(h, i); }, next);
  pass_on(mesh, numbers, next, creases, descent);
  return next;
}

// Where sums of coordinates may overflow, which they do nowhere else.
bool is_huge(std::span<const glm::dvec3> places) {
  const auto is_so = [](const glm::dvec3& p) {
    return std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)}) > 1e300;
  };
  return std::any_of(places.begin(), places.end(), is_so);
}

bool all_finite(std::span<const glm::dvec3> places) {
  return std::all_of(places.begin(), places.end(), [](const glm::dvec3& p) { return is_finite(p); });
}

}  // namespace

Subdivided subdivided(const Mesh& mesh, const Options& options, Progress& progress, Descent* descent) {
  if (descent && !descent->is_recording()) descent = nullptr;
  Subdivided result;
  const auto is_cancelled = [&](std::size_t done) {
    return result.is_cancelled = !progress.go_on(done, options.steps + 1);
  };
  if ((result.fault = fault_of_size(mesh, options)) || is_cancelled(0)) return result;
  Prepared prepared = prepare(mesh, options, descent);
  result.cut_faces = prepared.cut_faces;
  result.seams = prepared.seams;
  if ((result.fault = std::move(prepared.fault))) return result;
  Creases& creases = prepared.creases;
  const Mesh* at = prepared.changed ? &*prepared.changed : &mesh;
  if ((result.fault = fault_of_limit(*at, creases, options))) return result;
  const bool into_quads =
      options.scheme == Scheme::catmull_clark || (options.scheme == Scheme::midpoint && !polygons_of_mesh(*at).empty());
  Mesh level;
  for (std::size_t step = 0; step < options.steps; ++step) {
    if (is_cancelled(step)) return result;
    std::optional<Mesh> opened;
    if (options.scheme == Scheme::sqrt3)
      mark_shut_sheets(*at, creases);
    else if ((opened = with_open_sheets(*at, creases, descent)))
      at = &*opened;
    MeshColumns next =
        options.scheme == Scheme::sqrt3
            ? sqrt3_step(*at, creases, step % 2 != 0, descent)
            : split_step(*at, creases, options.scheme, into_quads ? Split::into_quads : Split::into_four, descent);
    if (step + 1 == options.steps && !options.to_limit) {
      result.columns = std::move(next);
      break;
    }
    level = Mesh(std::move(next));
    at = &level;
  }
  if (is_cancelled(options.steps)) return result;
  if (options.to_limit) {
    result.columns = level.columns();
    if (options.scheme != Scheme::midpoint) {
      carry_to_limit(level, creases, options.scheme, result.columns);
      result.columns.positions = limit_places(level, creases, options.scheme);
      put_normals(result.columns, limit_normals(level, creases, options.scheme));
    }
  }
  if (is_huge(mesh.positions()) && all_finite(mesh.positions()) && !all_finite(result.columns.positions))
    result.fault = Text{"coordinates would become infinite; scale the mesh down",
                        "座標が無限大になります。メッシュを縮小してください"};
  return result;
}

}  // namespace ryosen::subdivide
