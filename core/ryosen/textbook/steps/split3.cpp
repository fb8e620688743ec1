// Text 003's edge split on faces and a map from sides to opposites, line by line, beside the kernel's own split. As in
// the text nothing is taken out of the map, so keys of sides that are no more stay in it; they are shown.
#include <array>
#include <charconv>
#include <map>
#include <set>

#include "ryosen/base/number_text.h"
#include "ryosen/mesh/circulate.h"
#include "ryosen/textbook/forms/all.h"
#include "ryosen/textbook/forms/polygons.h"
#include "ryosen/textbook/steps/players.h"
#include "ryosen/textbook/steps/sources.h"

namespace ryosen::steps {

namespace {

using Side = std::pair<std::uint32_t, std::uint32_t>;

Side swapped(Side side) { return {side.second, side.first}; }
std::string key_text(Side side) { return std::to_string(side.first) + "," + std::to_string(side.second); }

// The text's structure, with a step for what is written to it.
class SplitPlay : public EditPlay {
 public:
  explicit SplitPlay(const Mesh& mesh) : EditPlay(mesh) {
    for (const Halfedge h : forms::corner_halfedges(mesh)) {
      if (corners_ % 3 == 0) faces_.emplace_back();
      faces_.back()[corners_++ % 3] = mesh.from(h).index;
    }
    for (std::uint32_t v = 0; v < mesh.vertex_slots(); ++v) places_.push_back(mesh.position(Vertex(v)));
    for (std::uint32_t h = 0; h < corners_; ++h) {
      const Side side = side_of(h);
      if (const auto other = opps_.find(swapped(side)); other != opps_.end()) {
        opps_[side] = -(other->second + 1);
        other->second = static_cast<std::int64_t>(h);
      } else {
        opps_[side] = -(static_cast<std::int64_t>(h) + 1);
      }
    }
  }

  std::size_t halfedges() const { return 3 * faces_.size(); }

  // Of the halfedge that leaves the smaller vertex. The number is below halfedges().
  void split(std::uint32_t number) {
    const Side given = side_of(number), other = swapped(given);
    const bool turns = opps_.at(given) >= 0 && other.first < given.first;
    split_side(turns ? other : given, number, turns);
  }

 private:
  // What the text calls h0 to h3, v0 to v3 and so on.
  struct Names {
    std::uint32_t fa, fb, fnew0, fnew1, v0, v1, v2, v3, vnew;
    std::int64_t h0, h1, h2, h3;
    bool is_boundary;
  };

  Side side_of(std::uint32_t h) const {
    const auto& face = faces_[h / 3];
    return {face[h % 3], face[(h + 1) % 3]};
  }
  std::uint32_t number_of(Side side) const {
    const auto other = opps_.find(swapped(side));
    if (other != opps_.end() && other->second >= 0) return static_cast<std::uint32_t>(other->second);
    return static_cast<std::uint32_t>(-(opps_.at(side) + 1));
  }
  Side next(Side side) const {
    const std::uint32_t h = number_of(side);
    return side_of(h / 3 * 3 + (h + 1) % 3);
  }
  Side prev(Side side) const { return next(next(side)); }

