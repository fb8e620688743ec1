#include "tests/support/core/random_meshes.h"

#include <algorithm>
#include <array>
#include <numeric>
#include <set>
#include <utility>

namespace ryosen {
namespace {

using Corners = std::vector<int>;

struct Draft {
  int points = 0;
  std::vector<Corners> faces;
  std::string story;

  int size() const { return static_cast<int>(faces.size()); }
};

bool simple(const Corners& face) {
  return face.size() >= 3 && std::set<int>(face.begin(), face.end()).size() == face.size();
}

bool has(const Corners& face, int point) { return std::find(face.begin(), face.end(), point) != face.end(); }

// Index of the corner from which the face runs a -> b, or -1.
int side_index(const Corners& face, int a, int b) {
  for (std::size_t i = 0; i < face.size(); ++i)
    if (face[i] == a && face[(i + 1) % face.size()] == b) return static_cast<int>(i);
  return -1;
}

bool is_side(const Draft& mesh, int a, int b) {
  for (const Corners& face : mesh.faces)
    if (side_index(face, a, b) >= 0 || side_index(face, b, a) >= 0) return true;
  return false;
}

Corners from_corner(Corners face, int first) {
  std::rotate(face.begin(), face.begin() + first, face.end());
  return face;
}

void shuffle(std::vector<int>& numbers, Dice& dice) {
  for (int i = static_cast<int>(numbers.size()) - 1; i > 0; --i) std::swap(numbers[i], numbers[dice.below(i + 1)]);
}

std::vector<int> permutation(int n, Dice& dice) {
  std::vector<int> numbers(static_cast<std::size_t>(n));
  std::iota(numbers.begin(), numbers.end(), 0);
  shuffle(numbers, dice);
  return numbers;
}

// ---- changes of a draft; each leaves it as it was where the dice find no place ----

// A random side as face and corner.
std::pair<int, int> any_side(const Draft& mesh, Dice& dice) {
  const int f = dice.below(mesh.size());
  return {f, dice.below(static_cast<int>(mesh.faces[f].size()))};
}

// The only other face at the side of f, which runs it the other way, or -1.
int only_neighbour(const Draft& mesh, int f, int a, int b) {
  int found = -1;
  for (int g = 0; g < mesh.size(); ++g) {
    if (g == f) continue;
    if (side_index(mesh.faces[g], a, b) >= 0) return -1;
    if (side_index(mesh.faces[g], b, a) < 0) continue;
    if (found >= 0) return -1;
    found = g;
  }
  return found;
}

void flip(Draft& mesh, Dice& dice) {
  const auto [f, i] = any_side(mesh, dice);
  const Corners one = from_corner(mesh.faces[f], i);
  const int g = only_neighbour(mesh, f, one[0], one[1]);
  if (g < 0 || one.size() != 3 || mesh.faces[g].size() != 3) return;
  const Corners other = from_corner(mesh.faces[g], side_index(mesh.faces[g], one[1], one[0]));
  if (one[2] == other[2] || is_side(mesh, one[2], other[2])) return;
  mesh.faces[f] = {one[0], other[2], one[2]};
  mesh.faces[g] = {one[1], one[2], other[2]};
}

void dissolve_edge(Draft& mesh, Dice& dice) {
  const auto [f, i] = any_side(mesh, dice);
  const Corners one = from_corner(mesh.faces[f], i);
  const int g = only_neighbour(mesh, f, one[0], one[1]);
  if (g < 0) return;
  const Corners other = from_corner(mesh.faces[g], side_index(mesh.faces[g], one[1], one[0]));
  Corners united(one.begin() + 1, one.end());
  united.push_back(one[0]);
  united.insert(united.end(), other.begin() + 2, other.end());
  if (!simple(united) || united.size() > 7) return;
  mesh.faces[f] = united;
  mesh.faces.erase(mesh.faces.begin() + g);
}

void point_on_edge(Draft& mesh, Dice& dice) {
  const auto [f, i] = any_side(mesh, dice);
  const int a = mesh.faces[f][i], b = mesh.faces[f][(static_cast<std::size_t>(i) + 1) % mesh.faces[f].size()];
  const int middle = mesh.points++;
  for (Corners& face : mesh.faces)
    for (auto [from, to] : {std::pair(a, b), std::pair(b, a)}) {
      const int at = side_index(face, from, to);
      if (at >= 0) face.insert(face.begin() + at + 1, middle);
    }
}

void point_in_face(Draft& mesh, Dice& dice) {
  const int f = dice.below(mesh.size());
  const Corners face = mesh.faces[f];
  const int apex = mesh.points++;
  mesh.faces.erase(mesh.faces.begin() + f);
  for (std::size_t i = 0; i < face.size(); ++i) mesh.faces.push_back({face[i], face[(i + 1) % face.size()], apex});
}

void remove_face(Draft& mesh, Dice& dice) {
  if (mesh.size() > 1) mesh.faces.erase(mesh.faces.begin() + dice.below(mesh.size()));
}

void turn_face(Draft& mesh, Dice& dice) {
  Corners& face = mesh.faces[dice.below(mesh.size())];
  std::reverse(face.begin(), face.end());
}

void double_face(Draft& mesh, Dice& dice) {
  Corners copy = mesh.faces[dice.below(mesh.size())];
  if (!dice.one_in(3)) std::reverse(copy.begin(), copy.end());
  if (dice.one_in(4)) shuffle(copy, dice);
  mesh.faces.push_back(copy);
}

// A new face at an existing side, to a new point or an old one: fins, ears and closed gaps.
void face_on_edge(Draft& mesh, Dice& dice) {
  const auto [f, i] = any_side(mesh, dice);
  const Corners face = from_corner(mesh.faces[f], i);
  Corners fin{face[1], face[0], dice.one_in(2) ? mesh.points++ : dice.below(mesh.points)};
  if (dice.one_in(3)) fin.push_back(dice.one_in(2) ? mesh.points++ : dice.below(mesh.points));
  if (dice.one_in(4)) std::swap(fin[0], fin[1]);
  if (simple(fin)) mesh.faces.push_back(fin);
}

void glue(Draft& mesh, int gone, int stays) {
  if (gone == stays) return;
  for (const Corners& face : mesh.faces)
    if (has(face, gone) && has(face, stays)) return;
  for (Corners& face : mesh.faces) std::replace(face.begin(), face.end(), gone, stays);
}

void glue_points(Draft& mesh, Dice& dice) {
  const int second = dice.below(mesh.points), first = dice.below(mesh.points);  // in this order with every compiler
  glue(mesh, first, second);
}

void glue_edges(Draft& mesh, Dice& dice) {
  const auto [f, i] = any_side(mesh, dice);
  const auto [g, k] = any_side(mesh, dice);
  const Corners one = from_corner(mesh.faces[f], i), other = from_corner(mesh.faces[g], k);
  glue(mesh, one[0], other[1]);
  glue(mesh, one[1], other[0]);
}

void add_isolated_point(Draft& mesh, Dice&) { ++mesh.points; }

void add(Draft& mesh, const Draft& part) {
  for (Corners face : part.faces) {
    for (int& p : face) p += mesh.points;
    mesh.faces.push_back(face);
  }
  mesh.points += part.points;
}

// ---- bases ----

Draft tetrahedron(Dice&) { return {4, {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}}, {}}; }

Draft sphere(Dice& dice) {
  Draft mesh = tetrahedron(dice);
  for (int n = dice.below(5); n > 0; --n) point_in_face(mesh, dice);
  for (int n = dice.below(12); n > 0; --n) flip(mesh, dice);
  return mesh;
}

Draft octahedron(Dice&) {
  return {6, {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 1}, {5, 2, 1}, {5, 3, 2}, {5, 4, 3}, {5, 1, 4}}, {}};
}

