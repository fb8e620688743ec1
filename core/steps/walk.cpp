// The one-ring of a vertex and the loops of a face, link by link: on table 5 where that holds the mesh, else on the
// kernel.
#include "core/forms/all.h"
#include "core/steps/mesh_rows.h"
#include "core/steps/play_texts.h"
#include "core/steps/players.h"
#include "core/steps/record_reader.h"
#include "core/steps/sources.h"

namespace ryosen::steps {

namespace {

// Table 5 has the gaps of a boundary; the kernel has none, and holds every mesh.
const forms::FormRow& form_to_walk_on(const Mesh& mesh) {
  const forms::FormRow& table_5 = *forms::find_form("halfedge");
  return forms::why_unsuitable(mesh, table_5) ? *forms::find_form("ryosen") : table_5;
}

std::string name_or_none(Element element) { return element.index == no_index ? "none" : slot_name(element); }
std::string name_or_none_ja(Element element) { return element.index == no_index ? "なし" : slot_name(element); }

// Makes a step of each link that is followed.
class LinkWalk {
 public:
  LinkWalk(const Mesh& mesh, const forms::FormRow& form, Source source)
      : mesh_(mesh), reader_(mesh, form), source_(source) {}

  // A step of its own, or a further link of the last one.
  enum class Tell { own, more };
  Element follow(Element of, std::string_view key, Tell tell, Text what = {}) {
    const Element to = reader_.link(of, key);
    if (tell == Tell::own || steps_.empty()) {
      Step& step = begin();
      step.caption = what + said(of, key, to);
      step.marks.push_back({Role::asked, of});
    } else {
      steps_.back().caption = steps_.back().caption + Text{", ", "、"} + said(of, key, to);
    }
    Step& step = steps_.back();
    const auto value = to.index == no_index ? std::nullopt : std::optional(slot_name(to));
    step.rows.push_back({std::string(table_of(of.kind)), slot_name(of), std::string(key), value, value});
    if (to.index == no_index)
      step.marks.push_back({Role::missing, of});
    else
      step.marks.push_back({Role::read, to});
    return to;
  }
  // The one, by number, of several links.
  std::vector<Element> follow_all(Element of, std::string_view key) { return reader_.links(of, key); }

  void add_to_last(const Text& more) { steps_.back().caption = steps_.back().caption + more; }
  void mark_last(Role role, Element element) { steps_.back().marks.push_back({role, element}); }
  void say(Text caption, const std::vector<Element>& answer) {
    Step& step = begin();
    step.caption = std::move(caption);
    mark_all(step, Role::answer, answer);
    const std::string count = std::to_string(reader_.read().size());
    step.rows.push_back({"records_read", "all", "count", count, count});
  }
  bool stores(Element::Kind kind, std::string_view key) const { return reader_.stores(kind, key); }
  std::size_t records() const { return reader_.read().size(); }

  std::unique_ptr<Sequence> done(Text remark) && {
    return std::make_unique<RecordedSteps>(mesh_, std::move(steps_), std::move(remark));
  }

 private:
  static Text said(Element of, std::string_view key, Element to) {
    const std::string k(key), name = slot_name(of);
    return {k + "(" + name + ") = " + name_or_none(to), k + "(" + name + ") = " + name_or_none_ja(to)};
  }
  Step& begin() {
    steps_.emplace_back();
    steps_.back().source = source_;
    return steps_.back();
  }

  const Mesh& mesh_;
  RecordReader reader_;
  Source source_;
  std::vector<Step> steps_;
};

Text counted(const char* en, const char* ja, const std::vector<Element>& found, std::size_t records) {
  const std::string n = std::to_string(found.size()), names = names_text(found), r = std::to_string(records);
  return {n + " " + en + ": " + names + "; " + r + " records were read",
          std::string(ja) + " " + n + " 個：" + names + "。読んだデータは " + r + " 個"};
}

// Around a vertex: counter-clockwise by twin(prev(h)) up to a gap, and from the first one clockwise by next(twin(h)).
class RingWalk {
 public:
  RingWalk(LinkWalk& walk, Vertex v) : walk_(walk), v_(v) {}

  std::vector<Element> run() {
    const Element first =
        walk_.follow(v_, "halfedge", Tell::own, {"The vertex stores one halfedge: ", "頂点の持つ半稜線は一つ："});
    if (first.index == no_index) return {};
    if (!counter_clockwise(first)) clockwise(first);
    return std::move(found_);
  }

