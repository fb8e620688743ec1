// The return type of what can fail for external reasons: a value, or a failure with its exit code and message.
#pragma once

#include <utility>
#include <variant>

#include "ryosen/base/message.h"

namespace ryosen {

// The exit codes of the program; every failure carries one.
enum class ExitCode {
  done = 0,
  found_problems = 1,
  usage = 2,
  input_missing = 3,
  input_malformed = 4,
  output_not_writable = 5,
  refused = 6,
  no_backend = 7,
  cancelled = 8,
  some_inputs_failed = 9,
  out_of_memory = 10,
  internal_error = 70,
};

struct Failure {
  ExitCode exit_code = ExitCode::internal_error;
  Message message;
};

// One that no place in a file is to blame for.
inline Failure make_failure(ExitCode exit_code, Code code, Text text) {
  Failure failure{exit_code, {}};
  failure.message.code = code;
  failure.message.text = std::move(text);
  return failure;
}

// Either a T or a Failure. Cheap to move; reading the alternative it does not hold is a programming error (throws
// std::bad_variant_access).
template <class T>
class [[nodiscard]] Result {
 public:
  Result(T value) : state_(std::move(value)) {}
  Result(Failure failure) : state_(std::move(failure)) {}

  bool ok() const { return state_.index() == 0; }
  explicit operator bool() const { return ok(); }

  T& value() & { return std::get<0>(state_); }
  const T& value() const& { return std::get<0>(state_); }
  T&& value() && { return std::get<0>(std::move(state_)); }
  T& operator*() & { return value(); }
  const T& operator*() const& { return value(); }
  T* operator->() { return &value(); }
  const T* operator->() const { return &value(); }

  const Failure& failure() const& { return std::get<1>(state_); }
  Failure&& failure() && { return std::get<1>(std::move(state_)); }

 private:
  std::variant<T, Failure> state_;
};

struct Nothing {};
using Status = Result<Nothing>;
inline Status success() { return Status(Nothing{}); }

}  // namespace ryosen
