// What `hull` has made, and how it says so.
#pragma once

#include <string>
#include <vector>

#include "app/cli/console.h"
#include "ryosen/hull/hull_extent.h"
#include "ryosen/hull/hull_shape.h"
#include "ryosen/hull/projection.h"

namespace ryosen::cli {

struct HullWishes {
  HullFaces faces = HullFaces::facets;
  Projection projection = Projection::none;
  bool per_component = false, measure = false;
};

struct MadeHull {
  std::size_t points = 0;   // of which it is the hull
  std::uint32_t first = 0;  // the lowest of them
  ConvexHull hull;
  HullSize size;
  HullExtent extent;
};

struct HullReport {
  HullReport(std::string file, HullWishes what) : input(std::move(file)), wishes(what) {}

  // The largest; -1 where there is no hull.
  int dimension() const;
  // `output`: where it was written, null where it was not.
  std::string json_line(ExitCode code, const std::string* output, const Console& console) const;
  std::string text(const std::string* output, const Console& console) const;

  std::string input;
  HullWishes wishes;
  std::vector<glm::dvec3> points = {};
  std::vector<MadeHull> hulls = {};
  std::vector<Message> messages = {};
};

}  // namespace ryosen::cli
