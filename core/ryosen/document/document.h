// An open mesh with its history. Every change goes through here, as one history entry each.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "ryosen/algo/repair/recipe.h"
#include "ryosen/document/outcome.h"
#include "ryosen/indexed/to_indexed.h"
#include "ryosen/io/file_state.h"
#include "ryosen/io/formats.h"
#include "ryosen/mesh/journal.h"
#include "ryosen/ops/each.h"
#include "ryosen/ops/preview/preview.h"
#include "ryosen/ops/preview/remedy.h"

namespace ryosen {

struct HistoryEntry {
  std::string command;       // the equivalent script line
  bool has_normals = false;  // it gave the corners normals of the surface behind it
  Lineage lineage = Lineage::numbers;
  std::shared_ptr<const Descent> descent = {};  // where the lineage is told and was asked for
};

// What repairs look at beside the mesh; a copy, so that it can be read on another thread.
struct BesideRepairs {
  std::vector<QuarantinedFace> quarantine;
  std::vector<Vertex> used, used_but_by_quarantine, on_lines;
  std::optional<bool> holds_floats;

  RecipeInput input() const { return {quarantine, used, used_but_by_quarantine, on_lines, holds_floats}; }
};

class Document {
 public:
  // Empty, without a file.
  Document();
  static Result<std::unique_ptr<Document>> open(const std::filesystem::path& path);
  explicit Document(MeshFile file, std::filesystem::path path = {});

  // With what is on trial.
  const Mesh& mesh() const { return mesh_; }
  const Journal& journal() const { return journal_; }
  // Data of the file (comments, libraries, messages), and its per-element tables (names, lines, quarantine). The mesh
  // itself has been moved out.
  const MeshFile& file() const { return file_; }
  const FileTables& tables() const { return tables_; }
  const std::filesystem::path& path() const { return path_; }

  // Applies an operator as one entry of the history. Refused: nothing changes. strict: warnings refuse too. `command`
  // is its line where that has been printed.
  Outcome apply(const AnyOp& op, bool strict = false, std::string command = {});
  // Applies an operator to each of these elements (see each.h) as one entry of the history, or none where nothing was
  // done. None where `progress` cancels it.
  std::optional<EachResult> apply_to_each(const OpInfo& op, std::span<const Element> elements,
                                          std::span<const std::string_view> arguments, std::string command, bool strict,
                                          Progress::Report progress = {});
  // Runs an algorithm as one entry of the history, which this command line does again, or none where it changes
  // nothing. None where `progress` cancels it: nothing has changed then. The values are those on this mesh.
  std::optional<AlgorithmResult> run(const AlgorithmRow& row, const ParameterValues& values, std::string command,
                                     Progress::Report progress = {}, AlgorithmWants wants = {});
  // What that would report of its goal where it began with the mesh that the last entry of the history began with, or
  // of the document's where another is on trial. Nothing changes. None where it is cancelled or the values do not fit.
  std::optional<AlgorithmResult> goal_report_of(const AlgorithmRow& row, const ParameterValues& values,
                                                Progress::Report progress = {});
  // The same for a recipe, whatever its rounds: one entry of the history or none. The result comes without
  // its mesh, which is that of the document.
  std::optional<RecipeResult> run(std::span<const RecipeStep> recipe, std::string command,
                                  const RecipeEvents& events = {});
  BesideRepairs beside_repairs() const;
  // Adds the mesh of a file as parts of their own, as one entry of the history. The sentence says what of the file was
  // left out: what belongs to corners and faces, lines, and faces that cannot be used; empty where nothing was.
  Text append(MeshFile file, std::string command);
  // Adds an attribute without values, of which every element has the default, as one entry of the history. Refused
  // where its name is taken or one of the program's own. `command` is the line where that has been written.
  Outcome add_attribute(AttributeColumn column, std::string command = {});
  // Removes one, likewise.
  Outcome remove_attribute(std::string_view name, std::string command = {});
  // Gives elements a value, as words of the attribute's type: a point with all its copies, an edge with all its sheets,
  // of a face or vertex all its corners. Elements of other kinds are passed over; refused where all are. No entry where
  // all have that value.
  Outcome set_attribute(std::string_view name, std::span<const Element> elements, std::span<const std::uint32_t> value,
                        std::string command);
  // What part_of() takes of these elements, as a file of its own. Nothing is on trial.
  MeshFile part(std::span<const Element> elements) const;
  // The verdict and the ghost of the result, on the mesh with what is on trial. The document is unchanged.
  Preview preview(const AnyOp& op) { return ryosen::preview(touchable(), journal_, op); }
  // Script lines after which the refused operator of `line` is legal; empty if none were found.
  std::vector<std::string> remedy(const std::string& line) { return RemedySearch(touchable()).find(line); }

  // Does an operator on trial, beside the history: until the next change, or until the trial is ended, the mesh is as
  // if it had been applied. Undo, redo and what is saved stay as they are.
  Outcome try_out(const AnyOp& op);
  // The same with an operator on each of these elements (each.h); nothing is on trial where nothing was done. None
  // where it is cancelled.
  std::optional<EachResult> try_out(const OpInfo& op, std::span<const Element> elements,
                                    std::span<const std::string_view> arguments, Progress::Report progress = {});
  // The same with an algorithm; nothing is on trial where it changes nothing. None where it is cancelled.
  std::optional<AlgorithmResult> try_out(const AlgorithmRow& row, const ParameterValues& values,
                                         Progress::Report progress = {});
  // The same with any other mesh, whole.
  void show_on_trial(MeshColumns columns);
  bool is_on_trial() const { return trial_.position() > 0; }
  void end_trial();

