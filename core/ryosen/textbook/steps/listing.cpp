// The collapse and the swap of program code 4 of text 000, line by line on the records of table 5, with the halfedges
// labelled (1) to (10) as in its figures, and beside it what the kernel does. Where the code follows a link that was
// never set it ends there, half done, and what stands written by then is shown.
#include <algorithm>
#include <array>

#include "ryosen/base/number_text.h"
#include "ryosen/mesh/circulate.h"
#include "ryosen/mesh/live_elements.h"
#include "ryosen/textbook/forms/all.h"
#include "ryosen/textbook/forms/halfedge_table.h"
#include "ryosen/textbook/forms/polygons.h"
#include "ryosen/textbook/steps/players.h"
#include "ryosen/textbook/steps/sources.h"

namespace ryosen::steps {

namespace {

using forms::HalfedgeTable;

// The pair of this halfedge was never set, and this line of the listing follows it.
struct NotPaired {
  std::uint32_t at;
  int line;
};

// The table, by slots of the mesh: its halfedges are corners.
class ListingPlay : public EditPlay {
 public:
  ListingPlay(const Mesh& mesh, Halfedge start)
      : EditPlay(mesh), table_(forms::inner_halfedges(mesh)), slots_(forms::corner_halfedges(mesh)) {
    for (const Vertex v : live_vertices(mesh)) vertices_.push_back(v.index);
    for (const Face f : live_faces(mesh)) faces_.push_back(f.index);
    he_ = static_cast<std::uint32_t>(std::find(slots_.begin(), slots_.end(), start) - slots_.begin());
    label_figure();
  }

  // Runs the code; where it is cut short the last step says so.
  void run(void (ListingPlay::*code)()) {
    try {
      (this->*code)();
      is_complete_ = true;
    } catch (const NotPaired& gap) {
      show_gap(gap);
    }
  }

  void collapse() {
    const std::uint32_t lt = name(34, "heLT", pair(prev(he_)), "he->prev->pair", Role::l8);
    const std::uint32_t rt = name(35, "heRT", pair(next(he_)), "he->next->pair", Role::l7);
    const std::uint32_t lb = name(36, "heLB", pair(next(across(he_, 36))), "he->pair->next->pair", Role::l9);
    const std::uint32_t rb = name(37, "heRB", pair(prev(across(he_, 37))), "he->pair->prev->pair", Role::l10);
    const std::uint32_t start = vertex(he_), end = vertex(next(he_));
    Step& move = begin(40, {"The right vertex moves to the middle of both.", "右の頂点を両端の中点へ動かす。"});
    const glm::dvec3 middle = 0.5 * (table_.positions[end] + table_.positions[start]);
    move.rows.push_back(
        {"text_vertices", vertex_name(end), "position", format_place(table_.positions[end]), format_place(middle)});
    table_.positions[end] = middle;
    mark(move, Role::changed, Vertex(vertices_[end]));
    set_halfedge(46, end, rb, {"The right vertex refers to (10)", "右の頂点から (10) を参照"});
    set_halfedge(47, vertex(prev(he_)), rt, {"The upper vertex refers to (7)", "上の頂点から (7) を参照"});
    set_halfedge(48, vertex(prev(across(he_, 48))), lb, {"The lower vertex refers to (9)", "下の頂点から (9) を参照"});
    turn_around(end);
    const std::uint32_t other = across(he_, 60);
    join(59, rt, lt, next(he_), prev(he_), {"(7) and (8) become a pair", "(7) と (8) を対にする"});
    join(60, lb, rb, next(other), prev(other), {"(9) and (10) become a pair", "(9) と (10) を対にする"});
    Step& gone = begin(63, {"The left vertex is deleted.", "左の頂点を削除する。"});
    gone.rows.push_back(
        {"text_vertices", vertex_name(start), "halfedge", halfedge_value(table_.vertex_halfedge[start]), {}});
    table_.vertex_halfedge[start] = no_index;
    mark(gone, Role::deleted, Vertex(vertices_[start]));
    delete_face(64, across(he_, 64), {"One face is deleted with its halfedges.", "一方の面を半稜線ごと削除する。"});
    delete_face(65, he_, {"The other face is deleted with its halfedges.", "他方の面を半稜線ごと削除する。"});
  }

