#include "ryosen/io/obj.h"

#include "tests/unit/core/io/io_helpers.h"

namespace ryosen {
namespace {

using io_test::difference_after_round_trip;
using io_test::find_message;
using io_test::read_refused;
using io_test::read_sound;

constexpr std::string_view four_vertices = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n";

std::string with_vertices(std::string_view rest) { return std::string(four_vertices) + std::string(rest); }

using Corners = std::vector<std::uint32_t>;
using Names = std::vector<std::string>;

Corners corners(const MeshFile& file, std::size_t face) {
  const auto range = file.mesh.face(face);
  return {range.begin(), range.end()};
}

void expect_quarantined(const std::string& text, std::string_view code, std::uint64_t line,
                        const std::vector<std::int64_t>& wanted) {
  const MeshFile file = read_sound("obj", text);
  ASSERT_EQ(file.mesh.quarantine.size(), 1u) << text;
  const QuarantinedFace& face = file.mesh.quarantine[0];
  EXPECT_EQ(face.code, code) << text;
  EXPECT_EQ(face.line, line) << text;
  EXPECT_EQ(face.corners, wanted) << text;
  EXPECT_TRUE(file.mesh.face(face.face).empty());
  EXPECT_NE(face.cause().en, "");
  EXPECT_NE(face.cause().ja, face.cause().en);
  const Message* message = find_message(file, code);
  ASSERT_NE(message, nullptr);
  EXPECT_EQ(message->line, line);
  EXPECT_EQ(difference_after_round_trip(file, "obj"), "") << text << write_obj(file);
}

TEST(obj_read, keeps_order_and_polygons) {
  const MeshFile file = read_sound("obj", with_vertices("v 1 1 1\nf 5 4 3 2 1\nf 1 2 3\nf 2 3 4 5\n"));
  EXPECT_EQ(file.mesh.positions.size(), 5u);
  EXPECT_EQ(file.mesh.face_count(), 3u);
  EXPECT_EQ(corners(file, 0), (Corners{4, 3, 2, 1, 0}));
  EXPECT_EQ(corners(file, 2), (Corners{1, 2, 3, 4}));
  EXPECT_EQ(file.mesh.face_lines, (std::vector<std::uint32_t>{6, 7, 8}));
  EXPECT_TRUE(file.messages.empty());
}

TEST(obj_read, doubles_are_right_to_the_last_bit) {
  const MeshFile file = read_sound("obj", "v 0.1 0.30000000000000004 1.7976931348623157e308\nv 4.9e-324 -0 .1e1\n");
  EXPECT_EQ(file.mesh.positions[0], glm::dvec3(0.1, 0.30000000000000004, 1.7976931348623157e308));
  EXPECT_EQ(file.mesh.positions[1].x, 4.9e-324);
  EXPECT_TRUE(std::signbit(file.mesh.positions[1].y));
}

TEST(obj_read, line_ends_tabs_marks_and_continuations) {
  for (const char* text : {"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3", "v 0 0 0\r\nv 1 0 0\r\nv 0 1 0\r\nf 1 2 3\r\n",
                           "v 0 0 0\rv 1 0 0\rv 0 1 0\rf 1 2 3\r", "\xef\xbb\xbfv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n",
                           "v\t0\t0\t0\n  v 1 0 0  \n\tv 0 1 0\t\nf\t1\t2\t3\t\n",
                           "v 0 0 \\\n0\nv 1 \\\r\n0 \\\r\n0\nv 0 1 0\nf 1 \\\n 2 \\\n 3\n",
                           "v 0 0 0 # first\nv 1 0 0\nv 0 1 0\nf 1 2 3 # last\n"}) {
    const MeshFile file = read_sound("obj", text);
    EXPECT_EQ(file.mesh.positions, (std::vector<glm::dvec3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}})) << text;
    ASSERT_EQ(file.mesh.face_count(), 1u) << text;
    EXPECT_EQ(corners(file, 0), (Corners{0, 1, 2})) << text;
    EXPECT_TRUE(file.messages.empty()) << text;
  }
}

