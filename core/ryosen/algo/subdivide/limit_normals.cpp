#include "ryosen/algo/subdivide/limit_normals.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <glm/geometric.hpp>
#include <numbers>

#include "ryosen/base/parallel.h"
#include "ryosen/mesh/attribute.h"

namespace ryosen::subdivide {

namespace {

glm::dvec3 unit(const glm::dvec3& v) {
  const double length = glm::length(v);
  return length > 0 && std::isfinite(length) ? v / length : glm::dvec3(0);
}

// The faces from one sharp edge of a vertex to the next, counter-clockwise: all of them where none is sharp.
struct Sector {
  std::vector<Halfedge> edges;  // outgoing; the last one has its face behind it
  bool is_closed = false;
};

// Places relative to the vertex.
class Around {
 public:
  Around(const Mesh& mesh, Vertex v) : mesh_(mesh), here_(mesh.position(v)) {}

  glm::dvec3 end(Halfedge h) const { return mesh_.position(mesh_.to(h)) - here_; }
  // Across the face to the left of h: of a quad the corner that is no neighbour.
  glm::dvec3 across(Halfedge h) const { return mesh_.position(mesh_.to(mesh_.next(h))) - here_; }

 private:
  const Mesh& mesh_;
  const glm::dvec3& here_;
};

struct Tangents {
  glm::dvec3 first{0.0}, second{0.0};
  glm::dvec3 normal() const { return unit(glm::cross(first, second)); }
};

Tangents smooth_tangents(const Around& around, const std::vector<Halfedge>& edges, Scheme scheme) {
  const auto n = static_cast<double>(edges.size());
  const double step = 2 * std::numbers::pi / n, c = std::cos(step);
  const bool has_quads = scheme == Scheme::catmull_clark;
  const double a = has_quads ? 1 + c + std::cos(step / 2) * std::sqrt(2 * (9 + c)) : 1;
  Tangents found;
  for (std::size_t i = 0; i < edges.size(); ++i) {
    const double here = step * static_cast<double>(i), next = here + step;
    const glm::dvec3 p = a * around.end(edges[i]);
    found.first += std::cos(here) * p;
    found.second += std::sin(here) * p;
    if (!has_quads) continue;
    const glm::dvec3 q = around.across(edges[i]);
    found.first += (std::cos(here) + std::cos(next)) * q;
    found.second += (std::sin(here) + std::sin(next)) * q;
  }
  return found;
}

// Across a crease: with the vertex at 0 its own weight plays no part.
glm::dvec3 across_crease(const Around& around, const std::vector<Halfedge>& edges, Scheme scheme) {
  const std::size_t k = edges.size();
  if (k == 2) return around.end(edges[0]) + around.end(edges[1]);
  const double step = std::numbers::pi / static_cast<double>(k - 1), c = std::cos(step);
  const bool has_quads = scheme == Scheme::catmull_clark;
  const double eigenvalue = has_quads ? (5 + c + std::sqrt((c + 1) * (c + 9))) / 16 : 0.375 + 0.25 * c;
  const auto of_edge = [&](std::size_t i) {  // 0 for the first and the last one
    return std::sin(step * static_cast<double>(i));
  };
  const auto of_face = [&](std::size_t i) { return (of_edge(i) + of_edge(i + 1)) / (16 * eigenvalue - 4); };
  glm::dvec3 sum(0);
  double edges_together = 0, faces_together = 0;
  for (std::size_t i = 1; i + 1 < k; ++i) {
    sum += of_edge(i) * around.end(edges[i]);
    edges_together += of_edge(i);
  }
  for (std::size_t i = 0; has_quads && i + 1 < k; ++i) {
    sum += of_face(i) * around.across(edges[i]);
    faces_together += of_face(i);
  }
  // What a step puts of p_1 into the points within, and of v.
  const double of_first = has_quads ? of_edge(1) / 16 + of_face(0) / 4 : of_edge(1) / 8;
  const double of_vertex = 0.375 * edges_together + 0.25 * faces_together;
  const double determinant = (eigenvalue - 1) * (eigenvalue - 0.25);
  const double ends = (of_first * (eigenvalue - 0.75) + of_vertex / 8) / determinant;
  return sum + ends * (around.end(edges.front()) + around.end(edges.back()));
}

glm::dvec3 mean_normal(const Around& around, const Sector& sector) {
  glm::dvec3 sum(0);
  const std::size_t n = sector.edges.size();
  for (std::size_t i = 0; i + (sector.is_closed ? 0 : 1) < n; ++i) {
    const glm::dvec3 a = unit(around.end(sector.edges[i])), b = unit(around.end(sector.edges[(i + 1) % n]));
    sum += std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b)) * unit(glm::cross(a, b));
  }
  return unit(sum);
}

// A step of a scheme around a dart whose sharp edge comes first. The vertex is at 0, then come the ends of the edges,
// then what lies across the quads.
class DartStep {
 public:
  DartStep(std::size_t valence, Scheme scheme) : n_(valence), has_quads_(scheme == Scheme::catmull_clark) {}

  std::size_t size() const { return 1 + n_ * (has_quads_ ? 2 : 1); }

