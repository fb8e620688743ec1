#include "ryosen/algo/repair/rims.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <map>

#include "ryosen/algo/unit_scale.h"
#include "ryosen/geometry/exact_sum.h"
#include "ryosen/geometry/polygon_normal.h"
#include "ryosen/geometry/single_precision.h"
#include "ryosen/geometry/unit_vector.h"
#include "ryosen/mesh/circulate.h"

namespace ryosen {

namespace {

constexpr double most_units = 4;

// dot(n, p - at), rounded once: a rim far from the origin leaves its plane by less than a plain sum errs.
double height(const glm::dvec3& n, const glm::dvec3& p, const glm::dvec3& at) {
  exact::Expansion<12> sum;
  for (int axis = 0; axis < 3; ++axis) {
    sum.add_product(n[axis], p[axis]);
    sum.add_product(-n[axis], at[axis]);
  }
  return sum.rounded();
}

bool looks_single(std::span<const glm::dvec3> rim) {
  std::size_t decimals = 0;
  for (const glm::dvec3& p : rim)
    for (int axis = 0; axis < 3; ++axis) {
      if (to_single(p[axis]) == p[axis]) continue;
      if (!is_decimal_of_single(p[axis])) return false;
      ++decimals;
    }
  return decimals == 0 || 2 * decimals >= 3 * rim.size();
}

// A unit vector across n.
glm::dvec3 across(const glm::dvec3& n) {
  const glm::dvec3 a = glm::abs(n);
  const glm::dvec3 axis = a.x <= a.y && a.x <= a.z ? glm::dvec3(1, 0, 0)
                          : a.y <= a.z             ? glm::dvec3(0, 1, 0)
                                                   : glm::dvec3(0, 0, 1);
  return glm::normalize(glm::cross(n, axis));
}

// The normal with its tilt against the places taken away, by least squares.
glm::dvec3 fitted(const glm::dvec3& n, std::span<const glm::dvec3> places, const glm::dvec3& at) {
  const glm::dvec3 u = across(n), v = glm::cross(n, u);
  double uu = 0, uv = 0, vv = 0, uh = 0, vh = 0;
  for (const glm::dvec3& p : places) {
    const double x = glm::dot(u, p - at), y = glm::dot(v, p - at), h = height(n, p, at);
    uu += x * x;
    uv += x * y;
    vv += y * y;
    uh += x * h;
    vh += y * h;
  }
  const double determinant = uu * vv - uv * uv;
  if (!(determinant > 1e-12 * uu * vv)) return n;
  const double a = (uh * vv - vh * uv) / determinant, b = (vh * uu - uh * uv) / determinant;
  return glm::normalize(n - a * u - b * v);
}

using RimPlaces = std::span<const glm::dvec3>;

// Axes at three corners of a rim, in which rims are compared.
struct Frame {
  glm::dvec3 origin;
  std::array<glm::dvec3, 3> axes;

