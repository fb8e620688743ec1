#include "ryosen/base/reasons.h"

#include <cstddef>

namespace ryosen {

namespace {

constexpr RuleText rules[] = {
#define RYOSEN_RULE(id, severity, operators, en, ja, remedy_en, remedy_ja) \
  {Rule::id, #id, RuleSeverity::severity, operators, en, ja, remedy_en, remedy_ja},
#include "ryosen/base/rules.def"
#undef RYOSEN_RULE
};

}  // namespace

std::span<const RuleText> rule_table() { return rules; }

const RuleText& text_of(Rule rule) { return rules[static_cast<std::size_t>(rule)]; }

}  // namespace ryosen
