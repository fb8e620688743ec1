#include "ryosen/textbook/forms/source_operators.h"

#include <array>

#include "ryosen/indexed/from_indexed.h"

namespace ryosen::forms {

namespace {

// Thrown when a link of a missing halfedge would be read or written.
struct MissingHalfedge {};

// Checked access to the table.
class Steps {
 public:
  explicit Steps(HalfedgeTable& table) : table_(table) {}

  std::uint32_t next(std::uint32_t h) const { return at(h).next; }
  std::uint32_t prev(std::uint32_t h) const { return at(h).prev; }
  std::uint32_t pair(std::uint32_t h) const { return at(h).pair; }
  std::uint32_t vertex(std::uint32_t h) const { return at(h).vertex; }
  std::uint32_t face(std::uint32_t h) const { return at(h).face; }

  void set_vertex(std::uint32_t h, std::uint32_t v) { write(at(h).vertex, v); }
  void set_halfedge(std::uint32_t v, std::uint32_t h) { write(table_.vertex_halfedge[v], h); }
  void join(std::uint32_t h, std::uint32_t g) {
    write(at(h).pair, g);
    write(at(g).pair, h);
  }
  void move_to_midpoint(std::uint32_t moved, std::uint32_t other) {
    write(table_.positions[moved], 0.5 * (table_.positions[moved] + table_.positions[other]));
  }
  void remove_vertex(std::uint32_t v) { table_.vertex_halfedge[v] = no_index; }
  void remove_face(std::uint32_t h) {
    const std::array loop{h, next(h), prev(h)};
    table_.face_halfedge[face(h)] = no_index;
    for (const std::uint32_t side : loop) at(side).vertex = no_index;
  }
  bool has_written() const { return has_written_; }
  std::size_t links_followed() const { return links_followed_; }

 private:
  HalfedgeTable::Record& at(std::uint32_t h) const {
    if (h == no_index) throw MissingHalfedge();
    ++links_followed_;
    return table_.halfedges[h];
  }
  template <class T>
  void write(T& place, const T& value) {
    place = value;
    has_written_ = true;
  }

  HalfedgeTable& table_;
  bool has_written_ = false;
  mutable std::size_t links_followed_ = 0;
};

// The halfedges across the four other edges of both triangles: left and right of the top, and of the bottom.
struct Surroundings {
  std::uint32_t top_left, top_right, bottom_left, bottom_right;

  Surroundings(const Steps& s, std::uint32_t h)
      : top_left(s.pair(s.prev(h))),
        top_right(s.pair(s.next(h))),
        bottom_left(s.pair(s.next(s.pair(h)))),
        bottom_right(s.pair(s.prev(s.pair(h)))) {}
};

void collapse(Steps& s, std::uint32_t h) {
  const Surroundings around(s, h);
  const std::uint32_t start = s.vertex(h), end = s.vertex(s.next(h));
  s.move_to_midpoint(end, start);
  s.set_halfedge(end, around.bottom_right);
  s.set_halfedge(s.vertex(s.prev(h)), around.top_right);
  s.set_halfedge(s.vertex(s.prev(s.pair(h))), around.bottom_left);
  for (std::uint32_t leaving = around.top_left; leaving != h; leaving = s.pair(s.prev(leaving)))
    s.set_vertex(leaving, end);
  s.join(around.top_right, around.top_left);
  s.join(around.bottom_left, around.bottom_right);
  s.remove_vertex(start);
  s.remove_face(s.pair(h));
  s.remove_face(h);
}

void swap(Steps& s, std::uint32_t h) {
  const Surroundings around(s, h);
  const std::uint32_t other = s.pair(h);
  s.set_halfedge(s.vertex(s.next(h)), around.bottom_right);
  s.set_halfedge(s.vertex(s.prev(h)), around.top_right);
  s.set_halfedge(s.vertex(h), around.top_left);
  s.set_halfedge(s.vertex(s.prev(other)), around.bottom_left);
  s.set_vertex(h, s.vertex(around.bottom_left));
  s.set_vertex(s.next(h), s.vertex(around.top_right));
  s.set_vertex(s.prev(h), s.vertex(around.top_left));
  s.set_vertex(other, s.vertex(around.top_right));
  s.set_vertex(s.next(other), s.vertex(around.bottom_left));
  s.set_vertex(s.prev(other), s.vertex(around.bottom_right));
  s.join(around.top_left, s.next(h));
  s.join(around.bottom_left, s.prev(h));
  s.join(around.top_right, s.prev(other));
  s.join(around.bottom_right, s.next(other));
}

Text describe(const SourceOutcome& outcome) {
  if (outcome.completed) return {"It runs to its end.", "最後まで実行されます。"};
  Text text = outcome.pair_of_edge_missing
                  ? Text{"It follows the pair of the edge itself", "その稜線自身の対をたどります。"}
                  : Text{"It follows the pair of a neighbouring edge", "隣の稜線の対をたどります。"};
  text.en +=
      ", which was never set: the constructor leaves it undefined, and nothing is paired there. What comes of it is "
      "undefined, at best a crash";
  text.ja +=
      "この対は一度も設定されず、コンストラクタも初期化しないため、値は不定です。"
      "以後の動作は未定義で、良くても異常終了します。";
  text.en +=
      outcome.changed_before ? "; the model has been changed in part by then." : "; nothing has been changed by then.";
  text.ja += outcome.changed_before ? "その時点でモデルの一部は書き換え済みです。"
                                    : "その時点でモデルは何も変わっていません。";
  return text;
}

SourceOutcome attempt(HalfedgeTable& table, std::uint32_t h, void (*operation)(Steps&, std::uint32_t)) {
  Steps steps(table);
  SourceOutcome outcome;
  outcome.pair_of_edge_missing = table.pair(h) == no_index;
  try {
    operation(steps, h);
    outcome.completed = true;
  } catch (const MissingHalfedge&) {
    outcome.changed_before = steps.has_written();
  }
  outcome.links_followed = steps.links_followed();
  outcome.sentence = describe(outcome);
  return outcome;
}

}  // namespace

SourceOutcome source_collapse(HalfedgeTable& table, std::uint32_t halfedge) {
  return attempt(table, halfedge, collapse);
}

SourceOutcome source_swap(HalfedgeTable& table, std::uint32_t halfedge) { return attempt(table, halfedge, swap); }

std::vector<SourceReport> sources_on_boundaries() {
  IndexedMesh two_triangles;
  two_triangles.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}};
  two_triangles.corners = {0, 1, 2, 2, 1, 3};
  two_triangles.face_offsets = {0, 3, 6};
  const HalfedgeTable table = inner_halfedges(from_indexed(std::move(two_triangles)));
  constexpr std::uint32_t boundary = 0, inner = 1;
  std::vector<SourceReport> reports;
  struct Operation {
    std::string id, ja;
    SourceOutcome (*run)(HalfedgeTable& table, std::uint32_t halfedge);
  };
  static const std::array operations{Operation{"collapse", "稜線削除", source_collapse},
                                     Operation{"swap", "稜線交換", source_swap}};
  for (const auto& [id, ja, run] : operations) {
    HalfedgeTable at_edge = table, beside = table;
    reports.push_back(
        {id, "boundary_edge", {id + " on a boundary edge", ja + "（境界の稜線）"}, run(at_edge, boundary)});
    reports.push_back({id, "beside_boundary", {id + " beside the boundary", ja + "（境界の隣）"}, run(beside, inner)});
  }
  return reports;
}

}  // namespace ryosen::forms
