#include "app/editor/autosave.h"

#include <cerrno>
#include <cstdio>
#include <new>
#include <utility>

#include "app/editor/commands.h"
#include "app/editor/words.h"
#include "core/io/gzip.h"
#include "core/io/system_reason.h"

namespace ryosen {

namespace {

namespace fs = std::filesystem;

fs::path whole(const fs::path& path) {
  std::error_code ignored;
  return path.empty() ? path : fs::absolute(path, ignored);
}

std::string original_remark(const fs::path& path) { return "# original " + file_argument(path.string()) + "\n"; }

}  // namespace

void Autosave::begin(const Document& document) {
  begin(document, {whole(document.path()), {}, document.mesh().hash()});
}

void Autosave::begin(const Document& document, SessionStart start) {
  fs::path file = whole(document.path());
  finish();
  start_ = std::move(start);
  file_.swap(file);
  unsaved_ = {};
  has_failed_ = false;
}

void Autosave::go_on(OwnedScript script, const Document& document, const LostSession& lost) {
  begin(document, lost.start);
  script_ = std::move(script);
  unsaved_ = lost.unsaved;
}

std::string Autosave::saved_remark() const { return "# saved " + file_argument(file_.string()) + "\n"; }

std::string Autosave::remark_behind(std::size_t lines, const Document& document) {
  unsaved_.edits += lines;
  if (!document.is_modified()) {
    unsaved_ = {};
    return saved_remark();
  }
  const Document::Unsaved now = document.unsaved();
  if (std::exchange(unsaved_, now) == now) return {};
  return "# unsaved " + std::to_string(now.edits) +
         (now.undone > 0 ? " " + std::to_string(now.undone) : std::string()) + "\n";
}

std::optional<Text> Autosave::give_up(const Text& reason) {
  has_failed_ = true;
  if (has_warned_) return std::nullopt;
  has_warned_ = true;
  return Text{"After a crash, edits from here on could not be recovered: " + reason.en,
              "異常終了した場合、これ以降の編集は復元できません：" + reason.ja};
}

std::optional<Text> Autosave::append(const std::string& text) {
  if (script_->append(text)) return std::nullopt;
  const Text reason = system_reason(errno);
  return give_up({reason.en + ".", reason.ja + "。"});
}

// Copies a file that is about to be replaced.
std::optional<Text> Autosave::keep_original(const fs::path& file) {
  const fs::path& start = start_.file;
  const std::string packing = has_gzip_name(start) ? start.extension().string() : "";
  const fs::path copy = script_->companion(without_gzip(start).extension().string() + packing);
  std::error_code error;
  fs::copy_file(file, copy, fs::copy_options::overwrite_existing, error);
  if (!error) fs::permissions(copy, fs::perms::owner_read | fs::perms::owner_write, error);
  if (error) {
    const Text reason = system_reason(error.value());
    return give_up({reason.en + ".", reason.ja + "。"});
  }
  start_.original = copy;
  return std::nullopt;
}

std::optional<Text> Autosave::open_script(const Session& session) {
  if (folder_.empty())
    return give_up({"neither XDG_STATE_HOME nor HOME names a folder.",
                    "環境変数 XDG_STATE_HOME も HOME もフォルダを指していません。"});
  Result<OwnedScript> script = OwnedScript::create(folder_);
  if (!script) return give_up(script.failure().message.text);
  script_ = std::move(script).value();
  char hash[17];
  std::snprintf(hash, sizeof hash, "%016llx", static_cast<unsigned long long>(start_.hash));
  std::string text = "# ryosen session 1\n# mesh " + std::string(hash) + "\n";
  text += start_.file.empty() ? "new\n" : "open " + file_argument(start_.file.string()) + "\n";
  std::optional<Text> warning;
  if (!start_.original.empty()) {  // it is a companion of the lost script and would be deleted with it
    warning = keep_original(start_.original);
    text += original_remark(start_.original);
  }
  if (file_ != start_.file) text += saved_remark();
  // A recovery may already have applied some edits.
  std::size_t lines = 0;
  for (const std::string& line : session.log()) {
    if (!is_edit(line)) continue;
    text += line + "\n";
    ++lines;
  }
  text += remark_behind(lines, session.document());
  if (!warning) warning = append(text);
  if (has_failed_) finish();
  return warning;
}

std::optional<Text> Autosave::note(const Session& session, const std::string& line) {
  const auto call = call_of(line);
  const bool edits = is_edit(line), saves = call && call->row.effect == Effect::writes;
  if (saves) file_ = whole(session.document().path());
  if (has_failed_) {
    // The script from before the failure may start from a file that has now been replaced.
    if (saves) finish();
    if (!std::exchange(lacked_memory_, false)) return std::nullopt;
    return give_up({"there was not enough memory.", "メモリが足りませんでした。"});
  }
  if (edits && !script_) return open_script(session);
  if (!script_ || !(edits || saves)) return std::nullopt;
  return append((edits ? line + "\n" : "") + remark_behind(edits ? 1 : 0, session.document()));
}

std::optional<Text> Autosave::before_save(const Session& session, const fs::path& target) {
  std::error_code error;
  if (has_failed_ || start_.file.empty() || !start_.original.empty() || !fs::equivalent(target, start_.file, error))
    return std::nullopt;
  std::optional<Text> warning = script_ ? std::nullopt : open_script(session);
  if (!script_ || has_failed_) return warning;
  warning = keep_original(start_.file);
  return warning || has_failed_ ? warning : append(original_remark(start_.original));
}

void Autosave::finish() {
  try {
    if (script_) script_->remove();
  } catch (const std::bad_alloc&) {  // it is offered for recovery once more
  }
  script_.reset();
}

}  // namespace ryosen