  void swap() {
    const std::uint32_t lt = name(69, "heLT", pair(prev(he_)), "he->prev->pair", Role::l8);
    const std::uint32_t rt = name(70, "heRT", pair(next(he_)), "he->next->pair", Role::l7);
    const std::uint32_t lb = name(71, "heLB", pair(next(across(he_, 71))), "he->pair->next->pair", Role::l9);
    const std::uint32_t rb = name(72, "heRB", pair(prev(across(he_, 72))), "he->pair->prev->pair", Role::l10);
    const std::uint32_t other = across(he_, 71);
    set_halfedge(75, vertex(next(he_)), rb, {"The right vertex refers to (10)", "右の頂点から (10) を参照"});
    set_halfedge(76, vertex(prev(he_)), rt, {"The upper vertex refers to (7)", "上の頂点から (7) を参照"});
    set_halfedge(77, vertex(he_), lt, {"The left vertex refers to (8)", "左の頂点から (8) を参照"});
    set_halfedge(78, vertex(prev(other)), lb, {"The lower vertex refers to (9)", "下の頂点から (9) を参照"});
    set_vertex(81, he_, vertex_of(lb, next(other), 81), "(1)");
    set_vertex(82, next(he_), vertex_of(rt, next(he_), 82), "(2)");
    set_vertex(83, prev(he_), vertex_of(lt, prev(he_), 83), "(3)");
    set_vertex(84, other, vertex_of(rt, next(he_), 84), "(4)");
    set_vertex(85, next(other), vertex_of(lb, next(other), 85), "(5)");
    set_vertex(86, prev(other), vertex_of(rb, prev(other), 86), "(6)");
    join(89, lt, next(he_), prev(he_), next(he_), {"(8) and (2) become a pair", "(8) と (2) を対にする"});
    join(90, lb, prev(he_), next(other), prev(he_), {"(9) and (3) become a pair", "(9) と (3) を対にする"});
    join(91, rt, prev(other), next(he_), prev(other), {"(7) and (6) become a pair", "(7) と (6) を対にする"});
    join(92, rb, next(other), prev(other), next(other), {"(10) and (5) become a pair", "(10) と (5) を対にする"});
  }

  // The kernel's operator, and in which faces the two results differ.
  std::unique_ptr<Sequence> beside_kernel(const std::string& line) && {
    Step step{{"Ryosen: " + line, "Ryosen：" + line}, {}, {}, {}, {}};
    const ParsedOp parsed = parse_line(mesh_, line);
    if (!parsed.op) {
      step.caption += Text{": ", "："} + parsed.sentence;
    } else if (const Verdict verdict = check(mesh_, *parsed.op); !verdict.legal()) {
      const RuleText& rule = ryosen::text_of(verdict.reasons[0].rule);
      step.caption += Text{" is refused: " + std::string(rule.en), "：できません。" + std::string(rule.ja)};
      mark_all(step, Role::missing, verdict.reasons[0].witnesses);
      if (is_complete_)
        step.caption += Text{" The code does it all the same.", "テキストのコードは実行してしまいます。"};
    } else {
      apply(*parsed.op);
      if (is_complete_) compare(step);
    }
    keep_labels();
    add(std::move(step));
    return std::move(*this).done();
  }

 private:
  using Corners = std::vector<std::uint32_t>;

