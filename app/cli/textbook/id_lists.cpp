#include "app/cli/id_lists.h"

#include "ryosen/textbook/forms/all.h"
#include "ryosen/textbook/forms/pairing.h"
#include "ryosen/textbook/steps/all.h"

namespace ryosen::cli {

namespace {

// The rows of a table with an id and these two members.
template <class Rows, class Member>
std::vector<IdEntry> entries(const Rows& rows, Member en, Member ja) {
  std::vector<IdEntry> all;
  for (const auto& row : rows) {
    all.push_back({std::string(row.id), {std::string(row.*en), std::string(row.*ja)}, {}});
    if constexpr (requires { row.syntax; }) all.back().syntax = std::string(row.syntax);
  }
  return all;
}

}  // namespace

std::vector<IdEntry> form_entries() { return entries(forms::all_forms(), &forms::FormRow::en, &forms::FormRow::ja); }
std::vector<IdEntry> relation_entries() {
  return entries(forms::relations(), &forms::RelationRow::en, &forms::RelationRow::ja);
}
std::vector<IdEntry> pairing_entries() { return entries(pairing_methods(), &PairingMethod::en, &PairingMethod::ja); }
std::vector<IdEntry> steps_entries() {
  return entries(steps::all_steps(), &steps::StepsRow::help_en, &steps::StepsRow::help_ja);
}
std::vector<IdEntry> role_entries() { return entries(steps::roles(), &steps::RoleRow::en, &steps::RoleRow::ja); }

}  // namespace ryosen::cli
