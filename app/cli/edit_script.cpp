#include "app/cli/edit_script.h"

#include "app/cli/console.h"
#include "app/cli/outputs.h"
#include "app/editor/commands/command_syntax.h"
#include "app/editor/commands/commands.h"
#include "ryosen/io/file_target.h"
#include "ryosen/io/input_file.h"

namespace ryosen::cli {

namespace {

// Follows what a script reads and writes.
class FileUse {
 public:
  FileUse(const std::string& input, RunFiles& files) : files_(files), current_(input) {}

  std::optional<Failure> open(const std::string& path) {
    files_.begin_document();
    files_.reads(path, FileRole::mesh);
    current_ = path;
    return std::nullopt;
  }

  std::optional<Failure> read(const std::string& path) {
    files_.reads(path, FileRole::mesh);
    return std::nullopt;
  }

  // Another document, of which it is not known here which file it has.
  std::optional<Failure> begin_another() {
    files_.begin_document();
    current_.clear();
    return std::nullopt;
  }

  std::optional<Failure> save(const std::string& path) {
    if (!path.empty() && !is_stream(path)) current_ = path;
    const std::string& target = path.empty() ? current_ : path;
    if (!target.empty()) return write({target, FileRole::saved});
    return usage_failure("bad_arguments", {"save needs a file name here: the document has none that is known before.",
                                           "save にはファイル名が必要です（文書のファイルが事前に決まりません）。"});
  }

  // A picture without a name takes a free one.
  std::optional<Failure> shoot(const std::string& path) {
    return path.empty() ? std::nullopt : write({path, FileRole::picture});
  }

  std::optional<Failure> write(const PlannedOutput& output) {
    if (Status may = files_.may_write(output.path, output.role); !may) return may.failure();
    files_.writes(output.path, output.role);
    const bool is_mesh = output.role == FileRole::saved || output.role == FileRole::result;
    return is_mesh ? fault_of_output(output.path, !current_.empty()) : std::nullopt;
  }

 private:
  RunFiles& files_;
  std::string current_;  // the document's file; empty where it is not known
};

std::optional<Failure> fault_of_line(const std::string& line, FileUse& use) {
  const auto call = call_of(line);
  if (auto fault = fault_of_command(line))
    return usage_failure(call ? Code("bad_arguments") : Code("unknown_command"), std::move(*fault));
  if (!call) return std::nullopt;
  const FileAccess file = call->row->file;
  if (file == FileAccess::reads)
    return call->effect == Effect::replaces ? use.open(file_of(*call)) : use.read(file_of(*call));
  if (file == FileAccess::writes_part) return use.write({file_of(*call), FileRole::saved});
  if (file == FileAccess::writes)
    return call->effect == Effect::writes ? use.save(file_of(*call)) : use.shoot(file_of(*call));
  return call->effect == Effect::replaces ? use.begin_another() : std::nullopt;
}

}  // namespace

Result<EditScript> read_edit_script(const std::string* script_file, const std::vector<std::string>& lines) {
  if ((script_file != nullptr) == !lines.empty())
    return usage_failure("usage", {"edit needs either --do (once or more) or --script.",
                                   "edit には --do（複数可）か --script の一方を指定してください。"});
  EditScript script;
  std::string text;
  for (const std::string& line : lines) text += line + "\n";
  if (script_file) {
    const Result<FileBytes> bytes = read_whole_file(*script_file);
    if (!bytes) return bytes.failure();
    script.file = *script_file;
    text = bytes->view();
  }
  script.lines = split_script(text);
  return script;
}

std::optional<Failure> find_fault(const EditScript& script, const std::string& input,
                                  const std::vector<PlannedOutput>& outputs, RunFiles& files) {
  FileUse use(input, files);
  for (const ScriptLine& line : script.lines) {
    auto fault = fault_of_line(line.text, use);
    if (!fault) continue;
    fault->message.line = line.line;
    return fault;
  }
  for (const PlannedOutput& output : outputs)
    if (auto fault = use.write(output)) return fault;
  return std::nullopt;
}

}  // namespace ryosen::cli
