#include "ryosen/ops/rules/collapse_links.h"

#include <algorithm>

#include "ryosen/mesh/circulate.h"
#include "ryosen/mesh/rings.h"
#include "ryosen/ops/rules/corner_values.h"

namespace ryosen {

void blend_corners(Edit& edit, Halfedge h, double along) {
  CornerWriter corners(edit);
  const Mesh& m = edit.mesh();
  for (std::size_t k = 0; k < corners.count(); ++k) {
    struct Chart {
      std::uint32_t gone, kept, blended;
    };
    std::vector<Chart> charts;
    for (Halfedge side : {h, twin(h)}) {
      if (m.is_outside(side)) continue;
      const Halfedge at_gone = side == h ? side : m.next(side), at_kept = side == h ? m.next(side) : side;
      const std::uint32_t gone = corners.index(k, at_gone), kept = corners.index(k, at_kept);
      if (std::none_of(charts.begin(), charts.end(), [&](const Chart& c) { return c.gone == gone && c.kept == kept; }))
        charts.push_back({gone, kept, corners.blend(k, gone, kept, along)});
    }
    const auto update = [&](Vertex v, std::uint32_t Chart::*old) {
      if (std::all_of(charts.begin(), charts.end(), [&](const Chart& c) { return c.*old == c.blended; })) return;
      for (Halfedge corner : outgoing(m, v)) {
        if (m.is_outside(corner)) continue;
        for (const Chart& chart : charts) {
          if (chart.*old != corners.index(k, corner)) continue;
          corners.set(k, corner, chart.blended);
          break;
        }
      }
    };
    update(m.from(h), &Chart::gone);
    update(m.to(h), &Chart::kept);
  }
}

namespace {

// Removes a triangle that has become a face with two sides: `going` starts or ends at the removed vertex, `staying` is
// the other side. `staying` replaces the twin of `going` in the adjacent face or boundary loop.
void close_two_gon(Edit& edit, Halfedge going, Halfedge staying, OpEffect& effect) {
  const Mesh& m = edit.mesh();
  const Halfedge beyond = twin(going);
  const Face dropped = m.face(staying), face = m.face(beyond);
  const Vertex apex = m.from(going) == m.to(staying) ? m.from(going) : m.to(going);
  const Halfedge from_apex = m.from(going) == apex ? going : beyond;
  CornerWriter corners(edit);
  for (std::size_t k = 0; k < corners.count(); ++k) corners.set(k, staying, corners.index(k, beyond));
  edit.connect(m.prev(beyond), staying);
  edit.connect(staying, m.next(beyond));
  edit.set_face(staying, face);
  if (face) replace_start(edit, face, beyond, staying);
  if (m.halfedge(apex) == from_apex) edit.set_halfedge(apex, m.from(staying) == apex ? staying : twin(staying));
  edit.remove(edge(going));
  edit.remove(dropped);
  effect.deleted.push_back(edge(going));
  effect.deleted.push_back(dropped);
}

}  // namespace

Halfedge take_edge_out(Edit& edit, Halfedge h, OpEffect& effect) {
  const Mesh& m = edit.mesh();
  const Halfedge o = twin(h);
  const auto is_plain_triangle = [&](Halfedge side) {
    return !m.is_outside(side) && is_triangle(m, side) && !m.has_rings(m.face(side));
  };
  const bool left_two_gon = is_plain_triangle(h), right_two_gon = is_plain_triangle(o);
  const Halfedge h_next = m.next(h), h_prev = m.prev(h), o_next = m.next(o), o_prev = m.prev(o);
  // A wire may have a free end, where its halves follow each other.
  const bool tip_kept = h_next == o, tip_gone = o_next == h;
  for (Halfedge side : {h, o}) {
    const Face f = m.face(side);
    if (f) replace_start(edit, f, side, m.next(side));
  }
  if (!tip_kept && !tip_gone) {
    edit.connect(h_prev, h_next);
    edit.connect(o_prev, o_next);
  } else {
    edit.connect(tip_kept ? h_prev : o_prev, tip_kept ? o_next : h_next);
  }
  if (left_two_gon) close_two_gon(edit, h_prev, h_next, effect);
  if (right_two_gon) close_two_gon(edit, o_next, o_prev, effect);
  edit.remove(edge(h));
  return tip_kept ? o_next : h_next;
}

}  // namespace ryosen
