// What the program says when it must end at once: sentences that are ready before anything begins, since nothing can be
// composed within a signal handler or without memory.
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

}  // namespace ryosen::cli
