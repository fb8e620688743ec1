// The header of a PLY file: the encoding, and the tables and properties that follow.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "ryosen/base/result.h"
#include "ryosen/io/properties.h"
#include "ryosen/io/reporter.h"

namespace ryosen {

// An attribute as a comment describes it, behind the word attribute (see mesh/attribute_text.h), because its property
// cannot say all:
//
//   comment attribute vertex.fixed bool first false
struct PlyAttribute {
  AttributeColumn column;  // without values
  std::string comment;
};

// Further properties and descriptions stay what they are.
inline constexpr std::size_t most_attributes_of_a_file = 4096;

// The name of the attribute that a property of an element would be: that of the property if it begins with the element
// (in faces also with corner), else with the element before it.
std::string attribute_of_property(TableKind kind, std::string_view property);
// Whether a property of this name may be read as something else than an attribute.
bool has_meaning_in_ply(TableKind kind, std::string_view property);

struct PlyHeader {
  Encoding encoding = Encoding::ascii;
  PropertyTables tables;                     // with roles, without values; row counts are unverified
  std::vector<std::uint64_t> element_lines;  // the header line of each table
  std::vector<std::string> counts;           // of rows as the header spells them, for messages
  std::vector<std::string> comments;         // without the word and without those of `attributes`
  std::vector<PlyAttribute> attributes;      // that comments describe
  Reporter reporter;                         // the warnings of the header
  std::optional<Failure> missing_z;          // the failure if vertices have no z, unless the count of numbers is exact
  std::string unknown_word;                  // the first one, as it may be shown; empty if there is none
  std::uint64_t unknown_line = 0;            // where it stands
  std::uint64_t lines = 0;                   // of the header
  std::uint64_t bytes = 0;                   // offset of the data

  // The table of a kind, or null.
  const PropertyTable* find(TableKind kind) const;
  // Adds to a failure of this file the unknown header word that may have caused it.
  Failure explained(Failure failure) const;
};

// How the lines of a header end, as the first one does. Only CR, and LF CR, say it of the others: LF and CR LF are
// taken for each other.
enum class PlyLineEnd { lf, cr, lf_cr };
PlyLineEnd ply_line_end(std::string_view bytes);
// The bytes with LF in place of LF CR.
std::string with_single_line_ends(std::string_view bytes);

// Reads up to the line end_header. Errors, with their line: an unreadable count, an unknown type, vertices without x or
// y, faces without a vertex list, a line that does not begin with a word. A line that begins with an unknown word is
// kept, with a warning. O(header).
Result<PlyHeader> read_ply_header(std::string_view bytes);

}  // namespace ryosen
