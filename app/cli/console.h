// Output of a command: results to stdout, messages to stderr, formatted as requested by the common flags.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "ryosen/base/message.h"
#include "ryosen/base/progress.h"
#include "ryosen/base/result.h"

namespace ryosen::cli {

// The language of the environment (LC_ALL, LC_MESSAGES, LANG).
Language language_of_environment();

// Makes text from files and file names safe for a terminal: control characters, those that turn the direction of
// writing, and bytes that are no UTF-8 become escapes (\x1b, \u202e); line ends and tabs stay.
std::string visible(std::string_view text);
// The same for what belongs on one line; there they become escapes too.
std::string visible_line(std::string_view text);

struct Console {
  Language language = Language::english;
  bool json = false;           // stdout carries JSON only, one object per line
  bool quiet = false;          // only errors on stderr
  bool verbose = false;        // nothing is shortened
  bool leaves_stdout = false;  // stdout is an output of the run: results go where messages go

  const std::string& text(const Text& t) const { return t.in(language); }
  std::string_view text(std::string_view en, std::string_view ja) const {
    return language == Language::japanese ? ja : en;
  }

  // Appends to stdout, or to what takes its place. Names of files go through visible_line() before, so that one that
  // holds a line end stays on its line; other control characters become escapes here.
  void print(std::string_view text) const;
  // The same, flushed immediately, also into a pipe.
  void print_now(std::string_view text) const;
  // Writes what is printed so far; false where any of it could not be written.
  static bool flush();
  // Prints the last of a run and flushes it, in one section: a signal comes before it and cancels, or behind it and
  // ends the program with this code, without a further word. False where any of what was printed could not be written.
  bool conclude(std::string_view text, ExitCode code) const;
  // The same as the end of a command, whose exit code it returns.
  ExitCode end(std::string_view text, ExitCode code = ExitCode::done) const {
    conclude(text, code);
    return code;
  }
  // A line on stderr, unless quiet.
  void note(const Text& text) const;
  // A message about a file, or about the command line if `file` is empty. Errors are shown even if quiet, infos only if
  // verbose.
  void show(const Message& message, std::string_view file = {}) const;
  // The line that show() writes about it, with its line end.
  std::string shown_line(const Message& message, std::string_view file) const;
  // Shows the failure and, with JSON, prints its error object, as the last of the run. Returns its exit code.
  ExitCode fail(const Failure& failure, std::optional<std::string_view> file = {}, std::string_view format = {}) const;
};

// A usage error.
Failure usage_failure(Code code, Text text);

// Shows on stderr, where that is a terminal and not quiet, how far `what` is. Never cancels: signals end the program.
Progress::Report report_on(const Console& console, std::string what);

}  // namespace ryosen::cli
