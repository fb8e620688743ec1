#include "ryosen/textbook/steps/tables.h"

#include <algorithm>
#include <cctype>

namespace ryosen::steps {

namespace {

bool is_digit(char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; }

// The digits at the front, without leading zeros, which are taken off.
std::string_view take_number(std::string_view& text) {
  std::size_t end = 0;
  while (end < text.size() && is_digit(text[end])) ++end;
  std::string_view number = text.substr(0, end);
  text.remove_prefix(end);
  while (number.size() > 1 && number[0] == '0') number.remove_prefix(1);
  return number;
}

}  // namespace

bool NaturalLess::operator()(std::string_view a, std::string_view b) const {
  const std::string_view whole_a = a, whole_b = b;
  while (!a.empty() && !b.empty()) {
    if (is_digit(a[0]) && is_digit(b[0])) {
      const std::string_view m = take_number(a), n = take_number(b);
      if (m.size() != n.size()) return m.size() < n.size();
      if (m != n) return m < n;
    } else {
      if (a[0] != b[0]) return a[0] < b[0];
      a.remove_prefix(1);
      b.remove_prefix(1);
    }
  }
  return a.empty() != b.empty() ? a.empty() : whole_a < whole_b;
}

void Tables::apply(const std::vector<RowChange>& changes) {
  for (const RowChange& change : changes) {
    Rows& rows = tables_[change.table];
    Fields& fields = rows[change.row];
    const auto known =
        std::find_if(fields.begin(), fields.end(), [&](const auto& field) { return field.first == change.field; });
    if (!change.new_value) {
      if (known != fields.end()) fields.erase(known);
      if (fields.empty()) rows.erase(change.row);
    } else if (known != fields.end()) {
      known->second = *change.new_value;
    } else {
      fields.emplace_back(change.field, *change.new_value);
    }
  }
}

const Tables::Rows& Tables::rows_of(const std::string& table) const {
  static const Rows none;
  const auto found = tables_.find(table);
  return found == tables_.end() ? none : found->second;
}

const Tables& TablesAlong::at(std::size_t i) {
  const std::size_t nearest = std::min(i / keyframe_steps, keyframes_.size() - 1);
  if (i < position_ || nearest * keyframe_steps > position_) {
    position_ = nearest * keyframe_steps;
    current_ = keyframes_[nearest];
  }
  while (position_ < i) {
    current_.apply(sequence_.at(++position_).rows);
    if (position_ == keyframes_.size() * keyframe_steps) keyframes_.push_back(current_);
  }
  return current_;
}

}  // namespace ryosen::steps