// A grid of quads with both directions closed to rings; `klein` turns the ring of columns over.
Draft closed_grid(int columns, int rows, bool klein, Dice& dice) {
  Draft mesh{columns * rows, {}, {}};
  const auto at = [&](int i, int j) {
    if (i == columns && klein) j = rows - j;
    return (i % columns) * rows + j % rows;
  };
  for (int i = 0; i < columns; ++i)
    for (int j = 0; j < rows; ++j) {
      const int a = at(i, j), b = at(i + 1, j), c = at(i + 1, j + 1), d = at(i, j + 1);
      if (dice.one_in(3)) {
        mesh.faces.push_back({a, b, c});
        mesh.faces.push_back({a, c, d});
      } else {
        mesh.faces.push_back({a, b, c, d});
      }
    }
  return mesh;
}

Draft torus(Dice& dice) {
  if (dice.one_in(2)) return closed_grid(3, 3 + dice.below(2), false, dice);
  Draft mesh{7, {}, {}};
  for (int i = 0; i < 7; ++i) {
    mesh.faces.push_back({i, (i + 1) % 7, (i + 3) % 7});
    mesh.faces.push_back({i, (i + 3) % 7, (i + 2) % 7});
  }
  return mesh;
}

Draft klein_bottle(Dice& dice) { return closed_grid(3, 3 + dice.below(2), true, dice); }

