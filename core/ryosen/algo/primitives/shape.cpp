#include "ryosen/algo/primitives/shape.h"

#include <cmath>
#include <numbers>

#include "ryosen/analysis/problem_sets.h"
#include "ryosen/base/count_text.h"
#include "ryosen/indexed/from_indexed.h"
#include "ryosen/mesh/append_mesh.h"

namespace ryosen {

namespace {

// Its faces fit together whatever the values, so only places can be at fault: too large, or one for several points.
std::optional<Text> fault_of(const Mesh& shape) {
  const ProblemSets sets(shape);
  for (const ProblemKind kind : {ProblemKind::nonfinite_vertex, ProblemKind::degenerate_area}) {
    if (sets.count(kind) == 0) continue;
    const ProblemRow& row = row_of(kind);
    const std::string n = std::to_string(sets.count(kind));
    return Text{"the values are too far apart, the shape would have " + n + " of the kind " + std::string(row.id),
                "値の差が大きすぎます（形状に「" + std::string(row.name_ja) + "」が " + n + " できるため）"};
  }
  return std::nullopt;
}

Text text_of(const ElementCounts& added) {
  const std::string v = std::to_string(added.vertices), e = std::to_string(added.edges);
  Text text = count_text(added.faces, "# face were added.", "# faces were added.", "面 # を追加しました。");
  text.en = v + " vertices, " + e + " edges and " + text.en;
  text.ja = "頂点 " + v + "、稜線 " + e + "、" + text.ja;
  return text;
}

// On the first eighth of the circle, at a share of the quarter.
glm::dvec2 point_at(std::size_t numerator, std::size_t denominator) {
  if (numerator == 0) return {1, 0};
  if (2 * numerator == denominator) return glm::dvec2(std::numbers::sqrt2 / 2);
  const double angle = std::numbers::pi / 2 * static_cast<double>(numerator) / static_cast<double>(denominator);
  return {std::cos(angle), std::sin(angle)};
}

}  // namespace

std::uint32_t Shape::add_point(const glm::dvec3& place) {
  list_.positions.push_back(centre_ + place);
  return static_cast<std::uint32_t>(list_.positions.size() - 1);
}

void Shape::add_face(std::span<const std::uint32_t> corners) {
  list_.corners.insert(list_.corners.end(), corners.begin(), corners.end());
  list_.face_offsets.push_back(static_cast<std::uint32_t>(list_.corners.size()));
}

AlgorithmResult Shape::add_to(Edit& edit, Progress& progress) && {
  constexpr std::size_t steps = 3;
  AlgorithmResult result;
  if (!progress.go_on(0, steps)) return result;
  const Mesh shape = from_indexed(std::move(list_));
  if (!progress.go_on(1, steps)) return result;
  result.fault = fault_of(shape);
  if (result.fault || !progress.go_on(2, steps)) return result;
  append_mesh(edit, shape);
  result.changed = shape.live().faces;
  result.text = text_of(shape.live());
  return result;
}

std::vector<glm::dvec2> points_on_circle(std::size_t count) {
  std::vector<glm::dvec2> points;
  points.reserve(count);
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t quarter = 4 * i / count, rest = 4 * i % count;
    const bool is_past_eighth = 2 * rest > count;
    const glm::dvec2 p = point_at(is_past_eighth ? count - rest : rest, count);
    const glm::dvec2 q = is_past_eighth ? glm::dvec2(p.y, p.x) : p;
    const glm::dvec2 turned[]{q, {-q.y, q.x}, {-q.x, -q.y}, {q.y, -q.x}};
    points.push_back(turned[quarter]);
  }
  return points;
}

}  // namespace ryosen