TEST(obj_read, a_backslash_before_blanks_joins_lines_of_numbers) {
  for (const char* face : {"f 1 2 \\ \n3\n", "f 1 \\\t\r\n2 \\ \r\n3\n", "f \\  \n1 \\\n2 3 \\ \n\n"}) {
    const MeshFile file = read_sound("obj", with_vertices(face));
    ASSERT_EQ(file.mesh.face_count(), 1u) << face;
    EXPECT_EQ(corners(file, 0), (Corners{0, 1, 2})) << face;
    EXPECT_TRUE(file.messages.empty()) << face;
  }
  EXPECT_EQ(read_sound("obj", "v 1 \\ \n2 3\nvt 0 \\ \n1\n").mesh.positions[0], glm::dvec3(1, 2, 3));
}

TEST(obj_read, a_name_that_swallows_a_line_is_warned_of) {
  for (const char* name : {"usemtl dir\\sub\\", "g a\\", "o C:\\", "usemtl a \\", "mtllib x\\", "s 1\\"}) {
    for (const char* line : {"f 1 3 4", "v 0 0 5", "vt 0 0", "f -1 -2 -3", "  f 1 3 4"}) {
      const MeshFile file = read_sound("obj", with_vertices("f 1 2 3\n" + std::string(name) + "\n" + line + "\n"));
      EXPECT_EQ(file.mesh.face_count(), 1u);
      const Message* const message = find_message(file, "unknown_keyword");
      ASSERT_NE(message, nullptr) << name << line;
      EXPECT_EQ(message->line, 6u);
      EXPECT_NE(message->text.en.find("line 7"), std::string::npos) << message->text.en;
      EXPECT_NE(message->text.ja.find("7 行目"), std::string::npos) << message->text.ja;
    }
  }
  for (const char* lines :
       {"usemtl a\\\nb\nf 1 2 3\n", "usemtl a\\ \nf 1 2 3\n", "g a\\\nfront 1\nf 1 2 3\n", "g a \\\n\nf 1 2 3\n"})
    EXPECT_EQ(find_message(read_sound("obj", with_vertices(lines)), "unknown_keyword"), nullptr) << lines;
}

TEST(obj_read, relative_and_forward_indices) {
  const MeshFile file = read_sound("obj", "f 1 2 3\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf -1 -2 -3\nv 0 0 1\nf -1 -2 1\n");
  EXPECT_TRUE(file.messages.empty());
  EXPECT_EQ(corners(file, 0), (Corners{0, 1, 2}));
  EXPECT_EQ(corners(file, 1), (Corners{2, 1, 0}));
  EXPECT_EQ(corners(file, 2), (Corners{3, 2, 0}));
}

TEST(obj_read, unusable_faces_are_quarantined_with_their_cause) {
  expect_quarantined(with_vertices("f 0 1 2\nf 1 2 3\n"), "index_out_of_range", 5, {-1, 0, 1});
  expect_quarantined(with_vertices("f 1 2 5\n"), "index_out_of_range", 5, {0, 1, 4});
  expect_quarantined(with_vertices("f 1 2 4294967297\n"), "index_out_of_range", 5, {0, 1, 4294967296});
  expect_quarantined(with_vertices("f 1 2 4294967296\n"), "index_out_of_range", 5, {0, 1, 4294967295});
  expect_quarantined(with_vertices("f 1 2 99999999999999999999\n"), "index_out_of_range", 5, {0, 1, INT64_MAX});
  expect_quarantined(with_vertices("f 1 2 -7\n"), "index_out_of_range", 5, {0, 1, -3});
  expect_quarantined("f -1 -2 -3\n" + std::string(four_vertices), "index_out_of_range", 1, {-1, -2, -3});
  expect_quarantined(with_vertices("f 1 2\nf 1 2 3\n"), "face_too_few_corners", 5, {0, 1});
  expect_quarantined(with_vertices("f\nf 1 2 3\n"), "face_too_few_corners", 5, {});
  expect_quarantined(with_vertices("f   \nf 1 2 3\n"), "face_too_few_corners", 5, {});
  expect_quarantined(with_vertices("f # 1 2 3\n"), "face_too_few_corners", 5, {});
  expect_quarantined(with_vertices("f 9 9\n"), "face_too_few_corners", 5, {8, 8});
  expect_quarantined(with_vertices("f 1 2 1\n"), "repeated_corner", 5, {0, 1, 0});
  expect_quarantined(with_vertices("f 1 2 3 4 2\n"), "repeated_corner", 5, {0, 1, 2, 3, 1});
  expect_quarantined(with_vertices("f 1 1 9\n"), "index_out_of_range", 5, {0, 0, 8});
  expect_quarantined(with_vertices("f 4 3 \\\n2 0\nf 1 2 3\n"), "index_out_of_range", 5, {3, 2, 1, -1});
}

