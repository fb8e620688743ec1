#include "ryosen/algo/repair/find_holes.h"

#include <algorithm>
#include <map>

#include "ryosen/algo/algorithm_rows.h"
#include "ryosen/algo/repair/detach_nonmanifold.h"
#include "ryosen/algo/repair/orient_faces.h"
#include "ryosen/algo/repair/weld_points.h"
#include "ryosen/geometry/is_finite.h"
#include "ryosen/geometry/place_keys.h"
#include "ryosen/mesh/circulate.h"
#include "ryosen/mesh/copies.h"
#include "ryosen/mesh/live_elements.h"
#include "ryosen/ops/rules/face_lists.h"
#include "ryosen/ops/rules/sheets.h"

namespace ryosen {

namespace {

struct Part {
  Halfedge last, first;  // sides of a part: its twofold place is between them
};

using Place = std::array<double, 3>;

// Where the least rotation of a cycle begins: the same place wherever the list begins. O(n).
std::size_t least_rotation(const std::vector<Place>& cycle) {
  const std::size_t n = cycle.size();
  std::size_t i = 0, j = 1, same = 0;
  while (i < n && j < n && same < n) {
    const Place &a = cycle[(i + same) % n], &b = cycle[(j + same) % n];
    if (a == b) {
      ++same;
      continue;
    }
    (b < a ? i : j) += same + 1;
    if (i == j) ++j;
    same = 0;
  }
  return std::min(i, j);
}

// The parts that are cut off one after another; what is left at the end is a part too. None where the loop stays whole.
std::vector<Part> parts_of(const Mesh& m, std::vector<Halfedge> sides) {
  constexpr std::size_t fewest_sides = 3;
  std::vector<Place> places;
  for (const Halfedge h : sides) {
    const glm::dvec3 place = m.position(m.from(h)) + 0.0;  // one zero
    places.push_back({place.x, place.y, place.z});
  }
  // The parts may depend on where the walk begins, and numbers of sides on how a file is written.
  const auto begin = static_cast<std::ptrdiff_t>(least_rotation(places));
  std::rotate(sides.begin(), sides.begin() + begin, sides.end());
  std::rotate(places.begin(), places.begin() + begin, places.end());
  const auto are_one = [&](Vertex v, Vertex w) {
    return point(m, v) == point(m, w) || (!has_copies(m, v) && !has_copies(m, w));
  };
  std::vector<Part> parts;
  std::vector<std::size_t> open;
  std::map<Place, std::size_t> index_in_open;
  for (std::size_t i = 0; i < sides.size(); ++i) {
    if (const auto at = index_in_open.find(places[i]); at != index_in_open.end()) {
      const std::size_t first = at->second;
      if (open.size() - first < fewest_sides || !are_one(m.from(sides[open[first]]), m.from(sides[i]))) return {};
      parts.push_back({sides[open.back()], sides[open[first]]});
      for (std::size_t k = first; k < open.size(); ++k) index_in_open.erase(places[open[k]]);
      open.resize(first);
    }
    index_in_open[places[i]] = open.size();
    open.push_back(i);
  }
  return open.size() < fewest_sides ? std::vector<Part>() : parts;
}

// Whether one vertex may take the place of two points without copies: no face has both, and no edge becomes another.
bool may_become_one(const Mesh& m, Vertex v, Vertex w) {
  std::vector<Face> faces;
  std::vector<Vertex> neighbours{v, w};
  for (const Halfedge h : outgoing(m, v)) {
    faces.push_back(m.face(h));
    neighbours.push_back(point(m, m.to(h)));
  }
  const auto has = [](const auto& list, auto element) {
    return std::find(list.begin(), list.end(), element) != list.end();
  };
  for (const Halfedge h : outgoing(m, w))
    if ((m.face(h) && has(faces, m.face(h))) || has(neighbours, point(m, m.to(h)))) return false;
  return true;
}

constexpr std::array<WhyOpenRow, 10> why_open_rows{{
    {WhyOpen::not_finite, "a corner is not a finite place", "座標が有限でない点を通るため"},
    {WhyOpen::visits_twice,
     "the loop visits a point twice (# parts them)",
     "同じ点を二度通るため（# で分けられます）",
     {detach_nonmanifold}},
    {WhyOpen::has_wire, "an edge without a face hangs there", "面のない稜線が付いているため"},
    {WhyOpen::cut_edge,
     "the loop runs along an edge that has several faces already (# or # first)",
     "すでに面が二つ以上ある稜線を通るため（先に # か #）",
     {detach_nonmanifold, orient_faces}},
    {WhyOpen::coincides,
     "its border lies on another one (# joins them)",
     "境界が別の境界と重なっているため（# でつながります）",
     {weld_equal_points}},
    {WhyOpen::face_exists, "a face on the same three points is there already", "同じ三点の面がすでにあるため"},
    {WhyOpen::flat_sheet, "it is the outer border of a flat sheet, which a patch would only double",
     "平らなシートの外周で、ふさいでもシートに重なるだけのため"},
    {WhyOpen::without_area, "every patch has a face without area", "どのふさぎ方でも面積ゼロの面ができるため"},
    {WhyOpen::edge_exists, "every patch needs an edge that is there already",
     "どのふさぎ方でもすでにある稜線が必要になるため"},
    {WhyOpen::crosses, "every patch that was tried crosses the surface or itself",
     "試したどのふさぎ方でも曲面または自分自身と交わるため"},
}};

// As it stands on its button, and as it is called.
Text name_of_remedy(AlgorithmResult (*run)(Edit&, const AlgorithmInput&, Progress&)) {
  for (const AlgorithmRow& row : repair_rows()) {
    if (row.run != run) continue;
    const std::string id = " [" + std::string(row.id) + "]";
    return {"'" + std::string(row.name_en) + "'" + id, "「" + std::string(row.name_ja) + "」" + id};
  }
  return {};
}

WhyOpen cause_before_trying(const Mesh& m, Halfedge start) {
  std::vector<std::uint32_t> points;
  for (Halfedge h : loop(m, start)) {
    if (!is_finite(m.position(m.from(h)))) return WhyOpen::not_finite;
    const std::uint32_t faces = point_edge(m, h).faces();
    if (faces != 1) return faces == 0 ? WhyOpen::has_wire : WhyOpen::cut_edge;
    points.push_back(point(m, m.from(h)).index);
  }
  const std::size_t n = points.size();
  sort_unique(points);
  if (n < 3 || points.size() < n) return WhyOpen::visits_twice;
  return n == 3 && face_on(m, points) ? WhyOpen::face_exists : WhyOpen::untried;
}

}  // namespace

std::vector<Vertex> part_loops(Edit& edit) {
  const Mesh& m = edit.mesh();
  std::vector<bool> seen(m.halfedge_slots(), false);
  std::vector<Part> parts;
  for (const Halfedge start : live_halfedges(m)) {
    if (seen[start.index] || !m.is_outside(start)) continue;
    std::vector<Halfedge> sides;
    for (const Halfedge h : loop(m, start)) {
      seen[h.index] = true;
      sides.push_back(h);
    }
    const auto is_plain = [&](Halfedge h) { return is_finite(m.position(m.from(h))) && point_edge(m, h).faces() == 1; };
    if (!std::all_of(sides.begin(), sides.end(), is_plain)) continue;
    const std::vector<Part> found = parts_of(m, sides);
    parts.insert(parts.end(), found.begin(), found.end());
  }
  Sheets sheets(edit);
  std::vector<Vertex> joined;
  for (const auto& [last, first] : parts) {
    const Vertex v = m.to(last), w = m.from(first);
    if (point(m, v) != point(m, w)) {
      if (has_copies(m, v) || has_copies(m, w) || !may_become_one(m, v, w)) continue;
      sheets.join_points(v, w);
      joined.push_back(std::min(v, w));
    }
    sheets.join_corner(last, first);
  }
  return joined;
}

void join_loops(Edit& edit, const std::vector<Vertex>& joined) {
  const Mesh& m = edit.mesh();
  Sheets sheets(edit);
  for (const Vertex v : live_vertices(m))
    if (count_fans(m, v) > 1) sheets.separate(v);
  for (const Vertex v : joined) {
    if (!m.is_alive(v) || !has_copies(m, v)) continue;
    for (const Vertex copy : live_copies(m, {&v, 1})) link_copies(edit, {&copy, 1});
  }
}

Text WhyOpenRow::text() const {
  Text text{std::string(en), std::string(ja)};
  const auto fill_in = [](std::string& clause, const std::string& name) {
    if (const std::size_t at = clause.find('#'); at != std::string::npos) clause.replace(at, 1, name);
  };
  for (const auto remedy : remedies) {
    if (!remedy) continue;
    const Text name = name_of_remedy(remedy);
    fill_in(text.en, name.en);
    fill_in(text.ja, name.ja);
  }
  return text;
}

std::span<const WhyOpenRow> reasons_to_stay_open() { return why_open_rows; }

std::vector<Hole> find_holes(const Mesh& mesh, std::optional<double> most_edges, Progress& progress) {
  std::vector<Hole> holes;
  std::vector<bool> seen(mesh.halfedge_slots(), false);
  const auto number = [&](Halfedge h) { return point(mesh, mesh.from(h)); };
  for (std::uint32_t i = 0; i < mesh.halfedge_slots() && progress.go_on(); ++i) {
    Halfedge start(i);
    if (seen[i] || !mesh.is_alive(start) || !mesh.is_outside(start)) continue;
    std::size_t edges = 0;
    bool has_face = false;
    for (Halfedge h : loop(mesh, Halfedge(i))) {
      seen[h.index] = true;
      ++edges;
      has_face = has_face || !mesh.is_outside(twin(h));
      if (number(h) < number(start)) start = h;
    }
    if (has_face && !(most_edges && static_cast<double>(edges) > *most_edges)) holes.push_back({start});
  }
  const auto order = [&](const Hole& hole) { return std::pair(number(hole.start), number(mesh.next(hole.start))); };
  std::sort(holes.begin(), holes.end(), [&](const Hole& a, const Hole& b) { return order(a) < order(b); });
  for (Hole& hole : holes)
    if (progress.go_on()) hole.cause = cause_before_trying(mesh, hole.start);
  return holes;
}

void tell_coinciding_borders(const Mesh& mesh, std::vector<Hole>& holes) {
  using Side = std::pair<glm::dvec3, glm::dvec3>;  // places, in order
  const auto side_of = [&](Halfedge h) {
    const glm::dvec3 &p = mesh.position(mesh.from(h)), &q = mesh.position(mesh.to(h));
    return is_before(q, p) ? Side(q, p) : Side(p, q);
  };
  const auto is_less = [](const Side& a, const Side& b) {
    return a.first != b.first ? is_before(a.first, b.first) : is_before(a.second, b.second);
  };
  const auto is_in_vain = [](const Hole& hole) {
    return hole.cause >= WhyOpen::face_exists && hole.cause < WhyOpen::filled;
  };
  if (std::none_of(holes.begin(), holes.end(), is_in_vain)) return;
  std::vector<Side> sides;
  for (const Halfedge h : live_halfedges(mesh)) {
    if (!mesh.is_outside(h) || mesh.is_outside(twin(h))) continue;
    if (is_finite(mesh.position(mesh.from(h))) && is_finite(mesh.position(mesh.to(h)))) sides.push_back(side_of(h));
  }
  std::sort(sides.begin(), sides.end(), is_less);
  for (Hole& hole : holes) {
    if (!is_in_vain(hole)) continue;
    const auto around = loop(mesh, hole.start);
    const bool coincides = std::all_of(around.begin(), around.end(), [&](Halfedge h) {
      const auto [first, last] = std::equal_range(sides.begin(), sides.end(), side_of(h), is_less);
      return last - first > 1;
    });
    if (coincides) hole.cause = WhyOpen::coincides;
  }
}

JoinedCorners joined_corners(const Mesh& mesh, std::span<const Hole> holes, std::span<const std::uint32_t> chosen) {
  std::vector<bool> is_corner(mesh.vertex_slots(), false);
  for (std::uint32_t i : chosen)
    for (Halfedge h : loop(mesh, holes[i].start)) is_corner[point(mesh, mesh.from(h)).index] = true;
  JoinedCorners joined;
  for (const Edge e : live_edges(mesh)) {
    const Halfedge h = halfedge(e, 0);
    const Vertex a = point(mesh, mesh.from(h)), b = point(mesh, mesh.to(h));
    if (is_corner[a.index] && is_corner[b.index]) joined.emplace_back(std::minmax(a, b));
  }
  sort_unique(joined);
  return joined;
}

}  // namespace ryosen
