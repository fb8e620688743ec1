#include "app/editor/shown/levels.h"

#include <utility>

#include "app/editor/commands/commands.h"
#include "app/editor/session/session.h"
#include "ryosen/algo/algorithms.h"

namespace ryosen {

std::span<const ParameterRow> level_parameters() {
  static const std::vector<ParameterRow> rows = [] {
    std::vector<ParameterRow> some;
    for (ParameterRow row : find_algorithm("simplify")->parameters) {
      if (row.id == "faces" || row.id == "ratio") continue;
      row.one_of = "";
      some.push_back(std::move(row));
    }
    return some;
  }();
  return rows;
}

ShownLevels::ShownLevels(std::unique_ptr<DetailLevels> levels, ParameterValues values, const Document& document)
    : levels_(std::move(levels)),
      values_(std::move(values)),
      quarantined_(document.tables().quarantine.size()),
      history_position_(document.position()),
      serial_(document.serial()),
      revision_(document.revision()) {}

std::size_t ShownLevels::level_of(std::size_t faces) const {
  return levels_->level_of(faces - std::min(faces, quarantined_));
}

bool ShownLevels::fits(const Document& document) const {
  return document.serial() == serial_ && document.position() == history_position_;
}

void ShownLevels::go_to(Document& document, std::size_t level) {
  levels_->go_to(level);
  document.show_on_trial(levels_->mesh().columns());
  revision_ = document.revision();
}

void ShownLevels::end(Document& document) const {
  if (is_shown(document)) document.end_trial();
}

std::string ShownLevels::line() const {
  ParameterValues values = values_;
  values.set("faces", std::to_string(faces()), "faces");
  return "simplify " + values.line();
}

void end_levels(Session& session) {
  if (session.levels) session.levels->end(session.document());
  session.levels.reset();
}

LevelAside::LevelAside(Session& session, Effect effect)
    : session_(session),
      levels_(std::move(session.levels)),
      was_shown_(levels_ && levels_->is_shown(session.document())),
      effect_(effect) {
  session.levels.reset();
  if (levels_) levels_->end(session.document());
  revision_ = session.document().revision();
}

LevelAside::~LevelAside() {
  if (levels_ && !session_.levels) session_.levels = std::move(levels_);
}

void LevelAside::bring_back(Outcome& outcome) {
  const std::shared_ptr<ShownLevels> levels = std::exchange(levels_, nullptr);
  if (!levels || session_.levels) return;
  Document& document = session_.document();
  if (!levels->fits(document) || document.revision() != revision_) return;
  session_.levels = levels;
  if (!was_shown_) return;
  if (effect_ == Effect::writes && outcome.done())
    outcome.say({"This is the open mesh, not the level that is shown: levels keep makes that the open one.",
                 "保存したのは開いているメッシュで、表示中の段階ではありません（levels keep で段階を採用します）。"});
  if (effect_ != Effect::none || !outcome.done()) return levels->go_to(document, levels->levels().level());
  outcome.say({"The view shows the open mesh; the slider of Levels of detail shows a level again.",
               "ビューは開いているメッシュです。詳細度のスライダーで段階の表示に戻ります。"});
}

bool shows_level(const Session& session) { return session.levels && session.levels->is_shown(session.document()); }

Outcome leave_level(Session& session) {
  end_levels(session);
  Outcome outcome;
  outcome.sentence = {"The levels of detail are left; the mesh is as it was before them.",
                      "詳細度の表示を終え、元のメッシュに戻しました。"};
  return outcome;
}

std::string line_to_account_for(const Session& session) {
  const Document& document = session.document();
  if (session.levels && session.levels->is_shown(document)) return session.levels->line();
  if (document.is_on_trial() || document.position() == 0) return {};
  const std::string& line = document.history()[document.position() - 1].command;
  const AlgorithmRow* const row = find_algorithm(line.substr(0, line.find(' ')));
  return row && row->accounts_for_edges ? line : std::string();
}

const EdgeAccount* make_account(Session& session) {
  if (session.account()) return session.account();
  const std::string line = line_to_account_for(session);
  if (line.empty()) return nullptr;
  const std::vector<std::string_view> words = split_words(line);
  const AlgorithmRow& row = *find_algorithm(words[0]);
  const ReadValues given = read_values(row.parameters, std::span(words).subspan(1));
  if (!given.values) return nullptr;
  auto result = session.document().account_of(row, *given.values, session.on_progress);
  if (!result || !result->account || result->account->rules.empty()) return nullptr;
  session.keep_account({session.document().serial(), session.document().revision(), std::move(result->account->rules),
                        std::move(result->account->remaining)});
  return session.account();
}

}  // namespace ryosen
