// What a step writes into the records of a DCEL, field by field, so that it can be taken back.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

#include "ryosen/textbook/forms/dcel.h"

namespace ryosen {

// One field of a record, before and after. Links are row numbers, no_index for none.
struct DcelChange {
  enum class Table : std::uint8_t { vertex, half_edge, face };
  enum class Field : std::uint8_t { incident_edge, origin, twin, next, prev, face, outer_component };
  Table table;
  std::uint32_t row;
  Field field;
  std::uint32_t old_value, new_value;

  friend bool operator==(const DcelChange&, const DcelChange&) = default;
};
std::string_view id_of(DcelChange::Table table);
std::string_view id_of(DcelChange::Field field);  // as the text names it

// Where the change is; the row is made where it is a new one.
std::uint32_t& cell(forms::DcelRecords& records, const DcelChange& change);

void apply_changes(std::span<const DcelChange> changes, forms::DcelRecords& records);
// Without the rows behind so many, which the changes have made.
void take_back_changes(std::span<const DcelChange> changes, std::size_t half_edge_rows, std::size_t face_rows,
                       forms::DcelRecords& records);

// The records without rows that are gone, for a Dcel; vertices without an edge stay.
forms::DcelRecords in_use(const forms::DcelRecords& records);

}  // namespace ryosen
