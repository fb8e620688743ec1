// The one-ring of a vertex and the loops of a face, link by link, on any form that can hold the mesh: by halfedges,
// from face to face, along wings, or, where no link leads on, by a look at every face. Without a form it is table 5,
// else the kernel.
#include <algorithm>

#include "ryosen/base/rows.h"
#include "ryosen/mesh/live_elements.h"
#include "ryosen/textbook/forms/all.h"
#include "ryosen/textbook/steps/link_walk.h"
#include "ryosen/textbook/steps/players.h"
#include "ryosen/textbook/steps/sources.h"

namespace ryosen::steps {

namespace {

using Tell = LinkWalk::Tell;

// Table 5 has the gaps of a boundary; the kernel has none, and holds every mesh.
const forms::FormRow& usual_form(const Mesh& mesh) {
  const forms::FormRow& table_5 = *forms::find_form("halfedge");
  return forms::why_unsuitable(mesh, table_5) ? *forms::find_form("ryosen") : table_5;
}

Text records_read(std::size_t records) {
  const std::string r = std::to_string(records);
  return {"; " + r + (records == 1 ? " record was read" : " records were read"), "。読んだデータは " + r + " 個"};
}

// How many were found, "neighbour" or "corner", and which.
Text counted(const std::string& en, const std::string& ja, const std::vector<Element>& found, std::size_t records) {
  const std::string n = std::to_string(found.size()), names = names_text(found);
  if (found.empty()) return Text{"no " + en, ja + "なし"} + records_read(records);
  return Text{n + " " + en + (found.size() == 1 ? ": " : "s: ") + names, ja + " " + n + " 個：" + names} +
         records_read(records);
}

const Text counter_clockwise_text{"Counter-clockwise: ", "反時計回りに："},
    clockwise_text{"Clockwise: ", "時計回りに："}, round_text{": round once", "：一周した"},
    boundary_text{": here is the boundary", "：境界"};

// What a walk finds around a point. Every way goes counter-clockwise up to a gap, and then clockwise from the start;
// where the point has copies, from each to the next.
class RingWalk {
 public:
  RingWalk(LinkWalk& walk, Vertex v, bool holds_copies) : walk_(walk), v_(v), holds_copies_(holds_copies) {}

  // By points, each once.
  std::vector<Element> run() {
    const Vertex first = v_;
    const bool has_copies = holds_copies_ && walk_.mesh().next_copy(v_) != v_;
    do {
      go_round();
      if (has_copies)
        v_ = walk_.follow(v_, "next_copy", Tell::own, {"The point has another copy: ", "点の次の複製："}).vertex();
    } while (v_ != first);
    if (has_copies) walk_.add_to_last({": all copies are visited", "：複製をすべて巡った"});
    return std::move(found_);
  }

 private:
  void go_round() {
    if (walk_.stores(Element::Kind::vertex, "halfedge"))
      by_halfedges();
    else if (walk_.stores(Element::Kind::vertex, "edge"))
      by_wings();
    else if (walk_.stores(Element::Kind::vertex, "face"))
      by_faces();
    else
      by_search();
  }

  void add(Element neighbour) {
    const Element point = walk_.mesh().copy_point(neighbour.vertex());
    if (std::find(found_.begin(), found_.end(), point) != found_.end()) return;
    walk_.mark_last(Role::answer, neighbour);
    found_.push_back(point);
  }

  // By twin(prev(h)), and from the first one by next(twin(h)).
  void by_halfedges() {
    const Element first =
        walk_.follow(v_, "halfedge", Tell::own, {"The vertex stores one halfedge: ", "頂点の持つ半稜線は一つ："});
    if (first.index == no_index || turn(first)) return;
    Element h = walk_.twin_of(first, Tell::own, {"Back at the start, clockwise: ", "始めに戻り、時計回りに："});
    while (h.index != no_index) {
      h = walk_.next(h, Tell::more);
      visit(h);
      h = walk_.twin_of(h, Tell::own, clockwise_text);
    }
    walk_.add_to_last({": here is the boundary again", "：再び境界"});
  }
  // The far end of a halfedge that leaves the vertex is where the next one begins.
  void visit(Element h) {
    const Element next = walk_.next(h, Tell::own, {slot_name(h) + " leaves: ", slot_name(h) + " が出る："});
    add(walk_.follow(next, "from", Tell::more));
  }
  // True where it comes round.
  bool turn(Element first) {
    Element h = first;
    do {
      visit(h);
      const Element incoming = walk_.prev(h, Tell::own, counter_clockwise_text);
      h = walk_.twin_of(incoming, Tell::more);
      if (h.index != no_index) continue;
      walk_.add_to_last({": here is the boundary, whose last neighbour is ", "：境界。最後の隣接頂点は "});
      add(walk_.follow(incoming, "from", Tell::more));
      return false;
    } while (h != first);
    walk_.add_to_last(round_text);
    return true;
  }

