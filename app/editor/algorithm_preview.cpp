#include "app/editor/algorithm_preview.h"

#include <chrono>

#include "app/editor/commands.h"

namespace ryosen {

namespace {

using PreviewClock = std::chrono::steady_clock;

constexpr std::chrono::milliseconds patience{200};

}  // namespace

bool AlgorithmPreview::is_shown(const Session& session) const {
  const Document& document = session.document();
  return serial_ == document.serial() && revision_ == document.revision();
}

bool AlgorithmPreview::is_offered(const Session& session) const {
  if (session.document().is_on_trial()) return is_shown(session);
  return !session.is_dear_to_try() && session.mesh().live().vertices > 0 && !session.preparing();
}

void AlgorithmPreview::show(Session& session, const AlgorithmRow& row, const ParameterValues& values) {
  const std::string line = line_of(row, values);
  if (line == line_ && is_shown(session)) return;
  Document& document = session.document();
  document.end_trial();
  line_ = line;
  told_ = {};
  if (const ReadValues found = values.on(session.mesh()); found.values) {
    const PreviewClock::time_point until = PreviewClock::now() + patience;
    // A picture is the same however long it takes.
    const bool is_patient = !session.trials().in_background;
    const auto result =
        document.try_out(row, *found.values, [&](double) { return is_patient || PreviewClock::now() < until; });
    if (!result)
      told_ = {"It takes too long to be shown beforehand.", "時間がかかるため、事前には表示しません。"};
    else
      told_ = result->refused ? *result->refused : result->fault ? *result->fault : result->text;
  }
  serial_ = document.serial();
  revision_ = document.revision();
}

void AlgorithmPreview::end(Session& session) {
  if (is_shown(session)) session.document().end_trial();
  line_.clear();
  told_ = {};
  serial_ = 0;
}

}  // namespace ryosen
