// The labels of a session: short texts at places of the mesh, which every picture shows, with or without panels.
//
// To have further ones drawn, write a function that adds them and its row in labels.cpp. The picture leaves out what
// lies behind the surface or would lie over a label that goes first.
#pragma once

#include <functional>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "app/editor/session/owners.h"
#include "ryosen/base/element.h"
#include "ryosen/base/handle.h"
#include "ryosen/scene/view/size.h"

namespace ryosen {

class Document;
class Findings;
class Mesh;
class Selecting;
class Session;
class Shown;
struct Preferences;
struct SeenMesh;
struct ViewState;

struct Label {
  glm::dvec3 at{0};                      // in mesh space; the text is centred there
  std::string text = {};                 // one line, UTF-8
  int priority = 0;                      // a higher one goes first; among equal ones the one that comes earlier
  Face own = {};                         // the face it is written on, which does not hide it
  glm::dvec2 shift_px{0};                // of the text from there, at display scale 1
  std::vector<glm::dvec2> else_px = {};  // further shifts to try, in this order, where that has no room
  // It was asked for: where it has none, or lies over the gizmo, it moves to the nearest room of the view.
  bool moves_aside = false;
  std::optional<glm::dvec2> pixel = {};      // instead of `at`: of the view, never hidden
  bool through = false;                      // shown though the surface hides its place
  bool begins_there = false;                 // the place is the left end of the text, not its middle
  double least_width_px = 0;                 // at display scale 1
  std::optional<std::uint32_t> ground = {};  // the colour below the text, 0xRRGGBB; else that of all labels
};

// What labels are about, from the least priority on.
inline constexpr int number_priority = 0, selected_priority = 1, measure_priority = 2, link_priority = 3,
                     legend_priority = 4, snap_priority = 5;

struct LabelSource {
  std::string_view id;
  // Whether it has any now; cheap, asked for each frame.
  OnOwners<bool(const Session&)> is_on;
  OnOwners<void(Session&, std::vector<Label>& labels)> add;
};
std::span<const LabelSource> label_sources();

// At most so many are drawn at a time.
inline constexpr std::size_t most_labels = 400;

// A label with its place in the view: the upper left corner of its text, in pixels of the view.
struct PlacedLabel {
  glm::ivec2 corner;
  Size size;
  std::string text;
  std::optional<std::uint32_t> ground = {};
  friend bool operator==(const PlacedLabel&, const PlacedLabel&) = default;
};

// Gives the size of a text in pixels.
using TextSize = std::function<Size(const std::string& text)>;

// Labels of all sources that are seen, in full within the view, and do not overlap. `scale` is that of the display. The
// same session gives the same labels. Cost: those elements that the sources go over, and a ray for each label that has
// room.
std::vector<PlacedLabel> placed_labels(Session& session, const TextSize& size_of, double scale);
// Labels of a mesh that is compared with; whether it has any is cheap to ask.
bool has_labels(const SeenMesh& compared);
std::vector<PlacedLabel> placed_labels(const SeenMesh& compared, const TextSize& size_of, double scale);

// Adds the numbers of elements that the switch `numbers` asks for, in view; the selected ones first. Where there are
// very many in view, every so many-th. O(slots of that sort).
void add_numbers(const SeenMesh& seen, std::set<Element> selected, std::vector<Label>& labels);
// Adds what was measured of up to three elements, in the middle of the way along which that was, else of the first one.
void add_measures(const Mesh& mesh, const Selecting& selecting, const Preferences& preferences,
                  std::vector<Label>& labels);
// Adds the caption of the step that is played, in the upper left corner, and beside its elements the labels of their
// roles.
void add_step(const Mesh& mesh, const ViewState& view, const Shown& shown, const Preferences& preferences,
              std::vector<Label>& labels);
// Whether there is a file and its mesh has nothing that a picture could show as a surface or as edges.
bool is_faceless(const Document& document);
// Adds how much there is then, and the first warning of the file.
void add_faceless(const Document& document, const ViewState& view, const Preferences& preferences,
                  std::vector<Label>& labels);
// Adds the legend of what the surface is coloured by, in the lower left corner: its name, and values on their colours.
void add_map_legend(Findings& findings, const ViewState& view, const Preferences& preferences,
                    std::vector<Label>& labels);

}  // namespace ryosen