  // Links that are followed. That a pair was never set shows when it is followed in turn: that ends the code.
  std::uint32_t next(std::uint32_t h) const { return table_.halfedges[h].next; }
  std::uint32_t prev(std::uint32_t h) const { return table_.halfedges[h].prev; }
  std::uint32_t vertex(std::uint32_t h) const { return table_.halfedges[h].vertex; }
  std::uint32_t pair(std::uint32_t h) const { return table_.halfedges[h].pair; }
  // Where a halfedge begins that is the pair of one inside.
  std::uint32_t vertex_of(std::uint32_t h, std::uint32_t inside, int line) const {
    if (h == no_index) throw NotPaired{inside, line};
    return vertex(h);
  }
  // The pair of h, to be followed.
  std::uint32_t across(std::uint32_t h, int line) const {
    if (pair(h) == no_index) throw NotPaired{h, line};
    return pair(h);
  }

  std::string vertex_name(std::uint32_t v) const { return slot_name(Vertex(vertices_[v])); }
  std::string halfedge_name(std::uint32_t h) const { return slot_name(slots_[h]); }
  std::optional<std::string> halfedge_value(std::uint32_t h) const {
    return h == no_index ? std::nullopt : std::optional(halfedge_name(h));
  }
  void mark(Step& step, Role role, Element element) const { step.marks.push_back({role, element}); }

  Step& begin(int line, Text caption) { return add({std::move(caption), {}, {}, code_4(line), {}}); }

  // Those of the figure stay while the code runs, behind what a step is about.
  void keep_labels() {
    const std::vector<Mark> labels = steps_.front().marks;
    for (std::size_t i = 1; i < steps_.size(); ++i)
      for (const Mark& label : labels)
        if (std::none_of(steps_[i].marks.begin(), steps_[i].marks.end(),
                         [&](const Mark& mark) { return mark.element == label.element && row_of(mark.role).is_label; }))
          steps_[i].marks.push_back(label);
  }

  // The figure before anything is done.
  void label_figure() {
    Step& step = begin(0, {"The edge of the halfedges (1) and (4), as in the figure", "図の半稜線 (1) と (4) の稜線"});
    step.source = collapse_and_swap_figures;
    const auto label = [&](Role role, std::uint32_t h) {
      if (h != no_index) mark(step, role, slots_[h]);
    };
    label(Role::l1, he_);
    label(Role::l2, next(he_));
    label(Role::l3, prev(he_));
    label(Role::l7, pair(next(he_)));
    label(Role::l8, pair(prev(he_)));
    const std::uint32_t other = pair(he_);
    if (other == no_index) return;
    label(Role::l4, other);
    label(Role::l5, next(other));
    label(Role::l6, prev(other));
    label(Role::l9, pair(next(other)));
    label(Role::l10, pair(prev(other)));
  }

  std::uint32_t name(int line, const char* variable, std::uint32_t h, const char* links, Role role) {
    const std::string label = std::string(" ") + std::string(row_of(role).id),
                      start = std::string(variable) + " = " + links;
    Step& step = begin(
        line, h == no_index ? Text{start + label + ", which was never set", start + label + "（未設定）"}
                            : Text{start + " = " + halfedge_name(h) + label, start + " = " + halfedge_name(h) + label});
    if (h != no_index) mark(step, role, slots_[h]);
    step.rows.push_back({"variables", variable, "halfedge", {}, halfedge_value(h)});
    return h;
  }

  void set_halfedge(int line, std::uint32_t v, std::uint32_t h, const Text& what) {
    const std::string is = h == no_index ? "?" : halfedge_name(h);
    Step& step = begin(
        line, what + Text{": " + vertex_name(v) + ".halfedge = " + is, "：" + vertex_name(v) + ".halfedge = " + is});
    step.rows.push_back(
        {"text_vertices", vertex_name(v), "halfedge", halfedge_value(table_.vertex_halfedge[v]), halfedge_value(h)});
    table_.vertex_halfedge[v] = h;
    mark(step, Role::changed, Vertex(vertices_[v]));
    if (h != no_index) mark(step, Role::read, slots_[h]);
  }

