#include "app/editor/camera/view_state.h"
#include "app/editor/labels/labels.h"
#include "app/editor/preferences/preference_values.h"
#include "app/editor/shown/player.h"
#include "app/editor/shown/shown.h"
#include "ryosen/mesh/circulate.h"
#include "ryosen/mesh/face_polygon.h"
#include "ryosen/mesh/find_element.h"
#include "ryosen/mesh/mesh.h"

namespace ryosen {

void add_step(const Mesh& mesh, const ViewState& view, const Shown& shown, const Preferences& preferences,
              std::vector<Label>& labels) {
  const Player& player = *shown.player();
  const std::string number = std::to_string(player.position()) + "/" + std::to_string(player.size()) + "  ";
  const std::string sentences[] = {number + player.caption().in(preferences.language)};
  add_caption(view, preferences, sentences, labels);
  for (const Player::Mark& mark : player.marks()) {
    if (!has_slot(mesh.lengths(), mark.element) || !is_alive(mesh, mark.element)) continue;
    Label label{.at = middle_of(mesh, mark.element), .text = std::string(mark.word), .priority = measure_priority};
    label.through = true;
    // A halfedge has its label on the side of its face.
    if (mark.element.kind == Element::Kind::halfedge && !mesh.is_outside(mark.element.halfedge())) {
      glm::dvec3 centre{0};
      double corners = 0;
      for (const Vertex v : vertices_around(mesh, mesh.face(mark.element.halfedge()))) {
        centre += mesh.position(v);
        ++corners;
      }
      label.at += 0.25 * (centre / corners - label.at);
    }
    labels.push_back(std::move(label));
  }
}

}  // namespace ryosen
