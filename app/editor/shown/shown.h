// Which mesh the view shows: that of the document or, on trial in its place, another one. Only this class begins and
// ends trials of an open document.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "ryosen/algo/algorithm.h"
#include "ryosen/analysis/problem_kinds.h"
#include "ryosen/analysis/self_intersections.h"
#include "ryosen/base/element.h"
#include "ryosen/document/document.h"
#include "ryosen/scene/view/camera.h"

namespace ryosen {

class Player;
class Session;
class ShownLevels;

// The effect of a command, told by the call: with some words a command only tells something, with others it edits.
enum class Effect {
  view,      // nothing to the document; needs none of its elements
  reads,     // needs elements of the document
  begins,    // begins something that ends in an edit, or sends a line that has an effect of its own
  edits,     // an entry of the history
  steps,     // through the history
  replaces,  // another document takes its place: unsaved changes would be lost
  writes,    // the document to a file
};
inline constexpr std::size_t effect_count = 7;

// These go into the log, and end a gesture.
constexpr bool is_logged(Effect effect) { return effect >= Effect::edits; }

// Whose mesh the view shows.
enum class ShownBy {
  document,
  step,     // of what is played
  level,    // of detail
  preview,  // of values that are being written
  gesture,  // that makes something
};

// How the mesh in the place of the document's answers a command.
enum class Response {
  keep,     // it stays
  beneath,  // the view shows the document's from then on, until its owner shows this again
  again,    // the view shows the document's while the command runs
  anew,     // it is made again from the mesh behind the command, and lies beneath
  end,      // it ends first
  instead,  // it ends, and the command does nothing more
  refuse,   // the command is refused
};
// The table of owners and effects. A frontend without a view has a column of its own.
Response response(ShownBy owner, Effect effect, bool has_view = true);

class Shown {
 public:
  explicit Shown(Session& session) : session_(session) {}

  // The owner of the mesh that is on the screen.
  ShownBy by() const;
  // Whether that is the last that an owner has shown; also where it is the document's own mesh, as at a step that edits
  // nothing.
  bool shows(ShownBy owner) const;
  // Nothing of the document can be picked or selected.
  bool is_replaced() const { return by() != ShownBy::document && by() != ShownBy::gesture; }
  Response response(Effect effect) const { return ryosen::response(by(), effect, has_view); }
  // Why something cannot be done while the document's mesh is replaced.
  Outcome refusal() const;

  bool has_view = true;  // somebody looks at it; set by frontends

  // The steps that are played, or the levels of detail; null for none. They stay while the document's mesh is shown,
  // and fit as long as that is at the place of its history where they were begun.
  const std::shared_ptr<Player>& player() const { return player_; }
  const std::shared_ptr<ShownLevels>& levels() const { return levels_; }
  bool fits() const;
  void begin(std::shared_ptr<Player> player);
  void begin(std::shared_ptr<ShownLevels> levels);
  // Must fit.
  void go_to_step(std::size_t position);
  void go_to_level(std::size_t level);
  // Returns what was played.
  std::shared_ptr<Player> end_steps();
  void end_levels();

  // Shows the result of an operator or an algorithm for an owner, in place of what is on trial. None where it is
  // cancelled.
  Outcome try_out(ShownBy owner, const AnyOp& op);
  std::optional<EachResult> try_out(ShownBy owner, const OpInfo& op, std::span<const Element> elements,
                                    std::span<const std::string_view> arguments, Progress::Report progress = {});
  std::optional<AlgorithmResult> try_out(ShownBy owner, const AlgorithmRow& row, const ParameterValues& values,
                                         Progress::Report progress = {});
  // Ends what is on trial: the view shows the mesh of the document, with what of it was selected, hidden, measured and
  // found.
  void end();
  // Ends everything; another document comes, or memory has run out.
  void forget();

  // Around the run of a command line.
  class Passage {
   public:
    Passage(Shown& shown, Effect effect, std::string_view line);
    // The outcome where the line is not run; none where it is.
    std::optional<Outcome> answered;
    // Brings back what was played, or the levels, once the line has run, and says so. Without this call they end:
    // memory has run out.
    void finish(Outcome& outcome);

   private:
    void bring_back_steps(Outcome& outcome);
    void bring_back_level(Outcome& outcome);
    void show_beneath(Outcome& outcome);
    void make_anew(Outcome& outcome);

    Shown& shown_;
    Effect effect_;
    Camera camera_;
    std::shared_ptr<Player> player_;
    std::shared_ptr<ShownLevels> levels_;
    std::uint64_t serial_, revision_ = 0;  // of the document
    bool was_shown_ = false;
  };

  // Called by the session for each change of its document: keeps what names elements of the document while another mesh
  // is on trial, and gives it back.
  void set_aside();
  void bring_back();
  void forget_aside();

 private:
  Document& document() const;
  void show(ShownBy owner, MeshColumns columns);
  void note(ShownBy owner);

  Session& session_;
  std::shared_ptr<Player> player_;
  std::shared_ptr<ShownLevels> levels_;
  struct Place {
    std::uint64_t serial = 0;
    std::size_t position = 0;
  };
  Place begun_;  // of the player or the levels
  struct Last {
    ShownBy owner = ShownBy::document;
    std::uint64_t serial = 0, revision = 0;
  };
  Last last_;  // that an owner has shown
  struct Aside {
    Elements selection;
    std::vector<Elements> measures;
    Elements hidden;
    std::optional<ProblemKind> searched;
    std::vector<std::uint32_t> findings;
    std::vector<FacePair> pairs;
  };
  std::optional<Aside> aside_;
};

// The title of the view: the file, with a star where there are edits that are not saved, or what is played or a level
// of detail in its place, and beneath that the file: "Playing: A cube (beneath: * cube.obj)". Empty where there is
// nothing.
std::string shown_name(const Session& session, bool with_beneath = true);

}  // namespace ryosen
