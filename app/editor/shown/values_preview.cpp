#include "app/editor/shown/values_preview.h"

#include <chrono>
#include <vector>

#include "app/editor/camera/framing.h"
#include "app/editor/session/session.h"
#include "ryosen/geometry/is_finite.h"
#include "ryosen/geometry/unit_vector.h"
#include "ryosen/mesh/live_elements.h"

namespace ryosen {

namespace {

using PreviewClock = std::chrono::steady_clock;

constexpr std::chrono::milliseconds patience{200};

// The places of what comes: of vertices beyond the bounds that the mesh had, and of those of a new part.
class ComingPlaces {
 public:
  ComingPlaces(const Mesh& mesh, bool adds_part)
      : new_from_(adds_part ? mesh.vertex_slots() : no_index), bounds_(box_of_live(mesh)) {
    const double hair = 1e-9 * length_of(bounds_.highest - bounds_.lowest);
    bounds_.lowest -= hair;
    bounds_.highest += hair;
  }

  std::vector<glm::dvec3> in(const Mesh& mesh) const {
    std::vector<glm::dvec3> places;
    for (const Vertex v : live_vertices(mesh)) {
      const glm::dvec3& place = mesh.position(v);
      if (v.index >= new_from_ || !bounds_.encloses({place, place})) places.push_back(place);
    }
    return places;
  }

 private:
  static Box box_of_live(const Mesh& mesh) {
    Box box;
    for (const Vertex v : live_vertices(mesh))
      if (is_finite(mesh.position(v))) box.add(mesh.position(v));
    return box;
  }

  std::uint32_t new_from_;
  Box bounds_;
};

}  // namespace

bool ValuesPreview::is_offered(const Findings& findings, const Shown& shown) const {
  if (shown.by() != ShownBy::document) return shown.by() == ShownBy::preview;
  return !is_costly_to_try(findings.mesh()) && findings.mesh().live().vertices > 0 && !findings.preparing();
}

void ValuesPreview::show(Session& session, const ValuesTrial& trial) {
  const Document& document = session.document();
  if (trial.line == line_ && serial_ == document.serial() && revision_ == document.revision()) return;
  take_back(session.document(), session.view, session.framing, session.shown);
  session.shown.end();
  line_ = trial.line;
  const ComingPlaces coming(session.mesh(), trial.adds_part);
  const PreviewClock::time_point until = PreviewClock::now() + patience;
  // A picture is the same however long it takes.
  const bool is_patient = !session.trials.in_background;
  const auto is_in_time = [&](double) { return is_patient || PreviewClock::now() < until; };
  told_ = trial.run(session.findings(), session.selecting, session.shown, is_in_time)
              .value_or(Text{"Too slow to preview.", "時間がかかるため、事前には表示しません。"});
  serial_ = document.serial();
  revision_ = document.revision();
  bring_into_view(session.mesh(), session.view, session.framing, coming.in(session.mesh()));
}

// Where all of the mesh was seen before, all of it: its panel covers a part of the view.
void ValuesPreview::bring_into_view(const Mesh& mesh, const ViewState& view, Framing& framing,
                                    std::span<const glm::dvec3> places) {
  bool is_seen = true;
  const auto look_for = [&](std::span<const glm::dvec3> some) {
    is_seen = is_seen && shows_all(view.camera, view.size, framing.covered(), some);
  };
  look_for(places);
  if (framing.is_framed()) with_places_to_frame(mesh, look_for);
  if (is_left_alone_ || is_seen) return;
  before_ = CameraBefore{view.camera, framing.is_framed()};
  framing.frame_all();
}

// With the camera as it was, where that is as it was left; also behind an undo, which has ended the trial.
void ValuesPreview::take_back(const Document& document, ViewState& view, Framing& framing, Shown& shown) {
  if (shown.shows(ShownBy::preview)) shown.end();
  if (serial_ != document.serial()) before_.reset();
  if (!before_) return;
  is_left_alone_ = !framing.is_framed();
  if (!is_left_alone_) view.camera = before_->camera;
  if (!is_left_alone_ && before_->was_framed) framing.frame_all();
  before_.reset();
}

void ValuesPreview::end(const Document& document, ViewState& view, Framing& framing, Shown& shown) {
  take_back(document, view, framing, shown);
  is_left_alone_ = false;
  line_.clear();
  told_ = {};
  serial_ = 0;
}

void ValuesPreview::hand_over(Session& session) {
  before_.reset();
  end(session.document(), session.view, session.framing, session.shown);
}

}  // namespace ryosen