TEST(obj_read, large_faces_with_a_repetition_are_found) {
  std::string text;
  for (int i = 0; i < 30; ++i) text += "v " + std::to_string(i) + " 0 0\n";
  std::string face = "f";
  for (int i = 1; i <= 30; ++i) face += " " + std::to_string(i);
  const MeshFile file = read_sound("obj", text + face + "\n" + face + " 12\n" + face + "\n");
  ASSERT_EQ(file.mesh.quarantine.size(), 1u);
  EXPECT_EQ(file.mesh.quarantine[0].face, 1u);
  EXPECT_EQ(file.mesh.quarantine[0].code, "repeated_corner");
  EXPECT_EQ(file.mesh.face(2).size(), 30u);
}

TEST(obj_read, quarantine_keeps_the_numbering_and_the_values_of_other_faces) {
  const MeshFile file = read_sound(
      "obj",
      with_vertices("vt 0 0\nvt 1 0\nvt 0 1\nvn 0 0 1\nf 1/1/1 2/2/1 3/3/1\nf 1/3/1 9/2 2/1\nf 2/2 3/3 4/1/1\n"));
  EXPECT_EQ(file.mesh.face_count(), 3u);
  ASSERT_EQ(file.mesh.quarantine.size(), 1u);
  EXPECT_EQ(file.mesh.quarantine[0].texcoords, (Corners{2, 1, 0}));
  EXPECT_EQ(file.mesh.quarantine[0].normals, (Corners{0, no_index, no_index}));
  EXPECT_EQ(corners(file, 2), (Corners{1, 2, 3}));
  EXPECT_EQ(file.mesh.texcoords.index, (Corners{0, 1, 2, 1, 2, 0}));
  EXPECT_EQ(file.mesh.normals.index, (Corners{0, 0, 0, no_index, no_index, 0}));
  EXPECT_EQ(difference_after_round_trip(file, "obj"), "");
}

TEST(obj_read, corner_forms) {
  const MeshFile file =
      read_sound("obj", with_vertices("vt .5\nvn 0 0 1\nf 1/1/1 2//1 3/1\nf 1/ 2// 3/1/\nf -4/-1/-1 -3//-1 +3\n"));
  EXPECT_TRUE(file.messages.empty());
  EXPECT_EQ(file.mesh.texcoords.index, (Corners{0, no_index, 0, no_index, no_index, 0, 0, no_index, no_index}));
  EXPECT_EQ(file.mesh.normals.index, (Corners{0, 0, no_index, no_index, no_index, no_index, 0, 0, no_index}));
  EXPECT_EQ(file.mesh.texcoords.components, 1);
  EXPECT_EQ(difference_after_round_trip(file, "obj"), "");
}

TEST(obj_read, values_out_of_range_are_dropped_and_the_face_stays) {
  for (const char* corner : {"1/9", "1/0", "1/-2", "1/99999999999"}) {
    const MeshFile file = read_sound("obj", with_vertices("vt 0 0\nf " + std::string(corner) + " 2/1 3/1\n"));
    EXPECT_EQ(corners(file, 0), (Corners{0, 1, 2})) << corner;
    EXPECT_EQ(file.mesh.texcoords.index, (Corners{no_index, 0, 0})) << corner;
    const Message* message = find_message(file, "texture_index_out_of_range");
    ASSERT_NE(message, nullptr) << corner;
    EXPECT_EQ(message->line, 6u);
  }
  const MeshFile file = read_sound("obj", with_vertices("vn 0 0 1\nf 1//2 2//1 3//0\n"));
  EXPECT_EQ(file.mesh.normals.index, (Corners{no_index, 0, no_index}));
  EXPECT_NE(find_message(file, "normal_index_out_of_range"), nullptr);
}

