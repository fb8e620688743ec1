// How a halfedge structure is built from a list: the steps (1) to (10) of section 4 of text 000, and beside them text
// 003's map, which stores a side without an opposite as a negative number, face by face.
#include <map>

#include "ryosen/base/number_text.h"
#include "ryosen/textbook/steps/players.h"
#include "ryosen/textbook/steps/side_list.h"
#include "ryosen/textbook/steps/sources.h"

namespace ryosen::steps {

namespace {

class BuildPlay {
 public:
  explicit BuildPlay(const Mesh& mesh) : mesh_(mesh), list_(mesh), pairs_(list_.sides.size(), no_index) {}

  std::unique_ptr<Sequence> play() && {
    for (const Vertex v : list_.points) add_vertex(v);
    for (std::uint32_t f = 0; f < list_.faces.size(); ++f) {
      add_face(f);
      for (std::uint32_t side = list_.offsets[f]; side < list_.offsets[f + 1]; ++side) find_pair(side);
      for (std::uint32_t side = list_.offsets[f]; side < list_.offsets[f + 1]; ++side) enter(side);
    }
    return std::make_unique<RecordedSteps>(mesh_, std::move(steps_), list_.remark());
  }

 private:
  Step& begin(int number, int line, const Text& caption) {
    const std::string n = "(" + std::to_string(number) + ") ";
    steps_.push_back({Text{n, n} + caption, {}, {}, code_2(line), {}});
    return steps_.back();
  }
  template <class Visit>
  void for_each_side(std::uint32_t f, Visit visit) {
    for (std::uint32_t side = list_.offsets[f]; side < list_.offsets[f + 1]; ++side) visit(side);
  }
  void link(Step& step, std::uint32_t side, const char* field, std::optional<std::string> to) {
    step.rows.push_back({"halfedges", list_.name(side), field, {}, std::move(to)});
  }

  void add_vertex(Vertex v) {
    const std::string name = slot_name(v), place = format_place(mesh_.position(v));
    Step& read = begin(1, 111, {"Coordinates are read: " + place, "座標を読む：" + place});
    read.marks.push_back({Role::asked, v});
    Step& made = begin(2, 112, {name + " is made; it has no halfedge yet.", name + " を作る。半稜線はまだない。"});
    made.marks.push_back({Role::created, v});
    made.rows = {{"vertices", name, "position", {}, place}, {"vertices", name, "halfedge", {}, {}}};
    Step& added = begin(3, 113, {name + " is added to the model.", name + " をモデルに加える。"});
    added.marks.push_back({Role::changed, v});
    const std::string n = std::to_string(vertices_++);
    added.rows.push_back({"model", "vertices", n, {}, name});
  }

  void add_face(std::uint32_t f) {
    const std::string face = slot_name(list_.faces[f]);
    std::vector<Element> corners, halves;
    for_each_side(f, [&](std::uint32_t side) {
      corners.push_back(Vertex(list_.sides[side].from));
      halves.push_back(list_.sides[side].halfedge);
    });
    Step& read =
        begin(4, 120, {"Indices are read: " + names_text(corners), "インデックスを読む：" + names_text(corners)});
    mark_all(read, Role::asked, corners);
    Step& made =
        begin(5, 78,
              {"Halfedges begin at these vertices: " + names_text(halves) + "; their pair is not set, not even to none",
               "頂点を起点とする半稜線を作る：" + names_text(halves) + "。対は未設定（NULL でもない）"});
    mark_all(made, Role::created, halves);
    for_each_side(f, [&](std::uint32_t side) {
      const std::string v = "v" + std::to_string(list_.sides[side].from);
      link(made, side, "from", v);
      if (first_.emplace(list_.sides[side].from, side).second)
        made.rows.push_back({"vertices", v, "halfedge", {}, list_.name(side)});
    });
    Step& linked = begin(6, 82, {"next and prev link them round.", "next と prev で一周つなぐ。"});
    mark_all(linked, Role::changed, halves);
    for_each_side(f, [&](std::uint32_t side) {
      link(linked, side, "next", list_.name(list_.next(side)));
      link(linked, side, "prev", list_.name(list_.prev(side)));
    });
    Step& seen =
        begin(7, 86, {face + " is made and links to one of them.", face + " を作り、そのうちの 1 つにリンクする。"});
    seen.marks.push_back({Role::created, list_.faces[f]});
    seen.rows.push_back({"faces", face, "halfedge", {}, list_.name(list_.offsets[f])});
    link_rings(f);
    Step& added = begin(8, 87, {face + " is added to the model.", face + " をモデルに加える。"});
    added.marks.push_back({Role::changed, list_.faces[f]});
    added.rows.push_back({"model", "faces", std::to_string(f), {}, face});
    Step& faced = begin(9, 88, {"The halfedges link to " + face + ".", "半稜線から " + face + " にリンクする。"});
    mark_all(faced, Role::changed, halves);
    for_each_side(f, [&](std::uint32_t side) { link(faced, side, "face", face); });
  }

