// Playing something step by step (ryosen/textbook/steps) by the words that call it, as "collapse 0-1" or "script cube".
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "app/editor/shown/player.h"
#include "ryosen/document/document.h"
#include "ryosen/textbook/steps/all.h"
#include "ryosen/textbook/steps/tables.h"

namespace ryosen {

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

// Goes through a sequence.
class StepsPlayer final : public Player {
 public:
  // `words` call the sequence; the mesh is that of the document.
  StepsPlayer(std::vector<std::string> words, std::unique_ptr<steps::Sequence> sequence, const Mesh& mesh);

  const std::string& call() const override { return call_; }
  Text name() const override { return name_of_played(words_); }
  std::size_t size() const override { return sequence_->size(); }
  Text caption() const override { return step_ ? step_->caption : name(); }
  std::vector<Mark> marks() const override;
  bool edits() const override { return sequence_->edits(); }
  const Mesh* other_mesh() const override;
  bool begins_with_nothing() const override { return sequence_->edits() && sequence_->mesh_at(0).live().vertices == 0; }
  Result<std::shared_ptr<Player>> again(const Document& document) const override;

  // The step that leads to the position; null before the first one.
  const steps::Step* step() const { return step_ ? &*step_ : nullptr; }
  Text remark() const { return sequence_->remark(); }
  std::optional<steps::Curve> curve() const { return sequence_->curve(); }
  // Of very many steps there is none: all steps before would have to be made.
  bool has_tables() const { return sequence_->size() <= most_with_tables; }
  // As all steps up to the position have filled them.
  const steps::Tables& tables() { return tables_.at(position()); }
  static constexpr std::size_t most_with_tables = 5000;

 private:
  void take_step() override;

  std::vector<std::string> words_;
  std::string call_;  // these as one line
  std::unique_ptr<steps::Sequence> sequence_;
  steps::TablesAlong tables_;
  std::optional<steps::Step> step_;
  std::uint64_t hash_;  // of the document's mesh
};

// Before the first of the steps that the words call.
Result<std::shared_ptr<Player>> make_player(const Document& document, std::span<const std::string> words);
// Plays these in place of what is played.
Outcome begin_playing(const Document& document, ViewState& view, Framing& framing, Shown& shown,
                      std::span<const std::string> words);
// The player of the view; null where it plays nothing of the source texts.
std::shared_ptr<StepsPlayer> steps_player(const Shown& shown);

}  // namespace ryosen
