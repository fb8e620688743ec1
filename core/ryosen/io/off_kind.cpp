// Parsing of the first word of an OFF file.
#include "ryosen/io/off.h"
#include "ryosen/io/text_lines.h"

namespace ryosen {

std::optional<OffKind> OffKind::from_word(std::string_view word) {
  OffKind kind;
  bool has_fourth = false, has_dimension = false;
  struct Prefix {
    std::string_view letters;
    bool& is_there;
  };
  const Prefix prefixes[] = {{"ST", kind.has_texcoords},
                             {"C", kind.has_colours},
                             {"N", kind.has_normals},
                             {"4", has_fourth},
                             {"n", has_dimension}};
  // In any order, each once.
  const auto take_one = [&] {
    for (const Prefix& prefix : prefixes) {
      if (prefix.is_there || !word.starts_with(prefix.letters)) continue;
      word.remove_prefix(prefix.letters.size());
      return prefix.is_there = true;
    }
    return false;
  };
  while (take_one()) {
  }
  kind.is_three_dimensional = !has_fourth && !has_dimension;
  if (word != "OFF") return std::nullopt;
  return kind;
}

std::string_view off_count_behind(std::string_view word) {
  const std::size_t after = word.find_last_not_of("0123456789") + 1;
  return word.substr(0, after).ends_with("OFF") ? word.substr(after) : std::string_view();
}

Likeness looks_like_off(std::string_view head, std::uint64_t) {
  TextLines lines(head, false);
  TextLine line;
  while (lines.next(line)) {
    std::string_view rest = line.text;
    const std::string_view word = take_word(rest);
    if (word.empty() || word[0] == '#') continue;
    const std::string_view first = word.substr(0, word.find('#'));
    return OffKind::from_word(first.substr(0, first.size() - off_count_behind(first).size())) ? Likeness::sure
                                                                                              : Likeness::no;
  }
  return Likeness::no;
}

}  // namespace ryosen
