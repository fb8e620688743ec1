#include "app/editor/labels/drawn_links.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <map>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "app/editor/camera/view_state.h"
#include "app/editor/session/session.h"
#include "app/editor/shown/gesturing.h"
#include "ryosen/mesh/circulate.h"
#include "ryosen/mesh/face_polygon.h"
#include "ryosen/mesh/find_element.h"
#include "ryosen/mesh/mesh.h"
#include "ryosen/mesh/rings.h"
#include "ryosen/scene/pick/screen_segment.h"
#include "ryosen/scene/view/clip_plane.h"

namespace ryosen {

namespace {

bool has_finite_length(const glm::dvec3& way) {
  const double squared = glm::dot(way, way);
  return std::isfinite(squared) && squared > 0;
}

// Lays arrows into the faces of the mesh as it is drawn. Both are needed as long.
class ArrowMaker {
 public:
  ArrowMaker(const Mesh& mesh, const ViewState& view, std::span<const glm::dvec3> places)
      : m_(mesh), places_(places), forward_(axes(view.camera).forward) {}

  // None where the edge has no length.
  std::optional<LinkArrow> of(Halfedge h, LinkRole role, Text label = {}) {
    const glm::dvec3 &p = place(m_.from(h)), &q = place(m_.to(h));
    if (!has_finite_length(q - p)) return std::nullopt;
    const double length = glm::length(q - p);
    const glm::dvec3 along = (q - p) / length;
    const Face f = m_.face(h), across = m_.face(twin(h));
    glm::dvec3 inward(0);
    double room = length;
    if (f || across) {
      const Frame& frame = frame_of(f ? f : across);
      inward = glm::cross(frame.normal, along);  // without a face it leads away from that of the twin
      if (f) room = frame.inradius;
    }
    if (!has_finite_length(inward)) inward = glm::cross(along, forward_);
    if (!has_finite_length(inward)) return std::nullopt;
    inward = glm::normalize(inward);
    const double shift = std::min(0.11 * length, 0.5 * room);
    double first = 0.1 * length, last = first;
    if (f) {
      first = trim(m_.from(h), m_.from(m_.prev(h)), along, shift, length);
      last = trim(m_.to(h), m_.to(m_.next(h)), -along, shift, length);
    }
    LinkArrow arrow{p + first * along + shift * inward, q - last * along + shift * inward, role, h, f, inward};
    arrow.is_boundary = !f || !across;
    arrow.label = std::move(label);
    return arrow;
  }
  glm::dvec3 normal(Face f) { return frame_of(f).normal; }
  double size(Face f) { return 2 * frame_of(f).inradius; }

 private:
  struct Frame {
    glm::dvec3 normal{0};  // of length 1, or 0
    double inradius = 0;   // of a regular polygon of this area and perimeter
  };

  const glm::dvec3& place(Vertex v) const { return places_[v.index]; }
  // How far behind a corner an arrow begins, so that it lies on the bisector of a corner that is not reflex. `along`
  // leads away from the corner, as does the way to `other`.
  double trim(Vertex corner, Vertex other, const glm::dvec3& along, double shift, double length) const {
    const double least = 0.1 * length;
    const glm::dvec3 side = place(other) - place(corner);
    if (!has_finite_length(side)) return least;
    const double cosine = std::clamp(glm::dot(along, side) / glm::length(side), -1.0, 1.0);
    const double half = std::sqrt((1 - cosine) / (1 + cosine + 1e-12));  // the tangent of half the angle
    return std::clamp(half > 0 ? shift / half : length, least, 0.4 * length);
  }

  const Frame& frame_of(Face f) {
    const auto [at, is_new] = frames_.try_emplace(f.index);
    if (!is_new) return at->second;
    const glm::dvec3& first = place(m_.from(m_.halfedge(f)));
    glm::dvec3 sum(0);
    double perimeter = 0;
    for (const Halfedge h : loop(m_, m_.halfedge(f))) {
      sum += glm::cross(place(m_.from(h)) - first, place(m_.to(h)) - first);
      perimeter += glm::length(place(m_.to(h)) - place(m_.from(h)));
    }
    if (has_finite_length(sum) && perimeter > 0) at->second = {glm::normalize(sum), glm::length(sum) / perimeter};
    return at->second;
  }

