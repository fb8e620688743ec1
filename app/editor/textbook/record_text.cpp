#include "app/editor/textbook/record_text.h"

#include <nlohmann/json.hpp>

#include "ryosen/mesh/names.h"

namespace ryosen {

namespace {

std::string none_in(Language language) { return language == Language::japanese ? "なし" : "none"; }

// The shortest digits that read back as the same number.
std::string shortest_digits(double value) { return nlohmann::ordered_json(value).dump(); }

std::string place_text(const glm::dvec3& at, bool is_list) {
  const std::string numbers = shortest_digits(at.x) + " " + shortest_digits(at.y) + " " + shortest_digits(at.z);
  return is_list ? "(" + numbers + ")" : numbers;
}

}  // namespace

std::vector<RecordLine> record_lines(const forms::Fields& fields, Language language) {
  std::vector<RecordLine> lines;
  for (const forms::Field& field : fields) {
    RecordLine line{std::string(field.key), std::string(field.word), {}, {}, {}};
    for (const glm::dvec3& at : field.places) line.values.push_back(place_text(at, field.is_list));
    for (std::size_t i = 0; i < field.links.size(); ++i) {
      const bool leads = field.links[i].index != no_index;
      line.values.push_back(leads ? slot_name(field.links[i]) : none_in(language));
      line.links.push_back(field.links[i]);
      const auto& stored = field.stored[i];
      line.stored += (i == 0 ? "= " : " ") + (stored ? std::to_string(*stored) : none_in(language));
    }
    if (line.values.empty()) {
      line.values.push_back(none_in(language));
      line.stored = "= " + none_in(language);
    }
    lines.push_back(std::move(line));
  }
  return lines;
}

}  // namespace ryosen
