#include "ryosen/ops/rules/raise.h"

#include <algorithm>
#include <cstdint>
#include <string>
#include <unordered_map>
#include <utility>

#include "ryosen/base/sort_unique.h"
#include "ryosen/geometry/is_finite.h"
#include "ryosen/mesh/attribute.h"
#include "ryosen/mesh/circulate.h"
#include "ryosen/mesh/copies.h"
#include "ryosen/mesh/rings.h"
#include "ryosen/ops/rules/corner_values.h"
#include "ryosen/ops/rules/sheets.h"
#include "ryosen/ops/rules/surgery.h"
#include "ryosen/ops/rules/united_values.h"

namespace ryosen {

Region::Region(const Mesh& mesh, std::span<const Face> faces) {
  for (Face f : faces)
    if (set_.insert(f).second) faces_.push_back(f);
  find_border(mesh);
  std::unordered_set<Vertex> met;
  for (Face f : faces_)
    for (Vertex v : vertices_around(mesh, f))
      if (met.insert(point(mesh, v)).second) points_.push_back(point(mesh, v));
  for (Vertex p : points_)
    if (!staying_.contains(p) && is_held(mesh, p)) staying_.insert(p);
}

void Region::find_border(const Mesh& mesh) {
  std::unordered_set<std::uint64_t> met;  // pairs of points
  for (Face f : faces_)
    for (Halfedge h : halfedges_around(mesh, f)) {
      if (is_bridge(mesh, h)) continue;
      const auto [low, high] = std::minmax({point(mesh, mesh.from(h)).index, point(mesh, mesh.to(h)).index});
      if (met.insert(std::uint64_t{low} << 32 | high).second) add_border(mesh, h);
    }
}

void Region::add_border(const Mesh& mesh, Halfedge side) {
  std::size_t ours = 0, others = 0;
  const auto count = [&](Halfedge sheet) {
    for (Halfedge h : {sheet, twin(sheet)})
      if (!mesh.is_outside(h)) ++(contains(mesh.face(h)) ? ours : others);
  };
  const Vertex a = mesh.from(side), b = mesh.to(side);
  if (!has_copies(mesh, a) && !has_copies(mesh, b)) {
    count(side);
  } else {
    for (Halfedge sheet : sheets_between(mesh, a, b)) count(sheet);
  }
  if (others == 0 && ours > 1) return;
  border_.push_back({side, ours > 1});
  staying_.insert({point(mesh, a), point(mesh, b)});
}

bool Region::is_held(const Mesh& mesh, Vertex p) const {
  return any_of_copies(mesh, p, [&](Vertex copy) {
    for (Halfedge h : outgoing(mesh, copy))
      if (mesh.is_wire(edge(h)) || (!mesh.is_outside(h) && !contains(mesh.face(h)))) return true;
    return false;
  });
}

bool Region::stays_behind(const Mesh& mesh, Vertex v) const { return staying_.contains(point(mesh, v)); }

namespace {

// Neighbouring faces of the region around a vertex that stays behind, counter-clockwise from `first`, an outgoing side,
// to `last`, an incoming one. They get a vertex of their own above.
//
//        last \  faces  / first
//              \   |   /            at an end with a wall the side stays below and the wall takes its place; at one
//               \  |  /             without the side goes up, and the outside behind it
//                 from
struct RaisedSector {
  Vertex from, top;
  Halfedge first, last;  // last is none where the faces close around the vertex
  Halfedge rise;         // from -> top, if there is a wall at one of the ends
  Halfedge left;         // an outgoing halfedge that may be left below
  bool wall_at_first = false, wall_at_last = false;
};

//      from' ---top---> to'
//        |               |
//       rise         rise_after
//        |               |
//      from ---side---> to
struct Wall {
  Halfedge side, after;  // after: the corner of the face at `to`, at a bridge the last one there
  bool is_shared = false;
  Face face;      // of the region
  Halfedge top;   // from' -> to', a side of the face; its twin belongs to the wall
  Halfedge rise;  // from -> from'
  Halfedge rise_after;
};

class Raise {
 public:
  Raise(Edit& edit, const Region& region, const glm::dvec3& by)
      : edit_(edit), m_(edit.mesh()), region_(region), by_(by), sheets_(edit) {}

  OpEffect run() {
    for (const Region::Border& b : region_.border()) {
      wall_at_.emplace(b.side, walls_.size());
      walls_.push_back({b.side, Halfedge(), b.is_shared, m_.face(b.side), {}, {}, {}});
    }
    part_sides();
    find_sectors();
    make_tops();
    set_wall_values();
    link_faces();
    for (RaisedSector& sector : sectors_) link_outside(sector);
    for (const auto& [h, sector] : corners_)
      if (!has_wall(h)) edit_.set_from(h, sectors_[sector].top);
    for (const Wall& wall : walls_) make_wall(wall);
    hold_halfedges();
    move_rest();
    make_manifold();
    return sheets_.finish();
  }