  const Mesh& m_;
  std::span<const glm::dvec3> places_;
  glm::dvec3 forward_;
  std::map<std::uint32_t, Frame> frames_;
};

constexpr std::size_t most_of_one = 200;

Text link_text(const char* en, const char* ja, const std::string& name) {
  const std::string behind = name.empty() ? "" : " " + name;
  return {en + behind, ja + behind};
}

// The arrows of one selected element.
class LinksOf {
 public:
  LinksOf(const Mesh& mesh, std::span<const glm::dvec3> places, ArrowMaker& make, std::vector<LinkArrow>& arrows)
      : m_(mesh), places_(places), make_(make), arrows_(arrows) {}

  void add(const Element& e) {
    if (e.kind == Element::Kind::vertex) return add(e.vertex());
    if (e.kind == Element::Kind::halfedge) return add(e.halfedge());
    if (e.kind == Element::Kind::edge) return add(e.edge());
    add(e.face());
  }

 private:
  const glm::dvec3& place(Vertex v) const { return places_[v.index]; }

  void arrow(Halfedge h, LinkRole role, const char* en, const char* ja) {
    if (auto made = make_.of(h, role, link_text(en, ja, name_of(m_, h)))) arrows_.push_back(std::move(*made));
  }
  void arrow_to(const glm::dvec3& from, const glm::dvec3& to, LinkRole role, Face on, Text label) {
    arrows_.push_back({from, to, role, {}, on, {}, false, std::move(label)});
  }
  void mark(Vertex v, const char* en, const char* ja) {
    arrow_to(place(v), place(v), LinkRole::vertex, {}, link_text(en, ja, slot_name(v)));
  }

  void add(Halfedge h) {
    const Halfedge n = m_.next(h), p = m_.prev(h), t = twin(h);
    const bool turns = n == p, back = n == t;
    arrow(h, LinkRole::itself, "halfedge", "半稜線");
    arrow(t, LinkRole::twin, back ? "twin, next" : "twin", back ? "対・次" : "対");
    // The first arrow is labelled first: there is no other place for the face's label.
    const Face f = m_.face(h);
    if (f) {
      const glm::dvec3 middle = 0.5 * (place(m_.from(h)) + place(m_.to(h)));
      arrow_to(middle, middle_of(m_, f), LinkRole::face, f, link_text("face", "面", slot_name(f)));
    }
    if (!back) arrow(n, LinkRole::next, turns ? "next, prev" : "next", turns ? "次・前" : "次");
    if (!turns && p != t) arrow(p, LinkRole::prev, "prev", "前");
    mark(m_.from(h), "from", "始点");
    // Text 003's v_opps: the corner of a triangle that the halfedge does not touch.
    if (f && m_.next(n) == p && !turns) mark(m_.to(n), "opposite", "対角頂点");
  }

  void add(Edge e) {
    const Halfedge h = halfedge(e), t = twin(h);
    mark(m_.from(h), "start", "始点");
    mark(m_.to(h), "end", "終点");
    const glm::dvec3 middle = 0.5 * (place(m_.from(h)) + place(m_.to(h)));
    struct Side {
      Halfedge h;
      const char *en, *ja, *next_en, *next_ja, *prev_en, *prev_ja;
    };
    for (const Side& side : {Side{h, "left", "左", "left next", "左の次", "left prev", "左の前"},
                             Side{t, "right", "右", "right next", "右の次", "right prev", "右の前"}}) {
      const Face f = m_.face(side.h);
      if (!f) continue;
      arrow_to(middle, middle_of(m_, f), LinkRole::face, f, link_text(side.en, side.ja, slot_name(f)));
      wing(m_.next(side.h), side.next_en, side.next_ja);
      wing(m_.prev(side.h), side.prev_en, side.prev_ja);
    }
  }
  void wing(Halfedge h, const char* en, const char* ja) {
    if (auto made = make_.of(h, LinkRole::wing, link_text(en, ja, name_of(m_, edge(h)))))
      arrows_.push_back(std::move(*made));
  }

