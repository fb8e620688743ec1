#include "app/editor/recovery/autosave.h"

#include <cerrno>
#include <cstdio>
#include <new>
#include <utility>

#include "app/editor/commands/commands.h"
#include "app/editor/commands/text/words.h"
#include "ryosen/io/formats.h"
#include "ryosen/io/gzip.h"
#include "ryosen/io/system_reason.h"

namespace ryosen {

namespace {

namespace fs = std::filesystem;

fs::path whole(const fs::path& path) {
  std::error_code ignored;
  return path.empty() ? path : fs::absolute(path, ignored);
}

std::string file_remark(const Document& document) {
  const FileState& known = document.known_file_with_content();
  return known.is_known() ? "# file " + known.text() + "\n" : std::string();
}

std::string original_remark(const fs::path& path) { return "# original " + file_argument(path.string()) + "\n"; }

}  // namespace

void Autosave::begin(const Document& document) {
  begin(document, {whole(document.path()), {}, document.mesh().hash(), document.known_file()});
}

void Autosave::begin(const Document& document, SessionStart start) {
  fs::path file = whole(document.path());
  finish();
  start_ = std::move(start);
  file_.swap(file);
  unsaved_ = {};
  has_failed_ = false;
}

std::optional<Text> Autosave::begin_anew(const Document& document, const std::vector<std::string>& log,
                                         SessionStart start) {
  begin(document, std::move(start));
  return open_script(document, log);
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

std::error_code Autosave::copy_as_original(const fs::path& file) {
  const fs::path& start = start_.file;
  const std::string packing = has_gzip_name(start) ? start.extension().string() : "";
  const fs::path copy = script_->companion(without_gzip(start).extension().string() + packing);
  std::error_code error;
  fs::copy_file(file, copy, fs::copy_options::overwrite_existing, error);
  if (!error) fs::permissions(copy, fs::perms::owner_read | fs::perms::owner_write, error);
  if (!error) start_.original = copy;
  return error;
}

// Copies a file that is about to be replaced.
std::optional<Text> Autosave::keep_original(const fs::path& file) {
  const std::error_code error = copy_as_original(file);
  if (!error) return std::nullopt;
  const Text reason = system_reason(error.value());
  return give_up({reason.en + ".", reason.ja + "。"});
}

// Writes the mesh that the session began with, for a file that has changed since. Keeps only what is read as the same
// mesh: a format may hold less.
void Autosave::write_original(const Document& document) {
  const Format* format = format_to_write(start_.file, document.file());
  if (!format || !format->write) format = find_format("ply");
  const fs::path copy = script_->companion(std::string(format->extensions.front()));
  if (!write_mesh_file(copy, document.contents_as_read(), {.format = format})) return;
  Result<MeshFile> again = read_mesh_file(copy);
  if (again && Document(std::move(again).value()).mesh().hash() == start_.hash) start_.original = copy;
}

// Copies the file that the session began with, so that its edits come back whatever becomes of that file. Without a
// copy they begin with the file itself.
void Autosave::keep_start(const Document& document) {
  const auto is_as_read = [&] { return start_.state.since(start_.file) == FileState::Change::none; };
  if (!start_.state.is_known()) return;
  if (is_as_read() && !copy_as_original(start_.file) && is_as_read()) return;
  start_.original.clear();
  write_original(document);
}

std::optional<Text> Autosave::open_script(const Document& document, const std::vector<std::string>& log) {
  if (folder_.empty())
    return give_up({"neither XDG_STATE_HOME nor HOME names a folder.",
                    "環境変数 XDG_STATE_HOME も HOME もフォルダを指していません。"});
  Result<OwnedScript> script = OwnedScript::create(folder_);
  if (!script) return give_up(script.failure().message.text);
  script_ = std::move(script).value();
  std::string text = "# ryosen session 1\n# mesh " + hash_text(start_.hash) + "\n";
  text += start_.file.empty() ? "new\n" : "open " + file_argument(start_.file.string()) + "\n";
  std::optional<Text> warning;
  if (start_.original.empty())
    keep_start(document);
  else  // it is a companion of the lost script and would be deleted with it
    warning = keep_original(start_.original);
  if (!start_.original.empty()) text += original_remark(start_.original);
  if (file_ != start_.file) text += saved_remark();
  text += file_remark(document);
  // A recovery may already have applied some edits.
  std::size_t lines = 0;
  for (const std::string& line : log) {
    if (!is_edit(line)) continue;
    text += line + "\n";
    ++lines;
  }
  text += remark_behind(lines, document);
  if (!warning) warning = append(text);
  if (has_failed_) finish();
  return warning;
}

std::optional<Text> Autosave::note(const Document& document, const std::vector<std::string>& log) {
  const std::string& line = log.back();
  const auto call = call_of(line);
  const bool edits = is_edit(line), saves = call && call->effect == Effect::writes;
  if (saves) file_ = whole(document.path());
  if (has_failed_) {
    // The script from before the failure may start from a file that has now been replaced.
    if (saves) finish();
    if (!std::exchange(lacked_memory_, false)) return std::nullopt;
    return give_up({"there was not enough memory.", "メモリが足りませんでした。"});
  }
  if (edits && !script_) return open_script(document, log);
  if (!script_ || !(edits || saves)) return std::nullopt;
  std::string text = (edits ? line + "\n" : "") + remark_behind(edits ? 1 : 0, document);
  if (saves) text += file_remark(document);
  return append(text);
}

std::optional<Text> Autosave::before_save(const Document& document, const std::vector<std::string>& log,
                                          const fs::path& target) {
  std::error_code error;
  std::optional<Text> warning;
  const bool replaces_start = !start_.file.empty() && fs::equivalent(target, start_.file, error);
  if (!has_failed_ && replaces_start && start_.original.empty()) {
    if (!script_) warning = open_script(document, log);
    if (script_ && !has_failed_ && start_.original.empty()) {
      warning = keep_original(start_.file);
      if (!has_failed_) warning = append(original_remark(start_.original));
    }
  }
  if (script_ && !has_failed_ && !warning) warning = append("# saving " + file_argument(whole(target).string()) + "\n");
  return warning;
}

void Autosave::note_document(const Document& document) {
  if (script_ && !has_failed_) append(remark_behind(0, document) + file_remark(document));
}

void Autosave::finish() {
  try {
    if (script_) script_->remove();
  } catch (const std::bad_alloc&) {  // it is offered for recovery once more
  }
  script_.reset();
}

}  // namespace ryosen