  Step& begin(Text caption, int line) { return add({std::move(caption), {}, {}, split_code(line), {}}); }
  void mark(Step& step, Role role, Side side) const {
    if (side.first >= mesh_.vertex_slots() || side.second >= mesh_.vertex_slots()) return;
    if (const Halfedge h = find_halfedge(mesh_, Vertex(side.first), Vertex(side.second)))
      step.marks.push_back({role, h});
  }
  void write(Side side, std::int64_t value, int line, const std::string& formula) {
    Step& step = begin({"opps[" + key_text(side) + "] = " + formula + " = " + std::to_string(value),
                        "opps[" + key_text(side) + "] = " + formula + " = " + std::to_string(value)},
                       line);
    put(step, side, value);
    mark(step, Role::changed, side);
  }
  void put(Step& step, Side side, std::int64_t value) {
    const auto known = opps_.find(side);
    const std::optional<std::string> was =
        known == opps_.end() ? std::nullopt : std::optional(std::to_string(known->second));
    step.rows.push_back({"opps", key_text(side), "value", was, std::to_string(value)});
    opps_[side] = value;
  }
  void write_face(std::uint32_t f, const std::array<std::uint32_t, 3>& corners, int line, const char* name) {
    const bool is_new = f == faces_.size();
    if (is_new) faces_.push_back({no_index, no_index, no_index});
    const std::string text = "(v" + std::to_string(corners[0]) + ", v" + std::to_string(corners[1]) + ", v" +
                             std::to_string(corners[2]) + ")";
    Step& step =
        begin({std::string(name) + ": face " + std::to_string(f) + (is_new ? " is added: " : " becomes ") + text,
               std::string(name) + "：面 " + std::to_string(f) + (is_new ? " を追加：" : " は ") + text},
              line);
    for (std::size_t i = 0; i < 3; ++i) {
      const std::optional<std::string> was = is_new ? std::nullopt : std::optional("v" + std::to_string(faces_[f][i]));
      step.rows.push_back(
          {"text_faces", "f" + std::to_string(f), "v" + std::to_string(i), was, "v" + std::to_string(corners[i])});
    }
    faces_[f] = corners;
  }
  // A side whose opposite is known, or a boundary, which stores its own number as a negative one.
  void write_kept(Side side, std::int64_t opposite, std::uint32_t own, int line, const char* name) {
    write(side, opposite < 0 ? -(static_cast<std::int64_t>(own) + 1) : opposite, line,
          opposite < 0 ? std::string("-(own number + 1)") : std::string(name));
  }
  void write_if_there(Side side, std::uint32_t value, int line) {
    if (opps_.contains(side)) return write(side, value, line + 1, "own number");
    begin({"There is no key " + key_text(side) + ": that side is a boundary.",
           "キー " + key_text(side) + " はない：その側は境界。"},
          line);
  }

  Names look_up(Side side, std::uint32_t number, bool turns) {
    Names n{};
    n.is_boundary = opps_.at(side) < 0;
    const int at = n.is_boundary ? 154 : 206;
    n.fa = number_of(side) / 3;
    n.fb = n.is_boundary ? no_index : static_cast<std::uint32_t>(opps_.at(side)) / 3;
    n.fnew0 = static_cast<std::uint32_t>(faces_.size());
    n.fnew1 = n.fnew0 + 1;
    n.v0 = side.second;
    n.v1 = next(side).second;
    n.v3 = side.first;
    n.v2 = n.is_boundary ? no_index : next(swapped(side)).second;
    n.vnew = static_cast<std::uint32_t>(places_.size());
    n.h0 = opps_.at(prev(side));
    n.h1 = opps_.at(next(side));
    if (!n.is_boundary) {
      n.h2 = opps_.at(prev(swapped(side)));
      n.h3 = opps_.at(next(swapped(side)));
    }
    const std::string h = std::to_string(number), own = std::to_string(number_of(side));
    Step& faces = begin(
        {"Halfedge " + h + (turns ? " is turned to " + own + ", which leaves the smaller vertex" : std::string()) +
             ": side " + key_text(side) + " of face " + std::to_string(n.fa) +
             (n.is_boundary ? ", a boundary" : ", beside face " + std::to_string(n.fb)),
         "半稜線 " + h + (turns ? "：小さい頂点から出る " + own + " に替える" : std::string()) + "：面 " +
             std::to_string(n.fa) + " の半稜線 " + key_text(side) +
             (n.is_boundary ? "（境界）" : "、隣は面 " + std::to_string(n.fb))},
        at);
    mark(faces, Role::asked, side);
    const std::string outer =
        "h0 = " + std::to_string(n.h0) + ", h1 = " + std::to_string(n.h1) +
        (n.is_boundary ? std::string() : ", h2 = " + std::to_string(n.h2) + ", h3 = " + std::to_string(n.h3));
    Step& opposites =
        begin({"The opposites around it: " + outer, "周りの反対辺：" + outer}, at + (n.is_boundary ? 4 : 6));
    for (const Side& around : {prev(side), next(side)}) mark(opposites, Role::read, around);
    const auto v = [](std::uint32_t index) { return std::to_string(index); };
    const std::string vertices =
        n.is_boundary ? "v0 = " + v(n.v0) + ", v1 = " + v(n.v1) + ", v2 = " + v(n.v3) + ", vnew = " + v(n.vnew)
                      : "v0 = " + v(n.v0) + ", v1 = " + v(n.v1) + ", v2 = " + v(n.v2) + ", v3 = " + v(n.v3) +
                            ", vnew = " + v(n.vnew);
    Step& corners = begin({"The vertices: " + vertices, "頂点：" + vertices}, at + (n.is_boundary ? 9 : 12));
    for (const std::uint32_t corner : {n.v0, n.v1, n.v2, n.v3})
      if (corner < mesh_.vertex_slots()) corners.marks.push_back({Role::read, Vertex(corner)});
    return n;
  }

