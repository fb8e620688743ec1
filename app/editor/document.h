// An open mesh with its history: every change goes through here, as an operator that is one entry of the history.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/algo/algorithms.h"
#include "core/indexed/to_indexed.h"
#include "core/io/formats.h"
#include "core/mesh/touched.h"
#include "core/ops/outlook/preview.h"
#include "core/ops/outlook/remedy.h"

namespace ryosen {

// How an operator or a command went.
struct Outcome {
  enum class Kind { done, refused, failed };
  Kind kind = Kind::done;
  ExitCode exit_code = ExitCode::done;
  // For refused and failed: names the element and the remedy. For done: what should be known of it, mostly nothing.
  Text sentence;
  // The script line of what was done to the mesh or a file, also where it is there and yet failed (a file that may not
  // survive a power cut); empty where nothing was.
  std::string performed;
  std::vector<Reason> reasons;
  std::vector<Reason> warnings;
  std::vector<std::string> created;  // names, as of after the operator
  std::vector<std::string> deleted;  // names, as of before it

  bool done() const { return kind == Kind::done; }
  // One sentence more.
  void say(const Text& more);
};

struct HistoryEntry {
  std::string command;  // the script line that does the same
};

class Document {
 public:
  // Empty, without a file.
  Document();
  static Result<std::unique_ptr<Document>> open(const std::filesystem::path& path);
  explicit Document(MeshFile file, std::filesystem::path path = {});

  const Mesh& mesh() const { return mesh_; }
  const Journal& journal() const { return journal_; }
  // What belongs to the file (comments, libraries, messages), and the tables that go with its numbers (names, lines,
  // quarantine). The mesh of the file has been taken out.
  const MeshFile& file() const { return file_; }
  const FileTables& tables() const { return tables_; }
  const std::filesystem::path& path() const { return path_; }

  // Applies an operator as one entry of the history. Refused: nothing changes. strict: warnings refuse too.
  Outcome apply(const AnyOp& op, bool strict = false);
  // Runs an algorithm as one entry of the history, which this command line does again, or none where it changes nothing.
  // None where `progress` cancels it: nothing has changed then. The values are those on this mesh.
  std::optional<AlgorithmResult> run(const AlgorithmRow& row, const ParameterValues& values, std::string command,
                                     Progress::Report progress = {});
  // The verdict, and the ghost of the result. The document is unchanged.
  Preview preview(const AnyOp& op) { return ryosen::preview(mesh_, journal_, op); }
  // Script lines after which the refused operator that `line` says is legal; empty where none were found.
  std::vector<std::string> remedy(const std::string& line) { return RemedySearch(mesh_).find(line); }

  // Step through the history; false where there is nothing to undo or redo.
  bool undo();
  bool redo();
  // Goes to a place in the history: 0 is the file as it was read.
  void go_to(std::size_t position);
  const std::vector<HistoryEntry>& history() const { return history_; }
  std::size_t position() const { return journal_.position(); }

  // Whether arguments that name no element (with this error) speak of one that another place of the history has: the
  // answer is then a refusal, not a slip of the pen. A face that was set aside when the file was read is in none.
  // O(history).
  enum class Elsewhere { no, earlier, later };  // undo brings an earlier one back, redo a later one
  Elsewhere exists_elsewhere(NameError error, std::span<const std::string_view> arguments);
  // When arguments name a face that was set aside: the sentence about it.
  std::optional<Text> set_aside(std::span<const std::string_view> arguments) const;

  bool is_modified() const { return saved_position_ != journal_.position(); }
  // No place of the history is that of a file.
  void mark_unsaved() { saved_position_ = no_index; }
  // The document as it would be written: all live elements and what belongs to the file.
  MeshFile contents() const;
  // What a file of this name would lose of the document, and what it would keep of what was removed, one warning each;
  // none where the name says no format.
  std::vector<Message> losses(const std::filesystem::path& path) const;
  // An empty path means the file that was opened. A pipe or device (see is_stream) gets the format of that file where
  // its name says none; it does not become the document's file, which stays unsaved.
  Status save(const std::filesystem::path& path, WriteOptions options = {});

  // Called after every commit, undo and redo, with the transaction of journal() that it was about.
  using Listener = std::function<void(std::size_t transaction)>;
  void add_listener(Listener listener) { listeners_.push_back(std::move(listener)); }
  // Grows with every change, also by undo and redo.
  std::uint64_t revision() const { return revision_; }
  // Different for every document that this process opens; never 0.
  std::uint64_t serial() const { return serial_; }

 private:
  Outcome refuse(const AnyOp& op, std::vector<Reason> reasons);
  // The open edit has become the last transaction; with it these faces are set aside, where that changes.
  void committed(std::string command, std::optional<std::vector<QuarantinedFace>> quarantine = {});
  // The faces set aside are others before and after some transactions.
  void exchange_quarantine(std::size_t transaction);
  void notify(std::size_t transaction);
  const Format* format_for(const std::filesystem::path& path) const;
  bool is_known(std::string_view name) const;
  bool are_known(std::span<const std::string_view> names) const;

  Mesh mesh_;
  Journal journal_;
  MeshFile file_;
  FileTables tables_;
  std::filesystem::path path_;
  std::vector<HistoryEntry> history_;
  std::map<std::size_t, std::vector<QuarantinedFace>> other_quarantine_;  // by transaction
  std::size_t saved_position_ = 0;
  std::uint64_t revision_ = 0;
  std::uint64_t serial_;
  std::vector<Listener> listeners_;
};

// The sentence of a reason with its witnesses named: "... (v7, 5-9)".
Text describe(const Mesh& mesh, const Reason& reason);
std::vector<std::string> names_of(const Mesh& mesh, const std::vector<Element>& elements);

}  // namespace ryosen
