#include "ryosen/algo/repair/detach_nonmanifold.h"

#include <algorithm>
#include <map>
#include <optional>
#include <unordered_map>
#include <unordered_set>

#include "ryosen/algo/repair/fan_groups.h"
#include "ryosen/algo/repair/pair_faces.h"
#include "ryosen/analysis/neighbourhood.h"
#include "ryosen/base/count_text.h"
#include "ryosen/base/sort_unique.h"
#include "ryosen/mesh/circulate.h"
#include "ryosen/mesh/copies.h"
#include "ryosen/mesh/live_elements.h"

namespace ryosen {

namespace {

std::vector<Vertex> nonmanifold_points(const Mesh& m) {
  std::vector<Vertex> found;
  Neighbourhood around(m, Neighbourhood::Reach::whole);
  for (const Vertex v : live_vertices(m))
    if (is_nonmanifold(around, v)) found.push_back(v);
  return found;
}

using Groups = std::vector<std::vector<Vertex>>;  // of copies that stay together, each ascending

// One turn of taking points apart.
class Detaching {
 public:
  explicit Detaching(Edit& edit) : edit_(edit), m_(edit.mesh()), fans_(m_) {}

  // Returns the number of new points.
  std::size_t take_apart(std::vector<Vertex> gently, const std::vector<Vertex>& wholly) {
    find_points(std::move(gently), wholly);
    find_fans(wholly);
    Sheets sheets(edit_);
    open_where_unpaired(sheets);
    for (const Vertex p : points_) separate_fans_at(sheets, p);
    const Groups groups = groups_of_copies();
    for (const std::vector<Vertex>& group : groups) link_copies(edit_, group);
    std::vector<Vertex> parts, maybe_split;
    for (const std::vector<Vertex>& group : groups) {
      if (has_copies(m_, group[0])) parts.push_back(group[0]);
      if (has_copies(m_, group[0]) || has_neighbour_with_copies(group[0])) maybe_split.push_back(group[0]);
    }
    sheets.make_manifold(maybe_split);
    find_what_is_next(parts);
    return groups.size() - points_.size();
  }

  // What the last turn asks for.
  std::vector<Vertex> next_gently, next_wholly;

 private:
  // Those, and all that edges of three or more faces connect with them.
  void find_points(std::vector<Vertex> gently, const std::vector<Vertex>& wholly) {
    Neighbourhood around(m_);
    points_ = std::move(gently);
    points_.insert(points_.end(), wholly.begin(), wholly.end());
    sort_unique(points_);
    std::unordered_set<Vertex> known(points_.begin(), points_.end());
    for (std::size_t i = 0; i < points_.size(); ++i)
      for (const StarEdge& e : around.star(points_[i]).edges)
        if (e.faces.is_nonmanifold() && known.insert(e.neighbour).second) points_.push_back(e.neighbour);
    std::sort(points_.begin(), points_.end());
  }

  void find_fans(const std::vector<Vertex>& wholly) {
    Neighbourhood around(m_);
    std::vector<std::vector<Halfedge>> edges;
    std::vector<std::pair<Halfedge, Halfedge>> alike;  // corners at misoriented edges that stay
    for (const Vertex p : points_) {
      const Star star = around.star(p);
      corners_.insert(corners_.end(), star.corners.begin(), star.corners.end());
      for (const StarEdge& e : star.edges) {
        const auto corner = [&](std::uint32_t i) { return star.corners[star.sides[e.first_side + i] / 2]; };
        if (e.faces.is_misoriented()) {
          if (std::binary_search(wholly.begin(), wholly.end(), p))
            cut_ends_.push_back(e.neighbour);
          else
            alike.emplace_back(corner(0), corner(1));
        }
        if (!e.faces.is_nonmanifold() || e.neighbour < p) continue;
        edges.emplace_back();
        for (std::uint32_t i = 0; i < e.faces.faces(); ++i) edges.back().push_back(side(star, e.first_side + i));
      }
    }
    add_sides(around, !edges.empty());
    for (const Halfedge corner : corners_) fans_.add_corner(corner);
    fans_.find_fans(edges);
    for (const auto& [one, other] : alike) fans_.join(one, other);
    for (const std::vector<Halfedge>& sides : edges)
      were_nonmanifold_.insert(were_nonmanifold_.end(), sides.begin(), sides.end());
  }

  // All faces need be paired only where edges have three or more.
  void add_sides(Neighbourhood& around, bool with_angles) {
    const FacePairing pairing = with_angles ? pair_faces(m_) : FacePairing();
    for (const Halfedge corner : corners_)
      for (const Halfedge h : {corner, m_.prev(corner)}) {
        Halfedge other = with_angles ? pairing.across[h.index] : around.across(h);
        if (!with_angles && other && around.run_alike(h, other)) other = Halfedge();
        fans_.add_side(h, other);
      }
  }

