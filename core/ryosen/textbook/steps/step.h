// A step of something that is played step by step, as data: what is done, which elements take part, what changes in
// which table, and where the source texts say so. Made here, so that the window, the command line and tests share it.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "ryosen/base/element.h"
#include "ryosen/base/enum_table.h"
#include "ryosen/base/message.h"

namespace ryosen::steps {

// The part that an element takes in a step.
enum class Role : std::uint8_t {
  asked,
  read,
  compared,
  answer,
  created,
  changed,
  deleted,
  missing,
  visible,
  horizon,
  united,
  l1,
  l2,
  l3,
  l4,
  l5,
  l6,
  l7,
  l8,
  l9,
  l10
};

// How strongly and in which sense it is drawn; the colours are the frontend's.
enum class RoleLook : std::uint8_t { main, quiet, good, bad, other };

struct RoleRow {
  Role role;
  std::string_view id;
  RoleLook look;
  bool is_label;  // its id stands beside the element in the picture
  std::string_view en, ja;
};
// The table of roles, in the order of the enum.
std::span<const RoleRow> roles();
inline const RoleRow& row_of(Role role) { return roles()[static_cast<std::size_t>(role)]; }

// An element of the mesh of the step (Sequence::mesh_at), by its slot; it may be one that the step has deleted.
struct Mark {
  Role role = Role::asked;
  Element element;

  friend bool operator==(const Mark&, const Mark&) = default;
};

// What the step has taken away, where it was: a chain of places.
struct Gone {
  Role role = Role::deleted;
  std::vector<glm::dvec3> places;

  friend bool operator==(const Gone&, const Gone&) = default;
};

// A cell of a table that the step writes, or that it reads: then both values are the same. No value: null, or the row
// is not there.
struct RowChange {
  std::string table, row, field;
  std::optional<std::string> old_value, new_value;

  friend bool operator==(const RowChange&, const RowChange&) = default;
};

// A place in the source texts. Line from 1 within the listing as printed, blank lines included; 0 for none.
struct Source {
  std::string_view text;  // its number
  std::string_view listing_en, listing_ja;
  int line = 0;
};

// The changes of the terms of V - E + F + (B + W + I) - H = 2(S - G), as in the totals. No B or no G where there is
// none before or after (analysis/euler_poincare.h).
struct Delta {
  std::int64_t v = 0, e = 0, f = 0;
  std::optional<std::int64_t> b = 0;
  std::int64_t w = 0, i = 0, h = 0, s = 0;
  std::optional<std::int64_t> g = 0;

  friend bool operator==(const Delta&, const Delta&) = default;
};
// "E + 1, W - 1"; "no term changes" where none does.
Text text_of(const Delta& delta);

struct Step {
  Text caption;
  std::vector<Mark> marks;
  std::vector<RowChange> rows;
  std::optional<Source> source;
  std::optional<Delta> delta;   // where it edits the kernel's mesh
  std::vector<Gone> gone = {};  // to be seen beside the marks
};

}  // namespace ryosen::steps
