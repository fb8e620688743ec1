#include "app/cli/edit_script.h"

#include <algorithm>
#include <filesystem>

#include "app/cli/console.h"
#include "app/editor/commands.h"
#include "app/editor/keys.h"
#include "app/editor/words.h"
#include "core/io/formats.h"
#include "core/io/input_file.h"

namespace ryosen::cli {

namespace {

bool is_same_file(const std::string& a, const std::string& b) {
  std::error_code error;
  return std::filesystem::equivalent(a, b, error);
}

std::optional<Failure> fault_of_output(const std::string& path) {
  const Format* const format = format_of_extension(path);
  if (format && format->write) return std::nullopt;
  return usage_failure("unknown_format",
                       {"The name " + path + " does not say in which format to write (see ryosen formats).",
                        "ファイル名 " + path + " からは、書き出す形式が決まりません（ryosen formats を参照）。"});
}

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

  std::optional<Failure> save(const std::string& path) {
    if (!path.empty()) current_ = path;
    return write(current_);
  }

  std::optional<Failure> write(const std::string& path) const {
    const bool is_input = std::any_of(inputs_.begin(), inputs_.end(),
                                      [&](const std::string& input) { return is_same_file(input, path); });
    if (!is_input || files_.may_overwrite_input) return fault_of_output(path);
    Failure failure;
    failure.exit_code = ExitCode::output_not_writable;
    failure.message.code = "input_would_be_replaced";
    failure.message.text = {path + " is an input; --overwrite allows to replace it.",
                            path + " は入力ファイルです。置き換えるには --overwrite を指定してください。"};
    return failure;
  }

 private:
  const EditFiles& files_;
  std::vector<std::string> inputs_;
  std::string current_;
};

std::optional<Failure> fault_of_line(const std::string& line, FileUse& use) {
  const std::string word = line.substr(0, line.find_first_of(" \t\r"));
  if (!find_op(word) && !ryosen::find_command(word))
    return usage_failure("unknown_command", unknown_command(word).sentence);
  if (word == "open") return use.open(file_name(behind_word(line)));
  if (word == "save") return use.save(file_name(behind_word(line)));
  const KeyRow* const key = word == "key" ? find_key(behind_word(line)) : nullptr;
  return key ? fault_of_line(std::string(key->command), use) : std::nullopt;
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