TEST(obj_read, unreadable_numbers_are_errors_with_their_place) {
  struct Case {
    const char* text;
    const char* code;
    std::uint64_t line, column;
  };
  for (const Case& c :
       {Case{"v 0 zero 0\n", "unreadable_number", 1, 5}, Case{"v 3.1+e2 0 0\n", "unreadable_number", 1, 3},
        Case{"v 0 0 0\n\n  v 1 2\n", "missing_number", 3, 8}, Case{"v\n", "missing_number", 1, 2},
        Case{"v 0 0 0x1\n", "unreadable_number", 1, 7}, Case{"v 0,5 0 0\n", "unreadable_number", 1, 3},
        Case{"vt a\n", "unreadable_number", 1, 4}, Case{"vn 0 0\n", "missing_number", 1, 7},
        Case{"v 0 0 \\\n 1e\n", "unreadable_number", 2, 2}, Case{"f 1 2 x\n", "unreadable_index", 1, 7},
        Case{"f 1 2.0 3\n", "unreadable_index", 1, 5}, Case{"f 1 /1 3\n", "unreadable_index", 1, 5},
        Case{"f 1/1/1/1 2 3\n", "unreadable_index", 1, 3}, Case{"l 1 b\n", "unreadable_index", 1, 5},
        Case{"v 0 0 0 0 0 x\n", "unreadable_number", 1, 13}}) {
    const Failure failure = read_refused("obj", c.text);
    EXPECT_EQ(failure.exit_code, ExitCode::input_malformed) << c.text;
    EXPECT_EQ(failure.message.code, c.code) << c.text;
    EXPECT_EQ(failure.message.line, c.line) << c.text;
    EXPECT_EQ(failure.message.column, c.column) << c.text;
    EXPECT_NE(failure.message.text.ja, "");
  }
}

TEST(obj_read, non_finite_numbers_stay_with_a_warning) {
  const MeshFile file = read_sound("obj", with_vertices("v nan 1.#INF -1e999\nvn 0 inf 0\nf 1 2 5\n"));
  EXPECT_TRUE(std::isnan(file.mesh.positions[4].x));
  EXPECT_EQ(file.mesh.positions[4].y, std::numeric_limits<double>::infinity());
  EXPECT_EQ(file.mesh.positions[4].z, -std::numeric_limits<double>::infinity());
  EXPECT_EQ(file.messages.size(), 4u);
  EXPECT_EQ(file.messages[0].line, 5u);
  EXPECT_EQ(file.mesh.quarantine.size(), 0u);
  EXPECT_EQ(difference_after_round_trip(file, "obj"), "");
}

TEST(obj_read, colours_and_weights) {
  const MeshFile file = read_sound("obj", "v 0 0 0\nv 1 0 0 0.5\nv 0 1 0 1 0 0.25\nv 0 0 1 0\nv 1 1 1 0 1 0 0.5\n");
  const IndexedMesh& mesh = file.mesh;
  EXPECT_TRUE(std::isnan(mesh.vertex_colours[0].x));
  EXPECT_EQ(mesh.vertex_colours[2], glm::dvec4(1, 0, 0.25, 1));
  EXPECT_EQ(mesh.vertex_colours[4], glm::dvec4(0, 1, 0, 0.5));
  EXPECT_TRUE(std::isnan(mesh.vertex_weights[0]));
  EXPECT_EQ(mesh.vertex_weights[1], 0.5);
  EXPECT_EQ(mesh.vertex_weights[3], 0.0);
  EXPECT_EQ(difference_after_round_trip(file, "obj"), "");
  EXPECT_NE(find_message(read_sound("obj", "v 0 0 0 1 1\n"), "extra_values"), nullptr);
}

