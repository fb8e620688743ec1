#include "app/editor/commands/expect.h"

#include "app/editor/commands/command_functions.h"
#include "app/editor/commands/text/words.h"
#include "app/editor/document/findings.h"
#include "ryosen/base/number_text.h"
#include "ryosen/document/document.h"
#include "ryosen/io/numbers.h"
#include "ryosen/mesh/copies.h"
#include "ryosen/mesh/mesh.h"

namespace ryosen {

namespace {

Outcome not_so(const std::string& claim, const Text& found) {
  Outcome outcome;
  outcome.kind = Outcome::Kind::failed;
  outcome.exit_code = ExitCode::found_problems;
  outcome.sentence = {"expected " + claim + ", found: " + found.en, claim + " のはずですが、実際は：" + found.ja};
  return outcome;
}

Outcome expect_verdict(Document& document, std::string_view line, bool legal) {
  const auto in_expect = [](const Text& sentence) {
    return usage_error("expect: " + sentence.en, "expect：" + sentence.ja);
  };
  const std::vector<std::string_view> words = split_words(line);
  if (!find_op(words[0])) return in_expect(not_an_operator(words[0]));
  const ParsedOp parsed = parse_line(document.mesh(), line);
  if (!parsed.op) {
    const Outcome other = no_element(document, line, parsed.error, parsed.sentence);
    if (other.kind != Outcome::Kind::refused) return in_expect(other.sentence);
    return legal ? not_so("legal " + std::string(line), other.sentence) : Outcome();
  }
  const Verdict verdict = check(document.mesh(), *parsed.op);
  if (verdict.legal() == legal) return {};
  const std::string claim = (legal ? "legal " : "refused ") + command_of(document.mesh(), *parsed.op);
  return not_so(claim, verdict.legal() ? Text{"legal", "可能"} : describe(document.mesh(), verdict.reasons[0]));
}

}  // namespace

std::string hash_text(const Mesh& mesh) { return hash_text(mesh.hash()); }

namespace {

// The value of a term, or why it has none.
Text found_text(Findings& findings, const EulerTerm& term) {
  const EulerPoincare& terms = findings.euler_terms();
  if (const auto value = term.value(terms)) return {std::to_string(*value), std::to_string(*value)};
  const Text why = why_no_value(findings.mesh(), terms, term);
  return {"none, " + why.en, std::string(term.ja) + "なし、" + why.ja};
}

}  // namespace

std::string expect_syntax() {
  std::string letters;
  for (const EulerTerm& term : euler_letters()) letters += letters.empty() ? "" : "|", letters += term.letter;
  return letters + " N|legal COMMAND|refused COMMAND|hash H";
}

Outcome run_expect(Document& document, Findings& findings, std::span<const std::string_view> arguments,
                   std::string_view whole) {
  const Outcome usage = wrong_arguments("expect");
  if (arguments.size() < 2) return usage;
  const std::string_view what = arguments[0];
  if (what == "legal" || what == "refused") return expect_verdict(document, behind_word(whole), what == "legal");
  if (arguments.size() != 2) return usage;
  const std::string expected(arguments[1]);
  if (what == "hash") {
    const std::string found = hash_text(document.mesh());
    return found == expected ? Outcome() : not_so("hash " + expected, {found, found});
  }
  std::int64_t number = 0;
  if (!read_integer(expected, number)) return usage;
  for (const EulerTerm& term : euler_letters()) {
    if (what != std::string_view(&term.letter, 1)) continue;
    const auto found = term.value(findings.euler_terms());
    return found == number ? Outcome() : not_so(std::string(what) + " " + expected, found_text(findings, term));
  }
  return usage;
}

}  // namespace ryosen
