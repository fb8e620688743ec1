// The table of roles: what part an element takes in a step.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

#include "ryosen/base/enum_table.h"

namespace ryosen::steps {

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
// In the order of the enum.
std::span<const RoleRow> roles();
inline const RoleRow& row_of(Role role) { return roles()[static_cast<std::size_t>(role)]; }

}  // namespace ryosen::steps
