#include "ryosen/io/ply_header.h"

#include <algorithm>
#include <optional>
#include <unordered_set>
#include <utility>
#include <vector>

#include "ryosen/io/numbers.h"
#include "ryosen/io/text_lines.h"
#include "ryosen/io/text_out.h"

namespace ryosen {
namespace {

bool has_role(const PropertyTable& table, PropertyRole role) {
  return std::any_of(table.properties.begin(), table.properties.end(),
                     [&](const Property& property) { return property.role == role; });
}

// A set of properties that the mesh has a place for. All of the first `needed` must be there.
struct RoleRow {
  TableKind kind;
  PropertyRole role;
  std::size_t needed;
  std::vector<std::string_view> names;
};

const std::vector<RoleRow>& scalar_roles() {
  using enum PropertyRole;
  static const std::vector<RoleRow> rows = {
      {TableKind::vertices, position, 2, {"x", "y", "z"}},
      {TableKind::vertices, normal, 3, {"nx", "ny", "nz"}},
      {TableKind::vertices, texcoord, 2, {"s", "t"}},
      {TableKind::vertices, texcoord, 2, {"u", "v"}},
      {TableKind::vertices, texcoord, 2, {"texture_u", "texture_v"}},
      {TableKind::vertices, vertex_colour, 3, {"red", "green", "blue", "alpha"}},
      {TableKind::vertices, vertex_colour, 3, {"diffuse_red", "diffuse_green", "diffuse_blue", "diffuse_alpha"}},
      {TableKind::vertices, vertex_colour, 3, {"r", "g", "b", "a"}},
      {TableKind::faces, face_colour, 3, {"red", "green", "blue", "alpha"}},
      {TableKind::other, vertex_number, 2, {"vertex1", "vertex2"}},
  };
  return rows;
}

struct ListRoleRow {
  TableKind kind;
  PropertyRole role;
  std::string_view name;
};

constexpr ListRoleRow list_roles[] = {
    {TableKind::faces, PropertyRole::corners, "vertex_indices"},
    {TableKind::faces, PropertyRole::corners, "vertex_index"},
    {TableKind::faces, PropertyRole::corner_texcoord, "texcoord"},
    {TableKind::other, PropertyRole::vertex_number, "vertex_indices"},
    {TableKind::other, PropertyRole::vertex_number, "vertex_index"},
};

Property* find_property(PropertyTable& table, std::string_view name, bool is_list) {
  for (Property& property : table.properties)
    if (property.name == name && property.is_list == is_list) return &property;
  return nullptr;
}

void give_scalar_role(PropertyTable& table, const RoleRow& row) {
  if (has_role(table, row.role)) return;
  std::vector<Property*> found;
  for (const std::string_view name : row.names) {
    Property* const property = find_property(table, name, false);
    if (!property) break;
    if (row.role == PropertyRole::vertex_number && is_floating(property->type)) break;
    found.push_back(property);
  }
  if (found.size() < row.needed) return;
  for (std::size_t i = 0; i < found.size(); ++i) {
    found[i]->role = row.role;
    found[i]->component = static_cast<std::uint8_t>(i);
  }
}

// Gives the properties of a table their roles by their names and types.
void give_roles(PropertyTable& table) {
  for (const RoleRow& row : scalar_roles())
    if (row.kind == table.kind) give_scalar_role(table, row);
  for (const ListRoleRow& row : list_roles) {
    if (row.kind != table.kind || has_role(table, row.role)) continue;
    Property* const property = find_property(table, row.name, true);
    if (property && is_floating(property->type) == (row.role == PropertyRole::corner_texcoord))
      property->role = row.role;
  }
}

class HeaderReader {
 public:
  explicit HeaderReader(std::string_view bytes) : lines_(bytes, false) {}

  Result<PlyHeader> read() {
    TextLine line;
    if (!lines_.next(line) || trimmed(line.text) != "ply") {
      return malformed("not_ply", {"The first line is not the word ply.", "最初の行が ply という語ではありません。"},
                       FilePlace::at_line(1));
    }
    while (!failure_ && !is_done_) {
      if (!lines_.next(line)) {
        fail("unexpected_end", {"The header has no end_header.", "ヘッダーに end_header がありません。"},
             FilePlace::at_line(lines_.count() + 1));
      } else {
        take(line.text);
      }
    }
    if (!failure_) finish();
    if (failure_) return header_.explained(std::move(*failure_));
    return std::move(header_);
  }