  void split_side(Side side, std::uint32_t number, bool turns) {
    const Names n = look_up(side, number, turns);
    const glm::dvec3 place = 0.5 * (places_[side.first] + places_[side.second]);
    Step& vertex = begin({"Vertex " + std::to_string(n.vnew) + " is added in the middle.",
                          "中点に頂点 " + std::to_string(n.vnew) + " を追加。"},
                         n.is_boundary ? 169 : 225);
    vertex.rows.push_back({"text_vertices", "v" + std::to_string(n.vnew), "position", {}, format_place(place)});
    places_.push_back(place);
    n.is_boundary ? rebuild_one(n) : rebuild_two(n);
    show_dead_keys(n.is_boundary ? 198 : 281);
    split_kernel(side);
  }

  // The text's v2 of a boundary side is v3 here, as the drawing has it.
  void rebuild_one(const Names& n) {
    const std::uint32_t a = 3 * n.fa, b = 3 * n.fnew0;
    write_face(n.fa, {n.v0, n.v1, n.vnew}, 173, "fa");
    write_face(n.fnew0, {n.v1, n.v3, n.vnew}, 178, "fnew");
    write_kept({n.v0, n.v1}, n.h1, a, 182, "h1");
    write({n.v1, n.vnew}, b + 2, 183, "fnew * 3 + 2");
    write({n.vnew, n.v0}, -(static_cast<std::int64_t>(a) + 3), 184, "-(own number + 1)");
    write_kept({n.v1, n.v3}, n.h0, b, 187, "h0");
    write({n.v3, n.vnew}, -(static_cast<std::int64_t>(b) + 2), 188, "-(own number + 1)");
    write({n.vnew, n.v1}, a + 1, 189, "fa * 3 + 1");
    write_if_there({n.v1, n.v0}, a, 192);
    write_if_there({n.v3, n.v1}, b, 195);
  }

  void rebuild_two(const Names& n) {
    const std::uint32_t a = 3 * n.fa, b = 3 * n.fb, c = 3 * n.fnew0, d = 3 * n.fnew1;
    write_face(n.fa, {n.v0, n.v1, n.vnew}, 229, "fa");
    write_face(n.fb, {n.v2, n.v0, n.vnew}, 234, "fb");
    write_face(n.fnew0, {n.v1, n.v3, n.vnew}, 239, "fnew0");
    write_face(n.fnew1, {n.v3, n.v2, n.vnew}, 242, "fnew1");
    write_kept({n.v0, n.v1}, n.h1, a, 246, "h1");
    write({n.v1, n.vnew}, c + 2, 247, "fnew0 * 3 + 2");
    write({n.vnew, n.v0}, b + 1, 248, "fb * 3 + 1");
    write_kept({n.v2, n.v0}, n.h2, b, 251, "h2");
    write({n.v0, n.vnew}, a + 2, 252, "fa * 3 + 2");
    write({n.vnew, n.v2}, d + 1, 253, "fnew1 * 3 + 1");
    write_kept({n.v1, n.v3}, n.h0, c, 256, "h0");
    write({n.v3, n.vnew}, d + 2, 257, "fnew1 * 3 + 2");
    write({n.vnew, n.v1}, a + 1, 258, "fa * 3 + 1");
    write_kept({n.v3, n.v2}, n.h3, d, 261, "h3");
    write({n.v2, n.vnew}, b + 2, 262, "fb * 3 + 2");
    write({n.vnew, n.v3}, c + 1, 263, "fnew0 * 3 + 1");
    write_if_there({n.v1, n.v0}, a, 266);
    write_if_there({n.v0, n.v2}, b, 270);
    write_if_there({n.v2, n.v3}, d, 274);
    write_if_there({n.v3, n.v1}, c, 278);
  }

