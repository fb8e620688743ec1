// How many operands a subcommand takes, and the values of its flags.
#include <algorithm>
#include <limits>

#include "app/cli/subcommand_table.h"

namespace ryosen::cli {

namespace {

template <class Counts>
std::size_t count_words(std::string_view words, const Counts& counts) {
  std::size_t count = 0;
  while (!words.empty()) {
    const std::string_view word = words.substr(0, words.find(' '));
    if (counts(word)) ++count;
    words.remove_prefix(std::min(words.size(), word.size() + 1));
  }
  return count;
}

}  // namespace

std::size_t Subcommand::least_operands() const {
  const bool may_lack = std::any_of(flags.begin(), flags.end(), [](const Flag& flag) { return flag.replaces_operand; });
  return may_lack ? 0 : count_words(operands, [](std::string_view word) { return !word.starts_with('['); });
}

std::size_t Subcommand::most_operands() const {
  if (operands.find("...") != std::string_view::npos) return std::numeric_limits<std::size_t>::max();
  return count_words(operands, [](std::string_view) { return true; });
}

bool Arguments::has(std::string_view flag) const { return value(flag) != nullptr; }

const std::string* Arguments::value(std::string_view flag) const {
  const std::string* last = nullptr;
  for (const Given& given : given_)
    if (given.flag == flag) last = &given.value;
  return last;
}

std::vector<std::string> Arguments::values(std::string_view flag) const {
  std::vector<std::string> all;
  for (const Given& given : given_)
    if (given.flag == flag) all.push_back(given.value);
  return all;
}

}  // namespace ryosen::cli
