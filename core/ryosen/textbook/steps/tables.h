// The tables that steps write, as they stand behind a step: what is played fills them.
#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "ryosen/textbook/steps/sequence.h"

namespace ryosen::steps {

// Numbers within names count as numbers: h2 comes before h10.
struct NaturalLess {
  bool operator()(std::string_view a, std::string_view b) const;
};

class Tables {
 public:
  using Fields =
      std::vector<std::pair<std::string, std::string>>;  // in the order in which they came; none without value
  using Rows = std::map<std::string, Fields, NaturalLess>;

  // A field that gets no value goes, and a row without fields with it.
  void apply(const std::vector<RowChange>& changes);
  const std::map<std::string, Rows>& all() const { return tables_; }
  // Empty where nothing was written.
  const Rows& rows_of(const std::string& table) const;

  friend bool operator==(const Tables&, const Tables&) = default;

 private:
  std::map<std::string, Rows> tables_;
};

// Those of a sequence, which must outlive this. Keeps a copy every so many steps, so that going back costs no more than
// that many.
class TablesAlong {
 public:
  static constexpr std::size_t keyframe_steps = 256;

  explicit TablesAlong(Sequence& sequence) : sequence_(sequence), keyframes_(1) {}

  // In state i, 0 <= i <= size(); valid until the next call.
  const Tables& at(std::size_t i);

 private:
  Sequence& sequence_;
  std::vector<Tables> keyframes_;  // in state keyframe_steps * k
  Tables current_;
  std::size_t position_ = 0;
};

}  // namespace ryosen::steps