  glm::dvec3 local(const glm::dvec3& p) const {
    return {glm::dot(axes[0], p - origin), glm::dot(axes[1], p - origin), glm::dot(axes[2], p - origin)};
  }
  glm::dvec3 place(const glm::dvec3& l) const { return origin + l.x * axes[0] + l.y * axes[1] + l.z * axes[2]; }
};

using FrameCorners = std::array<std::uint32_t, 3>;

double distance_to_line(const glm::dvec3& p, const glm::dvec3& at, const glm::dvec3& unit) {
  return glm::length((p - at) - glm::dot(unit, p - at) * unit);
}

template <class Height>
std::uint32_t highest(std::size_t n, Height height) {
  std::uint32_t best = 0;
  for (std::uint32_t i = 1; i < n; ++i)
    if (height(i) > height(best)) best = i;
  return best;
}

// The corner, the one farthest from it, and the one farthest from the line through both.
FrameCorners frame_corners(RimPlaces rim, std::uint32_t first) {
  const auto from_first = [&](std::uint32_t i) { return glm::distance(rim[i], rim[first]); };
  const std::uint32_t second = highest(rim.size(), from_first);
  const double length = from_first(second);
  const glm::dvec3 unit = length > 0 ? (rim[second] - rim[first]) / length : glm::dvec3(0.0);
  const auto from_line = [&](std::uint32_t i) { return distance_to_line(rim[i], rim[first], unit); };
  return {first, second, highest(rim.size(), from_line)};
}

std::optional<Frame> frame_of(RimPlaces rim, const FrameCorners& corners, bool is_mirrored) {
  const glm::dvec3 &a = rim[corners[0]], &b = rim[corners[1]], &c = rim[corners[2]];
  const double length = glm::distance(a, b);
  if (!(length > 0)) return std::nullopt;
  const glm::dvec3 x = (b - a) / length, aside = (c - a) - glm::dot(x, c - a) * x;
  const double width = glm::length(aside);
  if (!(width > 1e-9 * length)) return std::nullopt;
  const glm::dvec3 y = aside / width, z = glm::cross(x, y);
  return Frame{a, {x, y, is_mirrored ? -z : z}};
}

// A rim with what tells it from others.
class KnownRim {
 public:
  explicit KnownRim(RimPlaces rim) : rim_(rim) {
    const glm::dvec3 mean = mean_of(rim);
    for (std::size_t i = 0; i < rim.size(); ++i) {
      reaches_.push_back(glm::distance(rim[i], mean));
      length_ += glm::distance(rim[i], rim[(i + 1) % rim.size()]);
    }
    farthest_ = highest(rim.size(), [&](std::uint32_t i) { return reaches_[i]; });
  }

  double length() const { return length_; }
  double tolerance(double rounding) const { return 1e-6 * reaches_[farthest_] + rounding; }

  // How the corners of `other`, with as many, are those of this one.
  std::optional<EqualRim> match(const KnownRim& other, double tolerance) const {
    constexpr std::size_t most_tries = 8;
    std::size_t tries = 0;
    const std::uint32_t n = size();
    for (std::uint32_t i = 0; i < n && tries < most_tries; ++i) {
      if (std::abs(other.reaches_[i] - reaches_[farthest_]) > tolerance) continue;
      ++tries;
      for (const bool is_mirrored : {false, true}) {
        const std::uint32_t shift = is_mirrored ? (farthest_ + i) % n : (farthest_ + n - i) % n;
        const EqualRim equal{0, shift, is_mirrored};
        if (matches(other, equal, tolerance)) return equal;
      }
    }
    return std::nullopt;
  }

 private:
  std::uint32_t size() const { return static_cast<std::uint32_t>(rim_.size()); }

  bool matches(const KnownRim& other, const EqualRim& equal, double tolerance) const {
    const std::uint32_t n = size();
    for (std::uint32_t i = 0; i < n; ++i)
      if (std::abs(other.reaches_[i] - reaches_[equal.corner_of(i, n)]) > tolerance) return false;
    const FrameCorners theirs = frame_corners(other.rim_, 0);
    FrameCorners own;
    for (std::size_t k = 0; k < 3; ++k) own[k] = equal.corner_of(theirs[k], n);
    const auto frame = frame_of(other.rim_, theirs, equal.is_mirrored), own_frame = frame_of(rim_, own, false);
    if (!frame || !own_frame) return false;
    for (std::uint32_t i = 0; i < n; ++i) {
      const glm::dvec3 there = own_frame->local(rim_[equal.corner_of(i, n)]);
      if (glm::distance(frame->local(other.rim_[i]), there) > 4 * tolerance) return false;
    }
    return true;
  }

