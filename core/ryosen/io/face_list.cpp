#include "ryosen/io/face_list.h"

#include <algorithm>

#include "ryosen/base/column_memory.h"
#include "ryosen/base/parallel.h"
#include "ryosen/mesh/bridges.h"

namespace ryosen {
namespace {

// Removes from `values` (parallel to the corners) the ranges of the faces in `removed`.
void remove_ranges(std::vector<std::uint32_t>& values, const std::vector<std::uint32_t>& offsets,
                   const std::vector<QuarantinedFace>& removed) {
  if (values.empty()) return;
  auto out = values.begin() + offsets[removed.front().face];
  for (std::size_t i = 0; i < removed.size(); ++i) {
    const auto begin = values.begin() + offsets[removed[i].face + 1];
    const auto end = i + 1 < removed.size() ? values.begin() + offsets[removed[i + 1].face] : values.end();
    out = std::copy(begin, end, out);
  }
  values.erase(out, values.end());
}

}  // namespace

void FaceList::append(const FaceList& next, std::uint64_t lines_before) {
  const IndexedMesh& other = next.mesh_;
  const auto corners = static_cast<std::uint32_t>(mesh_.corners.size());
  for (const auto& [place, vertex] : next.wide_) wide_.emplace_back(corners + place, vertex);
  mesh_.corners.insert(mesh_.corners.end(), other.corners.begin(), other.corners.end());
  const auto append_each = [](auto begin, auto end, std::vector<std::uint32_t>& to, auto value_of) {
    const std::size_t count = to.size();
    to.resize(count + static_cast<std::size_t>(end - begin));
    std::transform(begin, end, to.begin() + static_cast<std::ptrdiff_t>(count), value_of);
  };
  append_each(other.face_offsets.begin() + 1, other.face_offsets.end(), mesh_.face_offsets,
              [corners](std::uint32_t offset) { return corners + offset; });
  append_each(other.face_lines.begin(), other.face_lines.end(), mesh_.face_lines, [lines_before](std::uint32_t line) {
    return static_cast<std::uint32_t>(std::min<std::uint64_t>(lines_before + line, no_index));
  });
}

bool FaceList::repeats_corner(std::size_t begin, std::size_t end, std::vector<std::uint32_t>& stamps) const {
  const std::uint32_t* const c = mesh_.corners.data();
  if (end - begin == 3) return c[begin] == c[begin + 1] || c[begin + 1] == c[begin + 2] || c[begin + 2] == c[begin];
  if (end - begin <= 8) {
    for (std::size_t i = begin + 1; i < end; ++i)
      if (std::find(c + begin, c + i, c[i]) != c + i) return true;
    return false;
  }
  stamps.resize(mesh_.positions.size(), no_index);
  const auto stamp = static_cast<std::uint32_t>(begin);  // unique per face
  for (std::size_t i = begin; i < end; ++i)
    if (std::exchange(stamps[c[i]], stamp) == stamp) return true;
  return false;
}

FaceList::Flaw FaceList::flaw(std::size_t face, std::vector<std::uint32_t>& stamps) const {
  const std::size_t begin = mesh_.face_offsets[face], end = mesh_.face_offsets[face + 1];
  const std::size_t vertex_count = mesh_.positions.size();
  if (end - begin < 3) return Flaw::too_few_corners;
  for (std::size_t i = begin; i < end; ++i)
    if (mesh_.corners[i] >= vertex_count) return Flaw::index_out_of_range;
  if (!repeats_corner(begin, end, stamps)) return Flaw::none;
  CornerLoops list;
  list.add(mesh_.face(face));
  return take_out_bridges(list) ? Flaw::bridged : Flaw::repeated_corner;
}

void FaceList::find_flaws(std::uint32_t begin, std::uint32_t end, std::vector<FlawedFace>& flawed) const {
  const std::uint32_t* const offsets = mesh_.face_offsets.data();
  const std::uint32_t* const corners = mesh_.corners.data();
  const std::size_t vertices = mesh_.positions.size();
  std::vector<std::uint32_t> stamps;
  for (std::uint32_t face = begin; face < end; ++face) {
    if (offsets[face + 1] - offsets[face] == 3) {
      const std::uint32_t a = corners[offsets[face]], b = corners[offsets[face] + 1], c = corners[offsets[face] + 2];
      if (a != b && b != c && c != a && std::max({a, b, c}) < vertices) continue;
    }
    if (const Flaw found = flaw(face, stamps); found != Flaw::none) flawed.push_back({face, found});
  }
}

QuarantinedFace FaceList::set_aside(std::size_t face, Flaw flaw) const {
  const std::size_t begin = mesh_.face_offsets[face], end = mesh_.face_offsets[face + 1];
  QuarantinedFace out;
  out.face = static_cast<std::uint32_t>(face);
  out.line = mesh_.face_lines.empty() ? 0 : mesh_.face_lines[face];
  out.code = flaw == Flaw::too_few_corners      ? Code("face_too_few_corners")
             : flaw == Flaw::index_out_of_range ? Code("index_out_of_range")
                                                : Code("repeated_corner");
  out.corners.assign(mesh_.corners.begin() + begin, mesh_.corners.begin() + end);
  auto wide = std::lower_bound(wide_.begin(), wide_.end(), std::pair<std::size_t, std::int64_t>(begin, INT64_MIN));
  for (; wide != wide_.end() && wide->first < end; ++wide) out.corners[wide->first - begin] = wide->second;
  const auto copy_values = [&](const std::vector<std::uint32_t>& from, CompactList<std::uint32_t>& to) {
    if (from.empty()) return;
    const auto first = from.begin() + begin, last = from.begin() + end;
    if (std::any_of(first, last, [](std::uint32_t value) { return value != no_index; })) to.assign(first, last);
  };
  copy_values(mesh_.texcoords.index, out.texcoords);
  copy_values(mesh_.normals.index, out.normals);
  return out;
}

void FaceList::close_gaps(const std::vector<QuarantinedFace>& removed) {
  remove_ranges(mesh_.texcoords.index, mesh_.face_offsets, removed);
  remove_ranges(mesh_.normals.index, mesh_.face_offsets, removed);
  remove_ranges(mesh_.corners, mesh_.face_offsets, removed);
  std::uint32_t shift = 0;
  auto next = removed.begin();
  std::uint32_t begin = 0;  // start of the face in the old numbering
  for (std::size_t face = 0; face + 1 < mesh_.face_offsets.size(); ++face) {
    const std::uint32_t end = mesh_.face_offsets[face + 1];
    if (next != removed.end() && next->face == face) {
      shift += end - begin;
      ++next;
    }
    mesh_.face_offsets[face + 1] = end - shift;
    begin = end;
  }
}

void FaceList::finish(Reporter& reporter) {
  const auto faces = static_cast<std::uint32_t>(mesh_.face_count());
  std::vector<std::vector<FlawedFace>> parts(threads_for(mesh_.corners.size()));
  for_each_part(faces, static_cast<unsigned>(parts.size()),
                [&](unsigned t, std::uint32_t begin, std::uint32_t end) { find_flaws(begin, end, parts[t]); });
  std::size_t count = 0;
  for (const std::vector<FlawedFace>& part : parts) {
    for (const FlawedFace& flawed : part) {
      if (flawed.flaw == Flaw::bridged)
        mesh_.bridged.push_back(flawed.face);
      else
        ++count;
    }
  }
  if (count == 0) return;
  mesh_.quarantine.reserve(count);
  for (std::vector<FlawedFace>& part : parts) {
    for (const auto& [face, flaw] : part) {
      if (flaw == Flaw::bridged) continue;
      const QuarantinedFace& aside = mesh_.quarantine.emplace_back(set_aside(face, flaw));
      const FilePlace place = aside.line != 0 ? FilePlace::at_line(aside.line) : FilePlace::at_face(face);
      reporter.warn(aside.code, place, [&] { return aside.cause(); });
    }
    release(part);
  }
  close_gaps(mesh_.quarantine);
  release(wide_);
}

}  // namespace ryosen
