#include "app/editor/shown/shown.h"

#include <algorithm>
#include <array>
#include <new>
#include <utility>

#include "app/editor/commands/text/words.h"
#include "app/editor/session/session.h"
#include "app/editor/shown/levels.h"
#include "app/editor/shown/player.h"

namespace ryosen {

namespace {

Outcome refused(std::string en, std::string ja) { return failed(ExitCode::refused, {std::move(en), std::move(ja)}); }

Text saved_beneath(ShownBy owner) {
  if (owner == ShownBy::level)
    return {"This is the open mesh, not the level that is shown: levels keep makes that the open one.",
            "保存したのは開いているメッシュで、表示中の段階ではありません（levels keep で段階を採用します）。"};
  return {"This is the open mesh, not the step that is shown.",
          "保存したのは開いているメッシュで、表示中の手順ではありません。"};
}

}  // namespace

Response response(ShownBy owner, Effect effect, bool has_view) {
  using enum Response;
  // One row per owner, in their order; one column per effect, in theirs.
  static constexpr std::array<std::array<Response, effect_count>, 5> answers{{
      // view  reads    begins  edits   steps    replaces  writes
      {{keep, keep, keep, keep, keep, keep, keep}},              // document
      {{keep, beneath, refuse, refuse, anew, again, again}},     // step
      {{keep, beneath, refuse, refuse, instead, again, again}},  // level
      {{keep, end, end, end, end, keep, keep}},                  // preview
      {{keep, end, end, end, end, end, end}},                    // gesture
  }};
  if (!has_view && owner != ShownBy::document) return effect == Effect::view ? keep : beneath;
  return answers[static_cast<std::size_t>(owner)][static_cast<std::size_t>(effect)];
}

Document& Shown::document() const { return session_.document(); }

ShownBy Shown::by() const { return document().is_on_trial() ? last_.owner : ShownBy::document; }

bool Shown::shows(ShownBy owner) const {
  return last_.owner == owner && last_.serial == document().serial() && last_.revision == document().revision();
}

void Shown::note(ShownBy owner) { last_ = {owner, document().serial(), document().revision()}; }

Outcome Shown::refusal() const {
  if (by() == ShownBy::level)
    return refused("the view shows a level of detail, not the mesh that is open; Esc or levels close ends that",
                   "ビューは詳細度の一段階を表示中です。Esc または levels close で開いているメッシュに戻ります");
  if (by() == ShownBy::preview)
    return refused("the view shows a preview of values, not the mesh that is open; run them or close their panel",
                   "ビューは値のプレビューを表示中です。実行するか、パネルを閉じると開いているメッシュに戻ります");
  const Text name = player_ ? player_->name() : Text();
  return refused(
      "the view shows a step of '" + name.en + "', not the mesh that is open; Esc or steps close ends that",
      "ビューは「" + name.ja + "」の手順を表示中です。Esc または steps close で開いているメッシュに戻ります");
}

bool Shown::fits() const {
  return (player_ || levels_) && begun_.serial == document().serial() && begun_.position == document().position();
}

void Shown::begin(std::shared_ptr<Player> player) {
  player_ = std::move(player);
  begun_ = {document().serial(), document().position()};
}

void Shown::begin(std::shared_ptr<ShownLevels> levels) {
  levels_ = std::move(levels);
  begun_ = {document().serial(), document().position()};
}

void Shown::go_to_step(std::size_t position) {
  player_->go_to(position);
  if (player_->edits()) {
    if (const Mesh* const mesh = player_->other_mesh())
      show(ShownBy::step, mesh->columns());
    else
      end();
  }
  note(ShownBy::step);
}

void Shown::go_to_level(std::size_t level) {
  levels_->go_to(level);
  show(ShownBy::level, levels_->levels().mesh().columns());
}

std::shared_ptr<Player> Shown::end_steps() {
  std::shared_ptr<Player> player = std::exchange(player_, nullptr);
  if (player && shows(ShownBy::step)) end();
  return player;
}

void Shown::end_levels() {
  if (levels_ && shows(ShownBy::level)) end();
  levels_.reset();
}

void Shown::show(ShownBy owner, MeshColumns columns) {
  document().show_on_trial(std::move(columns));
  note(owner);
}

Outcome Shown::try_out(ShownBy owner, const AnyOp& op) {
  end();
  Outcome outcome = document().try_out(op);
  note(owner);
  return outcome;
}

std::optional<EachResult> Shown::try_out(ShownBy owner, const OpInfo& op, std::span<const Element> elements,
                                         std::span<const std::string_view> arguments, Progress::Report progress) {
  end();
  auto result = document().try_out(op, elements, arguments, std::move(progress));
  note(owner);
  return result;
}

std::optional<AlgorithmResult> Shown::try_out(ShownBy owner, const AlgorithmRow& row, const ParameterValues& values,
                                              Progress::Report progress) {
  end();
  auto result = document().try_out(row, values, std::move(progress));
  note(owner);
  return result;
}

void Shown::end() {
  last_ = {};
  try {
    document().end_trial();  // which forgets the gesture that it was for
  } catch (const std::bad_alloc&) {
    session_.forget_derived();
    document().take_back(document().position());
  }
}

void Shown::forget() {
  player_.reset();
  levels_.reset();
  last_ = {};
}

void Shown::set_aside() {
  Aside& aside = aside_.emplace();
  aside.selection = session_.selecting.selection;
  aside.measures = session_.selecting.measures;
  Findings& findings = session_.findings();
  aside.hidden = findings.hidden().elements();
  const std::optional<Findings::Searched>& searched = findings.searched();
  HighlightSets* const sets = findings.found_highlights();
  const bool is_of_now =
      sets && searched && searched->document == document().serial() && searched->revision + 1 == document().revision();
  if (!is_of_now) return;
  aside.searched = searched->kind;
  aside.findings = sets->of(searched->kind).to_vector();
  aside.pairs = searched->pairs;
}

void Shown::bring_back() {
  if (!aside_) return;
  Aside aside = *std::exchange(aside_, std::nullopt);
  session_.selecting.selection = aside.selection;
  session_.selecting.measures = aside.measures;
  if (!aside.hidden.empty()) session_.selecting.hide(aside.hidden);
  if (aside.searched) session_.findings().put(*aside.searched, aside.findings, std::move(aside.pairs));
}

void Shown::forget_aside() {
  if (aside_) session_.selecting.selection = std::move(aside_->selection);
  aside_.reset();
}

Shown::Passage::Passage(Shown& shown, Effect effect, std::string_view line)
    : shown_(shown), effect_(effect), camera_(shown.session_.view.camera), serial_(shown.document().serial()) {
  const Response response = shown.response(effect);
  // A level is made to what it was made of.
  const bool makes_level = shown.by() == ShownBy::level && without_blanks(line) == shown.levels_->line();
  if (response == Response::refuse && !makes_level) {
    answered = shown.refusal();
    return;
  }
  if (response == Response::instead) {
    answered = leave_level(shown.session_.shown);
    return;
  }
  if (!shown.has_view && response != Response::keep) shown.end();  // nobody sees it: nothing is told
  if (is_logged(effect) || response != Response::keep) {
    was_shown_ = shown.shows(ShownBy::step) || shown.shows(ShownBy::level);
    player_ = std::exchange(shown.player_, nullptr);
    levels_ = std::exchange(shown.levels_, nullptr);
  }
  if (was_shown_ || response == Response::end) shown.end();
  revision_ = shown.document().revision();
}

void Shown::Passage::finish(Outcome& outcome) {
  if (player_ && !shown_.player_) bring_back_steps(outcome);
  if (levels_ && !shown_.levels_) bring_back_level(outcome);
}

void Shown::Passage::bring_back_steps(Outcome& outcome) {
  shown_.player_ = player_;
  if (shown_.fits()) {
    if (!was_shown_) return;
    if (outcome.done() && effect_ == Effect::reads) return show_beneath(outcome);
    shown_.go_to_step(player_->position());
    if (outcome.done() && effect_ == Effect::writes && shown_.is_replaced()) outcome.say(saved_beneath(ShownBy::step));
    return;
  }
  shown_.player_.reset();
  if (ryosen::response(ShownBy::step, effect_) == Response::anew) return make_anew(outcome);
  if (shown_.document().serial() == serial_) look_as_before(shown_.session_.view, shown_.session_.framing, *player_);
  outcome.say(end_of(*player_));
}

// Until the next step, and from where it was looked at before, unless the command looks from elsewhere. So what was
// taken back or done again is seen.
void Shown::Passage::show_beneath(Outcome& outcome) {
  if (shown_.session_.view.camera == camera_) look_as_before(shown_.session_.view, shown_.session_.framing, *player_);
  const Text name = player_->name();
  outcome.say({"The view shows the open mesh; the next step shows '" + name.en + "' again.",
               "ビューは開いているメッシュです。次の手順で「" + name.ja + "」に戻ります。"});
}

void Shown::Passage::make_anew(Outcome& outcome) {
  Session& session = shown_.session_;
  const std::size_t position = player_->position();
  const Text name = player_->name();
  const Result<std::shared_ptr<Player>> again = player_->again(session.document());
  if (!again) {
    look_as_before(session.view, session.framing, *player_);
    return outcome.say(Text{"The steps of '" + name.en + "' are left: ", "「" + name.ja + "」の再生を終えました："} +
                       failed(again.failure()).sentence);
  }
  begin_playing(session.document(), session.view, session.framing, session.shown, *again);
  Player& player = **again;
  player.camera_before = player_->camera_before;
  player.was_framed = player_->was_framed;
  player.is_running = player_->is_running;
  session.view.camera = camera_;
  player_ = shown_.player_;
  shown_.go_to_step(std::min(position, player.size()));
  if (!shown_.is_replaced()) return;
  shown_.end();
  if (was_shown_) show_beneath(outcome);
}

void Shown::Passage::bring_back_level(Outcome& outcome) {
  shown_.levels_ = levels_;
  if (!shown_.fits() || shown_.document().revision() != revision_) return shown_.levels_.reset();
  if (!was_shown_) return;
  if (outcome.done() && effect_ == Effect::writes) outcome.say(saved_beneath(ShownBy::level));
  if (!outcome.done() || effect_ != Effect::reads) return shown_.go_to_level(levels_->levels().level());
  outcome.say({"The view shows the open mesh; the slider of Levels of detail shows a level again.",
               "ビューは開いているメッシュです。詳細度のスライダーで段階の表示に戻ります。"});
}

std::string shown_name(const Session& session, bool with_beneath) {
  const Document& document = session.document();
  const std::string file = (document.is_modified() ? "* " : "") + session.document_name();
  const std::shared_ptr<Player>& player = session.shown.player();
  const bool plays = player && player->edits() && session.shown.shows(ShownBy::step);
  if (!plays && !session.shown.shows(ShownBy::level)) return file;
  Text name = plays ? Text{"Playing: ", "再生中："} + player->name() : Text{"Level of detail", "詳細度の一段階"};
  const bool has_file = document.is_modified() || !document.path().empty();
  if (has_file && with_beneath) name += Text{" (beneath: " + file + ")", "（下に " + file + "）"};
  return name.in(session.preferences.language);
}

}  // namespace ryosen
