// The editor state without window and rendering: document, selection, visibility, camera, hover. The window, the
// command line, scripts and tests all change it through the same command lines.
#pragma once

#include <algorithm>
#include <functional>
#include <memory>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <vector>

#include "app/editor/camera/view_state.h"
#include "app/editor/commands/text/command.h"
#include "app/editor/document/findings.h"
#include "app/editor/document/repair_trials.h"
#include "app/editor/document/run_files.h"
#include "app/editor/preferences/layout.h"
#include "app/editor/preferences/preference_values.h"
#include "app/editor/recovery/recovery.h"
#include "app/editor/session/asked_question.h"
#include "app/editor/session/frontend.h"
#include "app/editor/session/pointing.h"
#include "app/editor/session/selecting.h"
#include "app/editor/session/session_camera.h"
#include "app/editor/shown/gesturing.h"
#include "app/editor/shown/shown.h"
#include "app/editor/views/mesh_view.h"
#include "ryosen/document/document.h"

namespace ryosen {

class Input;

class Session {
 public:
  explicit Session(std::unique_ptr<Document> document);
  ~Session();

  Document& document() { return *open_.document; }
  const Document& document() const { return *open_.document; }
  const Mesh& mesh() const { return document().mesh(); }
  // All that follows from the mesh; replaced with the document.
  Findings& findings() { return *open_.findings; }
  const Findings& findings() const { return *open_.findings; }
  // What repairs would do.
  RepairTrials trials;

  // Executes a command (see commands.h) and logs its line if done. Never throws on user input.
  Outcome run(const Command& command);
  // What is carried out at the moment, by its name.
  Text at_work() const;
  // The command lines executed so far: a script that reproduces the state.
  const std::vector<std::string>& log() const { return log_; }

  // Which mesh the view shows.
  Shown shown{*this};

  // How the mesh is looked at. What stands below is made from it, in this order.
  ViewState view;
  Framing framing{*this, view};
  // Places the view in space in this rectangle of the picture; the left half of it where a mesh stands beside.
  void place_view(Size whole, glm::dvec2 origin);
  Selecting selecting{*this};
  Pointing pointing{*this, open_};
  Gesturing gesturing{*this};
  std::optional<AskedQuestion> asked_question;
  // User interface state changed by commands; stored without effect if there is no UI.
  Preferences preferences;
  Layout layout;
  std::vector<LostSession> lost;  // as `recover list` found them last

  // The mesh as the view shows it.
  SeenMesh seen();
  // Puts another mesh beside this one in the picture; null takes it away. Both are framed anew.
  void compare_with(std::unique_ptr<Document> other);
  // Null where there is none; looks as the view does at the moment.
  Compared* compared();
  bool is_comparing() const { return compared_ != nullptr; }
  // Until a file is open or somebody has asked for an empty mesh.
  bool is_at_start() const;
  // There is no mesh, and none is shown or read.
  bool is_empty() const;
  RunFiles files{RunFiles::Policy::by_kind};  // asked before a command writes; who runs scripts sets another policy
  Frontend frontend;
  // Where the events of scripts go.
  Input& input();

  // For windows, before each frame: goes on with what is found in the background.
  void prepare();

  // Whether the document's file has changed on disk, as it was last looked at: for windows, now and then, and before a
  // save. True where that is news.
  bool look_at_disk();
  FileState::Change change_on_disk() const { return change_on_disk_; }

  // Replaces the document; resets selection, hover and log.
  // `read_from` is the file that it was read from, where that is not its own: no output of the run takes its place.
  void set_document(std::unique_ptr<Document> document, std::optional<std::filesystem::path> read_from = {});
  // For titles: the name of the file, or that there is none; empty at the start.
  std::string document_name() const;

 private:
  friend class Shown;  // has what is found forgotten where memory runs out

  template <class Run>
  Outcome run_safely(Run run);  // undoes what a lack of memory left half done
  Outcome run_command(const Command& command);
  Outcome apply(const AnyOp& op, const std::string& line, std::uint64_t made_on);
  // The log has room for it.
  void log_line(Outcome& outcome, std::string line);
  // Updates what is derived from the mesh; forgets that where there is no memory for it.
  void follow(const Journal& journal, std::size_t transaction, Document::Change change);
  void update_derived(const Journal& journal, std::size_t transaction, Document::Change change);
  void forget_derived();
  void end_comparing();
  void forget_pointed();  // and what was put aside for a trial

  std::unique_ptr<Compared> compared_;
  OpenDocument open_;
  FileState::Change change_on_disk_ = FileState::Change::none;
  std::vector<std::string> log_;
  std::string running_;                // the first word of the line that is carried out
  std::size_t lines_logged_ = 0;       // in logs of earlier documents too
  std::unique_ptr<Input> view_input_;  // made when it is asked for
};

}  // namespace ryosen
