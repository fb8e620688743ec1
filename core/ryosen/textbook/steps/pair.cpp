// The ways of text 000 to find the pair of each halfedge, halfedge by halfedge: what is compared, how the tables fill,
// and how many comparisons there were. As in the text a search ends at the first match; last come the edges on which
// that is not what the kernel does.
#include <algorithm>
#include <array>
#include <map>

#include "ryosen/base/sort_unique.h"
#include "ryosen/textbook/forms/pairing.h"
#include "ryosen/textbook/steps/players.h"
#include "ryosen/textbook/steps/side_list.h"
#include "ryosen/textbook/steps/sources.h"

namespace ryosen::steps {

namespace {

// Where a method keeps the sides that it has seen. A place is a row of its table.
struct PairTable {
  std::string_view method;  // of pairing_methods()
  std::string_view table, field;
  Source source;
  // The row in which a side is kept, and that in which its pair is looked for; none: in all faces.
  std::string (*kept)(const SideList& list, std::uint32_t side);
  std::string (*sought)(const SideList& list, std::uint32_t side);
};

std::string key_16(const SideList& list, std::uint32_t side) {
  return std::to_string(sixteen_bit_key(list.sides[side].from, list.sides[side].to));
}
std::string key_of_both(const SideList& list, std::uint32_t side) {
  const auto [low, high] = std::minmax(list.sides[side].from, list.sides[side].to);
  return std::to_string(low) + "," + std::to_string(high);
}
std::string start_vertex(const SideList& list, std::uint32_t side) {
  return "v" + std::to_string(list.sides[side].from);
}
std::string end_vertex(const SideList& list, std::uint32_t side) { return "v" + std::to_string(list.sides[side].to); }
std::string element_at(const SideList& list, std::uint32_t side) {
  return "(" + std::to_string(list.sides[side].from) + "," + std::to_string(list.sides[side].to) + ")";
}
std::string element_across(const SideList& list, std::uint32_t side) {
  return "(" + std::to_string(list.sides[side].to) + "," + std::to_string(list.sides[side].from) + ")";
}

constexpr std::array tables{
    PairTable{"brute_force", "faces", "halfedges", code_2(63), nullptr, nullptr},
    PairTable{"vertex_lists", "vertex_lists", "halfedges", vertex_lists_text, start_vertex, end_vertex},
    PairTable{"hash_16", "hash", "halfedges", code_3(7), key_16, key_16},
    PairTable{"hash", "hash", "halfedges", hash_text, key_of_both, key_of_both},
    PairTable{"sparse_matrix", "matrix", "halfedges", matrix_text, element_at, element_across},
};

class PairPlay {
 public:
  PairPlay(const Mesh& mesh, const PairTable& table)
      : list_(mesh), table_(table), pairs_(list_.sides.size(), no_index) {}

  std::unique_ptr<Sequence> play(const Mesh& mesh) && {
    for (std::uint32_t f = 0; f < list_.faces.size(); ++f) {
      add_face(f);
      for (std::uint32_t side = list_.offsets[f]; side < list_.offsets[f + 1]; ++side) search(side);
    }
    end_as_the_kernel(mesh);
    return std::make_unique<RecordedSteps>(mesh, std::move(steps_), list_.remark());
  }

 private:
  Step& begin(Text caption) {
    steps_.push_back({std::move(caption), {}, {}, table_.source, {}});
    return steps_.back();
  }

  // The sides of a face go into the table before they look for their pairs.
  void add_face(std::uint32_t f) {
    const std::string name = slot_name(list_.faces[f]);
    Step& step =
        begin({name + " comes, and its halfedges go into the table.", name + " を加え、その半稜線を表に入れる。"});
    step.marks.push_back({Role::created, list_.faces[f]});
    for (std::uint32_t side = list_.offsets[f]; side < list_.offsets[f + 1]; ++side) {
      const std::string row = table_.kept ? table_.kept(list_, side) : name;
      std::vector<std::uint32_t>& kept = kept_[row];
      const auto was = names_of(kept);
      kept.push_back(side);
      step.rows.push_back({std::string(table_.table), row, std::string(table_.field), was, names_of(kept)});
      if (!table_.kept) all_.push_back(side);
    }
  }