  // Edges whose two faces are not paired. Opening one gives the side of its second face another halfedge.
  void open_where_unpaired(Sheets& sheets) {
    std::unordered_map<Halfedge, Halfedge> renamed;
    const auto now = [&](Halfedge h) {
      const auto found = renamed.find(h);
      return found == renamed.end() ? h : found->second;
    };
    for (const Halfedge corner : corners_)
      for (const Halfedge h : {now(corner), m_.prev(now(corner))}) {
        const Halfedge beyond = twin(h);
        if (m_.is_outside(beyond) || fans_.across(h) == beyond) continue;
        renamed[beyond] = sheets.open(h);
        fans_.rename(beyond, renamed[beyond]);
      }
    for (Halfedge& h : were_nonmanifold_) h = now(h);
  }

  // The copies of each point by their groups; copies without a face stay alone.
  Groups groups_of_copies() {
    Groups groups;
    for (const Vertex p : points_) {
      std::map<std::uint32_t, std::size_t> place;  // of the group
      for (const Vertex copy : live_copies(m_, {&p, 1})) {
        const std::optional<std::uint32_t> group = group_of(copy);
        const bool is_new = !group || place.try_emplace(*group, groups.size()).second;
        if (is_new)
          groups.push_back({copy});
        else
          groups[place.at(*group)].push_back(copy);
      }
    }
    return groups;
  }

  std::optional<std::uint32_t> group_of(Vertex copy) {
    if (!m_.is_isolated(copy))
      for (const Halfedge h : outgoing(m_, copy))
        if (!m_.is_outside(h)) return fans_.group(h);
    return std::nullopt;
  }

  bool has_neighbour_with_copies(Vertex v) const {
    if (m_.is_isolated(v)) return false;
    for (Vertex end : neighbours(m_, v))
      if (has_copies(m_, end)) return true;
    return false;
  }
  Halfedge side(const Star& star, std::uint32_t i) const {
    const Halfedge corner = star.corners[star.sides[i] / 2];
    return (star.sides[i] & 1u) != 0 ? m_.prev(corner) : corner;
  }

  void find_what_is_next(const std::vector<Vertex>& parts) {
    Neighbourhood around(m_);
    next_gently = std::move(cut_ends_);
    for (Vertex p : parts)
      if (m_.is_alive(p) && is_nonmanifold(around, around.point(p))) next_wholly.push_back(around.point(p));
    for (Halfedge h : were_nonmanifold_) {
      if (!m_.is_alive(h) || !around.edge(h).is_misoriented()) continue;
      for (Vertex v : {m_.from(h), m_.to(h)})
        if (has_copies(m_, v)) next_wholly.push_back(around.point(v));
    }
    sort_unique(next_wholly);
  }

  Edit& edit_;
  const Mesh& m_;
  FanGroups fans_;
  std::vector<Vertex> points_;
  std::vector<Halfedge> corners_;           // of faces at the points
  std::vector<Halfedge> were_nonmanifold_;  // sides of such edges
  std::vector<Vertex> cut_ends_;            // the other ends of misoriented edges that were cut
};

// Those that are non-manifold, and in none of the others.
void keep_nonmanifold(const Mesh& m, std::vector<Vertex>& points, const std::vector<Vertex>& others) {
  Neighbourhood around(m);
  std::erase_if(points, [&](Vertex p) { return !m.is_alive(p); });
  for (Vertex& p : points) p = around.point(p);
  sort_unique(points);
  std::erase_if(points, [&](Vertex p) {
    return std::binary_search(others.begin(), others.end(), p) || !is_nonmanifold(around, p);
  });
}

}  // namespace

bool is_nonmanifold(Neighbourhood& around, Vertex point) {
  return row_of(ProblemKind::nonmanifold_vertex).vertex(around, point);
}

void separate_fans_at(Sheets& sheets, Vertex point) {
  std::vector<Vertex> copies;
  for_each_copy(sheets.mesh(), point, [&](Vertex copy) { copies.push_back(copy); });
  for (Vertex copy : copies) sheets.separate(copy);
}

std::size_t detach_points(Edit& edit, std::vector<Vertex> gently, std::vector<Vertex> wholly) {
  const Mesh& m = edit.mesh();
  std::erase_if(wholly, [&](Vertex p) { return !m.is_alive(p); });
  for (Vertex& p : wholly) p = point(m, p);
  sort_unique(wholly);
  std::size_t made = 0;
  // Every turn splits a point, or leaves it to the next one to split wholly.
  for (;;) {
    keep_nonmanifold(m, gently, wholly);
    if (gently.empty() && wholly.empty()) return made;
    Detaching turn(edit);
    made += turn.take_apart(gently, wholly);
    gently = std::move(turn.next_gently);
    wholly = std::move(turn.next_wholly);
  }
}

AlgorithmResult detach_nonmanifold(Edit& edit, const AlgorithmInput&, Progress& progress) {
  const Mesh& m = edit.mesh();
  std::vector<Vertex> points = nonmanifold_points(m);
  AlgorithmResult result;
  result.changed = points.size();
  std::size_t made = 0;
  while (!points.empty() && progress.go_on()) {  // splitting some may expose others
    made += detach_points(edit, std::move(points));
    points = nonmanifold_points(m);
  }
  result.text = count_text(made, "One point was added to take the surface apart",
                           "# points were added to take the surface apart", "曲面を切り離すため点を # 個追加しました");
  if (made > 0) result.text += count_text(result.changed, " at # place", " at # places", "（# か所）");
  result.text += Text{".", "。"};
  return result;
}

}  // namespace ryosen
