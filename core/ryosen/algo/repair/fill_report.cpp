#include "ryosen/algo/repair/fill_report.h"

#include <algorithm>

#include "ryosen/base/count_text.h"
#include "ryosen/base/sort_unique.h"
#include "ryosen/mesh/circulate.h"
#include "ryosen/mesh/names.h"

namespace ryosen {

namespace {

constexpr std::size_t most_names = 3;

// "f3, f8, f9 and 2 more"
Text names_of(const Mesh& mesh, std::span<const Element> elements) {
  Text names;
  const std::size_t named = std::min(most_names, elements.size());
  for (std::size_t i = 0; i < named; ++i) {
    const std::string name = name_of(mesh, elements[i]);
    names += (i > 0 ? Text{", ", "、"} : Text{}) + Text{name, name};
  }
  if (named < elements.size()) {
    const std::size_t more = elements.size() - named;
    names += Text{with_number(" and # more", more), with_number("、ほか #", more)};
  }
  return names;
}

// Names the faces that cross, and the value that fills anyway.
Text crossed_text(const Mesh& mesh, std::span<const Hole> holes) {
  std::vector<Face> faces;
  for (const Hole& hole : holes)
    if (hole.cause == WhyOpen::crosses && hole.crossed) faces.push_back(hole.crossed);
  sort_unique(faces);
  const std::vector<Element> crossed(faces.begin(), faces.end());
  const Text names = names_of(mesh, crossed);
  const Text at = crossed.empty() ? Text{} : Text{" at " + names.en, "（" + names.ja + "）"};
  return at + Text{", crossing=allow fills anyway", "、crossing=allow でふさげます"};
}

LeftForReason left_for(const Mesh& mesh, const WhyOpenRow& row, std::span<const Hole> holes) {
  LeftForReason left{row.text(), {}};
  for (const Hole& hole : holes) {
    if (hole.cause != row.cause) continue;
    Edge lowest = edge(hole.start);
    for (Halfedge h : loop(mesh, hole.start)) lowest = std::min(lowest, edge(h));
    left.elements.emplace_back(lowest);
  }
  if (row.cause == WhyOpen::crosses && !left.elements.empty()) left.reason += crossed_text(mesh, holes);
  return left;
}

// "3 because every patch has a face without area (0-1, 4-8, 9-12)"
Text clause(const Mesh& mesh, const LeftForReason& left, bool is_only) {
  const Text names = names_of(mesh, left.elements);
  const std::string number = std::to_string(left.elements.size()) + " ";
  // The number has been told where there is one reason alone.
  const Text counted = is_only ? Text{} : Text{number + "because ", number};
  return counted + left.reason + Text{" (" + names.en + ")", " (" + names.ja + ")"};
}

// ": 2 flat, 1 fair"
Text shapes(const FilledHoles& filled) {
  Text text;
  const auto add = [&](std::size_t n, const Text& what) {
    if (n == 0) return;
    const std::string number = n < filled.count() ? std::to_string(n) + " " : "";
    text += (text.en.empty() ? Text{": ", "："} : Text{", ", "、"}) + Text{number + what.en, number + what.ja};
  };
  add(filled.flat, {"flat", "平ら"});
  add(filled.fair, {"fair", "滑らか"});
  add(filled.unfaired, {"not fair since no fair patch is sound", "滑らかにすると不健全"});
  add(filled.bare, {"bare since no finer patch is sound", "細かくすると不健全"});
  if (filled.flat > 0) text += Text{" (shape=fair continues the surface)", "（shape=fair で曲面を滑らかに続けます）"};
  if (filled.crossing > 0)
    text += count_text(filled.crossing, "; one patch crosses something", "; # patches cross something",
                       "。# 個は何かと交わります");
  return text;
}

Text filled_text(const FilledHoles& filled) {
  Text text = count_text(filled.count(), "One hole was filled", "# holes were filled", "穴を # 個ふさぎました");
  if (filled.count() > 0) {
    text += count_text(filled.faces, " by # triangle", " by # triangles", "（三角形 #");
    if (filled.vertices > 0)
      text += count_text(filled.vertices, " and # new vertex", " and # new vertices", "、新しい頂点 #");
    text += Text{"", "）"} + shapes(filled);
  }
  if (filled.mended > 0)
    text +=
        count_text(filled.mended, "; one face without area at a rim was removed first",
                   "; # faces without area at rims were removed first", "。先に縁の面積ゼロの面を # 個なくしました");
  return text;
}

}  // namespace

AlgorithmResult fill_report(const Mesh& mesh, const FilledHoles& filled, std::span<const Hole> holes) {
  AlgorithmResult result{filled.count() + filled.mended, 0, filled_text(filled)};
  for (const WhyOpenRow& row : reasons_to_stay_open()) {
    LeftForReason left = left_for(mesh, row, holes);
    result.left += left.elements.size();
    if (!left.elements.empty()) result.left_for.push_back(std::move(left));
  }
  if (result.left > 0)
    result.text += count_text(result.left, "; # could not be", "; # could not be", "。ふさげない穴 #");
  Text between{": ", "："};
  for (const LeftForReason& left : result.left_for) {
    result.text += between + clause(mesh, left, result.left_for.size() == 1);
    between = {"; ", "、"};
  }
  result.text += Text{".", "。"};
  return result;
}

}  // namespace ryosen
