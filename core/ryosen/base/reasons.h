// The table of rules: why an operator is refused or warned about, and the remedy, in both languages. Its rows stand in
// rules.def.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

namespace ryosen {

enum class Rule : std::uint8_t {
#define RYOSEN_RULE(id, severity, operators, en, ja, remedy_en, remedy_ja) id,
#include "ryosen/base/rules.def"
#undef RYOSEN_RULE
};

enum class RuleSeverity : std::uint8_t { refuse, warn };

struct RuleText {
  Rule rule;
  std::string_view id;  // as in JSON and scripts
  RuleSeverity severity;
  std::string_view operators;  // ids, separated by spaces; empty: all operators
  std::string_view en;         // one sentence; the witnesses are appended
  std::string_view ja;
  std::string_view remedy_en;  // what would make it legal, or why nothing would
  std::string_view remedy_ja;
};

std::span<const RuleText> rule_table();
const RuleText& text_of(Rule rule);

}  // namespace ryosen
