#include "ryosen/textbook/forms/questions.h"

#include <algorithm>
#include <random>

#include "ryosen/base/stopwatch.h"
#include "ryosen/textbook/forms/polygons.h"

namespace ryosen::forms {

Questions::Questions(const Mesh& mesh) {
  constexpr std::size_t count = 256;
  const Numbering numbers(mesh);
  std::mt19937 random(1);
  const auto pick = [&](std::uint32_t end) { return static_cast<std::uint32_t>(random() % end); };
  std::vector<EdgeEnds> all;
  for (std::uint32_t i = 0; i < mesh.edge_slots(); ++i)
    if (mesh.is_alive(Edge(i)))
      all.push_back(edge_ends(numbers.point[mesh.from(halfedge(Edge(i))).index],
                              numbers.point[mesh.to(halfedge(Edge(i))).index]));
  for (std::size_t i = 0; i < count; ++i) {
    if (numbers.points > 0) vertices.push_back(pick(numbers.points));
    if (numbers.faces > 0) faces.push_back(pick(numbers.faces));
    if (!all.empty()) edges.push_back(all[pick(static_cast<std::uint32_t>(all.size()))]);
  }
}

std::vector<std::uint32_t> handles_of(const Form& form, const std::vector<EdgeEnds>& edges, double seconds) {
  std::vector<std::uint32_t> handles;
  const Stopwatch watch;
  for (const EdgeEnds& ends : edges) {
    const std::uint32_t handle = form.find_edge(ends.a, ends.b);
    if (handle != no_index) handles.push_back(handle);
    if (watch.seconds() > seconds) break;
  }
  return handles;
}

// The fastest of several rounds, each long enough for the clock's resolution: other load only makes a round slower. A
// round length is accepted only if two rounds in a row are long enough.
std::optional<double> time_per_query(const Form& form, Relation relation, const std::vector<std::uint32_t>& elements,
                                     double seconds) {
  Answer answer;
  if (elements.empty() || !form.answer(relation, elements[0], answer)) return {};
  const auto time_round = [&](std::size_t count) {
    const Stopwatch watch;
    for (std::size_t i = 0; i < count; ++i) form.answer(relation, elements[i % elements.size()], answer);
    return watch.seconds();
  };
  const double long_enough = seconds / 8;
  std::size_t count = 1;
  double best = time_round(count);
  while (best < long_enough || (best = std::min(best, time_round(count))) < long_enough) best = time_round(count *= 2);
  for (int round = 0; round < 3; ++round) best = std::min(best, time_round(count));
  return best / static_cast<double>(count);
}

}  // namespace ryosen::forms