  // From weights of the points that a step makes to those of the points it makes them of.
  std::vector<double> back(const std::vector<double>& weights) const {
    std::vector<double> before(size(), 0);
    for (std::size_t i = 0; i < size(); ++i)
      add_point(i, weights[i], [&](std::size_t of, double share) { before[of] += share; });
    return before;
  }
  // The points that a step makes.
  std::vector<glm::dvec3> made_of(const std::vector<glm::dvec3>& points) const {
    std::vector<glm::dvec3> made(size(), glm::dvec3(0));
    for (std::size_t i = 0; i < size(); ++i)
      add_point(i, 1, [&](std::size_t of, double share) { made[i] += share * points[of]; });
    return made;
  }
  // Those of the vertex behind ever more steps.
  std::vector<double> limit_weights() const {
    constexpr int enough_steps = 160;  // of which each leaves at most about four fifths of the difference
    std::vector<double> weights(size(), 0);
    weights[0] = 1;
    for (int i = 0; i < enough_steps; ++i) weights = back(weights);
    return weights;
  }

 private:
  std::size_t edge_at(std::size_t i) const { return 1 + i % n_; }
  std::size_t face_at(std::size_t i) const { return 1 + n_ + i % n_; }

  template <class Add>
  void add_point(std::size_t i, double weight, const Add& add) const {
    if (i == 0) return add_vertex(weight, add);
    i <= n_ ? add_edge(i - 1, weight, add) : add_face(i - 1 - n_, weight, add);
  }
  template <class Add>
  void add_face(std::size_t i, double weight, const Add& add) const {
    for (const std::size_t corner : {std::size_t{0}, edge_at(i), edge_at(i + 1), face_at(i)}) add(corner, weight / 4);
  }
  template <class Add>
  void add_edge(std::size_t i, double weight, const Add& add) const {
    if (i == 0) {
      add(0, weight / 2);
      add(edge_at(0), weight / 2);
    } else if (has_quads_) {
      add(0, weight / 4);
      add(edge_at(i), weight / 4);
      add_face(i - 1, weight / 4, add);
      add_face(i, weight / 4, add);
    } else {
      add(0, 0.375 * weight);
      add(edge_at(i), 0.375 * weight);
      add(edge_at(i + n_ - 1), 0.125 * weight);
      add(edge_at(i + 1), 0.125 * weight);
    }
  }
  template <class Add>
  void add_vertex(double weight, const Add& add) const {
    const auto n = static_cast<double>(n_);
    if (has_quads_) {
      add(0, weight * (n - 2) / n);
      for (std::size_t i = 0; i < n_; ++i) {
        add(edge_at(i), weight / (n * n));
        add_face(i, weight / (n * n), add);
      }
      return;
    }
    const double c = 0.375 + 0.25 * std::cos(2 * std::numbers::pi / n), share = (0.625 - c * c) / n;
    add(0, weight * (1 - n * share));
    for (std::size_t i = 0; i < n_; ++i) add(edge_at(i), weight * share);
  }

  std::size_t n_;
  bool has_quads_;
};

// The edges around a dart, the sharp one first, and the points of its step.
struct Dart {
  DartStep step;
  std::vector<double> weights;
  std::vector<glm::dvec3> points;
  std::size_t valence;

  Dart(const Mesh& mesh, Vertex v, const std::vector<Halfedge>& edges, Scheme scheme)
      : step(edges.size(), scheme), weights(step.limit_weights()), points{mesh.position(v)}, valence(edges.size()) {
    for (const Halfedge h : edges) points.push_back(mesh.position(mesh.to(h)));
    if (scheme == Scheme::catmull_clark)
      for (const Halfedge h : edges) points.push_back(mesh.position(mesh.to(mesh.next(h))));
  }

  glm::dvec3 limit() const {
    glm::dvec3 sum(0);
    for (std::size_t i = 0; i < points.size(); ++i) sum += weights[i] * points[i];
    return sum;
  }

  // Of the faces around it after many steps, each of which is drawn twice as large.
  glm::dvec3 normal() {
    constexpr int enough_steps = 50;
    for (int i = 0; i < enough_steps; ++i) {
      const glm::dvec3 middle = limit();
      for (glm::dvec3& p : points) p = 2.0 * (p - middle);
      points = step.made_of(points);
    }
    glm::dvec3 sum(0);
    for (std::size_t i = 0; i < valence; ++i)
      sum += glm::cross(points[1 + i] - points[0], points[1 + (i + 1) % valence] - points[0]);
    return unit(sum);
  }
};

class LimitNormals {
 public:
  LimitNormals(const Mesh& mesh, const Creases& creases, Scheme scheme)
      : mesh_(mesh), creases_(creases), scheme_(scheme), normals_(mesh.halfedge_slots(), glm::dvec3(0)) {}

  std::vector<glm::dvec3> run() {
    const std::uint32_t n = mesh_.vertex_slots();
    for_each_part(n, threads_for(n), [&](unsigned, std::uint32_t begin, std::uint32_t end) {
      Sector sector;
      for (Vertex v(begin); v.index < end; ++v.index)
        if (mesh_.is_alive(v) && !mesh_.is_isolated(v)) find(v, sector);
    });
    return std::move(normals_);
  }