  // What the listing's face has no place for.
  void link_rings(std::uint32_t f) {
    const std::vector<std::uint32_t> rings = list_.rings_of(f);
    if (rings.empty()) return;
    std::vector<Element> starts;
    for (const std::uint32_t side : rings) starts.push_back(list_.sides[side].halfedge);
    const std::string face = slot_name(list_.faces[f]), names = names_text(starts);
    Step& step = begin(
        7, 0, {face + " also links to its inner loops: " + names, face + " から内側のループへもリンクする：" + names});
    step.source = inner_loops_text;
    mark_all(step, Role::changed, starts);
    step.rows.push_back({"faces", face, "inner", {}, names});
  }

  // Through all faces so far, the new one too, up to the first match.
  void find_pair(std::uint32_t side) {
    const std::uint32_t end = list_.offsets[list_.sides[side].face + 1];
    std::uint32_t found = 0;
    while (found < end && !list_.are_opposite(side, found)) ++found;
    const std::string name = list_.name(side), n = std::to_string(found < end ? found + 1 : end);
    Step& step = begin(10, 63,
                       {"The pair of " + name + " is looked for in all faces, " + n + " comparisons: ",
                        name + " の対を全ての面から探す（比較 " + n + " 回）："});
    step.marks.push_back({Role::asked, list_.sides[side].halfedge});
    if (found == end) {
      step.caption += Text{"none yet", "まだない"};
      return;
    }
    step.caption += Text{list_.name(found), list_.name(found)};
    step.marks.push_back({Role::answer, list_.sides[found].halfedge});
    for (const auto& [of, to] : {std::pair(side, found), std::pair(found, side)}) {
      const auto was = pairs_[of] == no_index ? std::nullopt : std::optional(list_.name(pairs_[of]));
      step.rows.push_back({"halfedges", list_.name(of), "twin", was, list_.name(to)});
      pairs_[of] = to;
    }
  }

  void enter(std::uint32_t side) {
    const std::pair key{list_.sides[side].from, list_.sides[side].to}, across{key.second, key.first};
    const auto text = [](const std::pair<std::uint32_t, std::uint32_t>& of) {
      return std::to_string(of.first) + "," + std::to_string(of.second);
    };
    const auto other = opps_.find(across);
    const bool is_there = other != opps_.end();
    const std::string h = std::to_string(side);
    const std::int64_t value = is_there ? -(other->second + 1) : -(static_cast<std::int64_t>(side) + 1);
    const std::string v = std::to_string(value);
    steps_.push_back(
        {is_there ? Text{"Map: (" + text(across) + ") is there, so (" + text(key) + ") = " + v + " and (" +
                             text(across) + ") = " + h,
                         "マップ：(" + text(across) + ") があるので (" + text(key) + ") = " + v + "、(" + text(across) +
                             ") = " + h}
                  : Text{"Map: (" + text(across) + ") is not there, so (" + text(key) + ") = -(" + h + " + 1) = " + v,
                         "マップ：(" + text(across) + ") がないので (" + text(key) + ") = -(" + h + " + 1) = " + v},
         {{Role::asked, list_.sides[side].halfedge}},
         {},
         map_code(is_there ? 11 : 16),
         {}});
    put(key, value);
    if (is_there) put(across, static_cast<std::int64_t>(side));
  }
  void put(std::pair<std::uint32_t, std::uint32_t> key, std::int64_t value) {
    const auto known = opps_.find(key);
    const auto was = known == opps_.end() ? std::nullopt : std::optional(std::to_string(known->second));
    steps_.back().rows.push_back(
        {"opps", std::to_string(key.first) + "," + std::to_string(key.second), "value", was, std::to_string(value)});
    opps_[key] = value;
  }

  const Mesh& mesh_;
  SideList list_;
  std::vector<std::uint32_t> pairs_;
  std::map<std::uint32_t, std::uint32_t> first_;  // the halfedge of each vertex
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::int64_t> opps_;
  std::size_t vertices_ = 0;
  std::vector<Step> steps_;
};

}  // namespace

Made play_build(const Mesh& mesh, Arguments arguments) {
  if (!arguments.empty()) return usage_of({"'build' takes no arguments.", "build に引数はありません。"});
  if (const auto why = why_no_side_list(mesh)) return refusal_of(*why);
  return BuildPlay(mesh).play();
}

Choices choices_of_build(const Mesh& mesh, Selected) { return why_no_side_list(mesh) ? Choices() : Choices{{}}; }

}  // namespace ryosen::steps
