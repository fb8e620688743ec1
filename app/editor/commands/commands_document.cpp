// The commands of files and of the history; `compare` reads another mesh beside the open one.
#include "app/editor/commands/command_functions.h"
#include "app/editor/commands/text/script.h"
#include "app/editor/commands/text/words.h"
#include "app/editor/document/large_files.h"
#include "app/editor/document/written_mesh.h"
#include "app/editor/recovery/autosave.h"
#include "app/editor/session/selection.h"
#include "app/editor/session/session.h"
#include "app/editor/texts/message_place.h"
#include "ryosen/io/file_target.h"
#include "ryosen/io/formats.h"
#include "ryosen/io/safe_write.h"
#include "ryosen/io/system_reason.h"

namespace ryosen {

namespace {

Outcome performed(std::string line) {
  Outcome outcome;
  outcome.performed = std::move(line);
  return outcome;
}

// Goes N entries through the history, or nowhere when there are not so many.
Outcome step_history(Document& document, Words arguments, std::string_view id, bool back) {
  const auto n = count_of(arguments);
  if (!n) return wrong_arguments(id);
  const std::size_t possible = back ? document.position() : document.history().size() - document.position();
  if (*n <= possible) {
    document.go_to(back ? document.position() - *n : document.position() + *n);
    return performed(std::string(id) + (*n == 1 ? "" : " " + std::to_string(*n)));
  }
  const std::string wanted = std::to_string(*n), there = std::to_string(possible), verb(id);
  if (possible == 0)
    return failed(ExitCode::refused, {"there is nothing to " + verb, verb + " できる操作がありません"});
  const std::string only = possible == 1 ? "there is only one edit to " : "there are only " + there + " edits to ";
  return failed(ExitCode::refused, {only + verb + ", not " + wanted,
                                    verb + " できる操作は " + there + " 件だけです（" + wanted + " 件の指定）"});
}

}  // namespace

Outcome run_undo(Document& document, Words a, std::string_view) { return step_history(document, a, "undo", true); }
Outcome run_redo(Document& document, Words a, std::string_view) { return step_history(document, a, "redo", false); }

bool opening_takes_long(Words arguments) {
  if (arguments.empty()) return false;
  const char* const begin = arguments.front().data();  // the words are parts of one line
  const char* const end = arguments.back().data() + arguments.back().size();
  return is_long_to_read(file_name({begin, static_cast<std::size_t>(end - begin)}));
}

Outcome not_read(const Failure& failure, const std::string& name) {
  if (failure.exit_code == ExitCode::cancelled) return cancelled();
  return failed(failure.exit_code, text_with_place(failure.message, name));
}

Outcome run_open(Session& session, Words arguments, std::string_view whole) {
  if (arguments.empty()) return wrong_arguments("open");
  const std::string name = file_name(whole);
  auto document = session.frontend.read_document(name);
  if (!document) return not_read(document.failure(), name);
  session.set_document(std::move(document).value());
  return performed("open " + file_argument(name));
}

Outcome run_new(Session& session, Words arguments, std::string_view) {
  if (!arguments.empty()) return wrong_arguments("new");
  session.set_document(std::make_unique<Document>());
  session.frontend.begins_empty = true;
  return performed("new");
}

Outcome run_start(Session& session, Words arguments, std::string_view) {
  if (!arguments.empty()) return wrong_arguments("start");
  session.set_document(std::make_unique<Document>());
  session.frontend.begins_empty = false;
  return performed("new");
}

Outcome run_append(Document& document, Framing& framing, Selecting& selecting, RunFiles& files, Words arguments,
                   std::string_view whole) {
  if (arguments.empty()) return wrong_arguments("append");
  const std::string name = file_name(whole);
  Result<MeshFile> file = read_mesh_file(name);
  if (!file) return failed(file.failure().exit_code, text_with_place(file.failure().message, name));
  const FirstSlots before(document.mesh());
  const bool was_empty = document.mesh().live() == ElementCounts();
  const std::string line = "append " + file_argument(name);
  const Text left_out = document.append(std::move(file).value(), line);
  files.reads(name, FileRole::mesh);
  selecting.selection = before.added_to(document.mesh());
  if (was_empty) framing.frame_all();
  Outcome outcome = performed(line);
  outcome.sentence = left_out;
  return outcome;
}

Outcome run_save_selected(Document& document, const Selecting& selecting, const Frontend& frontend, RunFiles& files,
                          Words arguments, std::string_view whole) {
  if (arguments.empty()) return wrong_arguments("save_selected");
  if (selecting.selection.empty())
    return failed(ExitCode::refused, {"save_selected: nothing is selected", "save_selected：選択がありません"});
  const std::string name = file_name(whole);
  if (const Status may = files.may_write(name, FileRole::saved); !may) return failed(may.failure());
  const MeshFile part = document.part(selecting.selection);
  const Format* const format = format_to_write(name, part);
  const std::vector<Message> losses = format && format->write ? loss_messages(part, *format) : std::vector<Message>();
  if (frontend.is_strict && !losses.empty()) return failed(refusal_of_losses());
  const Status status = write_mesh_file(name, part, {.format = format});
  if (is_in_place(status)) files.writes(name, FileRole::saved);
  if (!status) return failed(status.failure());
  Outcome outcome;
  const std::string v = std::to_string(part.mesh.positions.size()), f = std::to_string(part.mesh.face_count());
  outcome.sentence = {v + " vertices and " + f + " faces were written to " + name + ".",
                      "頂点 " + v + "、面 " + f + " を " + name + " に書き出しました。"};
  for (const Message& loss : losses) outcome.say(loss.text);
  return outcome;
}

Outcome run_reload(Session& session, Words arguments, std::string_view) {
  if (!arguments.empty()) return wrong_arguments("reload");
  const std::string name = session.document().path().string();
  if (name.empty())
    return failed(ExitCode::refused, {"the mesh has no file that could be read again", "読み直すファイルがありません"});
  const Camera camera = session.view.camera;
  Outcome outcome = session.run("open " + file_argument(name));
  if (!outcome.done()) return outcome;
  session.view.camera = camera;
  outcome.performed.clear();  // the log begins with what opened it
  return outcome;
}

Outcome run_keep_mine(Session& session, Words arguments, std::string_view) {
  if (!arguments.empty()) return wrong_arguments("keep_mine");
  session.document().take_file_as_known();
  session.document().mark_unsaved();  // no file holds this mesh
  if (session.frontend.autosave) session.frontend.autosave->note_document(session.document());
  session.look_at_disk();
  return {};
}

Outcome run_save(Session& session, Words, std::string_view whole) {
  Document& document = session.document();
  const std::string named = file_name(whole);
  if (named.empty() && !whole.empty()) return failed(ExitCode::usage, empty_name());
  const std::filesystem::path target = named.empty() ? document.path() : std::filesystem::path(named);
  if (target.empty()) return usage_error("save needs a file name here", "保存先のファイル名を指定してください");
  if (const Status may = session.files.may_write(target, FileRole::saved); !may) return failed(may.failure());
  session.look_at_disk();
  if (session.change_on_disk() == FileState::Change::changed &&
      is_same_file(target_of(target), target_of(document.path()))) {
    const std::string name = target.filename().string();
    return failed(
        ExitCode::refused,
        {"Another program has changed " + name +
             " since it was read. Reload (reload) reads it again; Keep mine (keep_mine) lets the next save replace it.",
         name + " は読み込み後に他のプログラムが変更しました。「読み直す」（reload）で読み直すか、"
                "「こちらを残す」（keep_mine）のあとで保存すると上書きできます。"});
  }
  const std::vector<Message> losses = document.losses(target);
  if (session.frontend.is_strict && !losses.empty()) {
    Outcome outcome = failed(refusal_of_losses());
    for (const Message& loss : losses) outcome.say(loss.text);
    return outcome;
  }
  const std::optional<Text> warning =
      session.frontend.autosave ? session.frontend.autosave->before_save(session.document(), session.log(), target)
                                : std::nullopt;
  const Status status = document.save(target);
  if (is_in_place(status)) session.files.writes(target, FileRole::saved);
  if (!status) {
    Outcome outcome = failed(status.failure());
    if (is_in_place(status)) outcome.performed = "save " + file_argument(target.string());
    return outcome;
  }
  session.look_at_disk();
  Outcome outcome = performed(named.empty() ? "save" : "save " + file_argument(named));
  for (const Message& loss : losses) outcome.say(loss.text);
  if (const std::optional<Text> found = file_findings_text(document, target)) outcome.say(*found);
  if (warning) outcome.say(*warning);
  return outcome;
}

namespace {

struct RecoverCall {
  enum class Kind { list, recover, discard };
  Kind kind = Kind::list;
  std::uint32_t number = 0;
  RecoverOnto onto = RecoverOnto::unchanged;
};

std::optional<RecoverCall> read_recover_call(Words arguments) {
  using Kind = RecoverCall::Kind;
  if (arguments.empty() || (arguments.size() == 1 && arguments[0] == "list")) return RecoverCall();
  RecoverCall call{arguments[0] == "discard" ? Kind::discard : Kind::recover};
  if (call.kind == Kind::discard) arguments = arguments.subspan(1);
  const std::string_view last = arguments.empty() ? std::string_view() : arguments.back();
  if (call.kind == Kind::recover && arguments.size() == 2 && (last == "as_was" || last == "as_is")) {
    call.onto = last == "as_was" ? RecoverOnto::as_was : RecoverOnto::as_is;
    arguments = arguments.first(1);
  }
  const auto number = count_of(arguments);
  if (!number) return std::nullopt;
  call.number = *number;
  return call;
}

Outcome list_lost(const std::vector<LostSession>& lost) {
  Outcome outcome;
  for (std::size_t i = 0; i < lost.size(); ++i) {
    const std::string number = std::to_string(i + 1);
    const Text text = describe(lost[i]);
    outcome.say({number + ": " + text.en + ".", number + "：" + text.ja + "。"});
    if (const Text change = told_change(lost[i], lost[i].change); !change.en.empty()) outcome.say(change);
  }
  if (lost.empty()) outcome.sentence = nothing_to_recover();
  return outcome;
}

}  // namespace

bool recover_only_tells(Words arguments) {
  const auto call = read_recover_call(arguments);
  return call && call->kind != RecoverCall::Kind::recover;
}

std::optional<Text> fault_of_recover(Words arguments, const std::string&) {
  return fault_unless(read_recover_call(arguments).has_value(), "recover");
}

Outcome run_recover(Session& session, Words arguments, std::string_view) {
  const auto call = read_recover_call(arguments);
  if (!call) return wrong_arguments("recover");
  const bool lists = call->kind == RecoverCall::Kind::list;
  // A number is that of the list which was seen.
  if (lists || session.lost.empty())
    if (const Status listed = list_lost_sessions(session.lost); !listed) return failed(listed.failure());
  if (lists) return list_lost(session.lost);
  if (call->number > session.lost.size()) {
    const Text list = list_lost(session.lost).sentence;
    return usage_error("recover: there is no number " + std::to_string(call->number) + ". " + list.en,
                       "recover：" + std::to_string(call->number) + " 番はありません。" + list.ja);
  }
  const LostSession lost = session.lost[call->number - 1];
  Outcome outcome = call->kind == RecoverCall::Kind::discard ? discard(lost) : recover(session, lost, call->onto);
  if (const Status listed = list_lost_sessions(session.lost); !listed) outcome.say(listed.failure().message.text);
  return outcome;
}

namespace {

// Of a file that is not there yet, and will not be by this run.
std::string free_picture_name(const RunFiles& files) {
  std::string name = "ryosen.png";
  for (int i = 1; !files.is_free(name); ++i) name = "ryosen-" + std::to_string(i) + ".png";
  return name;
}

}  // namespace

Outcome run_shot(Frontend& frontend, RunFiles& files, Words, std::string_view whole) {
  if (!frontend.take_picture)
    return failed(ExitCode::no_backend, {"no picture can be made here; use ryosen shot --script",
                                         "ここでは画像を作れません。ryosen shot --script を使ってください"});
  std::string name = file_name(whole);
  if (name.empty()) name = free_picture_name(files);
  if (const Status may = files.may_write(name, FileRole::picture); !may) return failed(may.failure());
  const Status status = frontend.take_picture(name);
  if (is_in_place(status)) files.writes(name, FileRole::picture);
  return status ? performed("shot " + file_argument(name)) : failed(status.failure());
}

Outcome run_compare(Session& session, Words arguments, std::string_view whole) {
  if (arguments.empty()) return wrong_arguments("compare");
  if (arguments.size() == 1 && arguments[0] == "off") {
    session.compare_with(nullptr);
    return {};
  }
  const std::string name = file_name(whole);
  auto document = session.frontend.read_document(name);
  if (!document) return not_read(document.failure(), name);
  session.files.reads(name, FileRole::mesh);
  session.compare_with(std::move(document).value());
  return {};
}

}  // namespace ryosen
