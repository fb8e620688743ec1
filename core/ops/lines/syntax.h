// The syntax of an operator's arguments, without any mesh.
//
//   A-B [start|end|mid|X,Y,Z]     blanks between arguments, [ ] around what may be missing, `|` between what may stand in
//   A B C ... | fN                one place, ` | ` between whole lists, ... for more of what stands before it
//
// A name with `-` is that of an edge, fN and fM of a face, t and DISTANCE are numbers, X,Y,Z is a place; other words of
// small letters are meant literally, as is `-` alone; all else names a vertex.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string_view>

#include "core/base/message.h"

namespace ryosen {

// The place of the first word that does not fit: words.size() where one is missing, none where all fit. Cost: the words
// times the length of the syntax.
std::optional<std::size_t> first_misfit(std::string_view syntax, std::span<const std::string_view> words);

// Whether a word is a name of a vertex, edge or face.
bool is_element_name(std::string_view word);

// What is wrong with the arguments of an operator, by its id in the list, on any mesh; nothing where that depends on the
// mesh.
std::optional<Text> fault_of_arguments(std::string_view id, std::span<const std::string_view> arguments);

}  // namespace ryosen
