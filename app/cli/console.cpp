#include "app/cli/console.h"

#include <cstdio>
#include <cstdlib>

#include "app/cli/contract/json.h"
#include "app/cli/last_words.h"
#include "app/cli/visible.h"
#include "app/editor/texts/message_place.h"
#include "ryosen/base/uninterrupted.h"

namespace ryosen::cli {

Language language_of_environment() {
  for (const char* name : {"LC_ALL", "LC_MESSAGES", "LANG"}) {
    const char* const value = std::getenv(name);
    if (value && *value) return std::string_view(value).starts_with("ja") ? Language::japanese : Language::english;
  }
  return Language::english;
}

void Console::print(std::string_view text) const {
  const std::string shown = json ? std::string() : visible(text);  // JSON has escapes of its own
  const std::string_view bytes = json ? text : shown;
  const Uninterrupted section(Uninterrupted::Section::print);
  std::fwrite(bytes.data(), 1, bytes.size(), leaves_stdout ? stderr : stdout);
}

void Console::print_now(std::string_view text) const {
  print(text);
  flush();
}

bool Console::flush() {
  const Uninterrupted section(Uninterrupted::Section::print);
  return std::fflush(stdout) == 0 && !std::ferror(stdout);
}

bool Console::conclude(std::string_view text, ExitCode code) const {
  const Uninterrupted section(Uninterrupted::Section::print);
  print(text);
  if (!flush()) return false;
  note_conclusion(code);
  return true;
}

void Console::note(const Text& message) const {
  if (!quiet) std::fprintf(stderr, "%s\n", visible_line(text(message)).c_str());
}

void Console::show(const Message& message, std::string_view file) const {
  if (message.severity != Severity::error && quiet) return;
  if (message.severity == Severity::info && !verbose) return;
  std::fputs(shown_line(message, file).c_str(), stderr);
}

std::string Console::shown_line(const Message& message, std::string_view file) const {
  std::string line = place_in_file(message, file.empty() ? "ryosen" : file);
  line += message.severity == Severity::error     ? text(": error: ", "：エラー：")
          : message.severity == Severity::warning ? text(": warning: ", "：警告：")
                                                  : text(": note: ", "：備考：");
  return visible_line(line + text(place_in_content(message) + message.text)) + "\n";
}

ExitCode Console::fail(const Failure& failure, std::optional<std::string_view> file, std::string_view format) const {
  show(failure.message, file.value_or(std::string_view()));
  conclude(json ? line_of(error_object(failure.message, file, format)) : std::string(), failure.exit_code);
  return failure.exit_code;
}

Failure usage_failure(Code code, Text text) { return make_failure(ExitCode::usage, code, std::move(text)); }

}  // namespace ryosen::cli
