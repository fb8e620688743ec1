// The effect of a command, told by the call: with some words a command only tells something, with others it edits.
#pragma once

#include <cstddef>

namespace ryosen {

enum class Effect {
  view,      // nothing to the document; needs none of its elements
  reads,     // needs elements of the document
  begins,    // begins something that ends in an edit, or sends a line that has an effect of its own
  edits,     // an entry of the history
  steps,     // through the history
  replaces,  // another document takes its place: unsaved changes would be lost
  writes,    // the document to a file
};
inline constexpr std::size_t effect_count = 7;

// These go into the log, and end a gesture.
constexpr bool is_logged(Effect effect) { return effect >= Effect::edits; }

}  // namespace ryosen