  RimPlaces rim_;
  std::vector<double> reaches_;  // by corner: how far it is from the mean of all
  double length_ = 0;
  std::uint32_t farthest_ = 0;
};

// Whether the sheet at the rim lies in the plane of the rim and faces the other way than a patch. Asked for the largest
// rim of a sheet, since that tells the plane best; for others of the sheet, whose faces have been seen, the answer is
// no.
bool is_border_of_flat(const Mesh& mesh, const Rims& rims, std::uint32_t hole, Halfedge start,
                       std::vector<bool>& seen) {
  const Face first = mesh.face(twin(start));
  if (seen[first.index]) return false;
  const RimPlane& plane = *rims.planes[hole];
  // The fit may lean within the tolerance. What is as thick as wide is no sheet, however small.
  const double most = std::min(2 * plane.tolerance(), std::sqrt(polygon_area(rims.places[hole])) / 64);
  std::vector<Face> open{first};
  seen[first.index] = true;
  bool is_flat = true;
  double faces_along = 0;
  for (std::size_t next = 0; next < open.size(); ++next) {
    std::vector<glm::dvec3> corners;
    for (Halfedge h : halfedges_around(mesh, open[next])) {
      corners.push_back(mesh.position(mesh.from(h)));
      is_flat = is_flat && plane.distance(corners.back()) <= most;
      const Face beyond = mesh.face(twin(h));
      if (!beyond || seen[beyond.index]) continue;
      seen[beyond.index] = true;
      open.push_back(beyond);
    }
    if (is_flat) faces_along += glm::dot(plane.normal(), polygon_normal(corners)) * polygon_area(corners);
  }
  return is_flat && faces_along < 0;
}

}  // namespace

glm::dvec3 mean_of(std::span<const glm::dvec3> places) {
  glm::dvec3 mean(0.0);
  for (const glm::dvec3& p : places) mean += p / static_cast<double>(places.size());
  return mean;
}

bool are_all_floats(std::span<const glm::dvec3> places) {
  return std::all_of(places.begin(), places.end(),
                     [](const glm::dvec3& p) { return !is_finite(p) || to_single(p) == p; });
}

std::optional<RimPlane> RimPlane::of(std::span<const glm::dvec3> rim, double largest,
                                     std::optional<bool> holds_floats) {
  if (!(largest > 0)) return std::nullopt;
  RimPlane plane;
  plane.exponent_ = std::ilogb(largest);
  const bool looks = looks_single(rim);
  plane.is_single_ = holds_floats.value_or(looks);
  plane.snaps_ = plane.is_single_ && looks;
  plane.box_ = box_of(rim);
  std::vector<glm::dvec3> places;
  for (const glm::dvec3& p : rim) places.push_back(times_power_of_two(p, -plane.exponent_));
  plane.normal_ = polygon_normal(places);
  if (plane.normal_ == glm::dvec3(0.0)) return std::nullopt;
  plane.at_ = mean_of(places);
  plane.normal_ = fitted(plane.normal_, places, plane.at_);
  double lowest = std::numeric_limits<double>::infinity(), highest = -lowest;
  for (const glm::dvec3& p : places) {
    const double h = height(plane.normal_, p, plane.at_);
    lowest = std::min(lowest, h);
    highest = std::max(highest, h);
  }
  if (!(std::ldexp((highest - lowest) / 2, plane.exponent_) <= plane.tolerance())) return std::nullopt;
  plane.at_ += (highest + lowest) / 2 * plane.normal_;
  return plane;
}

double RimPlane::tolerance() const { return std::ldexp(most_units * (is_single_ ? 0x1p-23 : 0x1p-52), exponent_); }

double RimPlane::distance(const glm::dvec3& p) const {
  return std::ldexp(std::abs(height(normal_, times_power_of_two(p, -exponent_), at_)), exponent_);
}

glm::dvec3 RimPlane::nearest(const glm::dvec3& p) const {
  const glm::dvec3 q = times_power_of_two(p, -exponent_);
  const glm::dvec3 foot = times_power_of_two(q - height(normal_, q, at_) * normal_, exponent_);
  return glm::clamp(snaps_ ? to_single(foot) : foot, box_.lowest, box_.highest);
}

std::vector<std::optional<EqualRim>> find_equal_rims(std::span<const std::vector<glm::dvec3>> rims, double rounding) {
  constexpr int most_compared = 4;
  using Known = std::pair<std::uint32_t, KnownRim>;
  std::map<std::size_t, std::multimap<double, Known>> by_size;
  std::vector<std::optional<EqualRim>> found(rims.size());
  for (std::uint32_t i = 0; i < rims.size(); ++i) {
    if (rims[i].size() < 3) continue;
    KnownRim rim(rims[i]);
    const double tolerance = rim.tolerance(rounding), slack = tolerance * static_cast<double>(rims[i].size());
    auto& by_length = by_size[rims[i].size()];
    int compared = 0;
    for (auto at = by_length.lower_bound(rim.length() - slack);
         at != by_length.end() && at->first <= rim.length() + slack && compared < most_compared && !found[i];
         ++at, ++compared) {
      found[i] = at->second.second.match(rim, tolerance);
      if (found[i]) found[i]->as = at->second.first;
    }
    if (found[i]) continue;
    const double length = rim.length();
    by_length.emplace(length, Known(i, std::move(rim)));
  }
  return found;
}

HolePatch patch_like(const HolePatch& other, const EqualRim& equal, const HoleLoop& hole) {
  const std::uint32_t n = hole.size();
  std::vector<std::uint32_t> number(other.places.size());  // by vertex of the other patch
  for (std::uint32_t i = 0; i < n; ++i) number[equal.corner_of(i, n)] = i;
  for (std::uint32_t v = n; v < number.size(); ++v) number[v] = v;
  HolePatch patch;
  patch.corners = n;
  patch.places = hole.places;
  const FrameCorners here = frame_corners(hole.places, 0);
  FrameCorners there;
  for (std::size_t k = 0; k < 3; ++k) there[k] = equal.corner_of(here[k], n);
  const auto from = frame_of(RimPlaces(other.places).first(n), there, false);
  const auto to = frame_of(hole.places, here, equal.is_mirrored);
  for (std::uint32_t v = n; v < other.places.size(); ++v)
    patch.places.push_back(to->place(from->local(other.places[v])));
  const auto renumbered = [&](const CornerTriangle& t) {
    if (t[0] == no_index) return t;
    const CornerTriangle moved{number[t[0]], number[t[1]], number[t[2]]};
    return equal.is_mirrored ? CornerTriangle{moved[0], moved[2], moved[1]} : moved;
  };
  for (const CornerTriangle& t : other.triangles) patch.triangles.push_back(renumbered(t));
  for (const CornerTriangle& t : other.parents) patch.parents.push_back(renumbered(t));
  return patch;
}

Rims read_rims(const Mesh& mesh, std::span<const Hole> holes, std::string_view shape,
               std::optional<bool> holds_floats) {
  const double largest = largest_finite_coordinate(mesh.positions());
  const bool has_floats = holds_floats.value_or(true) && are_all_floats(mesh.positions());
  Rims rims{std::vector<std::vector<glm::dvec3>>(holes.size()),
            std::vector<std::optional<RimPlane>>(holes.size()),
            std::vector<PatchStyle>(holes.size()),
            {},
            std::vector<bool>(holes.size(), false)};
  for (std::uint32_t i = 0; i < holes.size(); ++i) {
    if (holes[i].cause != WhyOpen::untried) continue;
    for (Halfedge h : loop(mesh, holes[i].start)) rims.places[i].push_back(mesh.position(mesh.from(h)));
    rims.planes[i] = RimPlane::of(rims.places[i], largest, holds_floats);
    PatchStyle& style = rims.styles[i];
    style.snaps_to_floats = has_floats;
    if (shape != "fair") style.plane = rims.planes[i];
    style.fairs = shape == "fair" || (shape == "auto" && !style.plane);
  }
  rims.equal = find_equal_rims(rims.places, largest * (holds_floats.value_or(has_floats) ? 0x1p-21 : 0x1p-50));
  for (const auto& equal : rims.equal)
    if (equal) rims.is_like[equal->as] = true;
  return rims;
}

void tell_flat_sheets(const Mesh& mesh, const Rims& rims, std::vector<Hole>& holes) {
  std::vector<std::pair<double, std::uint32_t>> by_area;
  for (std::uint32_t i = 0; i < holes.size(); ++i)
    if (rims.planes[i]) by_area.emplace_back(polygon_area(rims.places[i]), i);
  std::stable_sort(by_area.begin(), by_area.end(), [](const auto& a, const auto& b) { return a.first > b.first; });
  std::vector<bool> seen(mesh.face_slots(), false);
  for (const auto& [area, i] : by_area)
    if (is_border_of_flat(mesh, rims, i, holes[i].start, seen)) holes[i].cause = WhyOpen::flat_sheet;
}

}  // namespace ryosen
