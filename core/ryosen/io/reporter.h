// Warnings of a reader, with a limit per kind, so that a malformed file cannot exhaust memory; and the faults for which
// it refuses a file, and at how many places.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "ryosen/base/message.h"
#include "ryosen/base/result.h"
#include "ryosen/mesh/attribute_text.h"

namespace ryosen {

// The place in a file that a message refers to; zero means not given (byte and face: see the flags).
struct FilePlace {
  std::uint64_t line = 0;    // from 1
  std::uint64_t column = 0;  // from 1, in bytes
  std::uint64_t byte = 0;    // from 0
  bool byte_given = false;
  std::uint64_t face = 0;  // from 0
  bool face_given = false;

  static FilePlace at_line(std::uint64_t line, std::uint64_t column = 0) { return {line, column}; }
  static FilePlace at_byte(std::uint64_t byte) { return {0, 0, byte, true}; }
  static FilePlace at_face(std::uint64_t face) { return {0, 0, 0, false, face, true}; }
};

Message make_message(Severity severity, Code code, Text text, FilePlace place = {});

// The failure for malformed content; exit code input_malformed.
Failure malformed(Code code, Text text, FilePlace place = {});

// A token for display in a sentence: quoted, truncated to 40 bytes, without control characters or invalid UTF-8.
std::string shown(std::string_view token);

// Counts of what a reader ignored.
struct LeftOut {
  // Lines not understood.
  std::uint64_t lines = 0;
  // Numbers and indices that are meaningless, and rounded numbers.
  std::uint64_t values = 0;
  // Lines or bytes after the end of the mesh.
  std::uint64_t rest = 0;
};

class Reporter {
 public:
  static constexpr std::size_t listed_per_code = 20;

  // Adds a warning; make_text is only called if the warning is listed.
  template <class MakeText>
  void warn(Code code, FilePlace place, MakeText&& text) {
    if (count(code) <= listed_per_code)
      messages_.push_back(make_message(Severity::warning, code, std::forward<MakeText>(text)(), place));
  }

  // Adds what is worth knowing and no fault; said once.
  void inform(Code code, FilePlace place, Text text) {
    messages_.push_back(make_message(Severity::info, code, std::move(text), place));
  }

  // Counts something that is ignored; there should also be a warning about it.
  void leave_out(std::uint64_t LeftOut::*what, std::uint64_t count = 1) { left_out_.*what += count; }
  const LeftOut& left_out() const { return left_out_; }

  bool is_empty() const { return counts_.empty(); }

  // The warnings in the order of the file, then per kind one sentence with the number of those not listed.
  std::vector<Message> take();

 private:
  std::size_t count(Code code);

  std::vector<Message> messages_;
  LeftOut left_out_;
  std::vector<std::pair<Code, std::size_t>> counts_;
};

// Keeps the first fault of a reader. Where that is a value that cannot be, the reader goes on without keeping anything,
// so that all such places are counted; where it is one that leaves nothing to go on with, the reader stops. Both return
// false, as what reads a piece does that has a fault.
class Faults {
 public:
  // A value that cannot be; `text` is a function that makes the sentence. Lines count once.
  template <class MakeText>
  bool add(Code code, FilePlace place, MakeText&& text) {
    if (!failure_) failure_ = malformed(code, std::forward<MakeText>(text)(), place);
    if (failure_->message.code == code) count(place);
    return false;
  }
  // Nothing behind this place can be read.
  bool stop(Failure failure) {
    if (!failure_) failure_ = std::move(failure);
    is_stopped_ = true;
    return false;
  }

  bool any() const { return failure_.has_value(); }
  bool is_stopped() const { return is_stopped_; }
  // The first fault, with the number of those like it and where the first of these are. There must be one.
  Failure take();

 private:
  static constexpr std::size_t most_named = 5;

  void count(FilePlace place);

  std::optional<Failure> failure_;
  std::array<std::uint64_t, most_named> named_{};  // lines, or bytes
  std::uint64_t count_ = 0, last_ = 0;
  bool is_stopped_ = false;
};

// The failure of a text file that holds NUL bytes, with the first of them and how many there are; none if there is
// none.
std::optional<Failure> refuse_nul_bytes(std::string_view bytes);

// What several readers say, in the same words.
Failure empty_file();
Failure too_many_corners(FilePlace place);
Text not_a_number(std::string_view word);
Text sentence_of(const WordFault& fault);
Text not_a_whole_number(std::string_view word);
Text not_a_finite_number(std::string_view word);
void warn_of_non_finite_vertex(Reporter& reporter, FilePlace place);
// Counts the values as left out.
void warn_of_extra_values(Reporter& reporter, FilePlace place);
// Where the mesh has no vertices or no faces.
void warn_of_missing_elements(Reporter& reporter, std::size_t vertices, std::size_t faces);

}  // namespace ryosen
