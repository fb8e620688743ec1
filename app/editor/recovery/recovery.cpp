#include "app/editor/recovery/recovery.h"

#include <sys/stat.h>

#include <algorithm>
#include <charconv>
#include <chrono>
#include <span>
#include <thread>
#include <utility>

#include "app/editor/commands/commands.h"
#include "app/editor/commands/text/words.h"
#include "app/editor/preferences/user_folders.h"
#include "app/editor/recovery/autosave.h"
#include "app/editor/recovery/owned_script.h"
#include "app/editor/session/session.h"
#include "app/editor/texts/message_place.h"
#include "ryosen/io/folder_entries.h"
#include "ryosen/io/system_reason.h"

namespace ryosen {

namespace {

namespace fs = std::filesystem;

// The rest of a remark line that starts with this word, else none.
std::optional<std::string_view> remark(std::string_view line, std::string_view word) {
  if (!line.starts_with("# ") || !line.substr(2).starts_with(word)) return std::nullopt;
  const std::string_view rest = line.substr(2 + word.size());
  if (!rest.empty() && rest.front() != ' ') return std::nullopt;
  return without_blanks(rest);
}

// "1 2", the second is 0 where it is missing.
Document::Unsaved counts_of(std::string_view words) {
  Document::Unsaved counts;
  const char* const end = words.data() + words.size();
  const char* const blank = std::from_chars(words.data(), end, counts.edits).ptr;
  if (blank != end) std::from_chars(blank + 1, end, counts.undone);
  return counts;
}

std::string time_text(std::time_t time) {
  std::tm local{};
  ::localtime_r(&time, &local);
  char text[32];
  return {text, std::strftime(text, sizeof text, "%Y-%m-%d %H:%M", &local)};
}

// Retries, because a process scanning the folder locks each script briefly.
std::optional<OwnedScript> take(const fs::path& path) {
  for (int i = 0; i < 20; ++i) {
    if (auto script = OwnedScript::take(path)) return script;
    std::error_code ignored;
    if (!fs::exists(path, ignored)) break;
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  return std::nullopt;
}

Outcome not_to_be_had(const LostSession& lost) {
  const std::string script = lost.script.string();
  return failed(ExitCode::input_missing, {script + " is gone, or another window has recovered it.",
                                          script + " がないか、別のウィンドウで復元済みです。"});
}

Failure unreadable_folder(const fs::path& folder, int error) {
  const Text reason = system_reason(error);
  return make_failure(
      ExitCode::input_missing, "folder_unreadable",
      {"The folder " + folder.string() + ", where unsaved edits are kept, cannot be read: " + reason.en + ".",
       "保存していない編集を置くフォルダ " + folder.string() + " を読めません：" + reason.ja + "。"});
}

// Whether there is a copy of what the session began with.
bool has_original(const LostSession& lost) {
  std::error_code ignored;
  return !lost.start.original.empty() && fs::exists(lost.start.original, ignored);
}

// What the edits begin with; empty where that is an empty mesh.
const fs::path& source_of(const LostSession& lost, RecoverOnto onto) {
  return onto != RecoverOnto::as_is && has_original(lost) ? lost.start.original : lost.start.file;
}

Result<std::unique_ptr<Document>> begin_again(const LostSession& lost, const fs::path& source) {
  if (source.empty()) {
    MeshFile empty;
    return std::make_unique<Document>(std::move(empty), lost.file);
  }
  Result<MeshFile> file = read_mesh_file(source);
  if (!file) return file.failure();
  return std::make_unique<Document>(std::move(file).value(), lost.file);
}

Text count_edits(std::size_t n) {
  return {n == 1 ? "1 edit" : std::to_string(n) + " edits", std::to_string(n) + " 件の編集"};
}

// What the file lacks, and what it has too much.
Text difference_from_file(const Document::Unsaved& unsaved) {
  if (unsaved == Document::Unsaved{}) return {"all edits undone", "編集はすべて取り消し済み"};
  if (unsaved.undone == 0) return count_edits(unsaved.edits);
  const std::string undone = std::to_string(unsaved.undone), many = unsaved.undone == 1 ? "" : "s";
  const std::string ja = "保存済みの " + undone + " 件の取り消し";
  if (unsaved.edits == 0) return {undone + " saved edit" + many + " undone", ja};
  const Text count = count_edits(unsaved.edits);
  return {count.en + " and " + undone + " saved one" + many + " undone", count.ja + "と" + ja};
}

// Of so many entries of the history.
Text what_is_recovered(std::size_t entries, const Document::Unsaved& unsaved) {
  const Text count = count_edits(entries);
  const std::string last = std::to_string(unsaved.edits), undone = std::to_string(unsaved.undone);
  const std::string are = entries == 1 ? " is" : " are";
  Text text{count.en + are + " recovered and not saved yet.", count.ja + "を復元しました。まだ保存していません。"};
  if (entries == 0)
    text = {"The edits are recovered, and are undone as they were: redo does them again.",
            "編集を復元しました。すべて取り消した状態のままで、redo でやり直せます。"};
  else if (unsaved.edits == 0)
    text = {count.en + are + " recovered.", count.ja + "を復元しました。"};
  else if (unsaved.edits < entries)
    text = {count.en + " are recovered, of which the last " + last + (last == "1" ? " was" : " were") + " not saved.",
            count.ja + "を復元しました。そのうち最後の " + last + " 件は保存されていませんでした。"};
  if (unsaved.undone > 0)
    text += Text{" The file holds " + undone + " more, which had been undone.",
                 "ファイルには、取り消した " + undone + " 件も残っています。"};
  return text;
}

Text begun_with_another(const LostSession& lost) {
  const std::string file = lost.start.file.string();
  return {file + " is not the mesh that it was when these edits were made.",
          file + " は、これらの編集をしたときのメッシュではありません。"};
}

// "recover 2", by the place in the list.
std::string recover_line(std::span<const LostSession> all, const LostSession& lost) {
  const auto is_it = [&](const LostSession& other) { return other.script == lost.script; };
  const auto found = std::find_if(all.begin(), all.end(), is_it);
  return "recover " + (found == all.end() ? "N" : std::to_string(found - all.begin() + 1));
}

Outcome refused_first(const Session& session, const LostSession& lost, const Text& why) {
  const std::string line = recover_line(session.lost, lost);
  Outcome outcome = failed(ExitCode::refused, why);
  if (can_be_as_was(lost))
    outcome.say({line + " as_was does them again on the mesh as it was then, and leaves the file as it is now.",
                 line + " as_was で当時のメッシュに復元します（ファイルはそのまま残ります）。"});
  if (can_be_as_is(lost))
    outcome.say({line + " as_is does them again on the file as it is now.",
                 line + " as_is で今のファイルに対してやり直します。"});
  return outcome;
}

Text why_not(const LostSession& lost, RecoverOnto onto) {
  const std::string file = lost.start.file.string();
  if (onto == RecoverOnto::as_was)
    return {"There is no copy of " + file + " as it was when these edits were made.",
            "これらの編集をしたときの " + file + " の写しがありません。"};
  return {"These edits cannot be done again on the file as it is now: some of them were saved, or it is gone.",
          "途中で保存された編集があるか、ファイルがないため、今のファイルに対してはやり直せません。"};
}

// Replays the edits in the session, up to the first that fails.
Outcome replay(Session& session, const LostSession& lost) {
  for (std::size_t i = 0; i < lost.edits.size(); ++i) {
    if (i == lost.saved_edits) session.document().mark_saved();
    const ScriptLine& edit = lost.edits[i];
    const Outcome outcome = is_edit(edit.text)
                                ? session.run(edit.text)
                                : failed(ExitCode::usage, {"it is not an edit", "編集のコマンドではありません"});
    if (outcome.done()) continue;
    const std::string place = lost.script.string(), line = std::to_string(edit.line), n = std::to_string(i),
                      all = std::to_string(lost.edits.size());
    Outcome stopped =
        failed(outcome.exit_code, {n + " of " + all + " edits are recovered; line " + line + " of " + place +
                                       " cannot be done again (" + edit.text + "): " + outcome.sentence.en,
                                   all + " 件の編集のうち " + n + " 件を復元しました。" + place + " の " + line +
                                       " 行目（" + edit.text + "）はやり直せません：" + outcome.sentence.ja});
    stopped.say({"The script stays there.", "スクリプトはそのまま残してあります。"});
    return stopped;
  }
  return done_with(what_is_recovered(session.document().position(), lost.unsaved));
}

// The recovered document continues this script if it began as the script says; otherwise it gets a script of its own.
void hand_over(Autosave& autosave, Session& session, OwnedScript& script, const LostSession& lost, SessionStart start,
               Outcome& outcome) {
  const bool is_of_script = start.hash == lost.start.hash && start.original == lost.start.original;
  if (outcome.done() && is_of_script) {
    script.cut(lost.whole_bytes);
    return autosave.go_on(std::move(script), session.document(), lost);
  }
  if (!outcome.done()) return autosave.begin(session.document(), std::move(start));
  if (const auto warning = autosave.begin_anew(session.document(), session.log(), std::move(start)))
    outcome.say(*warning);
  if (autosave.script()) script.remove();
}

Text file_stays(const LostSession& lost, FileState::Change change) {
  if (change == FileState::Change::gone) return {};
  const std::string name = lost.file.filename().string();
  return {name + " stays as it is: saving to it is refused until keep_mine says so.",
          name + " はそのままです。keep_mine を実行するまで上書き保存はできません。"};
}

}  // namespace

fs::path recovery_folder() {
  const fs::path folder = user_folder(UserFolder::state);
  return folder.empty() ? folder : folder / "recovery";
}

bool is_edit(std::string_view line) {
  const auto call = call_of(line);
  return call && (call->effect == Effect::edits || call->effect == Effect::steps || call->row->prepares_edits);
}

bool can_be_as_was(const LostSession& lost) { return has_original(lost) || !can_be_as_is(lost); }

bool can_be_as_is(const LostSession& lost) {
  std::error_code ignored;
  return lost.saved_edits == 0 && !lost.file.empty() && lost.file == lost.start.file && fs::exists(lost.file, ignored);
}

Text told_change(const LostSession& lost, FileState::Change change) {
  const std::string file = lost.file.string();
  if (change == FileState::Change::gone)
    return {file + " has gone from the disk since these edits were made.",
            "これらの編集のあと、" + file + " がディスクからなくなりました。"};
  if (change == FileState::Change::none) return {};
  if (lost.was_saving)
    return {file + " was being saved when Ryosen ended, or another program has changed it.",
            file + " は異常終了のときに保存中だったか、他のプログラムが変更しました。"};
  return {"Another program has changed " + file + " since these edits were made.",
          "これらの編集のあと、" + file + " を他のプログラムが変更しました。"};
}

std::optional<LostSession> read_lost_session(std::string_view script) {
  LostSession lost;
  int number = 0;
  for (std::size_t end; (end = script.find('\n', lost.whole_bytes)) != script.npos; lost.whole_bytes = end + 1) {
    const std::string_view line = without_blanks(script.substr(lost.whole_bytes, end - lost.whole_bytes));
    ++number;
    if (number == 1 && line != "# ryosen session 1") return std::nullopt;
    if (const auto hash = remark(line, "mesh")) {
      std::from_chars(hash->data(), hash->data() + hash->size(), lost.start.hash, 16);
    } else if (const auto original = remark(line, "original")) {
      lost.start.original = file_name(*original);
    } else if (const auto state = remark(line, "file")) {
      lost.known = FileState::from_text(*state);
    } else if (remark(line, "saving")) {
      lost.was_saving = true;
    } else if (const auto saved = remark(line, "saved")) {
      lost.file = file_name(*saved);
      lost.known = {};
      lost.was_saving = false;
      lost.saved_edits = lost.edits.size();
      lost.unsaved = {};
    } else if (const auto unsaved = remark(line, "unsaved")) {
      lost.unsaved = counts_of(*unsaved);
    } else if (line.starts_with("open ") && number == 3) {
      lost.start.file = lost.file = file_name(behind_word(line));
    } else if (!line.empty() && !line.starts_with('#') && number > 3) {
      lost.edits.push_back({number, std::string(line)});
      lost.was_saving = false;
      ++lost.unsaved.edits;
    }
  }
  if (number == 0 && !script.empty()) return std::nullopt;
  return lost;
}

Status list_lost_sessions(std::vector<LostSession>& lost) {
  lost.clear();
  Result<std::vector<LostSession>> found = find_lost_sessions(recovery_folder());
  if (!found) return found.failure();
  lost = std::move(found).value();
  return success();
}

Result<std::vector<LostSession>> find_lost_sessions(const fs::path& folder) {
  std::vector<LostSession> found;
  std::error_code error;
  for (const ListedEntry& entry : folder_entries(folder, error)) {
    const std::string name = entry.path.filename().string();
    if (!name.starts_with(script_prefix) || !name.ends_with(script_suffix)) continue;
    std::optional<OwnedScript> script = OwnedScript::take(entry.path);
    if (!script) continue;
    const std::optional<std::string> content = script->content();
    std::optional<LostSession> lost = content ? read_lost_session(*content) : std::nullopt;
    struct stat status;
    if (!lost || ::stat(entry.path.c_str(), &status) != 0) continue;
    if (lost->is_saved()) {
      script->remove();
      continue;
    }
    lost->script = entry.path;
    lost->last_edit = status.st_mtime;
    lost->change = lost->known.since(lost->file);
    found.push_back(std::move(*lost));
  }
  if (error && error != std::errc::no_such_file_or_directory) return unreadable_folder(folder, error.value());
  std::sort(found.begin(), found.end(), [](const LostSession& a, const LostSession& b) {
    return a.last_edit != b.last_edit ? a.last_edit > b.last_edit : a.script < b.script;
  });
  return found;
}

Text nothing_to_recover() { return {"There is nothing to recover.", "復元できるものはありません。"}; }

Text describe(const LostSession& lost) {
  const std::string name = lost.file.string(), time = time_text(lost.last_edit);
  const Text count = difference_from_file(lost.unsaved);
  return {(name.empty() ? "a mesh without a file" : name) + ", " + count.en + ", " + time,
          (name.empty() ? "ファイルのないメッシュ" : name) + "、" + count.ja + "、" + time};
}

Outcome recover(Session& session, const LostSession& lost, RecoverOnto onto) {
  std::optional<OwnedScript> script = take(lost.script);
  if (!script) return not_to_be_had(lost);
  const FileState now = FileState::of(lost.file);  // before, so that what changes meanwhile is noticed
  FileState known = lost.known;
  const FileState::Change change = known.follow(lost.file);
  const bool is_unasked = onto == RecoverOnto::unchanged, is_as_is = onto == RecoverOnto::as_is;
  const bool may_be_gone = has_original(lost) || lost.start.file.empty() || lost.start.file != lost.file;
  if (is_unasked && change != FileState::Change::none && (change != FileState::Change::gone || may_be_gone))
    return refused_first(session, lost, told_change(lost, change));
  if (is_as_is && !can_be_as_is(lost)) return refused_first(session, lost, why_not(lost, onto));
  const fs::path source = source_of(lost, onto);
  Result<std::unique_ptr<Document>> document = begin_again(lost, source);
  if (!document) {
    const Text reason = text_with_place(document.failure().message, source.string());
    return failed(document.failure().exit_code, {reason.en + " The edits are still in " + lost.script.string() + ".",
                                                 reason.ja + " 編集は " + lost.script.string() + " に残っています。"});
  }
  const std::uint64_t hash = (*document)->mesh().hash();
  const bool is_same = source.empty() || hash == lost.start.hash;
  if (!is_same && is_unasked) return refused_first(session, lost, begun_with_another(lost));
  if (!is_same && !is_as_is && !can_be_as_was(lost)) return refused_first(session, lost, why_not(lost, onto));
  (*document)->mark_unsaved();
  if (is_as_is || !known.is_known()) known = now;
  (*document)->know_file_as(is_as_is || change == FileState::Change::none ? known : FileState::of_none_that_is());
  Autosave* const autosave = std::exchange(session.frontend.autosave, nullptr);
  const bool was_strict = std::exchange(session.frontend.is_strict, false);
  session.set_document(std::move(document).value(), lost.start.file);
  Outcome outcome = replay(session, lost);
  session.framing.frame_all();
  session.frontend.autosave = autosave;
  session.frontend.is_strict = was_strict;
  session.look_at_disk();
  const SessionStart start = is_as_is ? SessionStart{lost.file, {}, hash, now} : lost.start;
  if (autosave) hand_over(*autosave, session, *script, lost, start, outcome);
  if (change != FileState::Change::none && !is_as_is && outcome.done()) outcome.say(file_stays(lost, change));
  if (!is_same) outcome.say(Text{"But ", "ただし "} + begun_with_another(lost));
  return outcome;
}

Outcome discard(const LostSession& lost) {
  std::optional<OwnedScript> script = take(lost.script);
  if (!script) return not_to_be_had(lost);
  script->remove();
  const Text what = describe(lost);
  return done_with({"Discarded: " + what.en + ".", "破棄しました：" + what.ja + "。"});
}

}  // namespace ryosen