Draft projective_plane(Dice&) {
  return {
      6,
      {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 5}, {0, 5, 1}, {1, 2, 4}, {2, 3, 5}, {3, 4, 1}, {4, 5, 2}, {5, 1, 3}},
      {}};
}

Draft fan(Dice& dice) {
  const int n = 1 + dice.below(5);
  Draft mesh{n + 2, {}, {}};
  for (int i = 1; i <= n; ++i) mesh.faces.push_back({0, i, i + 1});
  if (n > 2 && dice.one_in(2)) mesh.faces.push_back({0, n + 1, 1});
  return mesh;
}

Draft polygon(Dice& dice) {
  const int n = 3 + dice.below(5);
  Corners face(static_cast<std::size_t>(n));
  std::iota(face.begin(), face.end(), 0);
  return {n, {face}, {}};
}

Draft pillow(Dice& dice) {
  Draft mesh = polygon(dice);
  Corners back = mesh.faces[0];
  std::reverse(back.begin(), back.end());
  mesh.faces.push_back(back);
  return mesh;
}

// A strip of quads and triangles closed to a ring, with or without a half twist.
Draft strip(Dice& dice) {
  const int n = 3 + dice.below(3);
  const bool twist = dice.one_in(2);
  Draft mesh{2 * n, {}, {}};
  for (int i = 0; i < n; ++i) {
    const bool turned = twist && i == n - 1;
    const int a = 2 * i, b = a + 1, next = (a + 2) % (2 * n), c = turned ? next : next + 1,
              d = turned ? next + 1 : next;
    if (dice.one_in(2)) {
      mesh.faces.push_back({a, d, c, b});
    } else {
      mesh.faces.push_back({a, d, c});
      mesh.faces.push_back({a, c, b});
    }
  }
  return mesh;
}

Draft prism(Dice& dice) {
  const int n = 3 + dice.below(3);
  Draft mesh{2 * n, {{}, {}}, {}};
  for (int i = 0; i < n; ++i) {
    mesh.faces[0].push_back(n - 1 - i);
    mesh.faces[1].push_back(n + i);
    mesh.faces.push_back({i, (i + 1) % n, n + (i + 1) % n, n + i});
  }
  return mesh;
}

// Faces that all meet in one edge.
Draft book(Dice& dice) {
  Draft mesh{2, {}, {}};
  for (int pages = 2 + dice.below(4); pages > 0; --pages) {
    Corners page{0, 1};
    for (int n = 1 + dice.below(3); n > 0; --n) page.push_back(mesh.points++);
    if (dice.one_in(2)) std::swap(page[0], page[1]);
    mesh.faces.push_back(page);
  }
  return mesh;
}

// Two poles and n meridians of one to three edges, with a face between neighbouring meridians: faces that share several
// edges, vertices with two edges.
Draft lampion(Dice& dice) {
  const int n = 2 + dice.below(3);
  Draft mesh{2, {}, {}};
  std::vector<Corners> meridians;
  bool bare = false;
  for (int i = 0; i < n; ++i) {
    Corners inner;
    for (int k = dice.below(3); k > 0; --k) inner.push_back(mesh.points++);
    if (inner.empty() && std::exchange(bare, true)) inner.push_back(mesh.points++);
    meridians.push_back(inner);
  }
  for (int i = 0; i < n; ++i) {
    const Corners &down = meridians[i], &up = meridians[(i + 1) % n];
    Corners face{0};
    face.insert(face.end(), down.begin(), down.end());
    face.push_back(1);
    face.insert(face.end(), up.rbegin(), up.rend());
    if (face.size() >= 3) mesh.faces.push_back(face);
  }
  return mesh.faces.empty() ? polygon(dice) : mesh;
}

Draft soup(Dice& dice) {
  Draft mesh{3 + dice.below(5), {}, {}};
  for (int n = 1 + dice.below(8); n > 0; --n) {
    Corners face = permutation(mesh.points, dice);
    const int size = dice.one_in(2) ? 3 : 3 + dice.below(4);
    if (static_cast<int>(face.size()) > size) face.resize(static_cast<std::size_t>(size));
    mesh.faces.push_back(face);
  }
  return mesh;
}

