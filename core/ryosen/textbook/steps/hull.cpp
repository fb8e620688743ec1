// The incremental convex hull of text 004: for each point the faces that it sees, their horizon, the faces that go and
// those that come, in the records of the text's DCEL and, beside it, on the kernel; in a plane the same with edges.
#include <charconv>

#include "ryosen/hull/projection.h"
#include "ryosen/mesh/copies.h"
#include "ryosen/mesh/live_elements.h"
#include "ryosen/textbook/steps/hull_sequence.h"
#include "ryosen/textbook/steps/players.h"

namespace ryosen::steps {

namespace {

std::vector<glm::dvec3> points_of(const Mesh& mesh) {
  std::vector<glm::dvec3> points;
  for (const Vertex v : live_vertices(mesh))
    if (point(mesh, v) == v) points.push_back(mesh.position(v));
  return points;
}

// Whether a point that was deleted lies before one that is there, so that these have other numbers among themselves.
bool are_renumbered(const Mesh& mesh, std::size_t points) {
  std::uint32_t end = mesh.vertex_slots();
  while (end > 0 && (!mesh.is_alive(Vertex(end - 1)) || point(mesh, Vertex(end - 1)) != Vertex(end - 1))) --end;
  return end != points;
}

Failure no_such_order() {
  return usage_of(
      {"'hull [ORDER [SEED]] [project=AXIS]' takes random, as_given or farthest, a number for random, and x, y, "
       "z or best for the axis.",
       "hull [ORDER [SEED]] [project=AXIS] の ORDER は random、as_given、farthest、SEED は random の番号、AXIS は "
       "x、y、z、best です。"});
}

struct Wishes {
  HullOrder order = HullOrder::random;
  std::uint64_t seed = 0;
  Projection projection = Projection::none;
};

std::optional<Wishes> read_wishes(Arguments arguments) {
  constexpr std::string_view project_word = "project=";
  Wishes wishes;
  if (!arguments.empty() && arguments.back().starts_with(project_word)) {
    const ProjectionRow* const row = find_projection(std::string_view(arguments.back()).substr(project_word.size()));
    if (!row) return {};
    wishes.projection = row->projection;
    arguments = arguments.first(arguments.size() - 1);
  }
  if (arguments.size() > 2) return {};
  if (!arguments.empty()) {
    const HullOrderRow* const row = find_hull_order(arguments[0]);
    if (!row) return {};
    wishes.order = row->order;
  }
  if (arguments.size() == 2) {
    const char* const end = arguments[1].data() + arguments[1].size();
    const auto [behind, error] = std::from_chars(arguments[1].data(), end, wishes.seed);
    if (error != std::errc() || behind != end || wishes.order != HullOrder::random) return {};
  }
  return wishes;
}

}  // namespace

Made play_hull(const Mesh& mesh, Arguments arguments) {
  const std::optional<Wishes> wishes = read_wishes(arguments);
  if (!wishes) return no_such_order();
  std::vector<glm::dvec3> points = points_of(mesh);
  project(points, wishes->projection);
  const int dimension = HullSteps(points, HullOrder::as_given).dimension();
  if (dimension < 2)
    return refusal_of({"The points do not span a plane (dimension " + std::to_string(dimension) +
                           "), so there is nothing to play; ryosen hull gives their hull.",
                       "点が平面を張らないため（次元 " + std::to_string(dimension) +
                           "）、再生する手順がありません。凸包は ryosen hull で得られます。"});
  const bool renumbered = are_renumbered(mesh, points.size());
  auto sequence = std::make_unique<HullSequence>(std::move(points), wishes->order, wishes->seed);
  if (renumbered)
    sequence->add_remark(
        {" They are numbered anew, without those that were deleted.", "削除した点を除き、番号を付け直しています。"});
  return std::unique_ptr<Sequence>(std::move(sequence));
}

Choices choices_of_hull(const Mesh& mesh, Selected) {
  const std::vector<glm::dvec3> points = points_of(mesh);
  const int dimension = HullSteps(points, HullOrder::as_given).dimension();
  if (dimension < 2) return {};
  Choices choices;
  for (const HullOrderRow& row : hull_orders()) choices.push_back({std::string(row.id)});
  if (dimension == 3) choices.push_back({"random", "project=best"});
  return choices;
}

}  // namespace ryosen::steps
