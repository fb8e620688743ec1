#include "app/editor/commands/text/words.h"

#include <algorithm>
#include <charconv>
#include <cstdio>

namespace ryosen {

namespace {

constexpr std::string_view blanks = " \t\r";

}  // namespace

std::string_view without_blanks(std::string_view text) {
  const std::size_t begin = text.find_first_not_of(blanks);
  if (begin == std::string_view::npos) return {};
  return text.substr(begin, text.find_last_not_of(blanks) - begin + 1);
}

std::string_view behind_word(std::string_view line) {
  line = without_blanks(line);
  return without_blanks(line.substr(std::min(line.find_first_of(blanks), line.size())));
}

std::string_view behind_id(std::string_view line) {
  const std::size_t id = std::min(line.find_first_not_of(blanks), line.size());
  return line.substr(std::min(line.find_first_of(blanks, id), line.size()));
}

std::string folded(std::string_view text) {
  std::string folded(text);
  for (char& c : folded)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return folded;
}

bool has_words(std::string_view text, std::string_view typed) {
  while (!(typed = without_blanks(typed)).empty()) {
    if (text.find(typed.substr(0, typed.find_first_of(blanks))) == text.npos) return false;
    typed = behind_word(typed);
  }
  return true;
}

bool begins_a_word(std::string_view text, std::string_view word) {
  const auto is_of_word = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9');
  };
  for (std::size_t at = text.find(word); at != text.npos; at = text.find(word, at + 1))
    if (at == 0 || !is_of_word(text[at - 1]) || !is_of_word(text[at])) return true;
  return false;
}

std::string capitalized(std::string text) {
  if (!text.empty() && text[0] >= 'a' && text[0] <= 'z') text[0] = static_cast<char>(text[0] - 'a' + 'A');
  return text;
}

std::string with_short_numbers(std::string_view line) {
  std::string shown;
  for (std::size_t at = 0; at < line.size();) {
    const auto is_beyond_latin = [](char c) { return static_cast<unsigned char>(c) >= 0x80; };  // as what Japanese has
    const bool begins = at == 0 || is_beyond_latin(line[at - 1]) ||
                        std::string_view(" ,=(").find(line[at - 1]) != std::string_view::npos;
    double value = 0;
    const char* const begin = line.data() + at;
    const auto [end, error] = std::from_chars(begin, line.data() + line.size(), value);
    std::string_view number(begin, begins && error == std::errc() ? end : begin);
    if (number.ends_with('.')) number.remove_suffix(1);  // of the sentence
    const std::string_view behind = line.substr(at + number.size());
    const bool is_whole_word = behind.empty() || behind == "." || behind.starts_with(". ") ||
                               is_beyond_latin(behind[0]) ||
                               std::string_view(" ,)%;:").find(behind[0]) != std::string_view::npos;
    const bool is_exact = number.find_first_of(".e") == std::string_view::npos && number != "-0";
    if (number.empty() || !is_whole_word || is_exact) {
      shown += line[at++];
      continue;
    }
    char text[32];
    std::snprintf(text, sizeof text, "%.6g", value == 0 ? 0.0 : value);
    shown += text;
    at += number.size();
  }
  return shown;
}

std::string file_argument(std::string_view name) {
  if (!name.empty() && name.find_first_of(" \t\r\n\"{};#") == std::string_view::npos) return std::string(name);
  std::string text = "\"";
  for (const char c : name) {
    if (c == '"' || c == '\\') text += '\\';
    if (c == '\n')
      text += "\\n";
    else if (c == '\r')
      text += "\\r";
    else
      text += c;
  }
  return text + '"';
}

std::string file_name(std::string_view argument) {
  argument = without_blanks(argument);
  if (argument.size() < 2 || argument.front() != '"' || argument.back() != '"') return std::string(argument);
  argument = argument.substr(1, argument.size() - 2);
  std::string name;
  for (std::size_t i = 0; i < argument.size(); ++i) {
    const char next = i + 1 < argument.size() ? argument[i + 1] : '\0';
    const bool is_escape = argument[i] == '\\' && (next == '"' || next == '\\' || next == 'n' || next == 'r');
    if (!is_escape) {
      name += argument[i];
      continue;
    }
    name += next == 'n' ? '\n' : next == 'r' ? '\r' : next;
    ++i;
  }
  return name;
}

Text closed(Text sentence) {
  if (!sentence.en.ends_with("?")) sentence.en += ".";
  if (!sentence.ja.ends_with("？")) sentence.ja += "。";
  return sentence;
}

}  // namespace ryosen
