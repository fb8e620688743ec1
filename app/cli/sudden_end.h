// Sudden ends of the program, and what it says then: interrupts, requests to terminate and the end of the terminal
// (INT, TERM, HUP), and a lack of memory where nothing can be thrown. The sentences are ready before anything begins,
// since nothing can be composed within a signal handler or without memory.
#pragma once

#include <optional>
#include <string_view>

#include "app/cli/console.h"

namespace ryosen::cli {

enum class LastWords { cancelled, cancelled_after_writing, stream_cut, window_ended, report_cut, out_of_memory };

// Composes them for this run, about this file where there is one; `has_goal`: why it stopped is told, too. Before, they
// are in English and not JSON.
void prepare_last_words(const Console& console, std::optional<std::string_view> file, bool has_goal);

// Writes the line on stderr and, with --json and `may_print`, its object on stdout. Allocates nothing, and may be
// called within a signal handler. Returns the exit code.
ExitCode say_last_words(LastWords words, bool may_print) noexcept;

// The run has said its last, whose exit code this is; prepare_last_words() takes it back.
void note_conclusion(ExitCode code) noexcept;
std::optional<ExitCode> conclusion() noexcept;

// From here on such a signal ends the program within 0.2 s, wherever it is at work: what it had begun to write is
// removed, the last words are said, and the exit code is 8. Once an output has its name the run goes on to its report
// and its own exit code, for at most as long. A signal that is ignored stays ignored. For main() alone: it concerns the
// process. They are held back until let_signals_in().
void answer_signals();

// The language and the kind of output are known, so that a signal can be answered; one that came before is now.
void let_signals_in();

// From here on a lack of memory that cannot be thrown further (in a destructor, through a driver) ends the program with
// its last words and code 10, not by a signal. For main().
void answer_lack_of_memory();

// More is to be done behind an output that is written, so that a signal cancels again.
void begin_another_step();

// The run is a window, which has no result to wait for: a signal ends it at any time.
void end_window_by_signals();

}  // namespace ryosen::cli