  void add(Vertex v) {
    mark(v, "vertex", "頂点");
    if (m_.is_isolated(v)) return;
    std::size_t n = 1;
    Halfedge h = m_.halfedge(v);
    do {
      const std::string number = std::to_string(n);
      if (n == 1)
        arrow(h, LinkRole::itself, "1 halfedge", "1 半稜線");
      else
        arrow(h, LinkRole::around, number.c_str(), number.c_str());
      h = m_.counter_clockwise(h);
    } while (h != m_.halfedge(v) && ++n <= most_of_one);
  }

  void add(Face f) {
    const glm::dvec3 middle = middle_of(m_, f);
    arrow_to(middle, middle + make_.size(f) * make_.normal(f), LinkRole::normal, {}, link_text("normal", "法線", ""));
    for_each_loop(m_, f, [&](Halfedge start) {
      const bool is_outer = start == m_.halfedge(f);
      add_loop(start, is_outer ? LinkRole::around : LinkRole::ring, is_outer);
    });
  }
  void add_loop(Halfedge start, LinkRole role, bool is_outer) {
    std::size_t n = 1;
    for (const Halfedge h : loop(m_, start)) {
      const std::string number = std::to_string(n);
      if (h == start)
        arrow(h, is_outer ? LinkRole::itself : role, is_outer ? "1 halfedge" : "ring",
              is_outer ? "1 半稜線" : "内側のループ");
      else
        arrow(h, role, number.c_str(), number.c_str());
      if (++n > most_of_one) return;
    }
  }