TEST(obj_read, groups_objects_materials_and_smoothing) {
  const MeshFile file = read_sound("obj", with_vertices("f 1 2 3\ng front  cube\no thing\nusemtl Red #1\ns 1\nf 1 2 4\n"
                                                        "g\ns off\nusemtl blue\nf 2 3 4\ng front  cube\nf 1 3 4\n"));
  const IndexedMesh& mesh = file.mesh;
  EXPECT_EQ(mesh.groups.names, Names{"front  cube"});
  EXPECT_EQ(mesh.groups.index, (Corners{no_index, 0, no_index, 0}));
  EXPECT_EQ(mesh.materials.names, (Names{"Red #1", "blue"}));
  EXPECT_EQ(mesh.materials.index, (Corners{no_index, 0, 1, 1}));
  EXPECT_EQ(mesh.objects.names, Names{"thing"});
  EXPECT_EQ(mesh.smoothing.names, (Names{"1", "off"}));
  EXPECT_EQ(mesh.smoothing.index, (Corners{no_index, 0, 1, 1}));
  EXPECT_EQ(difference_after_round_trip(file, "obj"), "");
}

TEST(obj_read, names_without_faces_stay) {
  const MeshFile file = read_sound("obj", with_vertices("g a\ng b\nusemtl x\nusemtl y\nf 1 2 3\nusemtl z\ng c\n"));
  EXPECT_EQ(file.mesh.groups.names, (Names{"a", "b", "c"}));
  EXPECT_EQ(file.mesh.materials.names, (Names{"x", "y", "z"}));
  EXPECT_EQ(difference_after_round_trip(file, "obj"), "");
}

TEST(obj_read, lines_and_points_stay_in_their_place) {
  const MeshFile file =
      read_sound("obj", with_vertices("vt 0\nl 1 2/1 3\ng a\nf 1 2 3\np 4 -1\ng b\nl 1 4\nf 1 2 4\nl 9 0 -9\n"));
  ASSERT_EQ(file.elements.items.size(), 4u);
  EXPECT_TRUE(file.elements.items[1].is_points);
  EXPECT_EQ(file.elements.items[1].before_face, 1u);
  EXPECT_EQ(file.elements.items[2].group, 1u);
  EXPECT_EQ(file.elements.vertices, (std::vector<std::int64_t>{0, 1, 2, 3, 3, 0, 3, 8, -1, -5}));
  EXPECT_EQ(file.elements.texcoords[1], 0u);
  const Message* message = find_message(file, "element_index_out_of_range");
  ASSERT_NE(message, nullptr);
  EXPECT_EQ(message->line, 13u);
  EXPECT_EQ(difference_after_round_trip(file, "obj"), "");
}

TEST(obj_read, comments_at_the_head_and_library_lines) {
  const MeshFile file =
      read_sound("obj", "# one \\\n\n  #two\nmtllib a.mtl b.mtl\nmtllib c d.mtl\nmtllib a.mtl b.mtl\n# no\n" +
                            with_vertices("f 1 2 3\n"));
  EXPECT_EQ(file.head_comments, (Names{"# one \\", "#two"}));
  EXPECT_EQ(file.material_libraries, (Names{"a.mtl b.mtl", "c d.mtl"}));
  EXPECT_EQ(difference_after_round_trip(file, "obj"), "");
}

TEST(obj_read, libraries_are_looked_for_in_the_folder_only) {
  const io_test::TemporaryFolder folder;
  std::ofstream(folder / "a b.mtl") << "newmtl x\n";
  std::ofstream(folder / "c.mtl") << "newmtl x\n";
  const auto codes = [&](const std::string& line) {
    const Result<MeshFile> file =
        read_obj("mtllib " + line + with_vertices("\nf 1 2 3\n").insert(0, "\n"), folder / "m.obj");
    Names out;
    for (const Message& message : file->messages) out.emplace_back(message.code);
    return out;
  };
  EXPECT_EQ(codes("a b.mtl"), Names{});
  EXPECT_EQ(codes("a\\ b.mtl c.mtl"), Names{});
  EXPECT_EQ(codes("c.mtl gone.mtl"), Names{"material_library_missing"});
  std::filesystem::create_directory(folder / "d.mtl");
  EXPECT_EQ(codes("d.mtl"), Names{"material_library_no_file"});
  EXPECT_EQ(codes("c.mtl/x.mtl"), Names{"material_library_missing"});
  EXPECT_EQ(codes(""), Names{"material_library_unnamed"});
  EXPECT_EQ(codes("/etc/passwd"), Names{"material_library_outside"});
  EXPECT_EQ(codes("../x.mtl"), Names{"material_library_outside"});
  EXPECT_EQ(codes("sub/../../x.mtl"), Names{"material_library_outside"});
  EXPECT_EQ(codes("..\\x.mtl"), Names{"material_library_outside"});
  EXPECT_EQ(codes("C:\\x.mtl"), Names{"material_library_outside"});
}

