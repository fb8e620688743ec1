// Reading, saving and reading again, in every format and encoding, before and after edits.
#include "ryosen/indexed/from_indexed.h"
#include "ryosen/io/edited_file.h"
#include "ryosen/io/triangulated.h"
#include "ryosen/mesh/names.h"
#include "ryosen/ops/collapse_edge.h"
#include "ryosen/ops/split_edge.h"
#include "tests/support/core/all_targets.h"
#include "tests/unit/core/io/io_helpers.h"

namespace ryosen {
namespace {

// A sheet of triangles with faces that cannot be used, one per cause, in between.
constexpr std::string_view sheet_with_set_asides =
    "v 0 0 0\nv 1 0 0\nv 2 0.1 0\nv 0 1 0\nv 1 1 0.3\nv 2 1 0\nv 0 2 0\nv 1 2 0\nv 2 2 0\n"
    "f 1 2 5\nf 1 5 5\nf 1 5 4\nf 2 3 6\nf 2 6 99\nf 2 6 5\nf 4 5 8\nf 0 4 5\nf 4 8 7\nf 3 1\nf 5 6 9\nf 1 2 3 1\nf 5 "
    "9 8\n";

std::vector<std::string> causes(const MeshFile& file) {
  std::vector<std::string> out;
  for (const QuarantinedFace& face : file.mesh.quarantine) out.push_back(std::string(face.code));
  return out;
}

// What comes back from a file in this format.
MeshFile through_file(const MeshFile& file, const WriteOptions& target) {
  return io_test::read_sound(target.format->id, bytes_of(file, *target.format, target.encoding));
}

// The file with one edge collapsed and another one split.
MeshFile edited(MeshFile file) {
  const FileTables tables = file_tables(file.mesh);
  Mesh mesh = from_indexed(std::move(file.mesh));
  Journal journal;
  Edit edit(mesh, &journal);
  const auto find = [&](const glm::dvec3& from, const glm::dvec3& to) {
    for (std::uint32_t i = 0; i < mesh.halfedge_slots(); ++i) {
      const Halfedge h(i);
      if (mesh.is_alive(h) && mesh.position(mesh.from(h)) == from && mesh.position(mesh.to(h)) == to) return h;
    }
    return Halfedge();
  };
  const glm::dvec3 a(1, 2, 0), b(0, 2, 0), c(0, 0, 0), d(1, 0, 0);
  const CollapseEdge collapse{find(a, b)};
  EXPECT_TRUE(collapse.check(mesh).legal());
  collapse.apply(edit);
  const SplitEdge split{find(c, d)};
  EXPECT_TRUE(split.check(mesh).legal());
  split.apply(edit);
  edit.commit();
  return edited_file(file, mesh, tables);
}

TEST(round_trip, every_format_gives_back_what_it_holds) {
  const MeshFile source = io_test::read_sound("obj", sheet_with_set_asides);
  ASSERT_EQ(source.mesh.quarantine.size(), 5u);
  for (const WriteOptions& target : test::all_targets()) {
    SCOPED_TRACE(std::string(target.format->id) + " " + std::to_string(static_cast<int>(target.encoding)));
    const MeshFile first = through_file(source, target);
    EXPECT_EQ(io_test::difference(first, through_file(first, target)), "");
    const bool holds_all = holds(target.format->holds(target.encoding), Holds::quarantine);
    if (holds_all) {
      EXPECT_EQ(causes(first), causes(source));
      EXPECT_TRUE(io_test::same_bits(first.mesh.positions, source.mesh.positions));
      EXPECT_EQ(first.mesh.corners, source.mesh.corners);
    }
    // The faces that are kept, and those that the losses do not count.
    std::uint64_t lost = 0;
    for (const Loss& loss : losses_of(source, *target.format, target.encoding))
      lost += loss.kind->code == "loses_quarantined" ? loss.count : 0;
    EXPECT_EQ(first.mesh.face_count() + lost, source.mesh.face_count());
  }
}

TEST(round_trip, faces_that_were_set_aside_are_set_aside_for_the_same_cause_after_edits) {
  const MeshFile source = io_test::read_sound("obj", sheet_with_set_asides);
  for (const WriteOptions& target : test::all_targets()) {
    SCOPED_TRACE(std::string(target.format->id) + " " + std::to_string(static_cast<int>(target.encoding)));
    const MeshFile before = through_file(source, target);
    const MeshFile after = edited(before);
    EXPECT_EQ(after.mesh.positions.size(), before.mesh.positions.size()) << "one less, one more";
    const MeshFile again = through_file(after, target);
    EXPECT_EQ(causes(again), causes(before));
    EXPECT_EQ(again.mesh.face_count(), after.mesh.face_count());
    EXPECT_EQ(io_test::difference(again, through_file(again, target)), "");
  }
}

TEST(round_trip, a_face_with_too_few_corners_that_do_not_exist_is_no_facet) {
  const MeshFile file = io_test::read_sound("obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nf 1 99\n");
  EXPECT_EQ(io_test::loss_codes(file, "stl-ascii"), "loses_quarantined");
  MeshFile facets = file;
  facets.has_free_facets = true;
  EXPECT_EQ(io_test::loss_codes(facets, "stl-ascii"), "loses_quarantined");
  EXPECT_EQ(through_file(facets, *find_target("stl-ascii")).mesh.face_count(), 1u);
}

TEST(round_trip, colours_brighter_than_white_come_back_from_off) {
  const MeshFile file = io_test::read_sound("obj", "v 0 0 0 1 1.5 0.25\nv 1 0 0 0 0 0\nv 0 1 0 1 1 1\nf 1 2 3\n");
  EXPECT_EQ(io_test::loss_codes(file, "off"), "");
  EXPECT_EQ(io_test::difference_after_round_trip(file, "off"), "");
  const MeshFile huge = io_test::read_sound("obj", "v 0 0 0 1e308 1.5 0.25\nv 1 0 0 0 0 0\nv 0 1 0 1 1 1\nf 1 2 3\n");
  EXPECT_EQ(io_test::loss_codes(huge, "off"), "loses_exact_colours");
}

// OBJ has colours from 0 to 1, but many programs write bytes there.
TEST(round_trip, colours_of_obj_may_be_bytes) {
  const auto with = [](const std::string& first) {
    return io_test::read_sound("obj", "v 0 0 0 " + first + "\nv 1 0 0 0 0 0\nv 0 1 0 255 255 255\nf 1 2 3\n");
  };
  const MeshFile file = with("128 64 255");
  EXPECT_EQ(file.mesh.vertex_colours[0], glm::dvec4(128 / 255.0, 64 / 255.0, 1, 1));
  const auto text = [&](const char* format) { return bytes_of(file, *find_format(format), Encoding::ascii); };
  EXPECT_NE(text("obj").find("v 0 0 0 128 64 255\n"), std::string::npos) << text("obj");
  EXPECT_NE(text("off").find("0 0 0 128 64 255\n"), std::string::npos) << text("off");
  EXPECT_NE(text("ply").find("property uchar red\n"), std::string::npos) << text("ply");
  for (const char* format : {"obj", "off"}) EXPECT_EQ(io_test::difference_after_round_trip(file, format), "") << format;
  EXPECT_EQ(io_test::read_sound("ply", text("ply")).mesh.vertex_colours, file.mesh.vertex_colours);
  // No bytes: a part of one, too large, below zero, with alpha, no number.
  for (const char* first : {"128.5 64 255", "128 64 256", "-1 64 255", "128 64 255 0.5", "64 nan 255"})
    EXPECT_EQ(with(first).mesh.vertex_colours[2].x, 255) << first;
  MeshFile edited = file;
  edited.mesh.vertex_colours[0].x = 0.3;
  EXPECT_EQ(io_test::difference_after_round_trip(edited, "obj"), "") << "no byte any more";
  edited.mesh.vertex_colours.assign(3, glm::dvec4(0, 1 / 255.0, 0, 1));
  EXPECT_EQ(io_test::difference_after_round_trip(edited, "obj"), "") << "as bytes it would be read as 0 and 1";
}

TEST(round_trip, dark_colours_that_came_as_bytes_stay_dark) {
  MeshFile file = io_test::read_sound("off", "COFF\n3 1 0\n0 0 0 1 1 0\n1 0 0 0 0 0\n0 1 0 255 0 0\n3 0 1 2\n");
  file.mesh.vertex_colours[2] = glm::dvec4(0, 0, 0, 1);
  EXPECT_EQ(io_test::difference_after_round_trip(file, "off"), "");
}

TEST(round_trip, names_of_solids_may_hold_control_characters) {
  const MeshFile file =
      io_test::read_sound("obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\ng front\x12side\nf 1 2 3\ng back\nf 1 3 4\n");
  const MeshFile again = through_file(file, *find_target("stl-ascii"));
  EXPECT_EQ(again.mesh.groups.names, (std::vector<std::string>{"front\x12side", "back"}));
}

TEST(round_trip, a_list_that_would_seem_to_count_from_zero_leaves_out_what_makes_it_so) {
  const MeshFile file = io_test::read_sound("obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 0 2 3\nf 0 1 3\nf 1 2 3\n");
  EXPECT_EQ(io_test::loss_codes(file, "txt"), "loses_quarantined");
  EXPECT_EQ(through_file(file, *find_target("txt")).mesh.face_count(), 1u);
  const MeshFile with_last = io_test::read_sound("txt", "3 3\n0 0 0\n1 0 0\n0 1 0\n0 2 3\n0 1 3\n1 2 3\n");
  EXPECT_EQ(io_test::difference_after_round_trip(with_last, "txt"), "");
}

TEST(round_trip, a_comment_that_looks_like_another_file_does_not_head_binary_stl) {
  MeshFile file = io_test::read_sound("obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  for (const char* comment : {"\xff\xfe by hand", "OFF 3 1 0", "PK\x03\x04", "solid or not"}) {
    file.head_comments = {comment};
    SCOPED_TRACE(comment);
    const std::string bytes = bytes_of(file, *find_format("stl"), Encoding::binary_little);
    const auto format = recognise(bytes, {});
    ASSERT_TRUE(format.ok());
    EXPECT_EQ((*format)->id, "stl");
    const MeshFile again = io_test::read_sound("stl", bytes);
    EXPECT_EQ(again.mesh.face_count(), 1u);
    EXPECT_EQ(io_test::loss_codes(file, "stl-binary").empty(), again.head_comments == file.head_comments);
  }
}

TEST(round_trip, the_largest_number_stays_the_largest_when_vertices_are_added) {
  const MeshFile file = io_test::read_sound(
      "obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nf 1 2 9223372036854775806\nl 1 9223372036854775806\n");
  const FileTables tables = file_tables(file.mesh);
  Mesh mesh = from_indexed(file.mesh);
  Edit edit(mesh, nullptr);
  for (int i = 0; i < 5; ++i) edit.fresh(edit.add_vertex(glm::dvec3(i)));
  edit.commit();
  const MeshFile after = edited_file(file, mesh, tables);
  ASSERT_EQ(after.mesh.quarantine.size(), 1u);
  EXPECT_EQ(after.mesh.quarantine[0].corners[2], INT64_MAX);
  EXPECT_EQ(after.elements.vertices[1], INT64_MAX);
  EXPECT_EQ(io_test::loss_codes(after, "txt").find("loses_exact"), std::string::npos) << "the losses can be asked for";
  EXPECT_EQ(through_file(after, *find_target("txt")).mesh.quarantine.size(), 1u);
}

TEST(round_trip, numbers_beyond64_bits_come_to_rest_after_one_conversion) {
  for (const std::string number : {"9999999999999999999", "-9999999999999999999", "9223372036854775807",
                                   "-9223372036854775808", "9223372036854775806", "4294967296"}) {
    const std::vector<std::pair<std::string, std::string>> sources = {
        {"off", "OFF\n4 2 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 1 2\n3 0 1 " + number + "\n"},
        {"obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 2 3\nf 1 2 " + number + "\nl 1 " + number + "\n"},
        {"txt", "4 2\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n1 2 3\n1 2 " + number + "\n"},
        {"ply",
         "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\nelement face "
         "2\nproperty list uchar int vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 1 2\n3 0 1 " +
             number + "\n"}};
    for (const auto& [from, text] : sources) {
      const MeshFile file = io_test::read_sound(from, text);
      for (const char* to : {"obj", "off", "txt", "ply-ascii", "ply-little"}) {
        const WriteOptions target = *find_target(to);
        const std::string first = bytes_of(file, *target.format, target.encoding);
        const MeshFile again = through_file(file, target);
        EXPECT_EQ(bytes_of(again, *target.format, target.encoding), first) << number << ' ' << from << ' ' << to;
        ASSERT_EQ(again.mesh.quarantine.size(), 1u) << number << ' ' << from << ' ' << to;
        EXPECT_EQ(again.mesh.quarantine[0].code, "index_out_of_range");
      }
    }
  }
}

TEST(round_trip, what_reading_leaves_out_is_lost_in_every_format) {
  const auto expect = [](std::string_view id, const std::string& text, const std::string& codes, std::uint64_t count) {
    const MeshFile file = io_test::read_sound(id, text);
    EXPECT_EQ(io_test::loss_codes(file, "off"), codes) << text;
    EXPECT_EQ(io_test::loss_codes(file, id), codes) << text;
    for (const Loss& loss : losses_of(file, *find_format("off"))) {
      EXPECT_EQ(loss.count, count) << text;
      const Text said = loss.message(find_format("off")->name).text;
      EXPECT_NE(said.en.find("Reading left out"), std::string::npos) << said.en;
      EXPECT_EQ(said.ja.find("保持できません"), std::string::npos) << said.ja;
    }
    EXPECT_EQ(io_test::loss_codes(triangulated(file), id), codes);
    const std::string again = bytes_of(file, *find_format(id));
    EXPECT_EQ(io_test::loss_codes(io_test::read_sound(id, again), id), "") << again;
  };
  const std::string triangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
  expect("obj", triangle, "", 0);
  expect("obj", triangle + "vp 0 0\nsurf 0 1 0 1 1 2 3\ncurv 0 1 1 2\nvp 1 1\n", "loses_unread_lines", 4);
  std::string many = triangle;
  for (int i = 0; i < 40; ++i) many += "word" + std::to_string(i) + "\n";
  expect("obj", many, "loses_unread_lines", 40);
  const MeshFile stray = io_test::read_sound("obj", "vt 0 0\n" + triangle + "f 1/1 2/2 3/3\n");
  EXPECT_EQ(io_test::loss_codes(stray, "obj"), "loses_unread_values");
  EXPECT_EQ(stray.left_out.values, 2u);
  expect("obj", triangle + "v 2 2 2 1 1\n", "loses_unread_values", 1);
  expect("off", "OFF\n3 1 0\n0 0 0 7\n1 0 0\n0 1 0\n3 0 1 2\n", "loses_unread_values", 1);
  expect("off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n3 0 1 2\n3 0 1 2\n", "loses_unread_rest", 2);
  expect("txt", "3 1\n0 0 0\n1 0 0\n0 1 0\n1 2 3\n1 2 3\n", "loses_unread_rest", 1);
  const std::string head =
      "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\nelement face 1\n"
      "property list uchar int vertex_indices\nend_header\n";
  expect("ply", head + "0 0 0 9\n1 0 0\n0 1 0\n3 0 1 2\n", "loses_unread_values", 1);
  expect("ply", head + "0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n8\n", "loses_unread_rest", 1);
  const MeshFile sound = io_test::read_sound("obj", triangle);
  for (const char* id : {"stl-binary", "stl-ascii", "ply-little"}) {
    const WriteOptions target = *find_target(id);
    const std::string bytes = bytes_of(sound, *target.format, target.encoding) + "more";
    EXPECT_EQ(io_test::loss_codes(io_test::read_sound(target.format->id, bytes), "obj"), "loses_unread_rest") << id;
  }
}

}  // namespace
}  // namespace ryosen
