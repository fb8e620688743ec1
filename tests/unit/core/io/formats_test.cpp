#include "ryosen/io/formats.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <atomic>

#include "ryosen/base/interruption.h"
#include "ryosen/io/gzip.h"
#include "tests/unit/core/io/io_helpers.h"

namespace ryosen {
namespace {

using io_test::TemporaryFolder;
using io_test::whole_file;

constexpr std::string_view obj_text = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
constexpr std::string_view off_text = "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";

// The id of the format that a file of this name and content is read as, or the code of the refusal.
std::string recognised(std::string_view bytes, const std::string& name) {
  const Result<const Format*> format = recognise(bytes, name);
  return format ? std::string((*format)->id) : std::string(format.failure().message.code);
}

TEST(formats, the_table_is_complete) {
  for (const Format& format : formats()) {
    EXPECT_EQ(find_format(format.id), &format);
    EXPECT_FALSE(format.name.en.empty());
    EXPECT_FALSE(format.name.ja.empty());
    ASSERT_FALSE(format.extensions.empty());
    for (const std::string_view extension : format.extensions) {
      EXPECT_EQ(format_of_extension("x" + std::string(extension)), &format);
    }
    EXPECT_NE(format.sniff, nullptr);
    EXPECT_NE(format.read, nullptr);
  }
  EXPECT_EQ(find_format("nosuch"), nullptr);
  EXPECT_EQ(format_of_extension("a.OBJ"), find_format("obj"));
  EXPECT_EQ(format_of_extension("obj"), nullptr);
}

TEST(formats, content_comes_before_the_name) {
  EXPECT_EQ(recognised(obj_text, "a.obj"), "obj");
  EXPECT_EQ(recognised(obj_text, "a"), "obj");
  EXPECT_EQ(recognised(obj_text, "a.off"), "obj");
  EXPECT_EQ(recognised(off_text, "a.obj"), "off");
  EXPECT_EQ(recognised("# c\n\nSTCNOFF\n", "a"), "off");
  EXPECT_EQ(recognised("# only a comment\n", "a.off"), "off");
  EXPECT_EQ(recognised("# only a comment\n", "a.obj"), "obj");
  EXPECT_EQ(recognised("3 1\n", "a.off"), "off");
  EXPECT_EQ(recognised("g a\n", "a"), "obj");
  EXPECT_EQ(recognised("mtllib a.mtl\n", "a"), "obj");
  EXPECT_EQ(recognised("hello\n", "a"), "unknown_format");
  EXPECT_EQ(recognised("v for vendetta\n", "a"), "obj");
  EXPECT_EQ(recognised("vector\n", "a"), "unknown_format");
}

TEST(formats, several_formats_that_begin_alike) {
  EXPECT_EQ(recognised("ply\r\nformat", "a"), "ply");
  EXPECT_EQ(recognised("plywood\n", "a"), "unknown_format");
  EXPECT_EQ(recognised("  SOLID a b\n\nFacet normal", "a"), "stl");
  EXPECT_EQ(recognised("solid\nendsolid\n", "a"), "stl");
  EXPECT_EQ(recognised("solid rock\nis hard\n", "a"), "unknown_format");
  EXPECT_EQ(recognised("solid", "a"), "stl");
  std::string binary = "solid, but binary";
  binary.resize(80, '\0');
  binary += std::string("\1\0\0\0", 4) + std::string(50, '\0');
  EXPECT_EQ(recognised(binary, "a.obj"), "stl");
  EXPECT_EQ(recognised(binary + "x", "a"), "binary_content");
  EXPECT_EQ(recognised(binary + "x", "a.stl"), "stl") << "cut or longer";
  EXPECT_EQ(recognised("3 1\n0 0 0\n", "a.off"), "txt");
  EXPECT_EQ(recognised("3 1\n", "a"), "txt");
  EXPECT_EQ(recognised("3 1\n0 0\n", "a"), "unknown_format");
  EXPECT_EQ(recognised("3 1 0\n0 0 0\n", "a"), "xyz");
  EXPECT_EQ(recognised(obj_text, "a.stl"), "content_mismatch");
  EXPECT_EQ(recognised(obj_text, "a.txt"), "obj");
}

TEST(formats, targets_by_name) {
  EXPECT_EQ(find_target("off")->format, find_format("off"));
  EXPECT_EQ(find_target("ply")->encoding, Encoding::automatic);
  EXPECT_EQ(find_target("ply-big")->encoding, Encoding::binary_big);
  EXPECT_EQ(find_target("stl-ascii")->format, find_format("stl"));
  EXPECT_FALSE(find_target("nosuch"));
  MeshFile file;
  EXPECT_EQ(encoding_of(file, *find_format("obj")), Encoding::automatic);
  EXPECT_EQ(encoding_of(file, *find_format("stl")), Encoding::binary_little);
  file.encoding = Encoding::ascii;
  EXPECT_EQ(encoding_of(file, *find_format("stl")), Encoding::ascii);
  file.encoding = Encoding::binary_big;
  EXPECT_EQ(encoding_of(file, *find_format("stl")), Encoding::binary_little);
  EXPECT_EQ(encoding_of(file, *find_format("ply")), Encoding::binary_big);
  EXPECT_EQ(encoding_of(file, *find_format("ply"), Encoding::ascii), Encoding::ascii);
}

TEST(formats, every_kind_of_bad_content_has_its_code) {
  using namespace std::string_view_literals;
  EXPECT_EQ(recognised("", "a.obj"), "empty_file");
  EXPECT_EQ(recognised("\x1f\x8b\x08\0\0\x01\x02"sv, "a.obj"), "compressed_file");
  EXPECT_EQ(recognised("PK\x03\x04", "a.off"), "compressed_file");
  EXPECT_EQ(recognised("\xff\xfev\0 \0000\0"sv, "a.obj"), "utf16");
  EXPECT_EQ(recognised("\xfe\xff\0v"sv, "a.obj"), "utf16");
  EXPECT_EQ(recognised("v\0 \0000\0 \0000\0 \0000\0\n\0"sv, "a.obj"), "utf16");
  EXPECT_EQ(recognised(std::string(4096, '\0'), "a.obj"), "zeros");
  EXPECT_EQ(recognised("ab\x01\x02\x03\0\xff"sv, "a.obj"), "binary_content");
  EXPECT_EQ(recognised("hello\0world"sv, "a.obj"), "nul_byte");
  EXPECT_EQ(recognised("x\n", "a.glb"), "unsupported_format");
}

TEST(formats, paths_that_cannot_be_read_have_their_codes) {
  const TemporaryFolder folder;
  const auto code = [](const std::filesystem::path& path) {
    const Result<MeshFile> file = read_mesh_file(path);
    EXPECT_FALSE(file.ok()) << path;
    EXPECT_EQ(file.failure().exit_code, ExitCode::input_missing) << path;
    EXPECT_FALSE(file.failure().message.text.ja.empty());
    return std::string(file.failure().message.code);
  };
  EXPECT_EQ(code(folder / "gone.obj"), "input_missing");
  EXPECT_EQ(code(folder.path()), "input_is_folder");
  std::ofstream(folder / "file.obj") << obj_text;
  EXPECT_EQ(code(folder / "file.obj/x.obj"), "input_missing");
  if (::geteuid() == 0) return;
  std::filesystem::permissions(folder / "file.obj", std::filesystem::perms::none);
  EXPECT_EQ(code(folder / "file.obj"), "input_unreadable");
}

TEST(formats, reads_and_writes_by_name) {
  const TemporaryFolder folder;
  std::ofstream(folder / "in.obj") << obj_text;
  const Result<MeshFile> file = read_mesh_file(folder / "in.obj");
  ASSERT_TRUE(file.ok());
  EXPECT_EQ(file->format, find_format("obj"));
  ASSERT_TRUE(write_mesh_file(folder / "out.OFF", *file).ok());
  EXPECT_EQ(whole_file(folder / "out.OFF"), off_text);
  WriteOptions options;
  options.format = find_format("obj");
  ASSERT_TRUE(write_mesh_file(folder / "out.txt", *file, options).ok());
  EXPECT_EQ(whole_file(folder / "out.txt"), obj_text);
  const Status nameless = write_mesh_file(folder / "out", *file);
  ASSERT_FALSE(nameless.ok());
  EXPECT_EQ(nameless.failure().exit_code, ExitCode::usage);
  const Status nowhere = write_mesh_file(folder / "no/out.obj", *file);
  ASSERT_FALSE(nowhere.ok());
  EXPECT_EQ(nowhere.failure().exit_code, ExitCode::output_not_writable);
  EXPECT_EQ(folder.entry_count(), 3u);
}

TEST(formats, a_name_that_says_another_format_is_reported) {
  const TemporaryFolder folder;
  std::ofstream(folder / "a.obj") << off_text;
  const Result<MeshFile> file = read_mesh_file(folder / "a.obj");
  ASSERT_TRUE(file.ok());
  EXPECT_EQ(file->format, find_format("off"));
  EXPECT_NE(io_test::find_message(*file, "content_mismatch"), nullptr);
}

// A format that is only read: a word and how many triangles lie on each other.
Format stack_format() {
  Format format;
  format.id = "stack";
  format.name = {"stack of triangles", "三角形の山"};
  format.extensions = {".stack"};
  format.sniff = [](std::string_view head, std::uint64_t) {
    return head.starts_with("stack ") ? Likeness::sure : Likeness::no;
  };
  format.read = [](std::string_view bytes, const std::filesystem::path&) -> Result<MeshFile> {
    MeshFile file;
    file.mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    for (char count = '0'; count < bytes[6]; ++count) {
      for (const std::uint32_t v : {0u, 1u, 2u}) file.mesh.corners.push_back(v);
      file.mesh.face_offsets.push_back(static_cast<std::uint32_t>(file.mesh.corners.size()));
    }
    return file;
  };
  return format;
}

TEST(formats, one_that_is_only_read_is_a_row_like_any_other) {
  const TemporaryFolder folder;
  std::ofstream(folder / "a.stack") << "stack 2\n";
  const std::size_t rows = formats().size();
  const Format* const first = &formats()[0];
  EXPECT_EQ(recognised("stack 2\n", "a.stack"), "unknown_format");
  EXPECT_FALSE(may_be_mesh(folder / "a.stack"));
  {
    const ScopedFormat added(stack_format());
    EXPECT_EQ(formats().size(), rows + 1);
    EXPECT_EQ(&formats()[0], first) << "rows stay where they are";
    EXPECT_EQ(recognised("stack 2\n", "a"), "stack");
    EXPECT_TRUE(may_be_mesh(folder / "a.stack"));
    EXPECT_EQ(find_target("stack")->format, &added.row());
    const Result<MeshFile> file = read_mesh_file(folder / "a.stack");
    ASSERT_TRUE(file.ok());
    EXPECT_EQ(file->format, &added.row());
    EXPECT_EQ(file->mesh.face_count(), 2u);
    for (const Status& status :
         {write_mesh_file(folder / "b.stack", *file), write_mesh_file(folder / "b.stack.gz", *file),
          write_mesh_file(folder / "b.obj", *file, {&added.row()})}) {
      ASSERT_FALSE(status.ok());
      EXPECT_EQ(status.failure().exit_code, ExitCode::usage);
      EXPECT_EQ(status.failure().message.code, "unknown_format");
      EXPECT_NE(status.failure().message.text.en.find("stack of triangles are only read"), std::string::npos);
    }
    EXPECT_TRUE(write_mesh_file(folder / "b.obj", *file).ok()) << "another format holds it";
    EXPECT_EQ(folder.entry_count(), 2u);
  }
  EXPECT_EQ(formats().size(), rows);
  EXPECT_EQ(find_format("stack"), nullptr);
}

TEST(formats, a_refused_file_says_what_it_was_taken_for) {
  const TemporaryFolder folder;
  std::ofstream(folder / "a.obj") << "v x\n";
  const Format* taken_for = nullptr;
  EXPECT_FALSE(read_mesh_file(folder / "a.obj", &taken_for).ok());
  EXPECT_EQ(taken_for, find_format("obj"));
  EXPECT_FALSE(read_mesh_file(folder / "gone.obj", &taken_for).ok());
  EXPECT_EQ(taken_for, nullptr);
}

TEST(formats, own_files_come_back_the_same_in_every_format_that_holds_them) {
  std::size_t files = 0;
  for (const auto& entry : std::filesystem::directory_iterator(RYOSEN_SOURCE_DIR "/tests/data/io")) {
    const Result<MeshFile> file = read_mesh_file(entry.path());
    ASSERT_TRUE(file.ok()) << entry.path();
    ++files;
    for (const Format& format : formats()) {
      if (!format.write || (&format != file->format && !losses_of(*file, format).empty())) continue;
      if (&format == file->format) {
        EXPECT_EQ(io_test::difference_after_round_trip(*file, format.id), "") << entry.path();
        continue;
      }
      const Result<MeshFile> again = io_test::read_text(format.id, bytes_of(*file, format));
      ASSERT_TRUE(again.ok()) << entry.path() << " as " << format.id;
      EXPECT_EQ(io_test::difference(io_test::without_form(*file), io_test::without_form(*again)), "")
          << entry.path() << " as " << format.id;
    }
  }
  EXPECT_GE(files, 4u);
}

// Not at the end of what is going on: that may be seconds away.
TEST(formats, reading_that_nobody_wants_ends_within_a_stage) {
  const Result<MeshFile> bunny = read_mesh_file(RYOSEN_SOURCE_DIR "/assets/stanford_bunny.obj");
  ASSERT_TRUE(bunny.ok());
  const std::atomic<bool> is_unwanted = true;
  for (const char* const id : {"obj", "off"}) {
    const Format& format = *find_format(id);
    const std::string bytes = bytes_of(*bunny, format);
    const Interruptible reading(&is_unwanted);
    EXPECT_THROW(static_cast<void>(read_mesh(bytes, format, "bunny")), Interrupted) << id;
    EXPECT_THROW(static_cast<void>(unpack_gzip(pack_gzip(bytes))), Interrupted) << id;
  }
}

}  // namespace
}  // namespace ryosen