 private:
  void fail(Code code, Text text, FilePlace place) { failure_ = malformed(code, std::move(text), place); }
  // On the line that is read.
  void fail(Code code, Text text) { fail(code, std::move(text), FilePlace::at_line(lines_.count())); }

  void take(std::string_view text) {
    std::string_view rest = text;
    const std::string_view word = take_word(rest);
    if (word == "comment")
      comment(on_one_line(after_blank(rest)));
    else if (word == "obj_info")
      header_.tables.obj_info.push_back(on_one_line(after_blank(rest)));
    else if (word == "format")
      format(rest);
    else if (word == "element")
      element(rest);
    else if (word == "property")
      property(rest);
    else if (word == "end_header")
      is_done_ = true;
    else if (!word.empty())
      unknown(word, text);
  }

  void comment(std::string text) {
    std::string_view rest = text;
    std::vector<std::string_view> words;
    if (take_word(rest) == "attribute")
      for (std::string_view word = take_word(rest); !word.empty(); word = take_word(rest)) words.push_back(word);
    if (words.empty() || !element_of_attribute(words[0]) || header_.attributes.size() == most_attributes_of_a_file)
      return header_.comments.push_back(std::move(text));
    ReadAttribute read = read_attribute(words);
    if (read.fault) {
      header_.reporter.warn("unknown_type", FilePlace::at_line(lines_.count()), [&] {
        return Text{"The comment on an attribute is not understood: ", "属性についてのコメントを解釈できません: "} +
               sentence_of(*read.fault);
      });
      return header_.comments.push_back(std::move(text));
    }
    header_.attributes.push_back({std::move(read.column), std::move(text)});
  }

  // If the end_header line is missing, data lines get here too; they do not begin with a letter.
  static bool is_text(std::string_view word, std::string_view line) {
    const char first = word[0] | 0x20;
    const auto is_control = [](char c) { return (c >= 0 && c < ' ' && c != '\t') || c == 0x7f; };
    return (first >= 'a' && first <= 'z') && std::none_of(line.begin(), line.end(), is_control);
  }

  void unknown(std::string_view word, std::string_view line) {
    if (!is_text(word, line)) {
      return fail(
          "unknown_keyword",
          {shown(word) + " is no word of a PLY header.", shown(word) + " は PLY のヘッダーの語ではありません。"},
          lines_.place(word.data()));
    }
    if (header_.unknown_word.empty()) {
      header_.unknown_word = shown(word);
      header_.unknown_line = lines_.count();
    }
    header_.reporter.warn("unknown_keyword", lines_.place(word.data()), [&] {
      return Text{shown(word) + " is no word of a PLY header; the line is kept as it is.",
                  shown(word) + " は PLY のヘッダーの語ではありません。この行はそのまま保持します。"};
    });
    PropertyTables& tables = header_.tables;
    const auto before = static_cast<std::uint32_t>(tables.tables.size());
    const auto properties = static_cast<std::uint32_t>(before == 0 ? 0 : tables.tables.back().properties.size());
    std::vector<UnknownLines>& lines = tables.unknown_lines;
    if (lines.empty() || lines.back().tables != before || lines.back().properties != properties)
      lines.push_back({{}, before, properties});
    lines.back().text.append(line).append("\n");
  }

  static std::string_view after_blank(std::string_view text) {
    if (!text.empty()) text.remove_prefix(1);
    return text;
  }

  void format(std::string_view rest) {
    const std::string_view word = take_word(rest), version = take_word(rest);
    if (word == "ascii")
      header_.encoding = Encoding::ascii;
    else if (word == "binary_little_endian")
      header_.encoding = Encoding::binary_little;
    else if (word == "binary_big_endian")
      header_.encoding = Encoding::binary_big;
    else
      return fail("unknown_encoding",
                  {shown(word) + " is not ascii, binary_little_endian or binary_big_endian.",
                   shown(word) + " は ascii、binary_little_endian、binary_big_endian のどれでもありません。"});
    if (version != "1.0") {
      return fail("unsupported_version", {"Only PLY 1.0 is supported, not " + shown(version) + ".",
                                          "PLY 1.0 だけに対応しています(" + shown(version) + " には未対応)。"});
    }
    has_format_ = true;
  }