 private:
  bool has_wall(Halfedge h) const { return wall_at_.contains(h); }
  Halfedge raised(Halfedge h) const {
    const auto found = wall_at_.find(h);
    return found == wall_at_.end() ? h : walls_[found->second].top;
  }
  const RaisedSector& sector_at(Halfedge corner) const { return sectors_[sector_at_.at(corner)]; }

  // Parts faces of which one goes up and the other stays, and no wall comes between them: three or more faces have the
  // edge on points, and its sheets were closed again.
  void part_sides() {
    std::vector<Halfedge> sides;
    for (Face f : region_.faces())
      for (Halfedge h : halfedges_around(m_, f)) {
        const Face beside = m_.face(twin(h));
        if (beside && beside != f && has_wall(h) == region_.contains(beside)) sides.push_back(h);
      }
    for (Halfedge h : sides) sheets_.open(h);
  }

  // In the order of the walls, then of the corners of the faces.
  void find_sectors() {
    for (const Wall& wall : walls_) add_sector(wall.side);
    for (Face f : region_.faces())
      for (Halfedge h : halfedges_around(m_, f))
        if (region_.stays_behind(m_, m_.from(h)) && !sector_at_.contains(h)) add_sector(first_from(h));
  }
  // Whether the face across a side does not go along with it.
  bool is_end(Halfedge side) const { return has_wall(side) || !region_.contains(m_.face(twin(side))); }
  Halfedge first_from(Halfedge h) const {
    for (Halfedge at = h;;) {
      if (is_end(at)) return at;
      at = m_.next(twin(at));
      if (at == h) return h;
    }
  }
  void add_sector(Halfedge first) {
    RaisedSector sector;
    sector.from = m_.from(first);
    sector.first = first;
    for (Halfedge h = first;;) {
      corners_.emplace_back(h, sectors_.size());
      sector_at_.emplace(h, sectors_.size());
      const Halfedge into = m_.prev(h);
      h = twin(into);
      if (is_end(into)) {
        sector.last = into;
        break;
      }
      if (h == first) break;
    }
    sector.wall_at_first = has_wall(first);
    sector.wall_at_last = sector.last && has_wall(sector.last);
    const glm::dvec3 base = m_.position(sector.from), moved = base + by_;
    sector.top = edit_.add_vertex(is_finite(moved) ? moved : base);
    edit_.derive(sector.top, sector.from, Derivation::copies);
    if (sector.wall_at_first || sector.wall_at_last) {
      sector.rise = edit_.add_edge(sector.from, sector.top);
      edit_.fresh(edge(sector.rise));
    }
    sectors_.push_back(sector);
  }

  void make_tops() {
    for (Wall& wall : walls_) {
      const RaisedSector &here = sector_at(wall.side), &there = sector_at(m_.next(wall.side));
      wall.top = edit_.add_edge(here.top, there.top);
      edit_.fresh(edge(wall.top));
      wall.rise = here.rise;
      wall.rise_after = there.rise;
      wall.after = m_.next(wall.side);
      while (is_bridge(m_, wall.after)) wall.after = m_.next(twin(wall.after));
    }
  }

  // Values are copied upwards and downwards; normals are not, they belong to the old surface.
  void set_wall_values() {
    for (const Wall& wall : walls_) edit_.derive(wall.top, wall.side, Derivation::copies);
    for (const Wall& wall : walls_) {
      const auto copy = [&](Halfedge corner, Halfedge from) {
        edit_.derive(corner, from, Derivation::copies);
        drop_normal(edit_, corner);
      };
      drop_normal(edit_, wall.side);
      copy(twin(wall.rise), wall.top);
      copy(twin(wall.top), raised(wall.after));
      copy(wall.rise_after, raised(wall.after));
    }
  }

  void link_faces() {
    std::vector<std::pair<Halfedge, Halfedge>> links;
    for (Face f : region_.faces()) {
      sheets_.changed(f);
      for (Halfedge h : halfedges_around(m_, f)) links.emplace_back(h, m_.next(h));
    }
    for (Face f : region_.faces()) {
      edit_.set_halfedge(f, raised(m_.halfedge(f)));
      for (std::uint32_t r = m_.first_ring(f); r != no_index; r = m_.ring(r).next)
        edit_.set_ring_halfedge(r, raised(m_.ring(r).halfedge));
    }
    for (const auto& [h, after] : links) edit_.connect(raised(h), raised(after));
  }