  void set_vertex(int line, std::uint32_t h, std::uint32_t v, const std::string& label) {
    const std::string text = label + ": " + halfedge_name(h) + ".vertex = " + vertex_name(v);
    Step& step = begin(line, {text, text});
    step.rows.push_back({"text_halfedges", halfedge_name(h), "from", vertex_name(vertex(h)), vertex_name(v)});
    table_.halfedges[h].vertex = v;
    mark(step, Role::changed, slots_[h]);
    mark(step, Role::read, Vertex(vertices_[v]));
  }

  // Every halfedge that leaves the left vertex leaves the right one.
  void turn_around(std::uint32_t end) {
    std::uint32_t inside = prev(he_), he1 = pair(inside);
    show_variable(52, "he1 = he->prev->pair = ", he1);
    do {
      if (he1 == no_index) throw NotPaired{inside, 54};
      set_vertex(54, he1, end, "he1");
      inside = prev(he1);
      he1 = pair(inside);
      show_variable(55, "he1 = he1->prev->pair = ", he1);
    } while (he1 != he_);
  }
  void show_variable(int line, const std::string& text, std::uint32_t h) {
    const std::string is = text + (h == no_index ? "?" : halfedge_name(h));
    Step& step = begin(line, h == he_ ? Text{is + ": he itself, the end", is + "：he に戻り終わり"} : Text{is, is});
    if (h != no_index) mark(step, Role::asked, slots_[h]);
  }

  // The one and the other, each of which is the pair of a halfedge inside.
  void join(int line, std::uint32_t h, std::uint32_t g, std::uint32_t inside_h, std::uint32_t inside_g, Text what) {
    if (h == no_index) throw NotPaired{inside_h, line};
    Step& step = begin(line, std::move(what));
    set_pair(step, h, g);
    if (g == no_index) throw NotPaired{inside_g, line};
    set_pair(step, g, h);
  }
  void set_pair(Step& step, std::uint32_t of, std::uint32_t to) {
    step.rows.push_back({"text_halfedges", halfedge_name(of), "twin", halfedge_value(pair(of)), halfedge_value(to)});
    table_.halfedges[of].pair = to;
    mark(step, Role::changed, slots_[of]);
  }

  void delete_face(int line, std::uint32_t h, Text what) {
    const std::uint32_t f = table_.halfedges[h].face;
    Step& step = begin(line, std::move(what));
    step.rows.push_back(
        {"text_faces", slot_name(Face(faces_[f])), "halfedge", halfedge_value(table_.face_halfedge[f]), {}});
    table_.face_halfedge[f] = no_index;
    mark(step, Role::deleted, Face(faces_[f]));
    for (const std::uint32_t side : {next(h), prev(h), h}) {
      step.rows.push_back({"text_halfedges", halfedge_name(side), "from", vertex_name(vertex(side)), {}});
      mark(step, Role::deleted, slots_[side]);
    }
  }

  void show_gap(const NotPaired& gap) {
    const std::size_t written =
        static_cast<std::size_t>(std::count_if(steps_.begin(), steps_.end(), [](const Step& step) {
          return std::any_of(step.rows.begin(), step.rows.end(),
                             [](const RowChange& row) { return row.table != "variables"; });
        }));
    const std::string n = std::to_string(written), at = halfedge_name(gap.at);
    Step& step = begin(
        gap.line, written == 0
                      ? Text{at + " has no pair: here is the boundary. The code follows it all the same, which is "
                                  "undefined; nothing is written by then.",
                             at + " に対はない（境界）。コードはそれでもたどり、動作は未定義。まだ何も書いていない。"}
                      : Text{at +
                                 " has no pair: here is the boundary. The code follows it all the same, which is "
                                 "undefined; " +
                                 n + " lines have written by then, and the model is left half done.",
                             at + " に対はない（境界）。コードはそれでもたどり、動作は未定義。" + n +
                                 " 行が書き換え済みで、モデルは途中のまま。"});
    mark(step, Role::missing, slots_[gap.at]);
  }

