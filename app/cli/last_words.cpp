#include "app/cli/last_words.h"

#include <poll.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cerrno>
#include <string>

#include "app/cli/contract/json.h"
#include "ryosen/algo/edge_rules.h"
#include "ryosen/base/resource_limits.h"

namespace ryosen::cli {
namespace {

struct LastWordsRow {
  LastWords words;
  ExitCode exit_code;
  Code code;
  std::string_view en, ja;
};

constexpr LastWordsRow last_words_rows[] = {
    {LastWords::cancelled, ExitCode::cancelled, "cancelled", "Cancelled; nothing is written.",
     "中止しました。何も書き出していません。"},
    {LastWords::cancelled_after_writing, ExitCode::cancelled, "cancelled",
     "Cancelled; what was written before stays as it is.", "中止しました。先に書き出したものはそのまま残ります。"},
    {LastWords::stream_cut, ExitCode::cancelled, "cancelled",
     "Cancelled; what was written to the pipe or device ends in the middle.",
     "中止しました。パイプまたは装置への書き出しは途中で終わっています。"},
    {LastWords::window_ended, ExitCode::cancelled, "cancelled",
     "The editor was ended; edits that are not saved are offered again at its next start.",
     "エディタが終了させられました。保存されていない編集は、次に起動したとき復元できます。"},
    {LastWords::report_cut, ExitCode::done, "cancelled", "The output is written; only the report on it was cut short.",
     "出力は書き出しましたが、その報告は途中で打ち切りました。"},
    {LastWords::out_of_memory, ExitCode::out_of_memory, "out_of_memory", out_of_memory_en, out_of_memory_ja},
};

struct PreparedLine {
  std::string on_stderr, on_stdout;
};
using PreparedLines = std::array<PreparedLine, std::size(last_words_rows)>;

std::atomic<const PreparedLines*> prepared_lines = nullptr;

std::atomic<int> concluding_code = -1;  // while nothing is concluded

Failure failure_of(const LastWordsRow& row) {
  return make_failure(row.exit_code, row.code, {std::string(row.en), std::string(row.ja)});
}

void write_whole(int descriptor, std::string_view bytes) noexcept {
  while (!bytes.empty()) {
    constexpr int patience_ms = 20;  // a full pipe whose reader sleeps is not waited for
    pollfd wanted{descriptor, POLLOUT, 0};
    const int ready = ::poll(&wanted, 1, patience_ms);
    if (ready < 0 && errno == EINTR) continue;
    if (ready <= 0) return;
    const ssize_t written = ::write(descriptor, bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) return;
    bytes.remove_prefix(static_cast<std::size_t>(written));
  }
}

}  // namespace

void prepare_last_words(const Console& console, std::optional<std::string_view> file, bool has_goal) {
  static PreparedLines& lines = *new PreparedLines;  // for ever: a signal may come at the very end
  prepared_lines = nullptr;
  concluding_code = -1;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const LastWordsRow& row = last_words_rows[i];
    const Message message = failure_of(row).message;
    PreparedLine& line = lines[i];
    line.on_stderr = console.shown_line(message, file.value_or(std::string_view()));
    line.on_stdout.clear();
    if (!console.json || row.exit_code == ExitCode::done) continue;
    Json object = error_object(message, file);
    if (has_goal && row.exit_code == ExitCode::cancelled) object["stopped"] = id_of(Stop::cancelled);
    line.on_stdout = line_of(object);
  }
  prepared_lines = &lines;
}

ExitCode say_last_words(LastWords words, bool may_print) noexcept {
  const LastWordsRow& row = last_words_rows[static_cast<std::size_t>(words)];
  if (const PreparedLines* const lines = prepared_lines) {
    const PreparedLine& line = (*lines)[static_cast<std::size_t>(words)];
    if (may_print) write_whole(STDOUT_FILENO, line.on_stdout);
    write_whole(STDERR_FILENO, line.on_stderr);
  } else {
    for (const std::string_view part : {std::string_view("ryosen: error: "), row.en, std::string_view("\n")})
      write_whole(STDERR_FILENO, part);
  }
  return row.exit_code;
}

void note_conclusion(ExitCode code) noexcept { concluding_code = static_cast<int>(code); }

std::optional<ExitCode> conclusion() noexcept {
  const int code = concluding_code;
  return code < 0 ? std::nullopt : std::optional(static_cast<ExitCode>(code));
}

}  // namespace ryosen::cli
