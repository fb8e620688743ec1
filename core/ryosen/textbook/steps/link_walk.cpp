#include "ryosen/textbook/steps/link_walk.h"

#include "ryosen/base/number_text.h"
#include "ryosen/textbook/forms/polygons.h"
#include "ryosen/textbook/steps/players.h"

namespace ryosen::steps {

namespace {

Text link_said(std::string_view key, Element of, const std::string& to, const std::string& to_ja) {
  const std::string front = std::string(key) + "(" + slot_name(of) + ") = ";
  return {front + to, front + to_ja};
}

}  // namespace

LinkWalk::LinkWalk(const Mesh& mesh, const forms::FormRow& form, Source source)
    : mesh_(mesh),
      reader_(mesh, form),
      source_(source),
      is_numbered_(reader_.stores(Element::Kind::halfedge, "from") &&
                   !reader_.stores(Element::Kind::halfedge, "next")) {
  if (!is_numbered_) return;
  corners_ = forms::corner_halfedges(mesh);
  corner_of_.assign(mesh.halfedge_slots(), no_index);
  for (std::uint32_t c = 0; c < corners_.size(); ++c) corner_of_[corners_[c].index] = c;
}

Step& LinkWalk::tell(Tell tell, Element about, const Text& what, const Text& said) {
  if (tell == Tell::own || steps_.empty()) {
    steps_.emplace_back();
    steps_.back().source = source_;
    steps_.back().caption = what + said;
    steps_.back().marks.push_back({Role::asked, about});
  } else {
    steps_.back().caption = steps_.back().caption + Text{", ", "、"} + said;
  }
  return steps_.back();
}

void LinkWalk::add_row(Step& step, Element of, std::string_view key, const std::string& value, bool is_none) {
  const std::optional<std::string> stored = is_none ? std::nullopt : std::optional(value);
  step.rows.push_back({std::string(table_of(of.kind)), slot_name(of), std::string(key), stored, stored});
}

Element LinkWalk::follow(Element of, std::string_view key, Tell how, const Text& what) {
  const Element to = reader_.link(of, key);
  const bool is_none = to.index == no_index;
  const std::string name = is_none ? "" : slot_name(to);
  Step& step = tell(how, of, what, link_said(key, of, is_none ? "none" : name, is_none ? "なし" : name));
  add_row(step, of, key, name, is_none);
  step.marks.push_back(is_none ? Mark{Role::missing, of} : Mark{Role::read, to});
  return to;
}

std::vector<Element> LinkWalk::follow_all(Element of, std::string_view key, Tell how, const Text& what) {
  const std::vector<Element> all = reader_.links(of, key);
  std::string names;
  for (const Element to : all) names += (names.empty() ? "" : " ") + (to.index == no_index ? "-" : slot_name(to));
  Step& step = tell(how, of, what, link_said(key, of, names.empty() ? "none" : names, names.empty() ? "なし" : names));
  add_row(step, of, key, names, names.empty());
  mark_all(step, Role::read, all);
  return all;
}

Element LinkWalk::turned(Element h, std::string_view key, std::uint32_t by, Tell how, const Text& what) {
  if (!is_numbered_) return follow(h, key, how, what);
  const std::uint32_t c = corner_of_[h.index], i = c / 3, j = (c % 3 + by) % 3;
  const Element to = corners_[3 * i + j];
  const std::string number = slot_name(to) + " (" + std::to_string(c) + " > 3*" + std::to_string(i) + "+" +
                             std::to_string(j) + " = " + std::to_string(3 * i + j) + ")";
  tell(how, h, what, link_said(key, h, number, number)).marks.push_back({Role::read, to});
  return to;
}

Element LinkWalk::twin_of(Element h, Tell how, const Text& what) {
  if (reader_.stores(Element::Kind::halfedge, "twin")) return follow(h, "twin", how, what);
  const Element parent = follow(h, "edge", how, what);
  for (const Element half : follow_all(parent, "halfedges", Tell::more))
    if (half != h) return half;
  return Halfedge();
}

Element LinkWalk::first_of(Element f, Tell how, const Text& what) {
  if (is_numbered_) {
    const Element to = mesh_.halfedge(f.face());
    tell(how, f, what, link_said("3i", f, slot_name(to), slot_name(to))).marks.push_back({Role::read, to});
    return to;
  }
  return follow(f, reader_.stores(Element::Kind::face, "outer") ? "outer" : "halfedge", how, what);
}

std::size_t LinkWalk::read_places(Face f) {
  const std::vector<glm::dvec3> places = reader_.places(f);
  std::string text;
  for (const glm::dvec3& place : places) text += (text.empty() ? "" : " ") + format_place(place);
  add_row(tell(Tell::own, f, {}, link_said("positions", f, text, text)), f, "positions", text, false);
  return places.size();
}

void LinkWalk::say(Text caption, const std::vector<Element>& answer) {
  steps_.emplace_back();
  Step& step = steps_.back();
  step.source = source_;
  step.caption = std::move(caption);
  mark_all(step, Role::answer, answer);
  const std::string count = std::to_string(records());
  step.rows.push_back({"records_read", "all", "count", count, count});
}

std::unique_ptr<Sequence> LinkWalk::done(Text remark) && {
  return std::make_unique<RecordedSteps>(mesh_, std::move(steps_), std::move(remark));
}

}  // namespace ryosen::steps