TEST(obj_read, unknown_lines_are_reported_once_per_keyword) {
  const MeshFile file = read_sound("obj", with_vertices("vw 1 2\nvw 3 4\ncurv 0 1\nf 1 2 3\n"));
  ASSERT_EQ(file.messages.size(), 2u);
  EXPECT_EQ(file.messages[0].code, "unknown_keyword");
  EXPECT_EQ(file.messages[0].line, 5u);
  EXPECT_NE(file.messages[0].text.en.find("2 lines"), std::string::npos);
  EXPECT_EQ(read_refused("obj", "<html>\n<body>\n").message.code, "not_obj");
}

TEST(obj_read, files_without_a_mesh) {
  EXPECT_EQ(read_refused("obj", "").message.code, "empty_file");
  EXPECT_EQ(read_refused("obj", " \n\t\n").message.code, "empty_file");
  EXPECT_NE(find_message(read_sound("obj", "# nothing\n"), "no_vertices"), nullptr);
  const MeshFile points = read_sound("obj", std::string(four_vertices));
  ASSERT_EQ(points.messages.size(), 1u);
  EXPECT_EQ(points.messages[0].code, "no_faces");
  EXPECT_FALSE(points.messages[0].line.has_value());
  EXPECT_TRUE(io_test::read_text("obj", write_obj(MeshFile{})).ok());
}

TEST(obj_read, nul_bytes_are_found_anywhere) {
  std::string text = with_vertices("f 1 2 3\n");
  text[20] = '\0';
  const Failure failure = read_refused("obj", text);
  EXPECT_EQ(failure.message.code, "nul_byte");
  EXPECT_EQ(failure.message.byte, 20u);
}

TEST(obj_read, warnings_of_one_kind_are_limited_and_counted) {
  std::string text(four_vertices);
  for (int i = 0; i < 1000; ++i) text += "f 1 2\n";
  const MeshFile file = read_sound("obj", text);
  EXPECT_EQ(file.mesh.quarantine.size(), 1000u);
  EXPECT_EQ(file.messages.size(), 21u);
  EXPECT_NE(file.messages.back().text.en.find("980"), std::string::npos);
}

TEST(obj_read, huge_lines_and_polygons) {
  std::string text;
  for (int i = 0; i < 100000; ++i) text += "v " + std::to_string(i) + " 0 0\n";
  text += "f";
  for (int i = 1; i <= 100000; ++i) text += " " + std::to_string(i);
  text += "\n# " + std::string(2000000, 'x') + "\ng " + std::string(2000000, 'y') + "\nf 1 2 3\n";
  const MeshFile file = read_sound("obj", text);
  EXPECT_EQ(file.mesh.face(0).size(), 100000u);
  EXPECT_EQ(file.mesh.groups.names[0].size(), 2000000u);
  EXPECT_EQ(difference_after_round_trip(file, "obj"), "");
}

TEST(obj_write, an_index_past_the_end_is_written_past_the_end) {
  const MeshFile file = read_sound("obj", with_vertices("f 1 2 3\nf 1 2 7\nf 0 1 2\nf 1 -6 2\n"));
  const std::string text = write_obj(file);
  EXPECT_EQ(text, with_vertices("f 1 2 3\nf 1 2 7\nf 0 1 2\nf 1 -6 2\n"));
}