// A soup that prefers sides still open, so that faces join.
Draft grown_soup(Dice& dice) {
  Draft mesh = polygon(dice);
  for (int n = 1 + dice.below(8); n > 0; --n) {
    const auto [f, i] = any_side(mesh, dice);
    const Corners side = from_corner(mesh.faces[f], i);
    if (side_index(mesh.faces[f], side[0], side[1]) >= 0 && only_neighbour(mesh, f, side[0], side[1]) >= 0) continue;
    Corners face{side[1], side[0]};
    for (int k = 1 + dice.below(3); k > 0; --k)
      face.push_back(dice.one_in(3) ? mesh.points++ : dice.below(mesh.points));
    if (simple(face)) mesh.faces.push_back(face);
  }
  return mesh;
}

template <class Function>
struct Row {
  const char* name;
  int weight;
  Function make;
};
using Base = Row<Draft (*)(Dice&)>;
using Change = Row<void (*)(Draft&, Dice&)>;

constexpr std::array<Base, 15> bases{{{"tetrahedron", 2, tetrahedron},
                                      {"sphere", 6, sphere},
                                      {"octahedron", 2, octahedron},
                                      {"torus", 1, torus},
                                      {"klein bottle", 1, klein_bottle},
                                      {"projective plane", 1, projective_plane},
                                      {"fan", 4, fan},
                                      {"polygon", 1, polygon},
                                      {"pillow", 2, pillow},
                                      {"strip", 4, strip},
                                      {"prism", 3, prism},
                                      {"book", 3, book},
                                      {"lampion", 4, lampion},
                                      {"soup", 4, soup},
                                      {"grown soup", 5, grown_soup}}};

constexpr std::array<Change, 11> changes{{{"flip", 2, flip},
                                          {"dissolve", 8, dissolve_edge},
                                          {"point on edge", 3, point_on_edge},
                                          {"point in face", 2, point_in_face},
                                          {"remove", 6, remove_face},
                                          {"turn", 1, turn_face},
                                          {"double", 1, double_face},
                                          {"face on edge", 3, face_on_edge},
                                          {"glue points", 2, glue_points},
                                          {"glue edges", 2, glue_edges},
                                          {"isolated", 1, add_isolated_point}}};

template <class Table>
const auto& draw(const Table& table, Dice& dice) {
  int sum = 0;
  for (const auto& row : table) sum += row.weight;
  int pick = dice.below(sum);
  std::size_t i = 0;
  while (pick >= table[i].weight) pick -= table[i++].weight;
  return table[i];
}

void shuffle_numbers(Draft& mesh, Dice& dice) {
  const std::vector<int> names = permutation(mesh.points, dice), order = permutation(mesh.size(), dice);
  std::vector<Corners> faces;
  for (int f : order) {
    Corners face = mesh.faces[f];
    for (int& p : face) p = names[p];
    faces.push_back(from_corner(face, dice.below(static_cast<int>(face.size()))));
  }
  mesh.faces = faces;
}

}  // namespace

std::uint64_t Dice::next() {
  state_ += 0x9e3779b97f4a7c15u;
  std::uint64_t z = state_;
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
  return z ^ (z >> 31);
}

RandomMesh random_mesh(std::uint64_t seed) {
  Dice dice(seed);
  const Base& base = draw(bases, dice);
  Draft mesh = base.make(dice);
  mesh.story = base.name;
  if (mesh.size() < 9 && dice.one_in(8)) {
    const Base& second = draw(bases, dice);
    add(mesh, second.make(dice));
    mesh.story += std::string(" beside ") + second.name;
    if (dice.one_in(2)) glue_points(mesh, dice);
    if (dice.one_in(2)) glue_edges(mesh, dice);
  }
  for (int n = dice.below(6); n > 0; --n) {
    const Change& change = draw(changes, dice);
    change.make(mesh, dice);
    mesh.story += std::string(", ") + change.name;
  }
  shuffle_numbers(mesh, dice);
  return {seed, mesh.story, mesh.points, mesh.faces};
}

RandomMesh random_manifold(std::uint64_t seed, int faces) {
  Dice dice(seed);
  Draft mesh = dice.one_in(4) ? torus(dice) : sphere(dice);
  while (mesh.size() < 2 * faces) point_in_face(mesh, dice);
  for (int n = 3 * faces; n > 0; --n) flip(mesh, dice);
  for (int n = dice.below(faces); n > 0 && mesh.size() > faces; --n) dissolve_edge(mesh, dice);
  if (dice.one_in(2)) remove_face(mesh, dice);
  shuffle_numbers(mesh, dice);
  return {seed, "manifold", mesh.points, mesh.faces};
}

}  // namespace ryosen