 private:
  bool is_sharp(Halfedge h) const { return creases_.sharpness_of(mesh_, h) > 0; }

  void find(Vertex v, Sector& sector) {
    const RuleAt at = rule_at(mesh_, creases_, v);
    bool has_sharp = false;
    for (const Halfedge h : outgoing(mesh_, v)) {
      if (!is_sharp(h)) continue;
      has_sharp = true;
      if (!mesh_.is_outside(h)) read(h, sector), put(v, sector, at.rule);
    }
    if (has_sharp) return;
    read(mesh_.halfedge(v), sector);
    put(v, sector, VertexRule::smooth);
  }

  void read(Halfedge first, Sector& sector) const {
    sector.edges.clear();
    Halfedge h = first;
    do {
      sector.edges.push_back(h);
      h = mesh_.counter_clockwise(h);
    } while (h != first && !is_sharp(h));
    sector.is_closed = h == first;
    if (!sector.is_closed) sector.edges.push_back(h);
  }

  void put(Vertex v, const Sector& sector, VertexRule rule) {
    const bool is_dart = sector.is_closed && is_sharp(sector.edges.front()) && scheme_ != Scheme::sqrt3;
    const glm::dvec3 normal =
        is_dart ? Dart(mesh_, v, sector.edges, scheme_).normal() : normal_of(Around(mesh_, v), sector, rule);
    for (std::size_t i = 0; i + (sector.is_closed ? 0 : 1) < sector.edges.size(); ++i)
      normals_[sector.edges[i].index] = normal;
  }

  glm::dvec3 normal_of(const Around& around, const Sector& sector, VertexRule rule) const {
    const std::vector<Halfedge>& edges = sector.edges;
    const glm::dvec3 mean = mean_normal(around, sector);
    if (is_sharp(edges.front()) && scheme_ == Scheme::sqrt3) return mean;
    glm::dvec3 normal(0);
    if (sector.is_closed) {
      normal = smooth_tangents(around, edges, scheme_).normal();
    } else {
      const glm::dvec3 first = around.end(edges.front()), last = around.end(edges.back());
      normal = unit(rule == VertexRule::crease ? glm::cross(across_crease(around, edges, scheme_), last - first)
                                               : glm::cross(first, last));
      // The way across points to the faces, or away from them where there is but one; a corner may be larger than 180
      // degrees.
      if (glm::dot(normal, mean) < 0) normal = -normal;
    }
    return normal == glm::dvec3(0) ? mean : normal;
  }

  const Mesh& mesh_;
  const Creases& creases_;
  const Scheme scheme_;
  std::vector<glm::dvec3> normals_;
};

}  // namespace

std::vector<glm::dvec3> limit_normals(const Mesh& mesh, const Creases& creases, Scheme scheme) {
  return LimitNormals(mesh, creases, scheme).run();
}

glm::dvec3 limit_of_dart(const Mesh& mesh, const Creases& creases, Vertex v, Scheme scheme) {
  std::vector<Halfedge> edges;
  Halfedge first = mesh.halfedge(v);
  for (const Halfedge h : outgoing(mesh, v))
    if (creases.sharpness_of(mesh, h) > 0) first = h;
  Halfedge h = first;
  do edges.push_back(h);
  while ((h = mesh.counter_clockwise(h)) != first);
  return Dart(mesh, v, edges, scheme).limit();
}

void put_normals(MeshColumns& columns, const std::vector<glm::dvec3>& normals) {
  std::erase_if(columns.attributes, [](const AttributeColumn& column) {
    return column.name == attribute_names::normal || column.name == attribute_names::normal_pool;
  });
  CornerColumns made = make_corner_columns(attribute_names::normal, attribute_names::normal_pool);
  AttributeColumn &index = made.index, &pool = made.pool;
  index.data.assign(normals.size(), no_index);
  std::uint32_t values = 0;
  for (std::uint32_t i = 0; i < normals.size(); ++i) {
    if (normals[i] == glm::dvec3(0) || index.data[i] != no_index) continue;
    const std::size_t place = pool.data.size();
    pool.data.resize(place + pool.words());
    std::memcpy(pool.data.data() + place, &normals[i], sizeof normals[i]);
    // The corners around the vertex that have the same one, on both sides of this one.
    const auto take = [&](Halfedge h, const auto& step) {
      for (h = step(h);
           h && columns.halfedges[h.index].face && index.data[h.index] == no_index && normals[h.index] == normals[i];
           h = step(h))
        index.data[h.index] = values;
    };
    index.data[i] = values;
    take(Halfedge(i), [&](Halfedge h) { return twin(columns.halfedges[h.index].prev); });
    take(Halfedge(i), [&](Halfedge h) {
      const Halfedge back = twin(h);
      return columns.halfedges[back.index].face ? columns.halfedges[back.index].next : Halfedge();
    });
    ++values;
  }
  columns.attributes.push_back(std::move(index));
  columns.attributes.push_back(std::move(pool));
}

}  // namespace ryosen::subdivide
