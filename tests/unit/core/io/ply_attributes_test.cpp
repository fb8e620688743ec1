#include "ryosen/io/ply_attributes.h"

#include <array>
#include <set>
#include <sstream>

#include "ryosen/document/document.h"
#include "ryosen/indexed/from_indexed.h"
#include "ryosen/io/edited_file.h"
#include "ryosen/mesh/attribute.h"
#include "ryosen/mesh/names.h"
#include "tests/support/core/random_meshes.h"
#include "tests/unit/core/io/io_helpers.h"

namespace ryosen {
namespace {

using io_test::difference;
using io_test::find_message;
using io_test::read_sound;

// A square and a triangle at an edge, a third face there, two that are set aside, and an isolated vertex.
constexpr std::string_view faces_ply =
    "ply\nformat ascii 1.0\nelement vertex 7\nproperty double x\nproperty double y\nproperty double z\n"
    "element face 5\nproperty list uchar int vertex_indices\nend_header\n"
    "0 0 0\n1 0 0\n1 1 0\n0 1 0\n2 0 0\n2 1 1\n9 9 9\n4 0 1 2 3\n3 1 4 2\n3 1 2 5\n3 0 0 1\n2 3 4\n";

std::vector<std::uint32_t> random_value(ValueType type, Dice& dice) {
  std::vector<std::uint32_t> words(type.words(), 0);
  with_scalar(type.scalar, [&](auto number) {
    for (std::uint32_t i = 0; i < type.count; ++i) {
      using Number = decltype(number);
      if constexpr (std::is_same_v<Number, bool>)
        number = dice.below(2) == 1;
      else if constexpr (std::is_floating_point_v<Number>)
        number = dice.below(5) == 0 ? Number(-0.0) : static_cast<Number>((2 * dice.unit() - 1)) / Number(3);
      else
        number = dice.below(4) == 0
                     ? std::numeric_limits<Number>::lowest()
                     : static_cast<Number>(std::numeric_limits<Number>::max() - static_cast<Number>(dice.below(3)));
      std::memcpy(reinterpret_cast<std::byte*>(words.data()) + i * sizeof number, &number, sizeof number);
    }
  });
  return words;
}

// One attribute of every type, rule and kind of elements, alone and three in a row, with random values and defaults.
MeshFile with_all_types(Dice& dice) {
  MeshFile file = read_sound("ply", faces_ply);
  file.mesh.edges = {{1, 2, no_index}, {0, 1, no_index}, {2, 5, no_index}};
  std::size_t aside_words = 0;
  for (const ElementKind element : {ElementKind::vertex, ElementKind::edge, ElementKind::corner, ElementKind::face})
    for (std::size_t scalar = 0; scalar < enum_count<Scalar>; ++scalar)
      for (const std::uint32_t count : {1u, 3u}) {
        AttributeColumn column;
        column.type = {static_cast<Scalar>(scalar), count};
        column.name = std::string(name_of(element)) + "." + name_of(column.type);
        column.element = element;
        column.rule = static_cast<ValueRule>(dice.below(4));
        column.fill = random_value(column.type, dice);
        const std::size_t rows[] = {file.mesh.positions.size(), file.mesh.edges.size(), file.mesh.corners.size(),
                                    file.mesh.face_count()};
        for (std::size_t row = 0; row < rows[static_cast<std::size_t>(element)]; ++row) {
          const std::vector<std::uint32_t> value = random_value(column.type, dice);
          column.data.insert(column.data.end(), value.begin(), value.end());
        }
        if (element == ElementKind::corner) aside_words += column.words();
        file.mesh.attributes.push_back(std::move(column));
      }
  for (QuarantinedFace& face : file.mesh.quarantine) {
    std::vector<std::uint32_t> values;
    for (const AttributeColumn& column : file.mesh.attributes)
      for (std::size_t i = 0; column.element == ElementKind::corner && i < face.corners.size(); ++i) {
        const std::vector<std::uint32_t> value = random_value(column.type, dice);
        values.insert(values.end(), value.begin(), value.end());
      }
    EXPECT_EQ(values.size(), aside_words * face.corners.size());
    face.values = values;
  }
  return file;
}

// As reading gives it: edges by rows, attributes by elements in the order of the tables.
MeshFile as_read(MeshFile file) {
  for (std::uint32_t row = 0; row < file.mesh.edges.size(); ++row) file.mesh.edges[row].row = row;
  const auto table_of = [](const AttributeColumn& column) {
    return column.element == ElementKind::vertex ? 0 : column.element == ElementKind::edge ? 2 : 1;
  };
  std::stable_sort(file.mesh.attributes.begin(), file.mesh.attributes.end(),
                   [&](const AttributeColumn& a, const AttributeColumn& b) { return table_of(a) < table_of(b); });
  return file;
}

TEST(ply_attributes, every_type_comes_back_from_every_encoding) {
  for (const std::uint64_t seed : {1, 2, 3, 4, 5}) {
    Dice dice(seed);
    const MeshFile file = with_all_types(dice);
    for (const Encoding encoding : {Encoding::ascii, Encoding::binary_little, Encoding::binary_big}) {
      const std::string bytes = bytes_of(file, *find_format("ply"), encoding);
      const MeshFile again = read_sound("ply", bytes);
      EXPECT_TRUE(again.mesh.attributes == as_read(file).mesh.attributes) << seed;
      EXPECT_TRUE(test::same_quarantine(again.mesh.quarantine, file.mesh.quarantine));
      EXPECT_TRUE(test::same_edges(again.mesh.edges, as_read(file).mesh.edges));
      EXPECT_TRUE(bytes_of(again, *find_format("ply"), encoding) == bytes) << seed;
      EXPECT_EQ(io_test::loss_codes(again, "ply"), "");
    }
  }
}

TEST(ply_attributes, every_type_comes_through_the_mesh) {
  Dice dice(7);
  const MeshFile file = read_sound("ply", bytes_of(with_all_types(dice), *find_format("ply"), Encoding::ascii));
  Document document(file);
  const MeshFile contents = document.contents();
  EXPECT_EQ(difference(contents, file), "");
  EXPECT_TRUE(bytes_of(contents, *find_format("ply")) == bytes_of(file, *find_format("ply")));
}

constexpr std::string_view edges_ply =
    "ply\nformat ascii 1.0\nelement vertex 7\nproperty float x\nproperty float y\nproperty float z\n"
    "element face 2\nproperty list uchar int vertex_indices\n"
    "element edge 7\nproperty uchar vertex1\nproperty uchar vertex2\nproperty float crease\nend_header\n"
    "0 0 0\n1 0 0\n1 1 0\n0 1 0\n2 0 0\n2 1 1\n9 9 9\n4 0 1 2 3\n3 1 4 2\n"
    "2 1 0.5\n5 6 7\n0 1 0\n1 2 8\n0 2 3\n3 2 0.25\n0 77 1\n";

TEST(ply_attributes, rows_of_edges_become_edges_of_the_mesh_where_it_has_them) {
  const MeshFile file = read_sound("ply", edges_ply);
  ASSERT_EQ(file.mesh.edges.size(), 3u) << "2-1, 0-1 and 3-2";
  EXPECT_EQ(file.properties.tables[2].rows, 4u) << "a line, the second row of an edge, a diagonal, and no vertex";
  EXPECT_EQ(totals_of(file).lines, 4u);
  EXPECT_EQ(bytes_of(file, *find_format("ply")), edges_ply);
  const Mesh mesh = from_indexed(file.mesh);
  const AttributeColumn* const crease = find_column(mesh, "edge.crease");
  ASSERT_TRUE(crease);
  std::multiset<float> values;
  for (const float value : attribute_values<float>(*crease)) values.insert(value);
  EXPECT_EQ(values, (std::multiset<float>{0, 0, 0, 0, 0.25f, 0.5f})) << "six edges";
}

std::string saved_after(std::string_view text, std::initializer_list<const char*> lines) {
  Document document(read_sound("ply", text));
  for (const char* line : lines) {
    const ParsedOp parsed = parse_line(document.mesh(), line);
    EXPECT_TRUE(parsed.op && document.apply(*parsed.op).done()) << line;
  }
  return bytes_of(document.contents(), *find_format("ply"));
}

std::string rows_of_edges(const std::string& text, std::size_t count) {
  std::size_t at = text.size();
  for (std::size_t i = 0; i <= count; ++i) at = text.rfind('\n', at - 1);
  return text.substr(at + 1);
}

TEST(ply_attributes, edges_follow_edits) {
  EXPECT_EQ(saved_after(edges_ply, {}), edges_ply);
  const std::string split = saved_after(edges_ply, {"split 1-2"});
  EXPECT_NE(split.find("element edge 8\n"), std::string::npos) << split;
  EXPECT_EQ(rows_of_edges(split, 8), "7 1 0.5\n7 2 0.5\n5 6 7\n0 1 0\n1 2 8\n0 2 3\n3 2 0.25\n0 78 1\n")
      << "both parts keep the crease";
  const std::string gone = saved_after(edges_ply, {"delete f0", "delete f1"});
  EXPECT_NE(gone.find("element edge 4\n"), std::string::npos) << "rows of edges go with them" << gone;
}

TEST(ply_attributes, new_edges_are_numbered_by_a_type_that_holds_their_ends) {
  std::string text =
      "ply\nformat ascii 1.0\nelement vertex 256\nproperty float x\nproperty float y\nproperty float z\n"
      "element face 1\nproperty list uchar int vertex_indices\nelement edge 1\nproperty uchar vertex1\n"
      "property uchar vertex2\nend_header\n0 0 0\n1 0 0\n0 1 0\n";
  for (int i = 3; i < 256; ++i) text += "5 5 5\n";
  text += "3 0 1 2\n0 1\n";
  const std::string split = saved_after(text, {"split 0-1"});
  EXPECT_NE(split.find("property int vertex1"), std::string::npos);
  EXPECT_EQ(rows_of_edges(split, 2), "0 256\n1 256\n") << split.substr(split.size() - 40);
}

TEST(ply_attributes, a_name_that_has_a_meaning_is_written_with_its_element) {
  Document document(read_sound("ply", faces_ply));
  Mesh mesh = document.mesh();
  {
    Edit edit(mesh, nullptr);
    edit.add_attribute("vertex.x", ElementKind::vertex, ValueRule::first, std::uint8_t{7});
    edit.add_attribute("face.red", ElementKind::face, ValueRule::sum, 1.5f);
    edit.add_attribute("edge.vertex1", ElementKind::edge, ValueRule::first, std::int16_t{-1});
    edit.commit();
  }
  const MeshFile file = edited_file(document.file(), mesh, document.tables());
  const std::string text = bytes_of(file, *find_format("ply"));
  EXPECT_NE(text.find("property uchar vertex.x\n"), std::string::npos) << text;
  EXPECT_NE(text.find("comment attribute face.red float sum 1.5\n"), std::string::npos) << text;
  EXPECT_EQ(difference(read_sound("ply", text), as_read(read_sound("ply", text))), "");
  EXPECT_EQ(read_sound("ply", text).mesh.attributes.size(), 3u);
}

TEST(ply_attributes, names_that_ryosen_uses_stay_properties) {
  std::string text(faces_ply);
  text.replace(text.find("end_header"), 0, "property int material\nproperty int group\n");
  for (const char* row : {"0 1 2 3\n", "1 4 2\n", "1 2 5\n", "0 0 1\n", "2 3 4\n"})
    text.insert(text.rfind(row) + std::string_view(row).size() - 1, " 5 6");
  const MeshFile file = read_sound("ply", text);
  EXPECT_TRUE(file.mesh.attributes.empty());
  EXPECT_EQ(bytes_of(file, *find_format("ply")), text);
}

TEST(ply_attributes, a_comment_that_describes_no_attribute_is_told_and_kept) {
  struct Case {
    const char *comment, *warning;
  };
  for (const Case& c :
       {Case{"attribute vertex.load flout", "\"flout\" is not a type; write float"},
        Case{"attribute vertex.load float mean", "\"mean\" is not a rule; write blend, first, greatest or sum"},
        Case{"attribute vertex.load float blend", "\"blend\" ends"},
        Case{"attribute vertex.load uchar first 256", "\"256\" is not a number of the type uchar"},
        Case{"attribute vertex.load bool first 2", "\"2\" is neither true nor false"},
        Case{"attribute vertex.load floatx3 blend 1 2", "\"2\" is the last of 2 numbers; the type floatx3 needs 3"},
        Case{"attribute vertex.load floatx0", "\"floatx0\" is not a type"},
        Case{"attribute vertex.load floatx99999999999", "is not a type"},
        Case{"attribute vertex.load", "\"\" is not a type"}, Case{"attribute vertex.missing bool", ""},
        Case{"attribute vertices are numbered", ""}, Case{"attribute", ""}}) {
    std::string text(faces_ply);
    text.insert(text.find("element"), "comment " + std::string(c.comment) + "\n");
    const MeshFile file = read_sound("ply", text);
    const Message* const message = find_message(file, "unknown_type");
    if (std::string_view(c.comment) == "attribute vertex.load float blend") {
      EXPECT_FALSE(message) << "the default is zero";
    } else {
      EXPECT_EQ(message != nullptr, *c.warning != '\0') << c.comment;
      if (message) {
        EXPECT_NE(message->text.en.find(c.warning), std::string::npos) << message->text.en;
        EXPECT_EQ(message->line, 3u);
      }
    }
    EXPECT_EQ(file.head_comments, std::vector<std::string>{c.comment}) << "kept";
    EXPECT_EQ(bytes_of(file, *find_format("ply")), text);
  }
}

TEST(ply_attributes, lists_that_do_not_fit_their_comment_stay_lists) {
  std::string text(faces_ply);
  text.insert(text.find("element"), "comment attribute face.axis floatx3 blend 0 0 1\n");
  text.insert(text.find("end_header"), "property list uchar float axis\n");
  for (const char* row : {"0 1 2 3\n", "1 4 2\n", "1 2 5\n", "0 0 1\n", "2 3 4\n"})
    text.insert(text.rfind(row) + std::string_view(row).size() - 1,
                std::string(row) == "1 4 2\n" ? " 2 0 1" : " 3 0 0 1");
  const MeshFile file = read_sound("ply", text);
  EXPECT_TRUE(file.mesh.attributes.empty());
  EXPECT_EQ(bytes_of(file, *find_format("ply")), text);
}

TEST(ply_attributes, other_formats_tell_what_they_lose) {
  Dice dice(3);
  const MeshFile file = with_all_types(dice);
  for (const char* id : {"obj", "off", "stl", "stl-ascii", "txt"}) {
    const std::string codes = io_test::loss_codes(file, id);
    EXPECT_NE(codes.find("loses_properties"), std::string::npos) << id;
    EXPECT_NE(codes.find("loses_extra_elements"), std::string::npos) << id << "the edges";
  }
}

TEST(ply_attributes, an_own_rule_is_a_loss) {
  Mesh mesh = from_indexed(read_sound("ply", faces_ply).mesh);
  {
    Edit edit(mesh, nullptr);
    const OwnRule own = [](const ValueSources&, std::uint32_t* value) { *value = 5; };
    edit.add_attribute("vertex.own", ElementKind::vertex, own, std::uint32_t{1});
    edit.commit();
  }
  const MeshFile file = edited_file({}, mesh, {});
  EXPECT_EQ(io_test::loss_codes(file, "ply"), "loses_rules");
  const MeshFile again = read_sound("ply", bytes_of(file, *find_format("ply")));
  ASSERT_EQ(again.mesh.attributes.size(), 1u);
  EXPECT_EQ(again.mesh.attributes[0].rule, ValueRule::first);
  EXPECT_EQ(again.mesh.attributes[0].fill, std::vector<std::uint32_t>{1});
}

TEST(ply_attributes, an_element_edge_that_is_something_else_stays) {
  std::string text(faces_ply);
  text.insert(text.find("end_header"), "element edge 1\nproperty list uchar int vertex_indices\n");
  text += "3 0 1 2\n";
  MeshFile file = read_sound("ply", text);
  EXPECT_EQ(bytes_of(file, *find_format("ply")), text);
  file.mesh.attributes.push_back(make_column("edge.load", ElementKind::edge, ValueRule::sum, 1.0));
  EXPECT_EQ(bytes_of(file, *find_format("ply")), text);
  EXPECT_EQ(io_test::loss_codes(file, "ply"), "loses_properties");
}

// The text with further properties behind those of a table, whose rows all get these words.
std::string with_properties(std::string_view table_end, const std::string& properties, const std::string& words) {
  std::string text(faces_ply);
  text.insert(text.find(table_end), properties);
  std::string out = text.substr(0, text.find("end_header\n") + 11);
  std::istringstream rows(text.substr(out.size()));
  int row = 0;
  for (std::string line; std::getline(rows, line); ++row) {
    const bool is_vertex = row < 7;
    out += line + (is_vertex == (table_end == "element face") ? words : "") + "\n";
  }
  return out;
}

TEST(ply_attributes, names_of_the_program_stay_properties_of_any_type) {
  for (const char* name : {"weight", "colour", "vertex.weight"}) {
    const std::string text = with_properties("element face", std::string("property float ") + name + "\n", " 0.5");
    const MeshFile file = read_sound("ply", text);
    EXPECT_TRUE(file.mesh.attributes.empty()) << name;
    EXPECT_EQ(bytes_of(Document(file).contents(), *find_format("ply")), text);
  }
}

TEST(ply_attributes, names_that_repeat_an_element_come_back) {
  Mesh mesh = from_indexed(read_sound("ply", faces_ply).mesh);
  {
    Edit edit(mesh, nullptr);
    for (const char* name : {"vertex.vertex.load", "vertex.load", "vertex.edge.x"})
      edit.add_attribute(name, ElementKind::vertex, ValueRule::sum, std::int16_t{3});
    for (const char* name : {"face.corner.x", "face.face.y", "face.y"})
      edit.add_attribute(name, ElementKind::face, ValueRule::sum, std::int16_t{3});
    for (const char* name : {"edge.edge.x", "edge.x"})
      edit.add_attribute(name, ElementKind::edge, ValueRule::sum, std::int16_t{3});
    edit.add_attribute("corner.x", ElementKind::corner, ValueRule::sum, std::int16_t{3});
    edit.commit();
  }
  const MeshFile file = edited_file({}, mesh, {});
  const MeshFile again = read_sound("ply", bytes_of(file, *find_format("ply")));
  EXPECT_EQ(again.mesh.attributes.size(), 9u);
  for (const AttributeColumn& column : file.mesh.attributes)
    EXPECT_EQ(std::count(again.mesh.attributes.begin(), again.mesh.attributes.end(), column), 1) << column.name;
}

TEST(ply_attributes, of_comments_on_one_name_the_last_that_fits_counts) {
  const std::string text = with_properties("element face", "property uchar flag\n", " 1")
                               .insert(std::string_view("ply\nformat ascii 1.0\n").size(),
                                       "comment attribute vertex.flag int\ncomment attribute vertex.flag bool\n");
  const MeshFile file = read_sound("ply", text);
  ASSERT_EQ(file.mesh.attributes.size(), 1u);
  EXPECT_EQ(file.mesh.attributes[0].type.scalar, Scalar::boolean);
  EXPECT_EQ(file.head_comments, std::vector<std::string>{"attribute vertex.flag int"});
  EXPECT_EQ(read_sound("ply", bytes_of(file, *find_format("ply"))).mesh.attributes, file.mesh.attributes);
}

TEST(ply_attributes, a_comment_without_its_property_describes_no_later_attribute) {
  std::string text(faces_ply);
  text.insert(text.find("element"), "comment attribute vertex.ghost float first 5\n");
  Document document(read_sound("ply", text));
  ASSERT_TRUE(document.add_attribute(make_column("vertex.ghost", ElementKind::vertex, ValueRule::blend, 0.0f)).done());
  const MeshFile again = read_sound("ply", bytes_of(document.contents(), *find_format("ply")));
  ASSERT_EQ(again.mesh.attributes.size(), 1u);
  EXPECT_EQ(again.mesh.attributes[0].rule, ValueRule::blend);
  EXPECT_EQ(again.mesh.attributes[0].fill, std::vector<std::uint32_t>{0});
}

TEST(ply_attributes, losses_name_what_is_lost) {
  const MeshFile file = read_sound("ply", with_properties("element face", "property float load\n", " 1"));
  const std::vector<Message> messages = loss_messages(file, *find_format("obj"));
  ASSERT_EQ(messages.size(), 1u);
  EXPECT_TRUE(messages[0].text.en.ends_with("further properties of vertices or faces: 1 (vertex.load)."))
      << messages[0].text.en;
}

TEST(ply_attributes, a_list_beside_a_whole_name_is_another_one) {
  std::string text = with_properties(
      "element face", "property list uchar float load\nproperty list uchar float vertex.load\n", " 3 7 8 9 3 1 2 3");
  text.insert(text.find("element"), "comment attribute vertex.load floatx3 blend 0 0 0\n");
  const MeshFile file = read_sound("ply", text);
  ASSERT_EQ(file.mesh.attributes.size(), 1u);
  EXPECT_EQ((attribute_value<std::array<float, 3>>(file.mesh.attributes[0], 0)), (std::array<float, 3>{1, 2, 3}));
  EXPECT_EQ(bytes_of(file, *find_format("ply")), text);
}

TEST(ply_attributes, more_properties_of_edges_than_attributes_stay_a_table) {
  for (const int count : {4093, 4094, 4095, 4096, 5000}) {
    std::string text(faces_ply);
    std::string properties = "element edge 0\nproperty int vertex1\nproperty int vertex2\n";
    for (int i = 0; i < count; ++i) properties += "property float p" + std::to_string(i) + "\n";
    text.insert(text.find("end_header"), properties);
    const MeshFile file = read_sound("ply", text);
    EXPECT_EQ(file.mesh.attributes.size(), count <= 4094 ? static_cast<std::size_t>(count) : 0u);
    EXPECT_TRUE(bytes_of(file, *find_format("ply")) == text);
  }
}

TEST(ply_attributes, an_attribute_of_edges_that_is_removed_stays_away) {
  Document document(read_sound("ply", edges_ply));
  ASSERT_TRUE(document.remove_attribute("edge.crease").done());
  const std::string text = bytes_of(document.contents(), *find_format("ply"));
  EXPECT_EQ(text.find("crease"), std::string::npos) << text;
  EXPECT_EQ(rows_of_edges(text, 7), "2 1\n5 6\n0 1\n1 2\n0 2\n3 2\n0 77\n");
  EXPECT_TRUE(read_sound("ply", text).mesh.attributes.empty());
}

TEST(ply_attributes, a_row_that_was_no_edge_gives_way_to_an_edge) {
  Document document(read_sound("ply", edges_ply));
  const ParsedOp cut = parse_line(document.mesh(), "split_face 0 2");
  const ParsedOp loop = parse_line(document.mesh(), "separate_loop 0 2");
  const std::optional<AnyOp>& op = cut.op ? cut.op : loop.op;
  ASSERT_TRUE(op && document.apply(*op).done());
  const Halfedge h = find_edge(document.mesh(), "0-2").element;
  const auto value = attribute_words(9.0f);
  ASSERT_TRUE(
      document.set_attribute("edge.crease", Elements{edge(h)}, value, "attribute set edge.crease 9 0-2").done());
  const MeshFile again = read_sound("ply", bytes_of(document.contents(), *find_format("ply")));
  const Mesh mesh = from_indexed(again.mesh);
  EXPECT_EQ(attribute_value<float>(*find_column(mesh, "edge.crease"), edge(find_edge(mesh, "0-2").element).index), 9);
}

TEST(ply_attributes, edges_without_properties_are_saved_with_a_part) {
  std::string text(edges_ply);
  const Document document(read_sound("ply", text));
  const MeshFile part = document.part(Elements{Face(0)});
  const std::string saved = bytes_of(part, *find_format("ply"));
  EXPECT_NE(saved.find("element edge 3\n"), std::string::npos) << saved;
}

TEST(ply_attributes, corners_of_faces_with_holes_keep_theirs) {
  const MeshFile file = read_sound(
      "ply",
      "ply\nformat ascii 1.0\ncomment attribute corner.mark int first 0\nelement vertex 8\nproperty float x\n"
      "property float y\nproperty float z\nelement face 1\nproperty list uchar int vertex_indices\n"
      "property list uchar int corner.mark\nend_header\n0 0 0\n9 0 0\n9 9 0\n0 9 0\n3 3 0\n6 3 0\n6 6 0\n3 6 0\n"
      "10 0 1 2 3 0 4 7 6 5 4 10 10 11 12 13 99 14 17 16 15 88\n");
  ASSERT_EQ(file.mesh.bridged.size(), 1u);
  const Document document(file);
  EXPECT_EQ(document.mesh().live().rings, 1u);
  EXPECT_EQ(difference(document.contents(), file), "");
}

}  // namespace
}  // namespace ryosen