 private:
  using Tell = LinkWalk::Tell;

  // The far end of a halfedge that leaves the vertex is where the next one begins.
  void visit(Element h) {
    const Element next = walk_.follow(h, "next", Tell::own, {slot_name(h) + " leaves: ", slot_name(h) + " が出る："});
    add(walk_.follow(next, "from", Tell::more));
  }
  void add(Element neighbour) {
    walk_.mark_last(Role::answer, neighbour);
    found_.push_back(neighbour);
  }

  // True where it comes round.
  bool counter_clockwise(Element first) {
    Element h = first;
    do {
      visit(h);
      const Element incoming = walk_.follow(h, "prev", Tell::own, {"Counter-clockwise: ", "反時計回りに："});
      h = walk_.follow(incoming, "twin", Tell::more);
      if (h.index != no_index) continue;
      walk_.add_to_last({": here is the boundary, whose last neighbour is ", "：境界。最後の隣接頂点は "});
      add(walk_.follow(incoming, "from", Tell::more));
      return false;
    } while (h != first);
    walk_.add_to_last({": round once", "：一周した"});
    return true;
  }
  void clockwise(Element first) {
    Element h = walk_.follow(first, "twin", Tell::own, {"Back at the start, clockwise: ", "始めに戻り、時計回りに："});
    while (h.index != no_index) {
      h = walk_.follow(h, "next", Tell::more);
      visit(h);
      h = walk_.follow(h, "twin", Tell::own, {"Clockwise: ", "時計回りに："});
    }
    walk_.add_to_last({": here is the boundary again", "：再び境界"});
  }

  LinkWalk& walk_;
  Vertex v_;
  std::vector<Element> found_;
};

void walk_loop(LinkWalk& walk, Element start, std::vector<Element>& corners) {
  Element h = start;
  do {
    corners.push_back(walk.follow(h, "from", LinkWalk::Tell::own));
    walk.mark_last(Role::answer, corners.back());
    h = walk.follow(h, "next", LinkWalk::Tell::more);
  } while (h != start);
  walk.add_to_last({": back at the start", "：始めに戻った"});
}

Text on_form(const forms::FormRow& form) {
  return {"On " + std::string(form.en) + " (" + std::string(form.source_en) + ").",
          std::string(form.ja) + "（" + std::string(form.source_ja) + "）の上で。"};
}

}  // namespace

Made play_walk(const Mesh& mesh, Arguments arguments) {
  if (arguments.size() != 1) return usage_of({"'walk V' takes a vertex vN.", "walk V の V は頂点 vN です。"});
  const Result<Vertex> v = named_element(find_vertex(mesh, arguments[0]));
  if (!v) return v.failure();
  const forms::FormRow& form = form_to_walk_on(mesh);
  LinkWalk walk(mesh, form, problem_2);
  const std::vector<Element> found = RingWalk(walk, *v).run();
  walk.say(counted("neighbours", "隣接頂点", found, walk.records()), found);
  return std::move(walk).done(on_form(form));
}

Made play_loop(const Mesh& mesh, Arguments arguments) {
  if (arguments.size() != 1) return usage_of({"'loop F' takes a face fN.", "loop F の F は面 fN です。"});
  const Result<Face> f = named_element(find_face(mesh, arguments[0]));
  if (!f) return f.failure();
  const forms::FormRow& form = form_to_walk_on(mesh);
  LinkWalk walk(mesh, form, loop_text);
  std::vector<Element> corners;
  const std::string_view first = walk.stores(Element::Kind::face, "outer") ? "outer" : "halfedge";
  walk_loop(walk,
            walk.follow(*f, first, LinkWalk::Tell::own, {"The face stores one halfedge: ", "面の持つ半稜線は一つ："}),
            corners);
  for (const Element inner : walk.follow_all(*f, "inner")) walk_loop(walk, inner, corners);
  walk.say(counted("corners", "角", corners, walk.records()), corners);
  return std::move(walk).done(on_form(form));
}

Choices choices_of_walk(const Mesh& mesh, Selected selection) {
  const auto v = usual_of<Vertex>(mesh, selection, mesh.vertex_slots());
  return v ? Choices{{slot_name(*v)}} : Choices();
}

Choices choices_of_loop(const Mesh& mesh, Selected selection) {
  const auto f = usual_of<Face>(mesh, selection, mesh.face_slots());
  return f ? Choices{{slot_name(*f)}} : Choices();
}

}  // namespace ryosen::steps
