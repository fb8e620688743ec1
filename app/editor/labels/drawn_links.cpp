#include "app/editor/labels/drawn_links.h"

#include <algorithm>
#include <glm/geometric.hpp>

#include "app/editor/labels/link_arrows.h"
#include "app/editor/session/session.h"
#include "ryosen/mesh/find_element.h"
#include "ryosen/scene/pick/screen_segment.h"
#include "ryosen/scene/view/clip_plane.h"

namespace ryosen {

namespace {

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
