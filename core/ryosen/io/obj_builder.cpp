#include "ryosen/io/obj_builder.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "ryosen/io/numbers.h"
#include "ryosen/io/obj.h"

namespace ryosen {
namespace {

// Converts an OBJ index (from 1, or relative to the end) to a number from 0. Index 0, which is invalid, and indices
// before the first one become negative, but not below obj_least_vertex. The largest number means overflow and is kept.
std::int64_t resolve(std::int64_t index, std::size_t count) {
  if (index == std::numeric_limits<std::int64_t>::max()) return index;
  if (index > 0) return index - 1;
  return index == 0 ? -1 : std::max(static_cast<std::int64_t>(count) + index, obj_least_vertex);
}

// Reads the next index of a corner: none at the end or before a slash. False if it is not an integer.
bool read_index(const char*& at, const char* end, std::int64_t& value, bool& has) {
  has = at != end && *at != '/';
  if (!has) return true;
  const auto [stop, error] = std::from_chars(at, end, value);
  if (error == std::errc() && (stop == end || *stop == '/')) {
    at = stop;
    return true;
  }
  const char* const slash = std::find(at, end, '/');
  const bool readable = read_integer({at, static_cast<std::size_t>(slash - at)}, value);
  at = slash;
  return readable;
}

// Whether it has the keyword of an element and a number behind it.
bool is_line_of_obj(std::string_view text) {
  return announces_numbers(take_word(text)) && take_word(text).find_first_of("0123456789") != std::string_view::npos;
}

}  // namespace

ObjBuilder::ObjBuilder(const TextLines& lines, const std::filesystem::path& model, bool is_later_piece)
    : lines_(&lines), model_(model), mesh_(file_.mesh), faces_(mesh_), is_later_piece_(is_later_piece) {
  FaceNames* const targets[] = {&mesh_.objects, &mesh_.groups, &mesh_.materials, &mesh_.smoothing};
  for (std::size_t i = 0; i < 4; ++i) names_[i].target = targets[i];
  mesh_.texcoords.components = 0;
}

// Records an unreadable value. The file is read again from the start of a piece that has one, so later values count.
template <class MakeText>
bool ObjBuilder::fail(Code code, const char* at, MakeText text) {
  has_given_up_ = is_later_piece_;
  return has_given_up_ ? false : faults_.add(code, lines_->place(at), text);
}

// Whether a line of this length cannot overflow the 32-bit numbering; fails otherwise.
bool ObjBuilder::has_room(std::size_t bytes) {
  const std::size_t most = std::max({mesh_.positions.size(), mesh_.face_count(), file_.elements.vertices.size(),
                                     mesh_.texcoords.pool.size(), mesh_.normals.pool.size()});
  if (!faces_.is_full(bytes) && most + bytes < no_index) return true;
  return faults_.stop(malformed("too_many_elements",
                                {"The file has more vertices, faces or corners than fit in 32-bit numbers.",
                                 "頂点・面・面の頂点の総数が 32 ビットの番号に収まりません。"},
                                FilePlace::at_line(lines_->count())));
}

void ObjBuilder::comment(std::string_view line) {
  if (in_head_) file_.head_comments.emplace_back(line);
}

bool ObjBuilder::read_value(std::string_view word, double& value) {
  const NumberRead read = read_real(word, value);
  if (read == NumberRead::unreadable) return fail("unreadable_number", word.data(), [&] { return not_a_number(word); });
  if (read == NumberRead::non_finite)
    reporter_.warn("nonfinite_number", lines_->place(word.data()), [&] { return not_a_finite_number(word); });
  return true;
}

// Reads at least `wanted` numbers and keeps the first `most`; `count` is how many the line has. False where this line
// or one before has a fault.
bool ObjBuilder::read_reals(std::string_view text, double* values, std::size_t wanted, std::size_t most,
                            std::size_t& count) {
  in_head_ = false;
  has_known_line_ = true;
  count = 0;
  double ignored = 0;
  while (true) {
    double& value = count < most ? values[count] : ignored;
    std::string_view rest = text;
    if (take_number(rest, value) && std::isfinite(value)) {
      text = rest;
      ++count;
      continue;
    }
    const std::string_view word = take_word(text);
    if (word.empty() || word[0] == '#') {
      if (count >= wanted) return !faults_.any();
      return fail("missing_number", word.data(), [&] {
        const std::string number = std::to_string(wanted), there = std::to_string(count);
        return Text{"The line has " + there + " numbers where " + number + " are needed.",
                    "数が " + number + " 個必要な行に " + there + " 個しかありません。"};
      });
    }
    if (!read_value(word, value)) return false;
    ++count;
  }
}

void ObjBuilder::warn_extra_values(std::size_t count) {
  reporter_.leave_out(&LeftOut::values);
  reporter_.warn("extra_values", FilePlace::at_line(lines_->first_line()), [&] {
    const std::string number = std::to_string(count);
    return Text{"A line with " + number + " numbers has no meaning here; those at the end are left out.",
                number + " 個の数が並ぶ行は意味を持たないため、末尾の数を無視しました。"};
  });
}

void ObjBuilder::vertex(std::string_view values) {
  double v[7];
  std::size_t count = 0;
  if (!has_room(1) || !read_reals(values, v, 3, 7, count)) return;
  const std::size_t number = mesh_.positions.size();
  mesh_.positions.emplace_back(v[0], v[1], v[2]);
  mesh_.vertex_lines.add(lines_->first_line());
  const bool has_weight = count == 4 && !std::isnan(v[3]);
  if (has_weight && mesh_.vertex_weights.empty()) mesh_.vertex_weights.assign(number, no_colour);
  if (has_weight || !mesh_.vertex_weights.empty()) mesh_.vertex_weights.push_back(has_weight ? v[3] : no_colour);
  const bool has_colour = (count == 6 || count == 7) && !std::isnan(v[3]);
  if (has_colour && mesh_.vertex_colours.empty())
    mesh_.vertex_colours.assign(number, glm::dvec4(no_colour, no_colour, no_colour, 1));
  if (has_colour) {
    mesh_.vertex_colours.emplace_back(v[3], v[4], v[5], count == 7 ? v[6] : 1.0);
    if (count == 7) mesh_.colour_components = 4;
    some_lack_alpha_ = some_lack_alpha_ || count == 6;
  } else if (!mesh_.vertex_colours.empty()) {
    mesh_.vertex_colours.emplace_back(no_colour, no_colour, no_colour, 1);
  }
  if (count == 5 || count > 7) warn_extra_values(count);
}

void ObjBuilder::texcoord(std::string_view values) {
  double v[3] = {0, 0, 0};
  std::size_t count = 0;
  if (!has_room(1) || !read_reals(values, v, 1, 3, count)) return;
  mesh_.texcoords.pool.emplace_back(v[0], v[1], v[2]);
  mesh_.texcoords.components = std::max(mesh_.texcoords.components, static_cast<int>(std::min<std::size_t>(count, 3)));
  if (count > 3) warn_extra_values(count);
}

void ObjBuilder::normal(std::string_view values) {
  double v[3];
  std::size_t count = 0;
  if (!has_room(1) || !read_reals(values, v, 3, 3, count)) return;
  mesh_.normals.pool.emplace_back(v[0], v[1], v[2]);
  if (count > 3) warn_extra_values(count);
}

// Reads a, a/b, a//c or a/b/c. False where it is none of these.
bool ObjBuilder::read_corner(std::string_view word, Corner& corner) {
  const char* at = word.data();
  const char* const end = at + word.size();
  bool has_vertex = false;
  corner.has_texcoord = corner.has_normal = false;
  bool readable = read_index(at, end, corner.vertex, has_vertex) && has_vertex;
  if (readable && at != end) readable = read_index(++at, end, corner.texcoord, corner.has_texcoord);
  if (readable && at != end) readable = read_index(++at, end, corner.normal, corner.has_normal);
  if (readable && at == end) return true;
  return fail("unreadable_index", word.data(), [&] {
    return Text{
        shown(word) + " is not a corner: vertex, vertex/texture, vertex//normal or vertex/texture/normal is meant.",
        shown(word) + " は面の頂点として読めません(頂点、頂点/テクスチャ、頂点//法線、頂点/テクスチャ/法線)。"};
  });
}

void ObjBuilder::face(std::string_view corners) {
  in_head_ = false;
  has_known_line_ = true;
  if (!has_room(corners.size() + 1)) return;
  Corner corner;
  while (true) {
    corner.has_texcoord = corner.has_normal = false;
    if (!take_number(corners, corner.vertex)) {
      const std::string_view word = take_word(corners);
      if (word.empty() || word[0] == '#') break;
      if (!read_corner(word, corner)) return;
    }
    if (faults_.any()) continue;
    if (corner.vertex < 0 && is_later_piece_) has_given_up_ = true;
    if (corner.has_texcoord || !mesh_.texcoords.index.empty())
      push_value(mesh_.texcoords.index, corner.has_texcoord, corner.texcoord, mesh_.texcoords.pool.size(), false);
    if (corner.has_normal || !mesh_.normals.index.empty())
      push_value(mesh_.normals.index, corner.has_normal, corner.normal, mesh_.normals.pool.size(), true);
    faces_.add_corner(resolve(corner.vertex, mesh_.positions.size()));
  }
  if (faults_.any()) return;
  faces_.end_face(lines_->first_line());
  end_names();
}

void ObjBuilder::push_value(std::vector<std::uint32_t>& indices, bool has, std::int64_t index, std::size_t pool,
                            bool is_normal) {
  if (indices.empty()) indices.assign(mesh_.corners.size(), no_index);
  indices.push_back(has ? resolve_value(index, pool, is_normal) : no_index);
}

// The pool index for an index of a corner; no_index with a warning if it is invalid.
std::uint32_t ObjBuilder::resolve_value(std::int64_t index, std::size_t pool, bool is_normal) {
  if (index < 0 && is_later_piece_) has_given_up_ = true;
  const std::int64_t place = resolve(index, pool);
  if (place >= 0 && place < static_cast<std::int64_t>(no_index)) return static_cast<std::uint32_t>(place);
  reporter_.leave_out(&LeftOut::values);
  reporter_.warn(is_normal ? Code("normal_index_out_of_range") : Code("texture_index_out_of_range"),
                 FilePlace::at_line(lines_->first_line()), [&] { return stray_value_text(is_normal, index); });
  return no_index;
}

void ObjBuilder::end_names() {
  const std::size_t faces = mesh_.face_count();
  for (NameTable& table : names_) {
    std::vector<std::uint32_t>& index = table.target->index;
    if (table.current == no_index && index.empty()) continue;
    if (index.empty()) index.assign(faces - 1, no_index);
    index.push_back(table.current);
  }
}

void ObjBuilder::element(bool is_points, std::string_view corners) {
  has_given_up_ = is_later_piece_;
  if (is_done()) return;
  in_head_ = false;
  has_known_line_ = true;
  if (!has_room(corners.size() + 1)) return;
  ElementList& elements = file_.elements;
  LineElement item;
  item.is_points = is_points;
  item.before_face = static_cast<std::uint32_t>(mesh_.face_count());
  item.first = static_cast<std::uint32_t>(elements.vertices.size());
  item.line = static_cast<std::uint32_t>(std::min<std::uint64_t>(lines_->first_line(), no_index));
  Corner corner;
  while (true) {
    const std::string_view word = take_word(corners);
    if (word.empty() || word[0] == '#') break;
    if (!read_corner(word, corner)) return;
    if (faults_.any()) continue;
    if (corner.has_texcoord && elements.texcoords.empty())
      elements.texcoords.assign(elements.vertices.size(), no_index);
    if (corner.has_texcoord || !elements.texcoords.empty()) {
      elements.texcoords.push_back(
          corner.has_texcoord ? resolve_value(corner.texcoord, mesh_.texcoords.pool.size(), false) : no_index);
    }
    elements.vertices.push_back(resolve(corner.vertex, mesh_.positions.size()));
  }
  if (faults_.any()) return;
  item.count = static_cast<std::uint32_t>(elements.vertices.size()) - item.first;
  std::uint32_t* const names[] = {&item.object, &item.group, &item.material, &item.smoothing};
  for (std::size_t i = 0; i < 4; ++i) *names[i] = names_[i].current;
  elements.items.push_back(item);
}

void ObjBuilder::name(NameKind kind, std::string_view text) {
  if (faults_.any()) return;
  in_head_ = false;
  has_known_line_ = true;
  NameTable& table = names_[static_cast<std::size_t>(kind)];
  if (!std::exchange(table.is_set, true)) table.faces_before = mesh_.face_count();
  std::string key(trimmed(text));
  if (key.empty() && kind == NameKind::smoothing) key = "off";
  if (key.empty()) {
    table.current = no_index;
    return;
  }
  table.current = number_of(key, table);
  warn_of_taken_lines();
}

// A name that ends in a backslash, as paths do, takes the next line with it.
void ObjBuilder::warn_of_taken_lines() {
  lines_->for_each_continuation([&](std::string_view text, std::uint64_t line) {
    if (!is_line_of_obj(text)) return;
    reporter_.warn("unknown_keyword", FilePlace::at_line(lines_->first_line()), [&] {
      const std::string number = std::to_string(line), taken = shown(trimmed(text));
      return Text{"The name ends in a backslash, which joins lines: line " + number + ", " + taken +
                      ", is part of the name and is not read.",
                  "名前が行をつなぐバックスラッシュで終わるため、" + number + " 行目 " + taken +
                      " は名前の一部となり、読み込みません。"};
    });
  });
}

// The number of a name, assigning a new one if needed.
std::uint32_t ObjBuilder::number_of(const std::string& name, NameTable& table) {
  const auto number = static_cast<std::uint32_t>(table.target->names.size());
  const auto [found, is_new] = table.numbers.try_emplace(name, number);
  if (is_new) table.target->names.push_back(name);
  return found->second;
}

void ObjBuilder::unknown(std::string_view keyword) {
  has_given_up_ = is_later_piece_;
  if (is_done() || faults_.any()) return;
  constexpr std::size_t most = 16;
  in_head_ = false;
  const std::string text = shown(keyword);
  for (UnknownKeyword& known : unknown_) {
    if (known.text == text) {
      ++known.count;
      return;
    }
  }
  if (unknown_.size() < most)
    unknown_.push_back({text, lines_->first_line(), 1});
  else
    ++other_unknown_;
}

}  // namespace ryosen
