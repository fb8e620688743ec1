#include "ryosen/algo/simplify/goal_text.h"

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "ryosen/algo/edge_rules.h"
#include "ryosen/algo/features.h"
#include "ryosen/algo/simplify/jump_limit.h"
#include "ryosen/base/count_text.h"
#include "ryosen/mesh/copies.h"

namespace ryosen {

namespace {

// The rules that hold edges, with how many, the most first.
Text names_of_holding(const std::vector<std::size_t>& remaining) {
  std::vector<std::pair<std::size_t, const EdgeRuleRow*>> holding;
  for (const EdgeRuleRow& row : edge_rule_table())
    if (const auto k = static_cast<std::size_t>(row.rule); k < remaining.size() && remaining[k] > 0)
      holding.emplace_back(remaining[k], &row);
  std::stable_sort(holding.begin(), holding.end(), [](const auto& a, const auto& b) { return a.first > b.first; });
  Text text;
  for (const auto& [count, row] : holding) {
    const std::string n = " " + std::to_string(count);
    text += Text{(text.en.empty() ? " (" : ", ") + std::string(row->id) + n,
                 (text.ja.empty() ? "：" : "、") + std::string(row->name_ja) + n};
  }
  if (!text.en.empty()) text.en += ")";
  return text;
}

Text text_of_misoriented_left(const Mesh& mesh) {
  const std::size_t misoriented = count_agreement(mesh).misoriented;
  if (misoriented == 0) return {};
  return count_text(misoriented, " One edge is misoriented; orient may mend it.",
                    " # edges are misoriented; orient may mend them.",
                    "向きの合わない稜線が # 本あります（orient で直せることがあります）。");
}

Text text_of_lost_shape() {
  static_assert(JumpLimit::most_times == 3 && JumpLimit::share_of_size == 0.05);
  return {
      "; more would lose the shape: every collapse that is left costs more than 5 % of the size and 3 times as much "
      "as any did at twice as many faces.",
      "（これ以上は形が崩れます。残りの稜線削除の誤差はどれも、大きさの 5 % を超え、面の数が倍だったときまでの最大の"
      " 3 倍も超えます）。"};
}

const Text force_goes_on{" force goes on.", "force を指定すると続けます。"};

}  // namespace

EdgeAgreement count_agreement(const Mesh& mesh) {
  EdgeAgreement agreement;
  agreement.edges = mesh.live().edges;
  if (!mesh.has_copies()) return agreement;
  agreement.edges = counts_on_points(mesh).edges;
  sheet_groups(mesh).for_each([&](std::span<const Edge> sheets) {
    agreement.misoriented += point_edge(mesh, halfedge(sheets.front())).is_misoriented();
  });
  return agreement;
}

Text text_of_goal(const Mesh& mesh, std::size_t before, std::size_t after, const GoalReport& report) {
  const std::string a = std::to_string(before);
  Text text = Text{"From " + a + " to ", "面 " + a + " 個から "} + count_text(after, "one face", "# faces", "# 個へ");
  if (report.stopped == Stop::shape)
    return text + text_of_lost_shape() + text_of_misoriented_left(mesh) + force_goes_on;
  if (report.stopped == Stop::error) {
    const bool names_seams = report.remaining[static_cast<std::size_t>(EdgeRule::seam)] > 0;
    const Text rules = names_seams ? names_of_holding(report.remaining) : Text();
    return text + Text{"; more would go beyond the error" + rules.en + ".", "（許容誤差まで" + rules.ja + "）。"};
  }
  if (report.stopped == Stop::blocked) {
    const Text rules = names_of_holding(report.remaining);
    return text + Text{"; no edge that is left can collapse" + rules.en + ".",
                       "（残りの稜線はどれも稜線削除できません" + rules.ja + "）。"};
  }
  return text + Text{".", "。"};
}

Text text_of_misoriented(const EdgeAgreement& agreement) {
  const std::string n = std::to_string(agreement.misoriented), all = std::to_string(agreement.edges);
  return Text{"Nothing was simplified: " + n + " of " + all +
                  " edges are misoriented, so that hardly any can collapse; orient turns faces so that neighbours "
                  "agree.",
              "簡略化していません。稜線 " + all + " 本中 " + n +
                  " 本の向きが合わず、ほとんど稜線削除できません（orient で面の向きを揃えてください）。"} +
         force_goes_on;
}

}  // namespace ryosen
