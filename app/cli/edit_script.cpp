#include "app/cli/edit_script.h"

#include "app/cli/console.h"
#include "app/cli/outputs.h"
#include "app/editor/command_syntax.h"
#include "app/editor/commands.h"
#include "core/io/input_file.h"

namespace ryosen::cli {

namespace {

// Follows what a script reads and writes.
class FileUse {
 public:
  FileUse(const EditScript& script, const EditFiles& files)
      : files_(files), inputs_{files.input}, current_(files.input) {
    if (!script.file.empty()) inputs_.push_back(script.file);
  }

  std::optional<Failure> open(const std::string& path) {
    inputs_.push_back(path);
    current_ = path;
    return std::nullopt;
  }

  // Another document, of which it is not known here which file it has.
  std::optional<Failure> replace() {
    current_.clear();
    return std::nullopt;
  }

  std::optional<Failure> save(const std::string& path) {
    if (!path.empty()) current_ = path;
    return write(current_);
  }

  std::optional<Failure> write(const std::string& path) const {
    if (!files_.may_overwrite_input) {
      if (auto fault = fault_of_replacing(path, inputs_)) return fault;
    }
    return fault_of_output(path);
  }

 private:
  const EditFiles& files_;
  std::vector<std::string> inputs_;
  std::string current_;
};

std::optional<Failure> fault_of_line(const std::string& line, FileUse& use) {
  const auto call = call_of(line);
  if (auto fault = fault_of_command(line))
    return usage_failure(call ? Code("bad_arguments") : Code("unknown_command"), std::move(*fault));
  if (!call) return std::nullopt;
  if (call->row.file == FileAccess::reads_mesh) return use.open(file_of(*call));
  if (call->row.file == FileAccess::writes_mesh) return use.save(file_of(*call));
  return call->row.effect == Effect::replaces ? use.replace() : std::nullopt;
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

std::optional<Failure> find_fault(const EditScript& script, const EditFiles& files) {
  FileUse use(script, files);
  for (const ScriptLine& line : script.lines) {
    auto fault = fault_of_line(line.text, use);
    if (!fault) continue;
    if (fault->exit_code == ExitCode::usage) fault->message.line = line.line;
    return fault;
  }
  return files.output ? use.write(*files.output) : std::nullopt;
}

}  // namespace ryosen::cli