  void element(std::string_view rest) {
    PropertyTable table;
    const std::string_view name = take_word(rest), word = take_word(rest);
    table.name = name;
    std::int64_t count = 0;
    if (table.name.empty() || word.empty() || !read_integer(word, count))
      return fail("unreadable_number", {shown(word) + " is not a count.", shown(word) + " は個数として読めません。"});
    if (count < 0) {
      return fail("negative_count",
                  {"The count " + shown(word) + " is negative.", "個数 " + shown(word) + " が負です。"});
    }
    if (!element_names_.insert(table.name).second) {
      return fail("repeated_element", {"The element " + shown(name) + " is announced twice.",
                                       "要素 " + shown(name) + " が 2 回宣言されています。"});
    }
    table.kind = table.name == "vertex" ? TableKind::vertices
                 : table.name == "face" ? TableKind::faces
                                        : TableKind::other;
    table.rows = static_cast<std::size_t>(count);
    header_.tables.tables.push_back(std::move(table));
    header_.counts.emplace_back(word);
    header_.element_lines.push_back(lines_.count());
  }

  bool type(std::string_view word, Scalar& type) {
    if (const auto found = find_scalar(word); found && *found != Scalar::boolean) return type = *found, true;
    fail("unknown_type", {shown(word) + " is not a type of PLY, such as float or int.",
                          shown(word) + " は PLY の型(float や int など)ではありません。"});
    return false;
  }

  void property(std::string_view rest) {
    if (header_.tables.tables.empty()) {
      return fail("property_without_element",
                  {"A property stands before the first element.", "最初の要素より前にプロパティがあります。"});
    }
    Property property;
    std::string_view word = take_word(rest);
    property.is_list = word == "list";
    if (property.is_list) {
      if (!type(take_word(rest), property.count_type)) return;
      if (is_floating(property.count_type)) {
        return fail("unknown_type",
                    {"The length of a list must be a whole number.", "リストの長さは整数型でなければなりません。"});
      }
      word = take_word(rest);
    }
    if (!type(word, property.type)) return;
    property.name = take_word(rest);
    if (property.name.empty())
      return fail("missing_name", {"The property has no name.", "プロパティに名前がありません。"});
    header_.tables.tables.back().properties.push_back(std::move(property));
  }

  void finish() {
    if (!has_format_)
      return fail("missing_format", {"The header has no line format.", "ヘッダーに format の行がありません。"});
    for (PropertyTable& table : header_.tables.tables) give_roles(table);
    for (std::size_t i = 0; i < header_.tables.tables.size(); ++i) {
      const PropertyTable& table = header_.tables.tables[i];
      const FilePlace place = FilePlace::at_line(header_.element_lines[i]);
      if (table.kind == TableKind::vertices && !has_all_coordinates(table, place)) return;
      if (table.kind == TableKind::faces && table.rows != 0 && !has_role(table, PropertyRole::corners)) {
        return fail("missing_property",
                    {"The faces have no list vertex_indices of whole numbers.",
                     "面に整数のリスト vertex_indices がありません。"},
                    place);
      }
    }
    if (!header_.find(TableKind::vertices))
      return fail("missing_element", {"The file has no element vertex.", "要素 vertex がありません。"});
    header_.lines = lines_.count();
    header_.bytes = lines_.next_byte();
    header_.tables.has_decimal_reals = header_.encoding == Encoding::ascii;
  }

  // Points of a plane may be meant by x and y alone.
  bool has_all_coordinates(const PropertyTable& table, FilePlace place) {
    if (has_position(table, 2)) return true;
    fail("missing_property", {"The vertices have no x, y and z.", "頂点に x、y、z がありません。"}, place);
    if (has_position(table, 1)) header_.missing_z = std::exchange(failure_, std::nullopt);
    return !failure_;
  }
  static bool has_position(const PropertyTable& table, int component) {
    return std::any_of(table.properties.begin(), table.properties.end(), [&](const Property& property) {
      return property.role == PropertyRole::position && property.component == component;
    });
  }

