#include "ryosen/ops/lines/syntax.h"

#include <algorithm>
#include <set>

#include "ryosen/ops/lines/arguments.h"

namespace ryosen {

namespace {

using Places = std::set<std::size_t>;

// Splits a text at separators outside brackets; empty pieces are dropped.
std::vector<std::string_view> split(std::string_view text, std::string_view separator) {
  std::vector<std::string_view> pieces;
  std::size_t begin = 0;
  int depth = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    depth += (text[i] == '[') - (text[i] == ']');
    if (depth != 0 || !text.substr(i).starts_with(separator)) continue;
    pieces.push_back(text.substr(begin, i - begin));
    begin = i + separator.size();
    i = begin - 1;
  }
  pieces.push_back(text.substr(begin));
  std::erase_if(pieces, [](std::string_view piece) { return piece.empty(); });
  return pieces;
}

// An empty mesh: names are checked for their syntax only.
const Mesh& empty_mesh() {
  static const Mesh mesh;
  return mesh;
}

bool is_face_name(std::string_view word) { return find_face(empty_mesh(), word).error != NameError::malformed; }

// Checks the part before `@`, and the face after it if present.
template <class Find>
bool is_name(std::string_view word, Find find) {
  const std::size_t at = word.find('@');
  return find(empty_mesh(), word).error != NameError::malformed &&
         (at == std::string_view::npos || is_face_name(word.substr(at + 1)));
}
bool is_vertex_name(std::string_view word) { return is_name(word, find_vertex); }
bool is_edge_name(std::string_view word) { return is_name(word, find_edge); }

bool fits(std::string_view pattern, std::string_view word) {
  if (pattern == "X,Y,Z") return parse_place(word).has_value();
  if (pattern == "t" || pattern == "DISTANCE") return parse_double(word).has_value();
  if (pattern == "fN" || pattern == "fM") return is_face_name(word);
  if (pattern == "-" || (pattern.size() > 1 && pattern.find_first_not_of("abcdefghijklmnopqrstuvwxyz") == pattern.npos))
    return word == pattern;
  return pattern.find('-') != std::string_view::npos ? is_edge_name(word) : is_vertex_name(word);
}

class Matcher {
 public:
  explicit Matcher(std::span<const std::string_view> words) : words_(words) {}

  // All positions reachable by matching a syntax from any of the given positions.
  Places match(std::string_view syntax, const Places& from) {
    Places ends;
    const std::vector<std::string_view> lists = split(syntax, " | ");
    for (std::string_view list : lists) ends.merge(match_list(list, from));
    if (lists.empty()) ends = from;
    return ends;
  }

  // The last position at which a word was missing or did not match.
  std::size_t farthest() const { return farthest_; }

 private:
  Places match_list(std::string_view list, Places at) {
    std::string_view before;
    for (std::string_view item : split(list, " ")) {
      at = item == "..." ? more_of(before, at) : match_item(item, at);
      before = item;
    }
    return at;
  }

  Places more_of(std::string_view item, Places at) {
    for (Places next = match_item(item, at); !next.empty(); next = match_item(item, next))
      at.insert(next.begin(), next.end());
    return at;
  }

  Places match_item(std::string_view item, const Places& at) {
    Places ends;
    if (item.starts_with('[')) {
      ends = match(item.substr(1, item.size() - 2), at);
      ends.insert(at.begin(), at.end());
      return ends;
    }
    const std::vector<std::string_view> patterns = split(item, "|");
    for (std::size_t i : at) {
      const auto takes = [&](std::string_view pattern) { return fits(pattern, words_[i]); };
      if (i < words_.size() && std::any_of(patterns.begin(), patterns.end(), takes))
        ends.insert(i + 1);
      else
        farthest_ = std::max(farthest_, i);
    }
    return ends;
  }

  std::span<const std::string_view> words_;
  std::size_t farthest_ = 0;
};

}  // namespace

bool is_element_name(std::string_view word) { return is_face_name(word) || is_vertex_name(word) || is_edge_name(word); }

std::optional<std::size_t> first_misfit(std::string_view syntax, std::span<const std::string_view> words) {
  Matcher matcher(words);
  const Places ends = matcher.match(syntax, {0});
  if (ends.contains(words.size())) return std::nullopt;
  return std::max(matcher.farthest(), ends.empty() ? 0 : *ends.rbegin());
}

}  // namespace ryosen
