#include "app/editor/levels.h"

#include "app/editor/session.h"

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

}  // namespace ryosen