  TextLines lines_;
  PlyHeader header_;
  std::optional<Failure> failure_;
  std::unordered_set<std::string> element_names_;
  bool is_done_ = false;
  bool has_format_ = false;
};

// Behind the first line end at or after `at`; the end if there is none.
std::size_t behind_line(std::string_view bytes, std::size_t at, PlyLineEnd ends) {
  const std::size_t end = bytes.find_first_of(ends == PlyLineEnd::cr ? "\r" : "\r\n", at);
  if (end == std::string_view::npos) return bytes.size();
  const bool has_two = ends == PlyLineEnd::lf_cr ? bytes.substr(end, 2) == "\n\r"
                       : ends == PlyLineEnd::lf  ? bytes.substr(end, 2) == "\r\n"
                                                 : false;
  return end + (has_two ? 2 : 1);
}

// The bytes up to the end of the line end_header (all bytes if there is none), so that binary data are not scanned for
// line ends.
std::string_view header_bytes(std::string_view bytes, PlyLineEnd ends) {
  constexpr std::string_view last = "end_header";
  for (std::size_t at = bytes.find(last); at != std::string_view::npos; at = bytes.find(last, at + 1)) {
    if (at == 0 || (bytes[at - 1] != '\n' && bytes[at - 1] != '\r')) continue;
    const std::string_view behind = bytes.substr(at + last.size(), 1);
    if (!behind.empty() && behind.find_first_of(" \t\r\n") != 0) continue;  // a longer word
    return bytes.substr(0, behind_line(bytes, at, ends));
  }
  return bytes;
}

}  // namespace

std::string attribute_of_property(TableKind kind, std::string_view property) {
  const ElementKind element = kind == TableKind::vertices ? ElementKind::vertex
                              : kind == TableKind::faces  ? ElementKind::face
                                                          : ElementKind::edge;
  const auto named = element_of_attribute(property);
  if (named && (*named == element || (*named == ElementKind::corner && kind == TableKind::faces)))
    return std::string(property);
  return std::string(name_of(element)).append(".").append(property);
}

bool has_meaning_in_ply(TableKind kind, std::string_view property) {
  const TableKind roles = kind == TableKind::edges ? TableKind::other : kind;
  for (const RoleRow& row : scalar_roles())
    if (row.kind == roles && std::find(row.names.begin(), row.names.end(), property) != row.names.end()) return true;
  return std::any_of(std::begin(list_roles), std::end(list_roles),
                     [&](const ListRoleRow& row) { return row.kind == roles && row.name == property; });
}

const PropertyTable* PlyHeader::find(TableKind kind) const {
  for (const PropertyTable& table : tables.tables)
    if (table.kind == kind) return &table;
  return nullptr;
}

Failure PlyHeader::explained(Failure failure) const {
  if (unknown_word.empty()) return failure;
  const std::string line = std::to_string(unknown_line);
  failure.message.text.en += " Line " + line + " begins with " + unknown_word + ", which PLY does not know.";
  failure.message.text.ja += line + " 行目の " + unknown_word + " は PLY にない語です。";
  return failure;
}

PlyLineEnd ply_line_end(std::string_view bytes) {
  const std::size_t end = bytes.find_first_of("\r\n");
  if (end == std::string_view::npos) return PlyLineEnd::lf;
  const bool has_two =
      end + 1 < bytes.size() && bytes[end + 1] != bytes[end] && (bytes[end + 1] == '\r' || bytes[end + 1] == '\n');
  if (bytes[end] == '\r') return has_two ? PlyLineEnd::lf : PlyLineEnd::cr;
  const bool is_blank_line = bytes.substr(end + 1).starts_with("\r\n");
  return has_two && !is_blank_line ? PlyLineEnd::lf_cr : PlyLineEnd::lf;
}

std::string with_single_line_ends(std::string_view bytes) {
  std::string out;
  out.reserve(bytes.size());
  for (std::size_t i = 0; i < bytes.size(); ++i) {
    out += bytes[i];
    if (bytes[i] == '\n' && i + 1 < bytes.size() && bytes[i + 1] == '\r') ++i;
  }
  return out;
}

Result<PlyHeader> read_ply_header(std::string_view bytes) {
  const PlyLineEnd ends = ply_line_end(bytes);
  const std::string_view head = header_bytes(bytes, ends);
  if (ends != PlyLineEnd::lf_cr) return HeaderReader(head).read();
  Result<PlyHeader> header = HeaderReader(with_single_line_ends(head)).read();
  if (header) header->bytes = head.size();
  return header;
}

}  // namespace ryosen
