#include "ryosen/ops/parameters/op_argument.h"

#include "ryosen/base/number_text.h"
#include "ryosen/mesh/names.h"

namespace ryosen {

std::vector<OpArgument> op_arguments(std::span<const std::string_view> words) { return {words.begin(), words.end()}; }

std::vector<OpArgument> op_arguments(std::span<const Element> elements, std::span<const std::string_view> words) {
  std::vector<OpArgument> all(elements.begin(), elements.end());
  all.insert(all.end(), words.begin(), words.end());
  return all;
}

std::vector<OpArgument> op_arguments(Element::Kind kind, std::size_t count, std::span<const std::string_view> words) {
  std::vector<OpArgument> all(count, OpArgument(kind));
  all.insert(all.end(), words.begin(), words.end());
  return all;
}

std::string print_argument(const Mesh& mesh, const OpArgument& argument) {
  if (const Element* const e = argument.element())
    return e->kind == Element::Kind::vertex ? name_of_copy(mesh, e->vertex()) : name_of(mesh, *e);
  return argument.position() ? format_place(*argument.position()) : std::string(argument.word());
}

}  // namespace ryosen
