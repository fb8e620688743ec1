#include "app/editor/expect.h"

#include "app/editor/commands.h"
#include "app/editor/words.h"
#include "core/io/numbers.h"
#include "core/mesh/copies.h"

namespace ryosen {

namespace {

Outcome not_so(const std::string& claim, const Text& found) {
  Outcome outcome;
  outcome.kind = Outcome::Kind::failed;
  outcome.exit_code = ExitCode::found_problems;
  outcome.sentence = {"expected " + claim + ", found: " + found.en, claim + " のはずですが、実際は：" + found.ja};
  return outcome;
}

Outcome expect_verdict(Session& session, std::string_view line, bool legal) {
  const auto in_expect = [](const Text& sentence) {
    return usage_error("expect: " + sentence.en, "expect：" + sentence.ja);
  };
  const std::vector<std::string_view> words = split_words(line);
  if (!find_op(words[0])) return in_expect(not_an_operator(words[0]));
  const Parsed<AnyOp> parsed = parse_line(session.mesh(), line);
  if (!parsed.op) {
    const Outcome other = no_element(session.document(), line, parsed.error, parsed.sentence);
    if (other.kind != Outcome::Kind::refused) return in_expect(other.sentence);
    return legal ? not_so("legal " + std::string(line), other.sentence) : Outcome();
  }
  const Verdict verdict = check(session.mesh(), *parsed.op);
  if (verdict.legal() == legal) return {};
  const std::string claim = (legal ? "legal " : "refused ") + command_of(session.mesh(), *parsed.op);
  return not_so(claim, verdict.legal() ? Text{"legal", "可能"} : describe(session.mesh(), verdict.reasons[0]));
}

}  // namespace

std::string hash_text(const Mesh& mesh) {
  constexpr std::string_view digits = "0123456789abcdef";
  std::uint64_t hash = mesh.hash();
  std::string text(16, '0');
  for (std::size_t i = 16; i-- > 0; hash >>= 4u) text[i] = digits[hash & 15u];
  return text;
}

Outcome run_expect(Session& session, std::span<const std::string_view> arguments, std::string_view whole) {
  const Outcome usage =
      usage_error("the command reads: expect V N | E N | F N | legal COMMAND | refused COMMAND | hash H",
                  "書式：expect V N | E N | F N | legal COMMAND | refused COMMAND | hash H");
  if (arguments.size() < 2) return usage;
  const std::string_view what = arguments[0];
  if (what == "legal" || what == "refused") return expect_verdict(session, behind_word(whole), what == "legal");
  if (arguments.size() != 2) return usage;
  const std::string expected(arguments[1]);
  const ElementCounts counts = counts_on_points(session.mesh());
  std::string found;
  if (what == "V")
    found = std::to_string(counts.vertices);
  else if (what == "E")
    found = std::to_string(counts.edges);
  else if (what == "F")
    found = std::to_string(counts.faces);
  else if (what == "hash")
    found = hash_text(session.mesh());
  else
    return usage;
  std::int64_t number = 0;
  if (what != "hash" && !read_integer(expected, number)) return usage;
  return found == expected ? Outcome() : not_so(std::string(what) + " " + expected, {found, found});
}

}  // namespace ryosen
