// Playing something step by step (ryosen/textbook/steps) by the words that call it, as "collapse 0-1" or "script cube".
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "ryosen/document/document.h"
#include "ryosen/scene/view/camera.h"
#include "ryosen/textbook/steps/all.h"
#include "ryosen/textbook/steps/tables.h"

namespace ryosen {

class Mesh;

class Document;
class Framing;
class Shown;
struct ViewState;

// Its row; a failure names those that there are.
Result<const steps::StepsRow*> find_played(std::string_view word);

// What `script` takes in place of the name of an exercise or a file.
inline constexpr std::string_view history_word = "history";
// Whether that is a file.
bool is_script_file(std::string_view name);

// The steps that the words call on a mesh. A script is an exercise by its id, which begins with an empty mesh, or a
// file, which goes on from this one.
Result<std::unique_ptr<steps::Sequence>> make_played(const Mesh& mesh, std::span<const std::string> words);
// The same on that of a document; `script history` plays its history.
Result<std::unique_ptr<steps::Sequence>> make_played(const Document& document, std::span<const std::string> words);

// What the words call, told: "A cube", "edge collapse 0-1".
Text name_of_played(std::span<const std::string> words);
// Goes through a sequence. The mesh of a state is shown in place of the document's, beside the history (Shown), so that
// nothing of the document changes; an edit ends the player.
class Player {
 public:
  // Before the first step, by the words that call it. The mesh is that of the document.
  Player(std::vector<std::string> words, std::unique_ptr<steps::Sequence> sequence, const Mesh& mesh);

  // Unique among those of this process; never 0.
  std::uint64_t serial() const { return player_serial_; }
  const std::vector<std::string>& words() const { return words_; }
  const std::string& call() const { return call_; }
  Text name() const { return name_of_played(words_); }
  std::size_t size() const { return sequence_->size(); }
  std::size_t position() const { return position_; }
  // That which leads to the position; null before the first one.
  const steps::Step* step() const { return step_ ? &*step_ : nullptr; }
  Text remark() const { return sequence_->remark(); }
  std::optional<steps::Curve> curve() const { return sequence_->curve(); }
  // Of very many steps there is none: all steps before would have to be made.
  bool has_tables() const { return sequence_->size() <= most_with_tables; }
  // As all steps up to the position have filled them.
  const steps::Tables& tables() { return tables_.at(position_); }
  static constexpr std::size_t most_with_tables = 5000;
  bool is_running = false;  // a frontend goes forward from time to time
  // Shows meshes of its own in place of that of the document.
  bool edits() const { return sequence_->edits(); }
  // What it begins with has nothing to be looked at: it is looked at as it ends, and then as the mesh was before.
  bool begins_with_nothing() const { return sequence_->edits() && sequence_->mesh_at(0).live().vertices == 0; }
  std::optional<Camera> camera_before;
  bool was_framed = false;                // and nobody had moved that: it may need another size by now
  std::vector<glm::dvec3> places_at_end;  // that are framed instead of those of a step

  // position <= size().
  void go_to(std::size_t position);
  // The mesh of this state; null where it is that of the document.
  const Mesh* other_mesh() const;

 private:
  std::uint64_t player_serial_;
  std::vector<std::string> words_;
  std::string call_;  // these as one line
  std::unique_ptr<steps::Sequence> sequence_;
  steps::TablesAlong tables_;
  std::size_t position_ = 0;
  std::optional<steps::Step> step_;
  std::uint64_t hash_;  // of the document's mesh
};

// Begins to play in place of what is played.
Outcome begin_playing(const Document& document, ViewState& view, Framing& framing, Shown& shown,
                      std::span<const std::string> words);
void end_playing(ViewState& view, Framing& framing, Shown& shown);
// The same as somebody asks for it, told.
Outcome leave_playing(ViewState& view, Framing& framing, Shown& shown);

// Looks from where somebody looked before it was played.
void look_as_before(ViewState& view, Framing& framing, const Player& player);
Text end_of(const Player& player);

}  // namespace ryosen
