#include "ryosen/mesh/slot_ranges.h"

#include <array>
#include <charconv>

#include "ryosen/mesh/find_element.h"

namespace ryosen {

namespace {

constexpr std::array<char, 4> letters{'v', 'h', 'e', 'f'};  // by Element::Kind

std::string name(Element::Kind kind, std::uint32_t slot) {
  return letters[static_cast<std::size_t>(kind)] + std::to_string(slot);
}

std::optional<Element> parse_slot(std::string_view word) {
  if (word.size() < 2) return std::nullopt;
  Element e;
  const char* const end = word.data() + word.size();
  const auto [behind, error] = std::from_chars(word.data() + 1, end, e.index);
  if (error != std::errc() || behind != end) return std::nullopt;
  for (std::size_t kind = 0; kind < letters.size(); ++kind)
    if (word[0] == letters[kind]) {
      e.kind = static_cast<Element::Kind>(kind);
      return e;
    }
  return std::nullopt;
}

}  // namespace

std::string slot_ranges(std::span<const Element> elements) {
  std::string text;
  for (std::size_t i = 0; i < elements.size();) {
    std::size_t end = i + 1;
    while (end < elements.size() && elements[end].kind == elements[i].kind &&
           elements[end].index == elements[end - 1].index + 1)
      ++end;
    text += " " + name(elements[i].kind, elements[i].index);
    if (end > i + 1) text += ".." + name(elements[i].kind, elements[end - 1].index);
    i = end;
  }
  return text;
}

std::optional<SlotRange> parse_slot_range(std::string_view word) {
  const std::size_t dots = word.find("..");
  if (dots == std::string_view::npos) return std::nullopt;
  const auto first = parse_slot(word.substr(0, dots)), last = parse_slot(word.substr(dots + 2));
  if (!first || !last || first->kind != last->kind || last->index < first->index || last->index == no_index)
    return std::nullopt;
  return SlotRange{*first, last->index};
}

void add_living(const Mesh& mesh, const SlotRange& range, Elements& elements) {
  const ColumnLengths lengths = mesh.lengths();
  for (Element e = range.first; e.index <= range.last && has_slot(lengths, e); ++e.index)
    if (is_alive(mesh, e)) elements.push_back(e);
}

}  // namespace ryosen
