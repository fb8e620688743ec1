// How the work of the forms grows with the number of faces: of the pairings, of what they are asked, and of the
// collapse. Everything is counted and timed when it is asked for, on meshes of growing size.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "ryosen/base/message.h"
#include "ryosen/base/progress.h"
#include "ryosen/mesh/mesh.h"
#include "ryosen/textbook/forms/form.h"

namespace ryosen::forms {

enum class GrowthOf : std::uint8_t { pairing, query, collapse };
struct GrowthRow {
  GrowthOf of;
  std::string_view id, en, ja;
  std::string_view counted_en, counted_ja;  // what is counted
};
// In the order of the enum.
std::span<const GrowthRow> growth_rows();

struct GrowthPoint {
  std::size_t faces = 0;
  double count = 0, seconds = 0;  // of a pairing, else of one query or one collapse
};

struct GrowthCurve {
  GrowthOf of = GrowthOf::pairing;
  std::string_view id;               // of the pairing, the form, or the way to collapse
  std::optional<Relation> relation;  // that is asked
  std::string_view en, ja;           // its name
  std::vector<GrowthPoint> points;   // the smallest mesh first
};

// The exponent of the power of the number of faces that fits best: 1 where it grows in proportion, 2 with the square, 0
// where it stays. None of fewer than two points that are not 0.
std::optional<double> slope_of_count(const GrowthCurve& curve);
std::optional<double> slope_of_time(const GrowthCurve& curve);

// With two decimals; "-" for none.
std::string slope_text(std::optional<double> slope);

// The cost of one collapse, in one of the ways in which an edge collapses here.
struct CollapseFigures {
  double count = 0;    // of links followed, list entries compared, or cells written; the mean
  double seconds = 0;  // the least: other load only makes it slower
};

struct CollapseWay {
  std::string_view id, en, ja;
  // Over several edges that may collapse; none where the mesh has none, or the form cannot hold it.
  std::optional<CollapseFigures> (*measure)(const Mesh& mesh);
};
// Text 000's listing with its lists of vertices and faces, the same with arrays in their place, and the kernel.
std::span<const CollapseWay> collapse_ways();

struct GrowthEffort {
  std::size_t most_faces = 60'000;
  double pairing_steps = 2e8;     // a pairing that takes more is left out from there on
  double query_seconds = 0.0001;  // to time one query with
};

// The curves of all pairings, of all relations on all forms that can tell, and of the ways to collapse, on `meshes` of
// growing size; a form that a mesh does not suit has no point there. Empty when it is cancelled. Cost: that of all
// pairings and of building every form for each mesh.
std::vector<GrowthCurve> measure_growth(std::span<const Mesh> meshes, const GrowthEffort& effort, Progress& progress);

}  // namespace ryosen::forms
