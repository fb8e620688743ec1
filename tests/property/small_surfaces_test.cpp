// Collapse, swap and split on every edge of all small surfaces, of the polygon meshes that dissolving makes of them,
// and of their parts, against the oracle.
#include "tests/support/core/small_surfaces.h"

#include <gtest/gtest.h>

#include <iostream>
#include <map>
#include <unordered_set>

#include "tests/support/core/kernel_lists.h"
#include "tests/support/core/long_run.h"
#include "tests/support/core/oracle/comparison.h"

namespace ryosen {
namespace {

using namespace test;
using oracle::Corners;

// Asks kernel and oracle about every operation on a mesh, and counts what the kernel says.
class Exhaustion {
 public:
  ~Exhaustion() {
    std::cout << meshes_ << " meshes, " << verdicts_ << " verdicts\n";
    for (const auto& [name, count] : counts_) std::cout << "  " << name << ": " << count << "\n";
  }

  void compare(int vertices, const std::vector<Corners>& faces) {
    const oracle::PolygonList points = oracle::polygon_list(vertices, faces);
    const Mesh mesh = kernel_mesh(points, 1);
    ++meshes_;
    const auto kernel = [&](const oracle::Operation& operation) {
      const AnyOp op = op_of(mesh, operation);
      const Verdict verdict = check(mesh, op);
      const std::string id(info_of(op).id);
      ++verdicts_;
      if (verdict.legal()) ++counts_[id + " legal"];
      if (!verdict.legal()) ++counts_[id + " refused"];
      for (const Reason& reason : verdict.reasons)
        ++counts_[id + " refused for " + std::string(text_of(reason.rule).id)];
      return verdict.legal();
    };
    for (const oracle::Disagreement& disagreement : oracle::compare(points, kernel)) {
      if (++disagreements_ > 10) return;
      ADD_FAILURE() << to_text(disagreement);
    }
  }

  // The same, unless an isomorphic mesh has been compared.
  void compare_new(int vertices, const std::vector<Corners>& faces) {
    if (seen_.insert(code_of(faces)).second) compare(vertices, faces);
  }

  std::size_t count(const std::string& name) const {
    const auto found = counts_.find(name);
    return found == counts_.end() ? 0 : found->second;
  }

 private:
  std::size_t meshes_ = 0, verdicts_ = 0, disagreements_ = 0;
  std::map<std::string, std::size_t> counts_;
  std::unordered_set<std::string> seen_;
};

const std::vector<Surface>& surfaces(int n) {
  static std::map<int, std::vector<Surface>> known;
  const auto [found, is_new] = known.try_emplace(n);
  if (is_new) found->second = closed_surfaces(n);
  return found->second;
}

TEST(small_surfaces_oracle, there_are_as_many_as_known) {
  const std::size_t all[] = {1, 1, 3, 9, 43}, orientable[] = {1, 1, 2, 6, 21};
  for (int n = 4; n <= (is_long_run() ? 8 : 7); ++n) {
    std::size_t count = 0;
    for (const Surface& surface : surfaces(n)) count += surface.orientable;
    EXPECT_EQ(surfaces(n).size(), all[n - 4]) << n;
    EXPECT_EQ(count, orientable[n - 4]) << n;
  }
}

TEST(small_surfaces_oracle, closed_triangulations_up_to_8_vertices) {
  Exhaustion all;
  for (int n = 4; n <= (is_long_run() ? 8 : 7); ++n)
    for (const Surface& surface : surfaces(n)) all.compare(n, surface.triangles);
  for (const char* name : {"collapse legal", "collapse refused", "swap legal", "swap refused", "split legal"})
    EXPECT_GT(all.count(name), 0u) << name;
}

TEST(small_surfaces_oracle, polygon_meshes_by_dissolving) {
  Exhaustion all;
  for (int n = 4; n <= (is_long_run() ? 7 : 6); ++n)
    for (const Surface& surface : surfaces(n)) {
      if (!surface.orientable) continue;
      for_each_dissolution(surface, [&](const auto& faces) { all.compare_new(n, faces); });
    }
  for (const char* name : {"collapse legal", "collapse refused for common_face", "collapse refused for duplicate_face",
                           "swap legal", "swap refused for corner_twice", "swap refused for duplicate_face"})
    EXPECT_GT(all.count(name), 0u) << name;
}

TEST(small_surfaces_oracle, parts_of_them) {
  Exhaustion all;
  for (int n = 4; n <= (is_long_run() ? 8 : 6); ++n)
    for (const Surface& surface : surfaces(n)) {
      for_each_connected_part(surface.triangles, Through::edges, [&](const auto& faces) {
        surface.orientable ? all.compare_new(n, faces) : all.compare(n, faces);
      });
    }
  for (int n = 4; n <= (is_long_run() ? 7 : 6); ++n)
    for (const Surface& surface : surfaces(n)) {
      if (!surface.orientable || static_cast<int>(surface.triangles.size()) != 2 * n - 4) continue;
      for_each_dissolution(surface, [&](const auto& faces) {
        for_each_connected_part(faces, Through::edges, [&](const auto& part) { all.compare_new(n, part); });
      });
    }
  for (int n = 4; n <= (is_long_run() ? 7 : 6); ++n)
    for (const Surface& surface : surfaces(n))
      if (surface.triangles.size() <= 12)
        for_each_connected_part(surface.triangles, Through::vertices, [&](const auto& part) { all.compare(n, part); });
  for (const char* name :
       {"collapse refused for isolated_apex", "collapse refused for closes_hole", "collapse refused for inner_edge",
        "swap refused for boundary", "collapse refused for copies"})
    EXPECT_GT(all.count(name), 0u) << name;
}

}  // namespace
}  // namespace ryosen
