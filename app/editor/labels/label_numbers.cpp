// The numbers of elements as labels.
#include <algorithm>
#include <optional>
#include <set>

#include "app/editor/camera/view_state.h"
#include "app/editor/document/findings.h"
#include "app/editor/labels/labels.h"
#include "app/editor/views/mesh_view.h"
#include "ryosen/mesh/circulate.h"
#include "ryosen/mesh/copies.h"
#include "ryosen/mesh/mesh.h"
#include "ryosen/scene/pick/screen_segment.h"

namespace ryosen {

namespace {

class NumberLabels {
 public:
  NumberLabels(const SeenMesh& seen, std::set<Element> selected, std::vector<Label>& labels)
      : findings_(seen.findings),
        view_(seen.view),
        m_(findings_.mesh()),
        places_(seen.places),
        labels_(labels),
        screen_(view_.camera, view_.size),
        selected_(std::move(selected)) {}

  template <class Handle>
  void add(std::uint32_t slots, char letter) {
    constexpr std::size_t many = 4000;  // more than can have room
    std::vector<std::uint32_t> in_view;
    for (std::uint32_t i = 0; i < slots; ++i) {
      const Handle element(i);
      if (m_.is_alive(element) && is_own(element) && !findings_.hidden().hides(m_, element) &&
          is_in_view(middle(element)))
        in_view.push_back(i);
    }
    const std::size_t step = in_view.size() / many + 1;
    for (std::size_t n = 0; n < in_view.size(); ++n) {
      const Handle element(in_view[n]);
      const bool is_selected = selected_.contains(Element(element));
      if (n % step != 0 && !is_selected) continue;
      Label label = label_of(element);
      label.text = letter + std::to_string(element.index);
      label.priority = is_selected ? selected_priority : number_priority;
      labels_.push_back(std::move(label));
    }
  }

  // As text 003 numbers the sides of triangles, and any corners in their order; those at a boundary in a colour of
  // their own.
  void add_corners() {
    constexpr std::uint32_t inner_colour = 0x1F5FA8, boundary_colour = 0x00785A;
    std::uint32_t number = 0;
    for (std::uint32_t f = 0; f < m_.face_slots(); ++f) {
      if (!m_.is_alive(Face(f))) continue;
      for (const Halfedge h : loop(m_, m_.halfedge(Face(f)))) {
        const std::uint32_t n = number++;
        if (findings_.hidden().hides(m_, h) || !is_in_view(middle(h))) continue;
        Label label = label_of(h);
        label.text = std::to_string(n);
        label.ground = m_.is_outside(twin(h)) ? boundary_colour : inner_colour;
        if (selected_.contains(Element(h))) label.priority = selected_priority;
        labels_.push_back(std::move(label));
      }
    }
  }

 private:
  // One number for all copies of a point.
  bool is_own(Vertex v) const { return point(m_, v) == v; }
  template <class Handle>
  bool is_own(Handle) const {
    return true;
  }

  bool is_in_view(const glm::dvec3& place) const {
    const auto at = screen_.project(place);
    return at && at->pixel.x >= 0 && at->pixel.y >= 0 && at->pixel.x < view_.size.width &&
           at->pixel.y < view_.size.height;
  }

  glm::dvec3 middle(Vertex v) const { return places_[v.index]; }
  glm::dvec3 middle(Edge e) const {
    const auto [a, b] = ends(m_, e);
    return 0.5 * middle(a) + 0.5 * middle(b);
  }
  glm::dvec3 middle(Halfedge h) const { return middle(edge(h)); }
  glm::dvec3 middle(Face f) const {
    glm::dvec3 sum(0);
    double corners = 0;
    for (const Vertex v : vertices_around(m_, f)) {
      sum += middle(v);
      ++corners;
    }
    return sum / corners;
  }

  // Of the loop of a halfedge that bounds a hole of its face, which lies away from it.
  std::optional<glm::dvec3> middle_of_ring(Halfedge h) const {
    const Face f = m_.face(h);
    if (!f || !m_.has_rings(f)) return std::nullopt;
    glm::dvec3 sum(0);
    double corners = 0;
    for (const Halfedge other : loop(m_, h)) {
      if (other == m_.halfedge(f)) return std::nullopt;
      sum += middle(m_.from(other));
      ++corners;
    }
    return sum / corners;
  }

  // Beside its vertex, so that both are seen.
  Label label_of(Vertex v) const { return {.at = middle(v), .shift_px = {0, -13}}; }
  Label label_of(Edge e) const { return {.at = middle(e)}; }
  Label label_of(Face f) const { return {.at = middle(f), .own = f}; }
  // On the side of its face; without one, away from that of its twin.
  Label label_of(Halfedge h) const {
    constexpr double inwards = 0.25;
    const glm::dvec3 at = middle(h);
    if (const auto around = middle_of_ring(h)) return {.at = at - inwards * (*around - at), .own = m_.face(h)};
    if (const Face f = m_.face(h)) return {.at = at + inwards * (middle(f) - at), .own = f};
    const Face across = m_.face(twin(h));
    return {.at = across ? at - inwards * (middle(across) - at) : at};
  }

  const Findings& findings_;
  const ViewState& view_;
  const Mesh& m_;
  std::span<const glm::dvec3> places_;
  std::vector<Label>& labels_;
  ScreenProjection screen_;
  std::set<Element> selected_;
};

}  // namespace

void add_numbers(const SeenMesh& seen, std::set<Element> selected, std::vector<Label>& labels) {
  NumberLabels numbers(seen, std::move(selected), labels);
  const Mesh& mesh = seen.findings.mesh();
  const auto shows = [&](Numbers which) {
    return seen.view.settings.numbers == which || seen.view.settings.numbers == Numbers::all;
  };
  if (shows(Numbers::vertices)) numbers.add<Vertex>(mesh.vertex_slots(), 'v');
  if (shows(Numbers::faces)) numbers.add<Face>(mesh.face_slots(), 'f');
  if (shows(Numbers::halfedges)) numbers.add<Halfedge>(mesh.halfedge_slots(), 'h');
  if (shows(Numbers::edges)) numbers.add<Edge>(mesh.edge_slots(), 'e');
  if (seen.view.settings.numbers == Numbers::corners) numbers.add_corners();
}

}  // namespace ryosen
