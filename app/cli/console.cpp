#include "app/cli/console.h"

#include <unistd.h>

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <cstdlib>

#include "app/cli/contract/json.h"
#include "app/cli/sudden_end.h"
#include "app/editor/texts/message_place.h"
#include "ryosen/base/uninterrupted.h"
#include "ryosen/base/utf8.h"

namespace ryosen::cli {

namespace {

std::uint32_t code_point(std::string_view character) {
  if (character.size() == 1) return static_cast<unsigned char>(character[0]);
  std::uint32_t code = static_cast<unsigned char>(character[0]) & (0x7fu >> character.size());
  for (const char c : character.substr(1)) code = code << 6 | (static_cast<unsigned char>(c) & 0x3fu);
  return code;
}

// A terminal would not show it at its place: a control character or one that changes the direction of writing.
bool is_control(std::uint32_t code) {
  const bool turns = code == 0x61c || code == 0x200e || code == 0x200f || (code >= 0x202a && code <= 0x202e) ||
                     (code >= 0x2066 && code <= 0x2069);
  const bool ends_line = code == 0x2028 || code == 0x2029;
  return code < 0x20 || (code >= 0x7f && code < 0xa0) || turns || ends_line;
}

std::string escaped(std::string_view text, std::string_view kept) {
  std::string out;
  out.reserve(text.size());
  while (!text.empty()) {
    const std::size_t length = utf8_length(text);
    const std::string_view character = text.substr(0, std::max<std::size_t>(length, 1));
    const std::uint32_t code = length == 0 ? static_cast<unsigned char>(text[0]) : code_point(character);
    if (length > 0 && (!is_control(code) || kept.find(character) != kept.npos)) {
      out += character;
    } else {
      char escape[8];
      std::snprintf(escape, sizeof escape, length > 1 ? "\\u%04x" : "\\x%02x", static_cast<unsigned>(code));
      out += escape;
    }
    text.remove_prefix(character.size());
  }
  return out;
}

}  // namespace

std::string visible(std::string_view text) { return escaped(text, "\n\t"); }

std::string visible_line(std::string_view text) { return escaped(text, {}); }

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
  return end(json ? line_of(error_object(failure.message, file, format)) : std::string(), failure.exit_code);
}

Failure usage_failure(Code code, Text text) { return make_failure(ExitCode::usage, code, std::move(text)); }

Progress::Report report_on(const Console& console, std::string what) {
  const bool is_shown = !console.quiet && ::isatty(STDERR_FILENO) == 1;
  return [is_shown, what = std::move(what)](double share) {
    if (is_shown) std::fprintf(stderr, "\r%s %3.0f %%\r", what.c_str(), 100 * share);
    return true;
  };
}

}  // namespace ryosen::cli
