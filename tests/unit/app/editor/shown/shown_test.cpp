// Each owner of the mesh on the screen meets a command of each effect. The record of all commands is
// tests/ui/shown_record_test.cpp.
#include "app/editor/shown/shown.h"

#include <gtest/gtest.h>

#include <functional>
#include <new>

#include "app/editor/commands/commands.h"
#include "app/editor/session/session.h"
#include "app/editor/shown/levels.h"
#include "app/editor/textbook/playing.h"
#include "ryosen/algo/algorithm_table.h"
#include "tests/support/app/program.h"

namespace ryosen {
namespace {

constexpr ShownBy owners[] = {ShownBy::document, ShownBy::step, ShownBy::level, ShownBy::preview, ShownBy::gesture};
constexpr Effect effects[] = {Effect::view,  Effect::reads,    Effect::begins, Effect::edits,
                              Effect::steps, Effect::replaces, Effect::writes};

// A cube, one edit and a selected face; an owner shows something in its place.
std::unique_ptr<Session> shown_by(ShownBy owner, bool has_view = true) {
  auto document = Document::open(test::asset("cube.obj"));
  auto session = std::make_unique<Session>(std::move(document).value());
  session->shown.has_view = has_view;
  const auto say = [&](const char* line) { EXPECT_TRUE(session->run(line).done()) << line; };
  for (const char* const line : {"poke f5", "select f0"}) say(line);
  if (owner == ShownBy::step)
    for (const char* const line : {"steps script square", "steps at 3"}) say(line);
  if (owner == ShownBy::level)
    for (const char* const line : {"levels", "levels at 6"}) say(line);
  if (owner == ShownBy::gesture) say("gesture extrude");
  if (owner == ShownBy::preview) {
    const AlgorithmRow& row = *find_algorithm("mirror");
    EXPECT_TRUE(session->shown.try_out(owner, row, *ParameterValues(row.parameters).on(session->mesh()).values));
  }
  EXPECT_EQ(session->shown.by(), owner);
  return session;
}

// A command of this effect that is done, or fails as asked.
CommandRow row_of_effect(Effect effect, const std::function<Outcome(Session&)>& run) {
  return {.id = "effect",
          .syntax = "",
          .help_en = "has an effect",
          .help_ja = "効果を持つ",
          .effect = effect,
          .run = [run](Session& session, Words, std::string_view) { return run(session); }};
}

TEST(shown, answers_each_effect_as_the_table_says) {
  for (const ShownBy owner : owners)
    for (const Effect effect : effects) {
      const auto session = shown_by(owner);
      const std::uint64_t before = session->mesh().hash();
      const Response response = session->shown.response(effect);
      bool was_run = false;
      ShownBy meanwhile = owner;
      const ScopedCommand command(row_of_effect(effect, [&](Session& s) {
        was_run = true;
        meanwhile = s.shown.by();
        return Outcome();
      }));
      const Outcome outcome = session->run("effect");
      const std::string what = std::to_string(int(owner)) + " x " + std::to_string(int(effect));
      EXPECT_EQ(was_run, response != Response::refuse && response != Response::instead) << what;
      EXPECT_EQ(outcome.done(), response != Response::refuse) << what;
      if (was_run) {
        EXPECT_EQ(meanwhile, response == Response::keep ? owner : ShownBy::document) << what;
      }
      const bool stays = response == Response::keep || response == Response::again || response == Response::refuse ||
                         response == Response::anew;  // anew: where nothing has changed it is as it was
      EXPECT_EQ(session->shown.by(), stays ? owner : ShownBy::document) << what;
      if (stays) {
        EXPECT_EQ(session->mesh().hash(), before) << what;
      }
      if (owner == ShownBy::step && response != Response::refuse) {
        EXPECT_TRUE(session->shown.player()) << what;
      }
      EXPECT_EQ(session->document().position(), 1u) << what;
    }
}

TEST(shown, nothing_stands_in_the_way_where_nobody_looks) {
  for (const ShownBy owner : {ShownBy::step, ShownBy::level})
    for (const Effect effect : effects) {
      const auto session = shown_by(owner, false);
      ShownBy meanwhile = owner;
      const ScopedCommand command(row_of_effect(effect, [&](Session& s) {
        meanwhile = s.shown.by();
        return Outcome();
      }));
      const Outcome outcome = session->run("effect");
      EXPECT_TRUE(outcome.done());
      EXPECT_TRUE(outcome.sentence.en.empty()) << outcome.sentence.en;
      EXPECT_EQ(meanwhile, effect == Effect::view ? owner : ShownBy::document);
    }
}

TEST(shown, ends_all_where_memory_runs_out) {
  for (const ShownBy owner : owners)
    for (const Effect effect : {Effect::view, Effect::reads, Effect::writes}) {
      const auto session = shown_by(owner);
      const std::uint64_t before = shown_by(ShownBy::document)->mesh().hash();
      const ScopedCommand command(row_of_effect(effect, [](Session&) -> Outcome { throw std::bad_alloc(); }));
      EXPECT_EQ(session->run("effect").exit_code, ExitCode::out_of_memory);
      EXPECT_EQ(session->shown.by(), ShownBy::document);
      EXPECT_FALSE(session->shown.player() || session->shown.levels());
      EXPECT_EQ(session->mesh().hash(), before);
      EXPECT_TRUE(session->run("undo").done());
    }
}

TEST(shown, looking_at_a_preview_or_asking_for_a_remedy_leaves_it) {
  for (const ShownBy owner : {ShownBy::step, ShownBy::level, ShownBy::preview, ShownBy::gesture}) {
    const auto session = shown_by(owner);
    const std::uint64_t before = session->mesh().hash();
    session->document().preview(MakeVertex{{3, 0, 0}});
    session->document().remedy("collapse 0-1");
    EXPECT_EQ(session->shown.by(), owner);
    EXPECT_EQ(session->mesh().hash(), before);
  }
}

// What is added to the document was counted against the mesh of the preview.
TEST(shown, what_a_command_adds_is_added_to_the_document) {
  for (const char* const line :
       {"append torus.off", "cube size=1", "sphere", "grid", "duplicate elements=f0 by=2,0,0"}) {
    const auto alone = shown_by(ShownBy::document), previewed = shown_by(ShownBy::preview);
    const std::string said = line == std::string("append torus.off") ? "append " + test::asset("torus.off") : line;
    const Outcome a = alone->run(said), b = previewed->run(said);
    EXPECT_EQ(a.done(), b.done()) << line << ": " << a.sentence.en << " / " << b.sentence.en;
    EXPECT_EQ(alone->mesh().hash(), previewed->mesh().hash()) << line;
    EXPECT_EQ(alone->selecting.selected_names(), previewed->selecting.selected_names()) << line;
  }
}

// Each element of a selection, on trial: nothing is on trial where nothing was done.
TEST(shown, tries_an_operator_on_each_element) {
  auto document = Document::open(test::asset("cube.obj"));
  const auto session = std::make_unique<Session>(std::move(document).value());
  const std::uint64_t before = session->mesh().hash();
  const Elements faces{Face(0), Face(1)}, edges{Edge(0), Edge(1), Edge(2)};
  const auto try_out = [&](std::string_view op, const Elements& elements, Words words, Progress::Report report = {}) {
    return session->shown.try_out(ShownBy::preview, *find_op(op), elements, words, std::move(report));
  };
  auto result = try_out("poke", faces, {});
  ASSERT_TRUE(result);
  EXPECT_EQ(result->done, 2u);
  EXPECT_TRUE(session->document().is_on_trial());
  EXPECT_EQ(session->document().position(), 0u);
  result = try_out("fill", edges, {});
  ASSERT_TRUE(result);
  EXPECT_EQ(result->done, 0u);
  EXPECT_EQ(result->refusals(), 3u) << "a cube has no hole";
  EXPECT_FALSE(session->document().is_on_trial()) << "the trial before has ended";
  const std::string_view wrong[] = {"nowhere"};
  result = try_out("poke", faces, wrong);
  ASSERT_TRUE(result);
  EXPECT_EQ(result->done, 0u);
  EXPECT_FALSE(session->document().is_on_trial());
  EXPECT_FALSE(try_out("poke", faces, {}, [](double) { return false; })) << "cancelled";
  EXPECT_FALSE(session->document().is_on_trial());
  EXPECT_EQ(session->mesh().hash(), before);
}

}  // namespace
}  // namespace ryosen