  // Goes from the first one, if there is one, to the next: round the vertex, or clockwise too from where a boundary is
  // met.
  template <class Next>
  void go_both_ways(Element first, Next next) {
    if (first.index == no_index) return;
    Element at = first;
    do at = next(at, true);
    while (at.index != no_index && at != first);
    if (at == first) return walk_.add_to_last(round_text);
    walk_.add_to_last(boundary_text);
    for (at = first; at.index != no_index;) at = next(at, false);
    walk_.add_to_last(boundary_text);
  }

  // Table 4: the edge before an edge on its left, seen from the vertex, is the next one about it.
  void by_wings() {
    const Element first =
        walk_.follow(v_, "edge", Tell::own, {"The vertex stores one edge: ", "頂点の持つ稜線は一つ："});
    go_both_ways(first, [&](Element e, bool counter_clockwise) {
      return counter_clockwise ? wing(e, "left_prev", "right_prev", counter_clockwise_text)
                               : wing(e, "right_next", "left_next", clockwise_text);
    });
  }
  // Visits the far end of an edge and goes on.
  Element wing(Element e, std::string_view from_start, std::string_view from_end, const Text& what) {
    const Element start = walk_.follow(e, "from", Tell::own, what);
    const bool leaves = start == Element(v_);
    add(leaves ? walk_.follow(e, "to", Tell::more) : start);
    return walk_.follow(e, leaves ? from_start : from_end, Tell::more);
  }

  // Table 3: the face across the side that ends at the vertex is the next one about it.
  void by_faces() {
    const Element first = walk_.follow(v_, "face", Tell::own, {"The vertex stores one face: ", "頂点の持つ面は一つ："});
    go_both_ways(first, [&](Element f, bool counter_clockwise) { return face_across(f, counter_clockwise); });
  }
  Element face_across(Element f, bool counter_clockwise) {
    const std::vector<Element> corners =
        walk_.follow_all(f, "vertices", Tell::own, counter_clockwise ? counter_clockwise_text : clockwise_text);
    const std::vector<Element> across = walk_.follow_all(f, "faces", Tell::more);
    const std::size_t n = corners.size(),
                      at = static_cast<std::size_t>(std::find(corners.begin(), corners.end(), Element(v_)) -
                                                    corners.begin()),
                      before = (at + n - 1) % n;
    add(corners[(at + 1) % n]);
    add(corners[before]);
    return across[counter_clockwise ? before : at];
  }

  // Table 2, and text 003's map: every face is read.
  void by_search() {
    const Mesh& mesh = walk_.mesh();
    for (const Face f : live_faces(mesh)) {
      const std::vector<Element> corners = walk_.follow_all(f, "vertices", Tell::own);
      const std::size_t n = corners.size();
      bool is_there = false;
      for (std::size_t at = 0; at < n; ++at)
        if (corners[at] == Element(v_)) {
          is_there = true;
          add(corners[(at + 1) % n]);
          add(corners[(at + n - 1) % n]);
        }
      const std::string name = slot_name(v_);
      walk_.add_to_last(is_there ? Text{": " + name + " is there", "：" + name + " がある"}
                                 : Text{": " + name + " is not there", "：" + name + " はない"});
    }
  }

