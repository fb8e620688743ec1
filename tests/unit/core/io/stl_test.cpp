#include "ryosen/io/stl.h"

#include "tests/unit/core/io/io_helpers.h"

namespace ryosen {
namespace {

using io_test::difference_after_round_trip;
using io_test::expect_refusals;
using io_test::find_message;
using io_test::read_refused;
using io_test::read_sound;
using Corners = std::vector<std::uint32_t>;

std::string text_facet(std::initializer_list<const char*> places) {
  std::string out = "facet normal 0 0 1\n outer loop\n";
  for (const char* place : places) out += std::string("  vertex ") + place + "\n";
  return out + " endloop\nendfacet\n";
}

std::string text_tetrahedron(const std::string& name) {
  return "solid " + name + "\n" + text_facet({"-0 -0.0 0", "0 1 0", "1 0 0"}) +
         text_facet({"0 0 0", "1 0 0", "0 0 1"}) + text_facet({"1 0 0", "0 1 0", "0 0 1"}) +
         text_facet({"0 0 0", "0 0 1", "0 1 0"}) + "endsolid " + name + "\n";
}

std::string binary(std::string head, std::uint32_t count, const std::vector<std::vector<float>>& facets,
                   std::uint16_t attribute = 0) {
  head.resize(80, '\0');
  const auto put = [&](const auto& value) { head.append(reinterpret_cast<const char*>(&value), sizeof value); };
  put(count);
  for (const std::vector<float>& facet : facets) {
    for (int i = 0; i < 3; ++i) put(0.0f);
    for (const float value : facet) put(value);
    put(attribute);
    if (attribute != 0) ++attribute;
  }
  return head;
}

const std::vector<std::vector<float>> four_facets = {{0, -0.0f, 0, 0, 1, 0, 1, 0, 0},
                                                     {0, 0, 0, 1, 0, 0, 0, 0, 1},
                                                     {1, 0, 0, 0, 1, 0, 0, 0, 1},
                                                     {0, 0, 0, 0, 0, 1, 0, 1, 0}};

TEST(stl_read, corners_at_equal_numbers_are_one_vertex) {
  for (const std::string& bytes : {text_tetrahedron("t"), binary("t", 4, four_facets)}) {
    const MeshFile file = read_sound("stl", bytes);
    EXPECT_EQ(file.mesh.positions.size(), 4u);
    EXPECT_EQ(file.mesh.corners, (Corners{0, 1, 2, 0, 2, 3, 2, 1, 3, 0, 3, 1}));
    ASSERT_EQ(file.messages.size(), 1u);
    EXPECT_EQ(file.messages[0].code, "welded");
    EXPECT_EQ(file.messages[0].severity, Severity::info);
    EXPECT_EQ(file.messages[0].text.en, "12 corners at 4 places were welded.");
    EXPECT_EQ(difference_after_round_trip(file, "stl"), "");
  }
}

TEST(stl_read, many_points_grow_the_table) {
  std::vector<std::vector<float>> facets;
  for (int i = 0; i < 3000; ++i) {
    const auto x = static_cast<float>(i);
    facets.push_back({x, 0, 0, x, 1, 0, x, 0, 1});
    facets.push_back({x, 0, 1, x, 1, 0, x, 0, 0});
  }
  const MeshFile file = read_sound("stl", binary("", 6000, facets));
  EXPECT_EQ(file.mesh.positions.size(), 9000u);
  for (std::uint32_t i = 0; i < 3000; ++i) {
    ASSERT_EQ(file.mesh.face(2 * i)[0], 3 * i);
    ASSERT_EQ(file.mesh.face(2 * i + 1)[0], 3 * i + 2);
  }
}

TEST(stl_read, solids_become_groups) {
  const MeshFile two = read_sound("stl", text_tetrahedron("a b") + "solid\nendsolid\n" + text_tetrahedron("a b"));
  EXPECT_EQ(two.mesh.groups.names, (std::vector<std::string>{"a b", "", "a b"}));
  EXPECT_EQ(two.mesh.groups.index, (Corners{0, 0, 0, 0, 2, 2, 2, 2}));
  EXPECT_EQ(difference_after_round_trip(two, "stl"), "");
  EXPECT_EQ(io_test::loss_codes(two, "stl-ascii"), "");
}

TEST(stl_read, words_in_any_case_and_layout) {
  const MeshFile file =
      read_sound("stl",
                 "SOLID\tx y\r\n Facet NORMAL 0 0 1 OUTER loop vertex 0 0 0 vertex 1 0 0\r\nVERTEX\r\n"
                 "0 1 0 ENDLOOP EndFacet endsolid anything at all");
  EXPECT_EQ(file.mesh.groups.names, std::vector<std::string>{"x y"});
  EXPECT_EQ(file.mesh.corners, (Corners{0, 1, 2}));
  EXPECT_EQ(file.messages.size(), 1u);
}

TEST(stl_read, a_text_on_one_line) {
  const MeshFile file = read_sound("stl",
                                   "solid a facet of mine facet normal 0 0 1 outer loop vertex 0 0 0 vertex 1 0 0 "
                                   "vertex 0 1 0 endloop endfacet endsolid a facet of mine");
  EXPECT_EQ(file.mesh.groups.names, std::vector<std::string>{"a facet of mine"});
  EXPECT_EQ(file.mesh.corners, (Corners{0, 1, 2}));
}

TEST(stl_read, a_byte_order_mark_before_solid) {
  const MeshFile file = read_sound("stl", "\xef\xbb\xbf" + text_tetrahedron("t"));
  EXPECT_EQ(file.mesh.face_count(), 4u);
  EXPECT_EQ(file.mesh.groups.names, std::vector<std::string>{"t"});
}

TEST(stl_read, facets_of_other_than_three_corners) {
  const MeshFile file =
      read_sound("stl", "solid\n" + text_facet({"0 0 0", "1 0 0", "1 1 0", "0 1 0"}) + text_facet({"0 0 0", "1 0 0"}) +
                            text_facet({"0 0 0", "0 0 0", "1 0 0"}) + "endsolid\n");
  EXPECT_EQ(find_message(file, "facet_many_corners")->line, 2u);
  ASSERT_EQ(file.mesh.quarantine.size(), 2u);
  EXPECT_EQ(file.mesh.quarantine[0].code, "face_too_few_corners");
  EXPECT_EQ(file.mesh.quarantine[0].line, 10u);
  EXPECT_EQ(file.mesh.quarantine[1].code, "repeated_corner");
  EXPECT_EQ(difference_after_round_trip(file, "stl"), "");
  EXPECT_EQ(io_test::loss_codes(file, "stl-ascii"), "");
  EXPECT_EQ(io_test::loss_codes(file, "stl-binary"), "loses_polygons loses_quarantined");
}

TEST(stl_read, places_that_are_not_finite) {
  const MeshFile text = read_sound("stl", "solid\n" + text_facet({"nan 0 0", "1 0 0", "0 1 0"}) +
                                              text_facet({"nan 0 0", "1 0 0", "1e999 1 0"}) + "endsolid\n");
  EXPECT_EQ(text.mesh.positions.size(), 5u) << "NaN equals nothing";
  EXPECT_EQ(find_message(text, "nonfinite_number")->line, 4u);
  const float infinity = std::numeric_limits<float>::infinity();
  const MeshFile file =
      read_sound("stl", binary("", 2, {{0, 0, 0, 1, 0, 0, infinity, 0, 0}, {infinity, 0, 0, 1, 0, 0, 2, 0, 0}}));
  EXPECT_EQ(file.mesh.positions.size(), 4u) << "infinity equals itself";
  EXPECT_EQ(find_message(file, "nonfinite_number")->face, 0u);
}

TEST(stl_read, attributes_and_head_are_kept) {
  const MeshFile file = read_sound("stl", binary("solid, but binary", 4, four_facets, 65533));
  EXPECT_EQ(file.head_comments, std::vector<std::string>{"solid, but binary"});
  ASSERT_EQ(file.mesh.attributes.size(), 1u);
  EXPECT_EQ(file.mesh.attributes[0].name, "face.attribute");
  EXPECT_EQ(file.mesh.attributes[0].data[2], 65535u);
  EXPECT_EQ(difference_after_round_trip(file, "stl"), "");
  EXPECT_EQ(io_test::loss_codes(file, "stl"), "");
  EXPECT_EQ(io_test::loss_codes(file, "stl-ascii"), "loses_properties loses_comments");
  const MeshFile ply = read_sound("ply", bytes_of(file, *find_format("ply"), Encoding::ascii));
  EXPECT_EQ(ply.mesh.attributes, file.mesh.attributes);
  EXPECT_EQ(read_sound("stl", bytes_of(ply, *find_format("stl"), Encoding::binary_little)).mesh.attributes,
            file.mesh.attributes);
  EXPECT_TRUE(read_sound("stl", binary("", 4, four_facets)).mesh.attributes.empty());
}

TEST(stl_read, heads_are_written_back_byte_for_byte) {
  const std::string magics("COLOR=\x10\x00\x20\xff,MATERIAL=\x01\x02\n\x00\x03", 25), blanks(80, ' '), zeros(80, '\0');
  for (const std::string& head : {magics, "solid " + magics, "by hand" + std::string(73, ' '), blanks, zeros}) {
    std::string bytes = binary("", 4, four_facets);
    bytes.replace(0, head.size(), head);
    const MeshFile file = read_sound("stl", bytes);
    EXPECT_EQ(bytes_of(file, *find_format("stl")).substr(0, 80), bytes.substr(0, 80));
    EXPECT_EQ(io_test::loss_codes(file, "stl"), "") << head;
    const bool is_wordless = head.find("COLOR") != std::string::npos;
    EXPECT_EQ(io_test::loss_codes(file, "obj"), is_wordless ? "loses_head" : "") << head;
    EXPECT_EQ(io_test::loss_codes(file, "stl-ascii"), is_wordless      ? "loses_head"
                                                      : head[0] == 'b' ? "loses_comments"
                                                                       : "")
        << head;
    MeshFile other = file;
    other.stl_head.replace(0, 4, "PK\x03\x04");
    EXPECT_EQ((*recognise(bytes_of(other, *find_format("stl")), {}))->id, "stl") << "and not a compressed file";
  }
}

TEST(stl_read, counts_that_do_not_fit) {
  const MeshFile none = read_sound("stl", binary("x", 0, {}));
  EXPECT_EQ(find_message(none, "no_faces")->byte, 80u);
  const MeshFile more = read_sound("stl", binary("x", 5, four_facets));
  EXPECT_EQ(find_message(more, "unexpected_end")->byte, 80u);
  EXPECT_EQ(more.mesh.face_count(), 4u);
  const std::string whole = binary("x", 4, four_facets);
  const MeshFile cut = read_sound("stl", whole.substr(0, whole.size() - 1));
  EXPECT_EQ(find_message(cut, "unexpected_end")->byte, 234u);
  EXPECT_EQ(cut.mesh.face_count(), 3u);
  const MeshFile less = read_sound("stl", binary("x", 3, four_facets));
  EXPECT_EQ(find_message(less, "extra_data")->byte, 234u);
  const Failure absurd = read_refused("stl", binary("x", 4000000000u, four_facets));
  EXPECT_EQ(absurd.message.code, "count_too_large");
  EXPECT_EQ(absurd.message.byte, 80u);
  EXPECT_EQ(read_refused("stl", std::string(83, 'x')).message.byte, 80u);
  EXPECT_EQ(read_refused("stl", std::string(200, 'x')).message.code, "not_stl");
}

TEST(stl_read, texts_that_cannot_be) {
  expect_refusals("stl", text_tetrahedron("t"),
                  {
                      {"solid t\nfacet", "solid t\nfacit", "unknown_keyword", 2},
                      {"normal 0", "normal x", "unreadable_number", 2},
                      {"normal", "norm", "unknown_keyword", 2},
                      {"outer", "inner", "unknown_keyword", 3},
                      {"vertex -0 -0.0 0", "vertex -0 -0.0", "unreadable_number", 5},
                      {"vertex 0 1 0", "vertex 0 1 0 7", "unknown_keyword", 5},
                      {" endloop\nendfacet", " endloop", "unknown_keyword", 8},
                      {"0 0 1\n endloop\nendfacet\nfacet normal 0 0 1\n outer loop\n  vertex 0 0 0\n  vertex 0 0 1\n  "
                       "vertex 0 1 0\n"
                       " endloop\nendfacet\nendsolid t\n",
                       "0 0", "unexpected_end", 21},
                  });
}

TEST(stl_read, texts_that_are_odd) {
  std::string text = text_tetrahedron("t");
  EXPECT_EQ(find_message(read_sound("stl", text + "garbage\nmore"), "extra_data")->line, 31u);
  text.resize(text.find("endsolid"));
  EXPECT_EQ(find_message(read_sound("stl", text), "missing_endsolid")->line, 30u);
  EXPECT_NE(find_message(read_sound("stl", "solid\nendsolid\n"), "no_faces"), nullptr);
}

TEST(stl_write, names_what_it_cannot_hold) {
  const MeshFile file =
      read_sound("obj",
                 "# c\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 .1 0\nv 0 0 0\nv 0 0 5\nv 7 7 7\ng a\nusemtl m\n"
                 "f 1 2 3 4\nf 5 2 6\nf 1 2\nf 1 1 2\nf 1 2 99\n");
  EXPECT_EQ(io_test::loss_codes(file, "stl-binary"),
            "loses_polygons loses_quarantined loses_isolated_vertices loses_topology loses_precision loses_groups "
            "loses_materials");
  EXPECT_EQ(io_test::loss_codes(file, "stl-ascii"),
            "loses_polygons loses_quarantined loses_isolated_vertices loses_topology loses_materials loses_comments");
  for (const Loss& loss : losses_of(file, *find_format("stl"))) {
    EXPECT_EQ(loss.count, loss.kind->code == "loses_quarantined" ? 2u : 1u) << loss.kind->code.row().id;
    EXPECT_FALSE(loss.message(find_format("stl")->name).text.ja.empty());
  }
  const MeshFile again = read_sound("stl", bytes_of(file, *find_format("stl")));
  EXPECT_EQ(again.mesh.positions.size(), 5u);
  EXPECT_EQ(again.mesh.corners.size(), 9u);
  ASSERT_EQ(again.mesh.quarantine.size(), 1u);
  EXPECT_EQ(again.mesh.quarantine[0].face, 3u);
}

// Normals are those of the places that are written, whatever they were before they became floats.
TEST(stl_write, what_is_read_and_written_again_is_the_same) {
  for (const char* places : {"0.1 0.2 0.3 1.7 0.9 0.123456789 0.333333333333 2.1 0.7", "0 0 0 1 0 0 0 1e-30 1e-31",
                             "16777217 0.1 0 16777219 0.3 0 16777221 0.7 1e-9", "1e-46 0 0 0 1e-46 0 0 0 1",
                             "1e30 0 0 0 1e30 1 3e38 1e20 7", "0.1 0.1 0.1 0.2 0.2 0.2 0.3 0.3 0.3000000000001"}) {
    std::istringstream words(places);
    std::string text;
    for (int i = 0; i < 3; ++i) {
      std::string x, y, z;
      words >> x >> y >> z;
      text.append("v ").append(x).append(" ").append(y).append(" ").append(z).append("\n");
    }
    const MeshFile file = read_sound("obj", text + "f 1 2 3\n");
    for (const char* const id : {"stl", "obj"}) {
      const std::string once = bytes_of(file, *find_format(id));
      EXPECT_EQ(bytes_of(read_sound(id, once), *find_format(id)), once) << id << " of " << places;
    }
    const std::string binary = write_stl(file, Encoding::binary_little), text_form = write_stl(file, Encoding::ascii);
    EXPECT_EQ(write_stl(read_sound("stl", binary), Encoding::binary_little), binary) << places;
    EXPECT_EQ(write_stl(read_sound("stl", text_form), Encoding::ascii), text_form) << places;
    EXPECT_EQ(write_stl(read_sound("stl", text_form), Encoding::binary_little), binary) << places;
  }
}

}  // namespace
}  // namespace ryosen