  // Keys of the map that are no side of a face.
  void show_dead_keys(int line) {
    std::set<Side> sides;
    for (std::uint32_t h = 0; h < halfedges(); ++h) sides.insert(side_of(h));
    std::string dead;
    Step step{{}, {}, {}, split_code(line), {}};
    for (const auto& [side, value] : opps_) {
      if (sides.contains(side)) continue;
      dead += (dead.empty() ? "(" : ", (") + key_text(side) + ")";
      const std::string stored = std::to_string(value);
      step.rows.push_back({"opps", key_text(side), "value", stored, stored});
      mark(step, Role::missing, side);
    }
    step.caption = {"Nothing is taken out of the map: its dead keys, of sides that are no more, are " + dead,
                    "マップからは何も消さない。もう無い半稜線の死んだキー：" + dead};
    add(std::move(step));
  }

  void split_kernel(Side side) {
    const std::string line = "split " + std::to_string(side.first) + "-" + std::to_string(side.second);
    const ParsedOp parsed = parse_line(mesh_, line);
    Step step{{"Ryosen: " + line, "Ryosen：" + line}, {}, {}, {}, {}};
    const bool is_legal = parsed.op && check(mesh_, *parsed.op).legal();
    if (is_legal)
      apply(*parsed.op);
    else
      step.caption = {"Ryosen refuses " + line + ".", "Ryosen では " + line + " はできません。"};
    add(std::move(step));
  }

  std::uint32_t corners_ = 0;
  std::vector<glm::dvec3> places_;
  std::vector<std::array<std::uint32_t, 3>> faces_;
  std::map<Side, std::int64_t> opps_;
};

// Numbers, separated by commas or in words of their own; none where one is none.
std::optional<std::vector<std::uint32_t>> numbers_of(Arguments arguments) {
  std::vector<std::uint32_t> numbers;
  for (const std::string& word : arguments)
    for (const char* at = word.data(); at <= word.data() + word.size(); ++at) {
      const char* const end = word.data() + word.size();
      const auto [behind_number, error] = std::from_chars(at, end, numbers.emplace_back());
      if (error != std::errc() || (behind_number != end && *behind_number != ',')) return {};
      at = behind_number;
    }
  return numbers;
}

}  // namespace

Made play_split3(const Mesh& mesh, Arguments arguments) {
  const auto numbers = numbers_of(arguments);
  if (!numbers || numbers->empty())
    return usage_of({"'split3 H' takes numbers 3i+j of halfedges, one split after the other, as in split3 1,4.",
                     "split3 H の H は半稜線の番号 3i+j です（続けて細分するには split3 1,4）。"});
  if (const auto why = forms::why_unsuitable(mesh, *forms::find_form("opposite_map"))) return refusal_of(*why);
  SplitPlay play(mesh);
  for (const std::uint32_t number : *numbers) {
    if (number >= play.halfedges()) {
      const std::string n = std::to_string(play.halfedges());
      return usage_of({"There is no halfedge " + std::to_string(number) + " then; there are " + n + ", from 0.",
                       "その時点で半稜線 " + std::to_string(number) + " はありません（0 から " + n + " 本）。"});
    }
    play.split(number);
  }
  return std::move(play).done();
}

Choices choices_of_split3(const Mesh& mesh, Selected) {
  return may_offer(mesh, "opposite_map") ? Choices{{"1"}} : Choices();
}

}  // namespace ryosen::steps
