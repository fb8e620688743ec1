#include "ryosen/algo/simplify/goal_text.h"

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "ryosen/algo/edge_rules.h"
#include "ryosen/algo/features.h"
#include "ryosen/algo/simplify/jump_limit.h"
#include "ryosen/analysis/figures.h"
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

Text text_of_cost() {
  static_assert(JumpLimit::most_times == 3 && JumpLimit::share_of_size == 0.05);
  return {
      "; more would lose the shape: every collapse that is left costs more than 5 % of the size and 3 times as much "
      "as any did at twice as many faces.",
      "（これ以上は形が崩れます。残りの稜線削除の誤差はどれも、大きさの 5 % を超え、面の数が倍だったときまでの最大の"
      " 3 倍も超えます）。"};
}

// Handles and parts that keep faces.
Text text_of_topology_left(const Mesh& mesh) {
  const Figures figures = compute_figures(mesh);
  const std::uint64_t handles = static_cast<std::uint64_t>(figures.genus.value_or(0)), parts = figures.components;
  if (handles == 0 && parts < 2) return {};
  const std::string h = std::to_string(handles), p = std::to_string(parts);
  if (handles == 0)
    return {" " + p + " parts are left; topology=change joins closed ones near each other.",
            "部分が " + p + " 個残っています（topology=change で閉じた部分のうち近いものをつなぎます）。"};
  if (parts < 2)
    return count_text(handles, " One handle is left; topology=change closes it.",
                      " # handles are left; topology=change closes them.",
                      "ハンドルが # 個残っています（topology=change で閉じます）。");
  return count_text(handles, " One handle", " # handles", "ハンドル # 個") +
         Text{" and " + p + " parts are left; topology=change closes and joins them.",
              "と部分 " + p + " 個が残っています（topology=change で閉じ、つなぎます）。"};
}

Text text_of_change(const TopologyChange& change) {
  Text text;
  if (change.closed_handles > 0)
    text += count_text(change.closed_handles, " One handle was closed.", " # handles were closed.",
                       "ハンドルを # 個閉じました。");
  if (change.joined_parts > 0)
    text += count_text(change.joined_parts, " One part was joined to another.", " # parts were joined to others.",
                       "部分を # 個、他の部分につなぎました。");
  return text;
}

const Text parts_too_far{"; more would lose the shape: the parts that are left lie too far from each other.",
                         "（これ以上は形が崩れます。残りの部分は互いに離れすぎています）。"};
const Text boundaries_would_grow{"; more would lose the shape: every edge that is left would draw a boundary out.",
                                 "（これ以上は形が崩れます。残りの稜線を削除すると境界が広がります）。"};
const Text force_goes_on{" force goes on.", "force を指定すると続けます。"};

Text text_of_shape(const GoalReport& report, const TopologyChange& change) {
  if (change.has_parts_too_far) return parts_too_far;
  return report.remaining[static_cast<std::size_t>(EdgeRule::error)] > 0 ? text_of_cost() : boundaries_would_grow;
}

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

Text text_of_goal(const Mesh& mesh, std::size_t before, std::size_t after, const GoalReport& report,
                  const TopologyChange& change) {
  const std::string a = std::to_string(before);
  Text text = Text{"From " + a + " to ", "面 " + a + " 個から "} + count_text(after, "one face", "# faces", "# 個へ");
  const bool asks = !change.is_allowed && (report.stopped == Stop::shape || report.stopped == Stop::blocked);
  const Text changed = text_of_change(change), left = asks ? text_of_topology_left(mesh) : Text();
  if (report.stopped == Stop::shape)
    return text + text_of_shape(report, change) + changed + left + text_of_misoriented_left(mesh) + force_goes_on;
  if (report.stopped == Stop::error) {
    const bool names_seams = report.remaining[static_cast<std::size_t>(EdgeRule::seam)] > 0;
    const Text rules = names_seams ? names_of_holding(report.remaining) : Text();
    return text + Text{"; more would go beyond the error" + rules.en + ".", "（許容誤差まで" + rules.ja + "）。"} +
           changed;
  }
  if (report.stopped == Stop::distance)
    return text + Text{"; more would go beyond the distance.", "（距離の上限まで）。"} + changed;
  if (report.stopped == Stop::blocked) {
    const Text rules = names_of_holding(report.remaining);
    return text +
           Text{"; no edge that is left can collapse" + rules.en + ".",
                "（残りの稜線はどれも稜線削除できません" + rules.ja + "）。"} +
           changed + left;
  }
  return text + Text{".", "。"} + changed;
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