  const Mesh& m_;
  std::span<const glm::dvec3> places_;
  ArrowMaker& make_;
  std::vector<LinkArrow>& arrows_;
};

// Adds the links of a living element, at most 200.
void add_links_of(const Mesh& mesh, std::span<const glm::dvec3> places, ArrowMaker& make, const Element& e,
                  std::vector<LinkArrow>& arrows) {
  LinksOf(mesh, places, make, arrows).add(e);
}

// The halfedges whose edges are in view and long enough there, the longest ones where there are too many.
std::vector<Halfedge> halfedges_in_view(const Findings& findings, const ViewState& view,
                                        std::span<const glm::dvec3> places, const Preferences& preferences) {
  const Mesh& m = findings.mesh();
  const ScreenProjection screen(view.camera, view.size);
  std::vector<std::pair<double, std::uint32_t>> edges;  // shortest last
  for (std::uint32_t i = 0; i < m.edge_slots(); ++i) {
    const Edge e(i);
    if (!m.is_alive(e) || findings.hidden().hides(m, e)) continue;
    const auto a = screen.project(places[m.from(halfedge(e)).index]),
               b = screen.project(places[m.to(halfedge(e)).index]);
    if (!a || !b) continue;
    const glm::dvec2 middle = 0.5 * (a->pixel + b->pixel);
    if (!(middle.x >= 0 && middle.y >= 0 && middle.x < view.size.width && middle.y < view.size.height)) continue;
    const double length = glm::length(a->pixel - b->pixel);
    if (length >= DrawnLinks::least_px * preferences.size_scale()) edges.emplace_back(-length, i);
  }
  constexpr std::size_t most_edges = DrawnLinks::most / 2;
  if (edges.size() > most_edges) {
    std::nth_element(edges.begin(), edges.begin() + most_edges, edges.end());
    edges.resize(most_edges);
  }
  std::vector<Halfedge> found;
  for (const auto& [length, i] : edges) {
    found.push_back(halfedge(Edge(i)));
    found.push_back(twin(halfedge(Edge(i))));
  }
  std::sort(found.begin(), found.end());
  return found;
}

}  // namespace

std::vector<LinkArrow> arrows_of(const Mesh& mesh, const ViewState& view, std::span<const glm::dvec3> places,
                                 const std::vector<Halfedge>& halfedges) {
  ArrowMaker make(mesh, view, places);
  std::vector<LinkArrow> arrows;
  for (const Halfedge h : halfedges)
    if (auto arrow = make.of(h, LinkRole::all)) arrows.push_back(std::move(*arrow));
  return arrows;
}

bool DrawnLinks::is_on(const Findings& findings, const Selecting& selecting, const Gesturing& gesturing) const {
  if (shown == LinksShown::off || findings.preparing() || gesturing.is_active()) return false;
  return shown != LinksShown::in_mode || selecting.mode == PickMode::halfedge;
}

const std::vector<LinkArrow>& DrawnLinks::of(const Session& session) {
  if (!is_on(session.findings(), session.selecting, session.gesturing)) {
    key_.reset();
    arrows_.clear();
    return arrows_;
  }
  const Document& document = session.document();
  const Selection& selection = session.selecting.selection;
  const Key key{.serial = document.serial(),
                .revision = document.revision(),
                .hidden = session.findings().hidden().revision(),
                .trail = trail_revision_,
                .shown = shown,
                .camera = session.view.camera,
                .view = session.view.size,
                .scale = session.preferences.size_scale(),
                .selection = selection.stamp()};
  if (key_ && *key_ == key) return arrows_;
  key_ = key;
  arrows_.clear();
  const std::span<const glm::dvec3> places = session.gesturing.drawn_positions();
  ArrowMaker make(session.mesh(), session.view, places);
  const auto lives = [&](const Element& e) {
    return is_alive(session.mesh(), e) && !session.findings().hidden().hides(session.mesh(), e);
  };
  if (!selection.empty() && lives(selection.back()))
    add_links_of(session.mesh(), places, make, selection.back(), arrows_);
  const bool goes_on = !trail_.empty() && selection.size() == 1 && selection[0] == Element(trail_.back());
  std::vector<Halfedge> drawn;
  for (const LinkArrow& arrow : arrows_) drawn.push_back(arrow.halfedge);
  const auto add = [&](Halfedge h, LinkRole role) {
    if (!lives(h)) return;
    const Face f = session.mesh().face(h);
    if (f && session.findings().hidden().hides(session.mesh(), f)) return;
    if (std::find(drawn.begin(), drawn.end(), h) != drawn.end()) return;
    if (auto arrow = make.of(h, role)) arrows_.push_back(std::move(*arrow));
  };
  if (goes_on)
    for (const Halfedge h : trail_) {
      add(h, LinkRole::trail);
      drawn.push_back(h);
    }
  if (shown == LinksShown::all || shown == LinksShown::faces)
    for (const Halfedge h : halfedges_in_view(session.findings(), session.view, places, session.preferences))
      if (shown == LinksShown::all || session.mesh().face(h)) add(h, LinkRole::all);
  return arrows_;
}

const LinkArrow* DrawnLinks::at(Session& session, glm::dvec2 pixel) {
  constexpr double within_px = 4;
  const ScreenProjection screen(session.view.camera, session.view.size);
  const bool hides = session.view.settings.xray == Xray::off;
  const std::optional<ClipPlane> clip = session.view.clip_plane();
  const LinkArrow* nearest = nullptr;
  double least = within_px * session.preferences.size_scale();
  for (const LinkArrow& arrow : of(session)) {
    const auto part = kept(arrow.from, arrow.to, clip);
    if (!arrow.halfedge || !part) continue;
    const glm::dvec3 way = arrow.to - arrow.from, from = arrow.from + part->first * way,
                     to = arrow.from + part->last * way;
    const auto near = screen.nearest_on_segment(from, to, pixel);
    if (!near || near->distance_px >= least) continue;
    const glm::dvec3 place = from + near->along * (to - from);
    const auto at = screen.project(place);
    if (!at || (hides && !session.findings()
                              .picker(session.view)
                              .is_seen(session.mesh(), session.view.camera, session.view.size, *at, place, arrow.on)))
      continue;
    least = near->distance_px;
    nearest = &arrow;
  }
  return nearest;
}

void DrawnLinks::forget_trail() {
  trail_.clear();
  ++trail_revision_;
}

void DrawnLinks::walked(Halfedge from, Halfedge to) {
  constexpr std::size_t most_steps = 500;
  if (trail_.empty() || trail_.back() != from || trail_.size() >= most_steps) trail_ = {from};
  trail_.push_back(to);
  ++trail_revision_;
}

}  // namespace ryosen