  void search(std::uint32_t side) {
    const std::string name = list_.name(side);
    const auto place = table_.sought ? kept_.find(table_.sought(list_, side)) : kept_.end();
    static const std::vector<std::uint32_t> nothing;
    const std::vector<std::uint32_t>& candidates = !table_.sought         ? all_
                                                   : place == kept_.end() ? nothing
                                                                          : place->second;
    std::size_t compared = 0;
    std::uint32_t found = no_index;
    bool is_own = false;  // among the candidates
    Step& step = begin({});
    step.marks.push_back({Role::asked, list_.sides[side].halfedge});
    for (const std::uint32_t other : candidates) {
      ++compared;
      if (list_.are_opposite(side, other)) {
        found = other;
        break;
      }
      // The table holds the side itself, too, which stays what the step is about.
      is_own |= other == side;
      if (other != side && step.marks.size() < most_marks)
        step.marks.push_back({Role::compared, list_.sides[other].halfedge});
    }
    const std::string before_count = std::to_string(comparisons_);
    comparisons_ += compared;
    step.rows.push_back({"comparisons", "all", "count", before_count, std::to_string(comparisons_)});
    const std::string from = std::to_string(list_.sides[side].from), to = std::to_string(list_.sides[side].to),
                      n = std::to_string(compared);
    const std::string where = table_.sought ? std::string(table_.table) + " " + table_.sought(list_, side) + ": " : "";
    const Text own = is_own ? Text{", itself among them", "（自身を含む）"} : Text();
    step.caption = Text{name + " (" + from + " to " + to + ") is compared with " + n,
                        name + "（" + from + " から " + to + "）を " + n + " 本と比べる"} +
                   own + Text{": " + where, "：" + where};
    if (found == no_index) {
      step.caption += Text{"no pair yet", "対はまだない"};
      return;
    }
    step.caption += Text{list_.name(found) + " is its pair", "対は " + list_.name(found)};
    step.marks.push_back({Role::answer, list_.sides[found].halfedge});
    set_pair(step, side, found);
    set_pair(step, found, side);
  }

  void set_pair(Step& step, std::uint32_t side, std::uint32_t pair) {
    if (pairs_[side] == pair) return;
    step.rows.push_back({"pairs", list_.name(side), "pair", name_of_pair(pairs_[side]), name_of_pair(pair)});
    pairs_[side] = pair;
  }
  std::optional<std::string> name_of_pair(std::uint32_t side) const {
    return side == no_index ? std::nullopt : std::optional(list_.name(side));
  }
  std::optional<std::string> names_of(const std::vector<std::uint32_t>& sides) const {
    std::string names;
    for (const std::uint32_t side : sides) names += (names.empty() ? "" : " ") + list_.name(side);
    return names.empty() ? std::nullopt : std::optional(names);
  }

  // Where more than two sides lie on an edge, or it is cut in the mesh, the kernel's pairs are not those of the text.
  void end_as_the_kernel(const Mesh& mesh) {
    std::vector<std::uint32_t> side_of(mesh.halfedge_slots(), no_index);
    for (std::uint32_t side = 0; side < list_.sides.size(); ++side) side_of[list_.sides[side].halfedge.index] = side;
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::vector<std::uint32_t>> edges;
    for (std::uint32_t side = 0; side < list_.sides.size(); ++side)
      edges[std::minmax(list_.sides[side].from, list_.sides[side].to)].push_back(side);
    const auto pair_in_mesh = [&](std::uint32_t side) { return side_of[twin(list_.sides[side].halfedge).index]; };
    for (const auto& [ends, sides] : edges) {
      const bool differs = std::any_of(sides.begin(), sides.end(),
                                       [&](std::uint32_t side) { return pairs_[side] != pair_in_mesh(side); });
      if (sides.size() < 3 && !differs) continue;
      const std::string name = std::to_string(ends.first) + "-" + std::to_string(ends.second);
      Step& step = begin(text_of_cut(name, sides.size()));
      for (const std::uint32_t side : sides) {
        const std::uint32_t pair = pair_in_mesh(side);
        step.marks.push_back({pair == no_index ? Role::missing : Role::answer, list_.sides[side].halfedge});
        set_pair(step, side, pair);
        if (pair == no_index || pair < side) continue;
        step.caption += Text{"; " + list_.name(side) + " and " + list_.name(pair) + " stay joined",
                             "。" + list_.name(side) + " と " + list_.name(pair) + " はつながる"};
      }
    }
  }

  static Text text_of_cut(const std::string& edge, std::size_t sides) {
    if (sides < 3)
      return {edge + " is cut in the mesh: there its sides are no pair", edge + " はメッシュでは切り離されている"};
    const std::string n = std::to_string(sides);
    return {edge + " has " + n + " sides: the text keeps the pairs it found last, Ryosen cuts the edge",
            edge + " には半稜線が " + n + " 本：テキストは最後に見つけた対を残し、Ryosen は稜線を切り離す"};
  }

  SideList list_;
  const PairTable& table_;
  std::vector<std::uint32_t> pairs_, all_;
  std::map<std::string, std::vector<std::uint32_t>> kept_;
  std::size_t comparisons_ = 0;
  std::vector<Step> steps_;
};

}  // namespace

Made play_pair(const Mesh& mesh, Arguments arguments) {
  std::string known;
  for (const PairTable& table : tables) {
    known.append(known.empty() ? "" : ", ").append(table.method);
    if (arguments.size() != 1 || table.method != arguments[0]) continue;
    if (const auto why = why_no_side_list(mesh)) return refusal_of(*why);
    return PairPlay(mesh, table).play(mesh);
  }
  return usage_of({"'pair METHOD' takes one of " + known + ".", "pair METHOD の METHOD は " + known + " です。"});
}

Choices choices_of_pair(const Mesh& mesh, Selected) {
  Choices choices;
  if (why_no_side_list(mesh)) return choices;
  for (const PairTable& table : tables) choices.push_back({std::string(table.method)});
  return choices;
}

}  // namespace ryosen::steps