TEST(obj_write, names_that_could_break_the_file_are_made_safe) {
  MeshFile file = read_sound("obj", with_vertices("g a\nf 1 2 3\nf 2 3 4\n"));
  file.mesh.groups.names[0] = "a\nv 0 0 0\\";
  file.head_comments = {"no mark\nv 1 1 1"};
  const MeshFile again = read_sound("obj", write_obj(file));
  EXPECT_EQ(again.mesh.positions.size(), 4u);
  EXPECT_EQ(again.mesh.face_count(), 2u);
  EXPECT_EQ(again.mesh.groups.names, Names{"a v 0 0 0\\"});
}

TEST(obj_write, the_bunny_comes_back_to_the_bit) {
  const Result<MeshFile> file = read_mesh_file(RYOSEN_SOURCE_DIR "/assets/stanford_bunny.obj");
  ASSERT_TRUE(file.ok());
  EXPECT_EQ(file->mesh.positions.size(), 34834u);
  EXPECT_EQ(file->mesh.face_count(), 69451u);
  EXPECT_TRUE(file->messages.empty());
  EXPECT_EQ(difference_after_round_trip(*file, "obj"), "");
  EXPECT_EQ(difference_after_round_trip(*file, "off"), "");
}

// Seven numbers of which the last four are bytes, as those of three are; what is written is what was read.
TEST(obj_read, colours_with_alpha_as_bytes) {
  struct Case {
    const char *first, *second;
    bool are_bytes;
    glm::dvec4 colour;  // of the first
  };
  const Case cases[] = {
      {"255 128 0 255", "0 0 0 51", true, {1, 128 / 255.0, 0, 1}},
      {"0 0 0 255", "0 0 0 0", true, {0, 0, 0, 1}},
      {"255 0 0 2", "0 1 0 1", true, {1, 0, 0, 2 / 255.0}},
      {"255 0 0 51", "0 255 0", true, {1, 0, 0, 0.2}},
      {"255 0 0 1", "0 255 0 0", false, {255, 0, 0, 1}},
      {"255 0 0 0.5", "0 255 0 200", false, {255, 0, 0, 0.5}},
      {"255 0 0 256", "0 255 0 200", false, {255, 0, 0, 256}},
      {"1 0 0 1", "0 0.5 0 1", false, {1, 0, 0, 1}},
  };
  for (const Case& one : cases) {
    const std::string text = "v 0 0 0 " + std::string(one.first) + "\nv 1 0 0 " + one.second + "\nv 0 1 0\nf 1 2 3\n";
    const MeshFile file = read_sound("obj", text);
    EXPECT_EQ(file.byte_colours, one.are_bytes) << text;
    EXPECT_EQ(file.mesh.vertex_colours[0], one.colour) << text;
    const std::string written = bytes_of(file, *find_format("obj"));
    if (std::string(one.second) == "0 255 0") {
      EXPECT_EQ(file.mesh.vertex_colours[1], glm::dvec4(0, 1, 0, 1)) << "one without alpha is opaque";
      EXPECT_NE(written.find("0 255 0 255\n"), std::string::npos) << written;
    } else {
      EXPECT_EQ(written, text);
    }
    EXPECT_EQ(read_sound("obj", written).mesh.vertex_colours[0], one.colour) << written;
  }
}

// Alphas that are all at most 1 as bytes would be read as shares.
TEST(obj_read, colours_with_alpha_are_written_so_that_they_are_read_again) {
  MeshFile file = read_sound("obj", "v 0 0 0 255 0 0 255\nv 1 0 0 0 255 0 51\nv 0 1 0 0 0 255 0\nf 1 2 3\n");
  for (const double alpha : {0.0, 1 / 255.0, 0.5, 0.2, 1.0}) {
    for (glm::dvec4& colour : file.mesh.vertex_colours) colour.w = alpha;
    const std::string written = bytes_of(file, *find_format("obj"));
    EXPECT_EQ(read_sound("obj", written).mesh.vertex_colours, file.mesh.vertex_colours) << written;
  }
}

}  // namespace
}  // namespace ryosen