  LinkWalk& walk_;
  Vertex v_;
  bool holds_copies_;
  std::vector<Element> found_;
};

void loop_by_halfedges(LinkWalk& walk, Element start, std::vector<Element>& corners) {
  Element h = start;
  do {
    corners.push_back(walk.follow(h, "from", Tell::own));
    walk.mark_last(Role::answer, corners.back());
    h = walk.next(h, Tell::more);
  } while (h != start);
  walk.add_to_last({": back at the start", "：始めに戻った"});
}

void loop_by_wings(LinkWalk& walk, Face f, std::vector<Element>& corners) {
  const Element first = walk.follow(f, "edge", Tell::own, {"The face stores one edge: ", "面の持つ稜線は一つ："});
  Element e = first;
  do {
    const bool is_left = walk.follow(e, "left", Tell::own) == Element(f);
    corners.push_back(walk.follow(e, is_left ? "from" : "to", Tell::more));
    walk.mark_last(Role::answer, corners.back());
    e = walk.follow(e, is_left ? "left_next" : "right_next", Tell::more);
  } while (e != first);
  walk.add_to_last({": back at the start", "：始めに戻った"});
}

std::vector<Element> corners_of_face(LinkWalk& walk, Face f) {
  std::vector<Element> corners;
  if (walk.stores(Element::Kind::halfedge, "from")) {
    loop_by_halfedges(walk, walk.first_of(f, Tell::own, {"The face leads to one halfedge: ", "面から半稜線の一つへ："}),
                      corners);
    if (!walk.stores(Element::Kind::face, "inner")) return corners;
    for (const Element inner : walk.follow_all(f, "inner", Tell::own, {"And to its inner loops: ", "内側のループへ："}))
      loop_by_halfedges(walk, inner, corners);
  } else if (walk.stores(Element::Kind::face, "edge")) {
    loop_by_wings(walk, f, corners);
  } else {
    corners = walk.follow_all(f, "vertices", Tell::own);
    for (const Element corner : corners) walk.mark_last(Role::answer, corner);
  }
  return corners;
}

Text on_form(const forms::FormRow& form) {
  return {"On " + std::string(form.en) + " (" + std::string(form.source_en) + ").",
          std::string(form.ja) + "（" + std::string(form.source_ja) + "）の上で。"};
}

// The form that is named, or the usual one.
Result<const forms::FormRow*> wanted_form(const Mesh& mesh, Arguments arguments) {
  if (arguments.size() < 2) return &usual_form(mesh);
  const forms::FormRow* const form = forms::find_form(arguments[1]);
  if (!form) {
    const std::string known = joined_ids(forms::all_forms(), ", ");
    return usage_of({"There is no form '" + arguments[1] + "'; the forms are " + known + ".",
                     "形状表現「" + arguments[1] + "」はありません（" + known + "）。"});
  }
  if (const auto why = forms::why_unsuitable(mesh, *form)) return refusal_of(on_form(*form) + Text{" ", ""} + *why);
  return form;
}

// On each form that can hold the mesh, the usual one first; on a large mesh that alone, since it takes time to see
// which can.
Choices choices_on_forms(const Mesh& mesh, const std::string& element, bool is_of_vertices) {
  Choices choices{{element}};
  if (mesh.live().faces > most_faces_asked) return choices;
  for (const forms::FormRow& row : forms::all_forms())
    if ((row.stores_vertices || !is_of_vertices) && !forms::why_unsuitable(mesh, row))
      choices.push_back({element, std::string(row.id)});
  return choices;
}

constexpr std::uint32_t most_faces_searched = 1000;

}  // namespace

Made play_walk(const Mesh& mesh, Arguments arguments) {
  if (arguments.empty() || arguments.size() > 2)
    return usage_of(
        {"'walk V' takes a vertex vN, and may take a form.", "walk V の V は頂点 vN です（形状表現も指定可）。"});
  const Result<Vertex> v = named_element(find_vertex(mesh, arguments[0]));
  if (!v) return v.failure();
  const Result<const forms::FormRow*> form = wanted_form(mesh, arguments);
  if (!form) return form.failure();
  if (!(*form)->stores_vertices)
    return refusal_of(on_form(**form) +
                      Text{" It stores places alone, neither vertices nor neighbours: choose another.",
                           "座標だけを持ち、頂点も隣接関係も持ちません。別の形状表現を選んでください。"});
  LinkWalk walk(mesh, **form, problem_2);
  const bool searches = !walk.stores(Element::Kind::vertex, "halfedge") &&
                        !walk.stores(Element::Kind::vertex, "edge") && !walk.stores(Element::Kind::vertex, "face");
  if (searches && mesh.live().faces > most_faces_searched)
    return refusal_of(on_form(**form) + Text{" It would read every face, and these are too many to show one by one: "
                                             "'relation vertex_vertices' counts them.",
                                             "すべての面を読むため、一つずつ示すには多すぎます（relation "
                                             "vertex_vertices で数を示せます）。"});
  // Without copies it is the point that has a ring.
  const Vertex asked = (*form)->holds_copies ? *v : mesh.copy_point(*v);
  const std::vector<Element> found = RingWalk(walk, asked, (*form)->holds_copies).run();
  walk.say(counted("neighbour", "隣接頂点", found, walk.records()), found);
  return std::move(walk).done(on_form(**form));
}

Made play_loop(const Mesh& mesh, Arguments arguments) {
  if (arguments.empty() || arguments.size() > 2)
    return usage_of(
        {"'loop F' takes a face fN, and may take a form.", "loop F の F は面 fN です（形状表現も指定可）。"});
  const Result<Face> f = named_element(find_face(mesh, arguments[0]));
  if (!f) return f.failure();
  const Result<const forms::FormRow*> form = wanted_form(mesh, arguments);
  if (!form) return form.failure();
  LinkWalk walk(mesh, **form, loop_text);
  if (!(*form)->stores_vertices) {
    const std::string n = std::to_string(walk.read_places(*f));
    walk.say(Text{n + " places", "座標 " + n + " 個"} + records_read(walk.records()), {});
    return std::move(walk).done(on_form(**form));
  }
  const std::vector<Element> corners = corners_of_face(walk, *f);
  walk.say(counted("corner", "角", corners, walk.records()), corners);
  return std::move(walk).done(on_form(**form));
}

Choices choices_of_walk(const Mesh& mesh, Selected selection) {
  const auto v = usual_of<Vertex>(mesh, selection);
  return v ? choices_on_forms(mesh, slot_name(*v), true) : Choices();
}

Choices choices_of_loop(const Mesh& mesh, Selected selection) {
  const auto f = usual_of<Face>(mesh, selection);
  return f ? choices_on_forms(mesh, slot_name(*f), false) : Choices();
}

}  // namespace ryosen::steps
