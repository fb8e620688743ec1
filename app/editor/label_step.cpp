#include "app/editor/labels.h"
#include "app/editor/playing.h"
#include "core/mesh/circulate.h"
#include "core/mesh/find_element.h"
#include "core/mesh/middle.h"

namespace ryosen {

namespace {

constexpr double caption_row_px = 19, caption_margin_px = 12;  // at display scale 1

// Roughly, in pixels at display scale 1: other characters than Latin ones are as wide as they are high.
double width_of(std::string_view character) { return character.size() > 1 ? 15.0 : 7.8; }

// The lines of a text of at most so many pixels each: broken between words, or between characters where these are wide.
std::vector<std::string> broken_lines(std::string_view text, double most_px) {
  std::vector<std::string> lines(1);
  double width = 0;
  std::size_t last_break = 0;  // in the last line: behind it the next one begins
  for (std::size_t at = 0; at < text.size();) {
    std::size_t bytes = 1;
    while (at + bytes < text.size() && (static_cast<unsigned char>(text[at + bytes]) & 0xc0u) == 0x80u) ++bytes;
    const std::string_view character = text.substr(at, bytes);
    at += bytes;
    lines.back() += character;
    width += width_of(character);
    if (character == " " || bytes > 1) last_break = lines.back().size();
    if (width < most_px || last_break == 0) continue;
    std::string rest = lines.back().substr(last_break);
    lines.back().resize(last_break);
    width = 7.8 * double(rest.size());
    lines.push_back(std::move(rest));
    last_break = 0;
  }
  return lines;
}

}  // namespace

double caption_px(const Session& session) {
  constexpr int usual_rows = 2;
  return (caption_margin_px + usual_rows * caption_row_px) * session.label_scale();
}

void add_step(Session& session, std::vector<Label>& labels) {
  const Player& player = *session.player;
  const steps::Step* const step = player.step();
  const Text caption = step ? step->caption : player.name();
  const std::string number = std::to_string(player.position()) + "/" + std::to_string(player.size()) + "  ";
  int row = 0;
  const double scale = session.label_scale();
  const double left = session.covered_px.x / scale + caption_margin_px;
  const double room =
      (session.view.width - session.covered_px.x - session.covered_px.y) / scale - 2 * caption_margin_px;
  for (std::string& line : broken_lines(number + caption.in(session.language), room))
    labels.push_back({.text = std::move(line),
                      .priority = legend_priority,
                      .shift_px = {left, caption_margin_px + (row++ + 0.5) * caption_row_px},
                      .pixel = glm::dvec2(0, 0),
                      .begins_there = true});
  if (!step) return;
  const Mesh& mesh = session.mesh();
  for (const steps::Mark& mark : step->marks) {
    const steps::RoleRow& role = steps::row_of(mark.role);
    if (!role.is_label || !has_slot(mesh.lengths(), mark.element) || !is_alive(mesh, mark.element)) continue;
    Label label{.at = middle_of(mesh, mark.element), .text = std::string(role.id), .priority = measure_priority};
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
