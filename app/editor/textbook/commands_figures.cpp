// The commands `exercise` and `figure`: the meshes of the source texts.
#include "app/editor/commands/text/script.h"
#include "app/editor/recovery/autosave.h"
#include "app/editor/session/session.h"
#include "app/editor/textbook/exercises.h"
#include "app/editor/textbook/figures.h"
#include "app/editor/textbook/textbook_commands.h"

namespace ryosen {

std::optional<Text> fault_of_exercise(Words arguments, const std::string&) {
  const bool is_one = arguments.size() == 1 && find_exercise(arguments[0]);
  return is_one ? std::nullopt : std::optional(wrong_arguments("exercise").sentence);
}

// Its steps name their elements by numbers, which begin at 0 in an empty mesh without a history only.
Outcome run_exercise(Session& session, Words arguments, std::string_view) {
  if (fault_of_exercise(arguments, {})) return wrong_arguments("exercise");
  if (session.mesh().vertex_slots() > 0 || !session.document().path().empty())
    return failed(ExitCode::refused, {"an exercise begins with an empty mesh; first say: new",
                                      "演習は空のメッシュから始めます。先に new を実行してください"});
  Outcome outcome;
  for (const ScriptLine& line : split_script(find_exercise(arguments[0])->script))
    if (outcome = session.run(line.text); !outcome.done()) return outcome;
  session.document().mark_generated();
  if (session.frontend.autosave) session.frontend.autosave->note_document(session.document());
  session.framing.frame_all();
  outcome.performed.clear();
  outcome.sentence = {"Undo goes back through its steps.", "「元に戻す」で一手ずつ戻れます。"};
  return outcome;
}

std::optional<Text> fault_of_figure(Words arguments, const std::string&) {
  const bool is_one = arguments.size() == 1 && find_figure(arguments[0]);
  return is_one ? std::nullopt : std::optional(wrong_arguments("figure").sentence);
}

// An entry of the history, so that what is recovered has it too.
Outcome run_figure(Document& document, Framing& framing, Words arguments, std::string_view) {
  if (fault_of_figure(arguments, {})) return wrong_arguments("figure");
  if (document.mesh().vertex_slots() > 0 || !document.path().empty())
    return failed(ExitCode::refused, {"a figure comes into an empty mesh; first say: new",
                                      "図は空のメッシュに置きます。先に new を実行してください"});
  const Figure& figure = *find_figure(arguments[0]);
  Result<MeshFile> file = mesh_of_figure(figure);
  if (!file) return failed(file.failure());
  const std::string line = "figure " + std::string(figure.id);
  document.append(std::move(file).value(), line);
  document.mark_generated();
  framing.frame_all();
  Outcome outcome;
  outcome.performed = line;
  outcome.sentence = {std::string(figure.name_en) + ".", std::string(figure.name_ja) + "。"};
  return outcome;
}

}  // namespace ryosen
