// Sentences in the upper left corner of the view: of a step that is played, and of a file without faces.
#include <algorithm>

#include "app/editor/camera/view_state.h"
#include "app/editor/labels/labels.h"
#include "app/editor/preferences/preference_values.h"
#include "app/editor/shown/player.h"
#include "app/editor/shown/shown.h"
#include "app/editor/texts/message_place.h"
#include "ryosen/base/count_text.h"
#include "ryosen/document/document.h"
#include "ryosen/mesh/circulate.h"
#include "ryosen/mesh/face_polygon.h"
#include "ryosen/mesh/find_element.h"
#include "ryosen/mesh/mesh.h"

namespace ryosen {

namespace {

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

// Adds sentences in the upper left corner, broken into lines that have room.
void add_caption(const ViewState& view, const Preferences& preferences, std::span<const std::string> sentences,
                 std::vector<Label>& labels) {
  int row = 0;
  const double scale = preferences.label_scale();
  const double left = view.covered_px.x / scale + caption_margin_px;
  const double room = (view.size.width - view.covered_px.x - view.covered_px.y) / scale - 2 * caption_margin_px;
  for (const std::string& sentence : sentences)
    for (std::string& line : broken_lines(sentence, room))
      labels.push_back({.text = std::move(line),
                        .priority = legend_priority,
                        .shift_px = {left, caption_margin_px + (row++ + 0.5) * caption_row_px},
                        .pixel = glm::dvec2(0, 0),
                        .begins_there = true});
}

}  // namespace

bool is_faceless(const Document& document) {
  const ElementCounts live = document.mesh().live();
  return live.faces == 0 && live.edges == 0 && !document.path().empty();
}

void add_faceless(const Document& document, const ViewState& view, const Preferences& preferences,
                  std::vector<Label>& labels) {
  const MeshFile& file = document.file();
  std::vector<std::string> sentences;
  const Text what =
      document.mesh().live().vertices == 0
          ? Text{"The mesh is empty.", "メッシュは空です。"}
          : count_text(document.mesh().live().vertices, "The mesh has one vertex and no faces.",
                       "The mesh has # vertices and no faces.", "メッシュには頂点が # 個ありますが、面はありません。");
  sentences.push_back(what.in(preferences.language));
  const auto is_about_rest = [](const Message& m) { return m.code != "no_faces" && m.code != "no_vertices"; };
  const auto first = std::find_if(file.messages.begin(), file.messages.end(), is_about_rest);
  if (first != file.messages.end())
    sentences.push_back(text_with_place(*first, document.path().filename().string()).in(preferences.language));
  add_caption(view, preferences, sentences, labels);
}

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