  // The faces of the table as corner lists from the smallest corner.
  static void from_smallest(Corners& corners) {
    std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
  }
  void compare(Step& step) {
    for (std::uint32_t f = 0; f < faces_.size(); ++f) {
      Corners by_code, by_kernel;
      if (const std::uint32_t start = table_.face_halfedge[f]; start != no_index)
        for (std::uint32_t h : {start, next(start), prev(start)}) by_code.push_back(vertices_[vertex(h)]);
      if (mesh_.is_alive(Face(faces_[f])))
        for (const Vertex v : vertices_around(mesh_, Face(faces_[f]))) by_kernel.push_back(v.index);
      if (!by_code.empty()) from_smallest(by_code);
      if (!by_kernel.empty()) from_smallest(by_kernel);
      if (by_code == by_kernel) continue;
      step.rows.push_back({"by_code_and_by_kernel", slot_name(Face(faces_[f])), "vertices", text_of_corners(by_code),
                           text_of_corners(by_kernel)});
    }
    const std::string n = std::to_string(step.rows.size());
    step.caption +=
        (step.rows.empty() ? Text{" gives the same faces", "：コードと同じ面になる"}
                           : Text{" gives other corners to " + n + " faces", "：" + n + " 面の頂点がコードと異なる"});
  }
  static std::optional<std::string> text_of_corners(const Corners& corners) {
    std::string text;
    for (const std::uint32_t v : corners) text += (text.empty() ? "v" : " v") + std::to_string(v);
    return text.empty() ? std::nullopt : std::optional(text);
  }

  HalfedgeTable table_;
  std::vector<Halfedge> slots_;                  // of each halfedge of the table
  std::vector<std::uint32_t> vertices_, faces_;  // slots
  std::uint32_t he_ = no_index;
  bool is_complete_ = false;
};

Made play_listing(const Mesh& mesh, Arguments arguments, std::string_view id, void (ListingPlay::*code)(),
                  std::string_view behind_edge) {
  const std::string call(id);
  if (arguments.size() != 1)
    return usage_of({"'" + call + " A-B' takes an edge A-B.", call + " A-B の A-B は稜線です。"});
  const Result<Halfedge> found = named_element(find_edge(mesh, arguments[0]));
  if (!found) return found.failure();
  const forms::FormRow& table_5 = *forms::find_form("opposite_map");  // triangles, one sheet at each point
  if (const auto why = forms::why_unsuitable(mesh, table_5)) return refusal_of(*why);
  // The code begins with a halfedge of a face; on a boundary the given one may have none.
  const Halfedge start = mesh.is_outside(*found) ? twin(*found) : *found;
  ListingPlay play(mesh, start);
  play.run(code);
  const std::string line = call + " " + std::to_string(mesh.from(start).index) + "-" +
                           std::to_string(mesh.to(start).index) + std::string(behind_edge);
  return std::move(play).beside_kernel(line);
}

Choices edges_to_offer(const Mesh& mesh, Selected selection) {
  if (!may_offer(mesh, "opposite_map")) return {};
  const auto name = [&](Edge e) {
    return Choices{{std::to_string(mesh.from(halfedge(e)).index) + "-" + std::to_string(mesh.to(halfedge(e)).index)}};
  };
  if (const auto e = selected_of<Edge>(mesh, selection)) return name(*e);
  for (const Edge e : live_edges(mesh))
    if (!mesh.is_boundary(e)) return name(e);
  return {};
}

}  // namespace

Made play_collapse(const Mesh& mesh, Arguments arguments) {
  return play_listing(mesh, arguments, "collapse", &ListingPlay::collapse, " mid");
}
Made play_swap(const Mesh& mesh, Arguments arguments) {
  return play_listing(mesh, arguments, "swap", &ListingPlay::swap, "");
}
Choices choices_of_collapse(const Mesh& mesh, Selected selection) { return edges_to_offer(mesh, selection); }
Choices choices_of_swap(const Mesh& mesh, Selected selection) { return edges_to_offer(mesh, selection); }

}  // namespace ryosen::steps
