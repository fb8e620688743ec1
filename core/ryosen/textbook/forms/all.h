// The table of forms. Comparison, benchmarks and tests iterate over it; a new form is a pair of files and a row.
#pragma once

#include <span>
#include <string_view>

#include "ryosen/textbook/forms/form.h"

namespace ryosen::forms {

std::span<const FormRow> all_forms();
// Null for an unknown id.
const FormRow* find_form(std::string_view id);

}  // namespace ryosen::forms
