// Shows in the view beforehand what an algorithm or an operator would do with the values that are in its fields.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>

#include "ryosen/base/message.h"
#include "ryosen/base/progress.h"
#include "ryosen/scene/view/camera.h"

namespace ryosen {

class Findings;
class Document;
class Framing;
class Mesh;
class Selecting;
class Session;
class Shown;
struct ViewState;

// A trial: a line that identifies it; whether what it adds is a part of its own; and the function that puts it on trial
// and tells its outcome, or none where it was cancelled. Values that do not fit the mesh put nothing on trial.
struct ValuesTrial {
  std::string line;
  bool adds_part = false;
  std::function<std::optional<Text>(const Findings& findings, const Selecting& selecting, Shown& shown,
                                    Progress::Report progress)>
      run;
};

// The session's Shown shows it. Only what is quick is shown: on meshes that are not large, and cancelled where it takes
// longer than somebody who types would wait. What comes beyond the bounds of the mesh, or as a new part, is brought
// into view where it is not in it, until it goes or somebody moves the camera.
class ValuesPreview {
 public:
  bool is_offered(const Findings& findings, const Shown& shown) const;
  // Shows it, unless it is what is shown.
  void show(Session& session, const ValuesTrial& trial);
  // Takes it back, where nothing else has taken its place.
  void end(const Document& document, ViewState& view, Framing& framing, Shown& shown);
  // As it is about to be done: what was brought into view stays there.
  void hand_over(Session& session);
  // Returns what is said of the last one that was shown, or why nothing is shown. Empty where nothing was.
  const Text& told() const { return told_; }

 private:
  void take_back(const Document& document, ViewState& view, Framing& framing, Shown& shown);
  void bring_into_view(const Mesh& mesh, const ViewState& view, Framing& framing, std::span<const glm::dvec3> places);

  std::string line_;                         // that was shown last
  std::uint64_t serial_ = 0, revision_ = 0;  // of the document then
  Text told_;
  struct CameraBefore {
    Camera camera;
    bool was_framed;
  };
  std::optional<CameraBefore> before_;  // while what is shown was brought into view
  bool is_left_alone_ = false;          // somebody has moved the camera since
};

}  // namespace ryosen
