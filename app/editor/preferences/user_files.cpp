#include "app/editor/preferences/user_files.h"

#include <algorithm>
#include <system_error>

#include "app/editor/commands/command_syntax.h"
#include "app/editor/commands/commands.h"
#include "app/editor/commands/text/words.h"
#include "app/editor/preferences/preferences.h"
#include "app/editor/session/session.h"
#include "ryosen/io/input_file.h"
#include "ryosen/io/safe_write.h"

namespace ryosen {

namespace {

namespace fs = std::filesystem;

struct Line {
  std::size_t number;
  std::string text;
};

// Without empty ones and remarks. None where nothing is there.
Result<std::vector<Line>> lines_of(const fs::path& file) {
  std::vector<Line> lines;
  std::error_code error;
  if (file.empty() || !fs::exists(file, error)) return lines;
  const Result<FileBytes> bytes = read_whole_file(file);
  if (!bytes) return bytes.failure();
  std::size_t number = 0;
  for (std::string_view rest = bytes->view(); !rest.empty();) {
    const std::size_t end = std::min(rest.find('\n'), rest.size());
    const std::string_view line = without_blanks(rest.substr(0, end));
    rest.remove_prefix(std::min(end + 1, rest.size()));
    ++number;
    if (!line.empty() && line.front() != '#') lines.push_back({number, std::string(line)});
  }
  return lines;
}

std::string content_of(std::string_view head, const std::vector<std::string>& lines) {
  std::string content(head);
  for (const std::string& line : lines) content += line + "\n";
  return content;
}

Failure broken_line(const fs::path& file, const Line& line, const Text& fault) {
  const std::string place = file.string() + ":" + std::to_string(line.number);
  return make_failure(ExitCode::input_malformed, "bad_value",
                      {place + ": " + fault.en + ". Everything in this file is as at first.",
                       place + "：" + fault.ja + "。このファイルの設定はすべて最初の値にします。"});
}

// What is wrong with a line of preferences that this version knows.
std::optional<Text> fault_of_line(const std::vector<std::string_view>& words, const std::string& line) {
  if (words[0] == "bind") return fault_of_command(line);
  if (words.size() != 2)
    return Text{std::string(words[0]) + " takes one value", std::string(words[0]) + " の値は一つです"};
  return fault_of_preference(words[0], words[1]);
}

bool is_known(std::string_view word) { return word == "bind" || find_preference(word); }

constexpr std::string_view preferences_head =
    "# Preferences of Ryosen: a line each, as the command prefer takes them (ryosen help edit). Lines may be changed "
    "or\n"
    "# taken away while no window is open.\n";
constexpr std::string_view layout_head = "# The panels of Ryosen, as the commands panel and columns set them.\n";
constexpr std::string_view recent_head = "# The files that were open in Ryosen, the latest first.\n";

}  // namespace

Result<ReadPreferences> read_preferences(Session& session, const fs::path& file) {
  const Result<std::vector<Line>> lines = lines_of(file);
  if (!lines) return lines.failure();
  ReadPreferences read;
  std::vector<std::string> known;
  for (const Line& line : *lines) {
    const std::vector<std::string_view> words = split_words(line.text);
    if (!is_known(words[0])) {
      read.unknown.push_back(line.text);
      continue;
    }
    if (const auto fault = fault_of_line(words, line.text)) return broken_line(file, line, *fault);
    if (words[0] != "bind") read.values[std::string(words[0])] = words[1];
    known.push_back((words[0] == "bind" ? "" : "prefer ") + line.text);
  }
  for (const std::string& line : known) session.run(line);
  if (read.unknown.empty()) return read;
  std::string names;
  for (const std::string& line : read.unknown) names.append(names.empty() ? "" : ", ").append(split_words(line)[0]);
  read.warning = {file.string() + " has preferences that this version does not know, which stay there: " + names + ".",
                  file.string() + " にこの版で使わない設定があります（そのまま残します）：" + names + "。"};
  return read;
}

UserFiles::UserFiles(fs::path folder, fs::path preferences) : folder_(std::move(folder)) {
  if (!folder_.empty()) {
    preferences_.path = folder_ / "preferences";
    layout_.path = folder_ / "layout";
    recent_.path = folder_ / "recent";
  }
  if (!preferences.empty()) preferences_.path = std::move(preferences);
}

Text UserFiles::begin(Session& session) {
  Text said;
  const auto say = [&](const Text& more) {
    said.en += (said.en.empty() ? "" : " ") + more.en;
    said.ja += more.ja;
  };
  Result<ReadPreferences> read = read_preferences(session, preferences_.path);
  preferences_.is_broken = !read;
  if (read) unknown_ = std::move(read->unknown);
  if (read) file_ = std::move(read->values);
  if (!read)
    say(read.failure().message.text);
  else if (!read->warning.en.empty())
    say(read->warning);
  begin_layout(session, said);
  begin_recent(session.preferences);
  take_as_given(session);
  preferences_.written = preferences_now(session);
  layout_.written = content_of(layout_head, session.layout.commands());
  return said;
}

void UserFiles::begin_layout(Session& session, Text& said) {
  const Result<std::vector<Line>> lines = lines_of(layout_.path);
  const Layout at_first = session.layout;
  Text broken = lines ? Text() : lines.failure().message.text;
  for (std::size_t i = 0; lines && i < lines->size() && broken.en.empty(); ++i) {
    const Line& line = (*lines)[i];
    const auto words = split_words(line.text);
    const bool is_layout = words[0] == "panel" || words[0] == "columns";
    const auto fault = is_layout ? fault_of_command(line.text)
                                 : std::optional(Text{"this is no line of a layout", "配置の行ではありません"});
    if (fault)
      broken = broken_line(layout_.path, line, *fault).message.text;
    else
      session.run(line.text);
  }
  session.layout.wanted.clear();  // nobody asks for one of them now
  layout_.is_broken = !broken.en.empty();
  if (!layout_.is_broken) return;
  session.layout = at_first;
  said.en += (said.en.empty() ? "" : " ") + broken.en;
  said.ja += broken.ja;
}

void UserFiles::begin_recent(Preferences& preferences) {
  preferences.recent.clear();
  const Result<std::vector<Line>> lines = lines_of(recent_.path);
  if (!lines) return;
  for (const Line& line : *lines)
    if (preferences.recent.size() < most_recent) preferences.recent.push_back(file_name(line.text));
}

void UserFiles::take_as_given(const Session& session) {
  for (const PreferenceRow& row : preference_table()) given_[std::string(row.field.id)] = row.value(session);
}

// A value that nobody has changed in the window stays what it is in the file.
std::string UserFiles::preferences_now(const Session& session) {
  std::vector<std::string> lines;
  for (const PreferenceRow& row : preference_table()) {
    const std::string id(row.field.id), value = row.value(session);
    if (value != given_[id]) file_[id] = given_[id] = value;
    if (const auto kept = file_.find(id); kept != file_.end()) lines.push_back(id + " " + kept->second);
  }
  for (const KeyBinding& binding : session.preferences.bindings) lines.push_back(line_of(binding));
  lines.insert(lines.end(), unknown_.begin(), unknown_.end());
  return content_of(preferences_head, lines);
}

// Other windows may have noted files meanwhile.
void UserFiles::note_recent(const fs::path& path, Preferences& preferences) {
  std::error_code ignored;
  const std::string file = path.empty() ? std::string() : fs::absolute(path, ignored).string();
  if (file.empty() || file == last_file_) return;
  last_file_ = file;
  begin_recent(preferences);
  std::erase(preferences.recent, file);
  preferences.recent.insert(preferences.recent.begin(), file);
  if (preferences.recent.size() > most_recent) preferences.recent.resize(most_recent);
}

Status UserFiles::write(Kept& kept, const std::string& content) {
  if (kept.path.empty() || content == kept.written) return success();
  kept.written = content;  // tried once
  std::error_code error;
  fs::create_directories(kept.path.parent_path(), error);
  if (kept.is_broken) {
    fs::path aside = kept.path;
    aside += ".broken";
    fs::rename(kept.path, aside, error);
    if (error) return not_writable(aside, error.value());
    kept.is_broken = false;
  }
  const Status status = safe_write(kept.path, content);
  return is_in_place(status) ? success() : status;
}

std::optional<Text> UserFiles::keep(Session& session) {
  if (folder_.empty() && preferences_.path.empty()) return std::nullopt;
  note_recent(session.document().path(), session.preferences);
  std::vector<std::string> recent;
  for (const std::string& file : session.preferences.recent) recent.push_back(file_argument(file));
  const Status kept[]{
      write(preferences_, preferences_now(session)),
      write(layout_, content_of(layout_head, session.layout.commands())),
      recent.empty() ? success() : write(recent_, content_of(recent_head, recent)),
  };
  for (const Status& status : kept) {
    if (status || has_failed_) continue;
    has_failed_ = true;
    const Text& why = status.failure().message.text;
    return Text{"What you prefer cannot be kept for the next time: " + why.en, "設定を保存できません：" + why.ja};
  }
  return std::nullopt;
}

}  // namespace ryosen
