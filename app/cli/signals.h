// The answer to what ends the program at once: interrupts, requests to terminate and the end of the terminal (INT,
// TERM, HUP), and a lack of memory where nothing can be thrown.
#pragma once

namespace ryosen::cli {

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
