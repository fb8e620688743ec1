// Reads, prints and matches the line of an operator by its parameters.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "ryosen/base/element.h"
#include "ryosen/ops/parameters/argument_reader.h"
#include "ryosen/ops/parameters/op_parameter.h"

namespace ryosen {

// "A-B [start|end|mid|X,Y,Z]": blanks between places, [ ] around optional ones, `|` between the values of a place and
// ` | ` between whole lists; `...` repeats.
std::string syntax_of(const OpLine& line);

// Reads the arguments into the operator. The first error stays in the reader.
void read_line(const OpLine& line, const Mesh& mesh, ArgumentReader& in, void* op);
// Prints the arguments, each behind a blank. Inverse of read_line() on the mesh where it was printed.
std::string print_line(const OpLine& line, const Mesh& mesh, const void* op);
// The halfedge of an operator on one edge; none of others.
Halfedge halfedge_of(const OpLine& line, const void* op);

// An argument of a line whose elements need not exist: a word, or any element of a kind.
struct OpWord {
  std::string_view text;
  std::optional<Element::Kind> kind = {};

  OpWord(std::string_view word) : text(word) {}
  OpWord(Element::Kind any) : kind(any) {}
};
// Words, and a kind of elements before them.
std::vector<OpWord> op_words(std::span<const std::string_view> words);
std::vector<OpWord> op_words(Element::Kind kind, std::size_t count, std::span<const std::string_view> words);

// The index of the first word that fits none of the lists: words.size() if one is missing, none if all fit. Cost: the
// words times the parameters.
std::optional<std::size_t> first_misfit(const OpLine& line, std::span<const OpWord> words);
// The kind of element that may come next: a vertex before an edge before a face; none where none may.
std::optional<Element::Kind> next_element(const OpLine& line, std::span<const OpWord> words);
// Whether a list takes any number of elements.
bool takes_any_number(const OpLine& line);

}  // namespace ryosen