  // Step through the history; false if there is nothing to undo or redo.
  bool undo();
  bool redo();
  // Goes to a position in the history; 0 is the file as read.
  void go_to(std::size_t position);
  // Goes back to the position at which a command began that has found no memory, and forgets what it has added to the
  // history. Ends a trial, of which no listener is told. Allocates nothing itself.
  void take_back(std::size_t position);
  const std::vector<HistoryEntry>& history() const { return history_; }
  std::size_t position() const { return journal_.position(); }

  // Whether arguments that name no element (with this error) name one that exists at another position of the history:
  // then the outcome is a refusal, not a usage error. A quarantined face exists at no position. O(history).
  enum class Elsewhere { no, earlier, later };  // earlier: undo restores it; later: redo does
  Elsewhere exists_elsewhere(NameError error, std::span<const std::string_view> arguments);
  // If arguments name a quarantined face: the sentence about it.
  std::optional<Text> quarantine_text(std::span<const std::string_view> arguments) const;

  // Whether the file is another one than was read or saved; never where the document has none. Reads it once for each
  // change of its times.
  FileState::Change change_on_disk() { return on_disk_.follow(path_); }
  // The state of the file when it was last read or saved; with its content, which is read when it is first asked for.
  const FileState& known_file() const { return on_disk_; }
  const FileState& known_file_with_content() const {
    on_disk_.learn_content(path_);
    return on_disk_;
  }
  void know_file_as(FileState state) { on_disk_ = state; }
  // Takes the file as it is for that from now on, so that the next save may replace it.
  void take_file_as_known() { on_disk_ = FileState::of(path_); }
  bool is_modified() const {
    return saved_position_ != position() && !(path_.empty() && position() <= held_.in_history);
  }
  // How many edits lie between the mesh and what is saved; none where no position of the history is.
  std::optional<std::size_t> unsaved_edits() const;
  // Marks every history position as unsaved.
  void mark_unsaved();
  // The file holds what the mesh is now, though it may have been changed since (see mark_unsaved).
  void mark_saved() { held_ = {position(), position()}; }
  // The program itself has made all that there is so far, and can make it again: as long as there is no file nobody
  // would miss it, also where some of it is undone.
  void mark_generated() { mark_saved(); }
  // What the mesh and its file do not have in common, in entries of the history.
  struct Unsaved {
    std::size_t edits = 0;   // done, and not in the file
    std::size_t undone = 0;  // or done otherwise since, and in the file
    bool operator==(const Unsaved&) const = default;
  };
  Unsaved unsaved() const;
  // The document as it would be written: all live elements and the data of the file; never what is on trial.
  MeshFile contents() const;
  // The document as it was read, before its first edit. O(mesh + history).
  MeshFile contents_as_read() const;
  // What writing to a file of this name would lose, and which removed elements it would still contain, one warning
  // each; empty if the extension is unknown.
  std::vector<Message> losses(const std::filesystem::path& path) const;
  // An empty path means the file that was opened. A pipe or device (see is_stream) gets the format of that file where
  // its name says none; it does not become the document's file, which stays unsaved.
  Status save(const std::filesystem::path& path, WriteOptions options = {});

  // Called after every commit, undo and redo, with the transaction concerned, of journal() or of a trial. Must not
  // throw.
  enum class Change { made, undone, redone, tried, trial_ended };
  using Listener = std::function<void(const Journal& journal, std::size_t transaction, Change change)>;
  void add_listener(Listener listener) { listeners_.push_back(std::move(listener)); }
  // Called before the mesh is touched, though it be as it was behind a preview: for whoever reads it on another thread.
  std::function<void()> before_writing;
  // Increases with every change, including undo and redo.
  std::uint64_t revision() const { return revision_; }
  // Unique among the documents opened by this process; never 0.
  std::uint64_t serial() const { return serial_; }

 private:
  Mesh without_trial() const;
  Mesh before_last_entry();
  Mesh& touchable() {
    if (before_writing) before_writing();
    return mesh_;
  }
  Mesh& writable() {
    end_trial();
    return touchable();
  }
  Outcome refuse(const std::string& command, std::vector<Reason> reasons);
  // An algorithm in an edit of this mesh, with what it has to know of the file.
  AlgorithmResult run_in(Edit& edit, const AlgorithmRow& row, const ParameterValues& values, AlgorithmWants wants,
                         Progress& progress) const;
  using OtherQuarantine = std::map<std::size_t, std::vector<QuarantinedFace>>;  // by transaction

  // So that committed() finds room for one entry more.
  void make_room_in_history();
  // Records that the open edit has become the last transaction, with the new quarantine if it changed. Allocates
  // nothing.
  void committed(HistoryEntry entry, OtherQuarantine other = {});
  // Swaps the quarantine with the stored one, for transactions that change it.
  void exchange_quarantine(std::size_t transaction);
  void notify(const Journal& journal, std::size_t transaction, Change change);
  bool is_known(std::string_view name) const;
  bool are_known(std::span<const std::string_view> names) const;

  Mesh mesh_;
  Journal journal_;
  Journal trial_;  // one transaction while there is a trial, else none
  MeshFile file_;
  FileTables tables_;
  std::filesystem::path path_;
  mutable FileState on_disk_;  // learns its content later
  std::vector<HistoryEntry> history_;
  OtherQuarantine other_quarantine_;
  std::size_t saved_position_ = 0;
  // How many entries the file holds, and how many of them, the first ones, the history still has.
  struct Held {
    std::size_t entries = 0, in_history = 0;
  };
  Held held_;
  std::uint64_t revision_ = 0;
  std::uint64_t serial_;
  std::vector<Listener> listeners_;
};

}  // namespace ryosen
