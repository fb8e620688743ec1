#include "ryosen/io/edited_file.h"

#include "ryosen/indexed/from_indexed.h"
#include "ryosen/io/obj.h"
#include "ryosen/ops/all.h"
#include "ryosen/ops/rules/sheets.h"
#include "tests/unit/core/io/io_helpers.h"

namespace ryosen {
namespace {

constexpr std::string_view used_beside_obj =
    "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nv 5 5 5\nv 6 5 5\nv 7 5 5\n"
    "f 1 2 3\nf 5 5 6\nf 5 6 99\nf 6 5\nl 5 6 7\np 7\nf 1 3 4\n";

constexpr std::string_view used_beside_ply =
    "ply\nformat ascii 1.0\nelement vertex 7\nproperty float x\nproperty float y\nproperty float z\n"
    "property float quality\nelement face 3\nproperty list uchar int vertex_indices\nelement edge 2\n"
    "property int vertex1\nproperty int vertex2\nproperty uchar crease\nend_header\n"
    "0 0 0 1\n1 0 0 2\n0 1 0 3\n0 0 1 4\n5 5 5 5\n6 5 5 6\n7 5 5 7\n3 0 1 2\n3 4 4 5\n3 0 2 3\n4 5 9\n6 0 8\n";

// The file after these vertices, which must have no faces, were removed.
MeshFile without(const MeshFile& file, std::initializer_list<std::uint32_t> vertices) {
  const FileTables tables = file_tables(file.mesh);
  Mesh mesh = from_indexed(file.mesh);
  Edit edit(mesh, nullptr);
  Sheets sheets(edit);
  for (const std::uint32_t v : vertices) sheets.remove_vertex(Vertex(v));
  edit.commit();
  return edited_file(file, mesh, tables);
}

MeshFile written_and_read_again(const MeshFile& file, std::string_view id) {
  return io_test::read_sound(id, bytes_of(file, *find_format(id)));
}

TEST(edited_file, keeps_removed_vertices_that_faces_set_aside_lines_and_points_use) {
  const MeshFile file = io_test::read_sound("obj", used_beside_obj);
  const MeshFile edited = without(file, {4, 5, 6});
  EXPECT_EQ(edited.kept_vertices, 3u);
  EXPECT_EQ(io_test::difference(file, written_and_read_again(edited, "obj")), "");
  const MeshFile again = written_and_read_again(edited, "obj");
  ASSERT_EQ(again.mesh.quarantine.size(), 3u);
  EXPECT_EQ(again.mesh.quarantine[0].code, "repeated_corner");
  EXPECT_EQ(again.mesh.quarantine[1].code, "index_out_of_range");
  EXPECT_EQ(again.mesh.quarantine[2].code, "face_too_few_corners");
}

TEST(edited_file, keeps_removed_vertices_that_edges_of_ply_use) {
  const MeshFile file = io_test::read_sound("ply", used_beside_ply);
  const MeshFile edited = without(file, {4, 5, 6});
  EXPECT_EQ(edited.kept_vertices, 3u);
  EXPECT_EQ(io_test::difference(file, written_and_read_again(edited, "ply")), "");
}

TEST(edited_file, lets_removed_vertices_go_that_nothing_uses) {
  const MeshFile file = io_test::read_sound("obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 9 9 9\nf 1 2 3\n");
  const MeshFile edited = without(file, {3});
  EXPECT_EQ(edited.mesh.positions.size(), 3u);
  EXPECT_EQ(edited.kept_vertices, 0u);
  EXPECT_TRUE(loss_messages(edited, *find_format("obj")).empty());
}

TEST(edited_file, says_which_removed_vertices_stay) {
  const MeshFile edited = without(io_test::read_sound("obj", used_beside_obj), {4, 6});
  const std::vector<Message> messages = loss_messages(edited, *find_format("obj"));
  ASSERT_EQ(messages.size(), 1u);
  EXPECT_EQ(messages[0].code, "keeps_vertices");
  EXPECT_EQ(messages[0].text.en.substr(0, 2), "2 ");
  for (const Message& message : loss_messages(edited, *find_format("stl"))) EXPECT_NE(message.code, "keeps_vertices");
}

// The file after some lines of operators.
MeshFile after_lines(const MeshFile& source, std::initializer_list<const char*> lines) {
  const FileTables tables = file_tables(source.mesh);
  Mesh mesh = from_indexed(source.mesh);
  for (const char* line : lines) {
    const ParsedOp parsed = parse_line(mesh, line);
    EXPECT_TRUE(parsed.op && check(mesh, *parsed.op).legal()) << line << " " << parsed.sentence.en;
    if (!parsed.op) continue;
    Edit edit(mesh, nullptr);
    apply(edit, *parsed.op);
    edit.commit();
  }
  return edited_file(source, mesh, tables);
}

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t n = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++n;
  return n;
}

// Two quads with texture coordinates and normals of their own, and one of each that nothing uses.
constexpr std::string_view textured =
    "v 0 0 0\nv 1 0 0\nv 2 0 0\nv 0 1 0\nv 1 1 0\nv 2 1 0\nv 9 9 9\nvt 7 7\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\n"
    "vt .5 .5\nvn 0 0 1\nvn 0 1 0\nvn 1 0 0\nf 1/2/1 2/3/1 5/4/1 4/5/1\nf 2/2/2 3/3/2 6/6/2 5/5/2\n";

MeshFile without_unused_values(MeshFile file) {
  drop_unused_values(file);
  return file;
}

TEST(edited_file, leaves_out_texture_coordinates_and_normals_that_nothing_uses) {
  const MeshFile source = io_test::read_sound("obj", textured);
  EXPECT_EQ(count(write_obj(after_lines(source, {"delete f1"})), "\nvt "), 6u) << "only where it is asked for";
  const std::string first = write_obj(without_unused_values(after_lines(source, {"delete f1"})));
  EXPECT_NE(first.find("\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nvn 0 0 1\nf 1/1/1 2/2/1 "), std::string::npos) << first;
  EXPECT_EQ(count(first, "\nvt ") + count(first, "\nvn "), 5u) << first;
  const std::string second = write_obj(without_unused_values(after_lines(source, {"delete f0"})));
  EXPECT_NE(second.find("\nvt 0 0\nvt 1 0\nvt 0 1\nvt 0.5 0.5\nvn 0 1 0\nf "), std::string::npos) << second;
  EXPECT_EQ(count(second, "/4/1 "), 1u) << second;
  EXPECT_EQ(count(write_obj(without_unused_values(after_lines(source, {"delete f0", "delete f1"}))), "\nvt "), 0u);
}

TEST(edited_file, faces_set_aside_and_lines_keep_their_texture_coordinates) {
  const MeshFile source =
      io_test::read_sound("obj", std::string(textured) + "vt 3 3\nvt 4 4\nf 1/7 1/7 2/7\nl 1/8 2/8\n");
  const MeshFile edited = without_unused_values(after_lines(source, {"delete f1"}));
  const MeshFile again = io_test::read_sound("obj", write_obj(edited));
  ASSERT_EQ(again.mesh.quarantine.size(), 1u);
  EXPECT_EQ(again.mesh.texcoords.pool[again.mesh.quarantine[0].texcoords.data()[0]], glm::dvec3(3, 3, 0));
  EXPECT_EQ(again.mesh.texcoords.pool[again.elements.texcoords[0]], glm::dvec3(4, 4, 0));
  EXPECT_EQ(again.mesh.texcoords.pool.size(), 6u);
}

TEST(edited_file, isolated_vertices_of_ply_keep_their_normals) {
  MeshFile source = io_test::read_sound(
      "ply",
      "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\n"
      "property float nx\nproperty float ny\nproperty float nz\nelement face 1\n"
      "property list uchar int vertex_indices\nend_header\n0 0 0 0 0 1\n1 0 0 0 1 0\n0 1 0 1 0 0\n1 1 0 0 0 -1\n"
      "3 0 1 2\n");
  source.format = find_format("ply");
  const MeshFile again = written_and_read_again(without_unused_values(source), "ply");
  ASSERT_EQ(again.mesh.normals.pool.size(), 4u);
  EXPECT_EQ(again.mesh.normals.pool[3], glm::dvec3(0, 0, -1));
}

TEST(edited_file, writes_wires_as_lines_that_come_back_once) {
  const MeshFile source = io_test::read_sound("obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 5 5 5\ng side\nf 1 2 3\n");
  const MeshFile file = after_lines(source, {"make_edge 3 2", "make_vertex 6,6,6", "make_edge 4 3"});
  const std::string written = write_obj(file);
  EXPECT_EQ(count(written, "\nl "), 2u) << written;
  EXPECT_EQ(count(written, "\nl 3 4\n"), 1u) << written;
  EXPECT_EQ(count(written, "\nl 4 5\n"), 1u) << written;
  EXPECT_EQ(io_test::loss_codes(file, "obj"), "loses_wires") << "reading gives lines back";
  const MeshFile again = io_test::read_sound("obj", written);
  ASSERT_EQ(again.elements.items.size(), 2u);
  EXPECT_TRUE(losses_of(again, *find_format("obj")).empty());
  EXPECT_EQ(again.elements.vertices, (std::vector<std::int64_t>{2, 3, 3, 4}));
  EXPECT_EQ(again.elements.items[0].group, no_index);
  EXPECT_EQ(write_obj(after_lines(again, {})), written) << "neither doubled nor lost";
  EXPECT_EQ(write_obj(after_lines(again, {"make_edge 2 3"})), written) << "a wire along a line is there already";
  EXPECT_EQ(again.mesh.groups.names, source.mesh.groups.names);
}

TEST(edited_file, wires_follow_their_ends_to_new_numbers) {
  const MeshFile source = io_test::read_sound("obj", "v 0 0 0\nv 9 9 9\nv 1 0 0\nv 0 1 0\nv 5 5 5\nf 1 3 4\nl 5 4\n");
  const std::string written = write_obj(after_lines(source, {"make_edge 4 0", "make_edge 3 4", "remove_vertex 1"}));
  EXPECT_EQ(count(written, "\nl "), 2u) << "the wire 3-4 lies along the line of the file: " << written;
  EXPECT_EQ(count(written, "\nl 4 3\n"), 1u) << written;
  EXPECT_EQ(count(written, "\nl 1 4\n"), 1u) << written;
}

TEST(edited_file, wires_are_listed_as_lost_in_every_format) {
  const MeshFile file = after_lines({}, {"make_vertex 0,0,0", "make_vertex 1,0,0", "make_edge 0 1"});
  for (const Format& format : formats()) {
    if (!format.write) continue;
    const std::vector<Loss> losses = losses_of(file, format);
    const auto wires =
        std::find_if(losses.begin(), losses.end(), [](const Loss& l) { return l.kind->code == "loses_wires"; });
    ASSERT_NE(wires, losses.end()) << format.id;
    EXPECT_EQ(wires->count, 1u);
    const Text text = wires->message(format.name).text;
    EXPECT_EQ(text.en.find("cannot hold") == std::string::npos, format.id == "obj") << text.en;
    EXPECT_EQ(text.ja.find("保持できません") == std::string::npos, format.id == "obj") << text.ja;
  }
}

}  // namespace
}  // namespace ryosen