  // Where an end has no wall, the outside is parted into one above and one below.
  void link_outside(RaisedSector& sector) {
    if (sector.last.is_none() || (sector.wall_at_first && sector.wall_at_last)) return;
    const Halfedge into = twin(sector.first), out = twin(sector.last);
    const Halfedge rest = m_.next(into), before = m_.prev(out);
    if (!sector.wall_at_last) edit_.set_from(out, sector.top);
    if (sector.wall_at_first) {
      edit_.connect(before, sector.rise);
      edit_.connect(sector.rise, out);
    } else if (sector.wall_at_last) {
      edit_.connect(into, twin(sector.rise));
      edit_.connect(twin(sector.rise), rest);
    } else if (before != into) {
      edit_.connect(into, out);
      edit_.connect(before, rest);
      sector.left = rest;
    }
  }

  void make_wall(const Wall& wall) {
    const Face fresh = edit_.add_face(wall.side);
    edit_.derive(fresh, wall.face, Derivation::copies);
    edit_.connect(wall.side, wall.rise_after);
    edit_.connect(wall.rise_after, twin(wall.top));
    edit_.connect(twin(wall.top), twin(wall.rise));
    edit_.connect(twin(wall.rise), wall.side);
    set_face_along(edit_, wall.side, fresh);
    edit_.set_face(wall.top, wall.face);
    sheets_.changed(fresh);
  }

  void hold_halfedges() {
    for (const RaisedSector& sector : sectors_) {
      edit_.set_halfedge(sector.top, raised(sector.first));
      hold_outside(edit_, sector.top);
      if (const Halfedge held = m_.halfedge(sector.from); held && m_.from(held) == sector.from) continue;
      Halfedge left = sector.wall_at_first ? sector.first : sector.wall_at_last ? sector.rise : sector.left;
      if (left && m_.from(left) != sector.from) left = Halfedge();
      edit_.set_halfedge(sector.from, left);
    }
    std::vector<Vertex> below;
    for (const RaisedSector& sector : sectors_) below.push_back(sector.from);
    sort_unique(below);
    for (Vertex v : below) hold_outside(edit_, v);
  }

  void move_rest() {
    for (Vertex p : region_.points()) {
      if (region_.stays_behind(m_, p)) continue;
      const glm::dvec3 moved = m_.position(p) + by_;
      if (is_finite(moved)) move_point(edit_, p, moved);
    }
  }

  // Points with several sectors, or an end without a wall, may have to be cut or joined otherwise.
  void make_manifold() {
    std::vector<std::pair<Vertex, std::size_t>> by_point;
    for (std::size_t i = 0; i < sectors_.size(); ++i) by_point.emplace_back(point(m_, sectors_[i].from), i);
    std::sort(by_point.begin(), by_point.end());
    std::vector<Vertex> points, bare;
    for (std::size_t i = 0, end = 0; i < by_point.size(); i = end) {
      std::vector<Vertex> tops;
      for (end = i; end < by_point.size() && by_point[end].first == by_point[i].first; ++end)
        tops.push_back(sectors_[by_point[end].second].top);
      const RaisedSector& sector = sectors_[by_point[i].second];
      if (tops.size() == 1 && sector.wall_at_first && sector.wall_at_last) continue;
      if (tops.size() > 1) link_copies(edit_, tops);
      points.insert(points.end(), {by_point[i].first, tops[0]});
    }
    std::vector<Edge> made;
    for (const Wall& wall : walls_) made.push_back(edge(wall.top));
    share_values(edit_, made);
    for (const Wall& wall : walls_)
      if (wall.is_shared) sheets_.open(wall.top);
    for (const RaisedSector& sector : sectors_)
      if (m_.is_isolated(sector.from)) bare.push_back(sector.from);
    sort_unique(bare);
    std::reverse(bare.begin(), bare.end());
    sheets_.remove_vertices(bare);
    if (!points.empty()) sheets_.make_manifold(points);
  }

  Edit& edit_;
  const Mesh& m_;
  const Region& region_;
  const glm::dvec3 by_;
  Sheets sheets_;
  std::vector<Wall> walls_;
  std::unordered_map<Halfedge, std::size_t> wall_at_;  // by side
  std::vector<RaisedSector> sectors_;
  std::vector<std::pair<Halfedge, std::size_t>> corners_;  // by sector; the map: by outgoing side
  std::unordered_map<Halfedge, std::size_t> sector_at_;
};

}  // namespace

OpEffect raise(Edit& edit, const Region& region, const glm::dvec3& by) { return Raise(edit, region, by).run(); }

}  // namespace ryosen
