#include "ryosen/io/gzip.h"

#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include "tests/support/core/long_run.h"
#include "tests/unit/core/io/io_helpers.h"

namespace ryosen {
namespace {

using io_test::TemporaryFolder;
using io_test::whole_file;

constexpr std::string_view packed_obj = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";

std::string text_of(const Result<FileBytes>& bytes) {
  return bytes ? std::string(bytes->view()) : "refused: " + std::string(std::string_view(bytes.failure().message.code));
}

// The refusal of a file, which must say where in the packed file.
Failure refusal(std::string_view packed, std::uint64_t most = most_unpacked_bytes) {
  const Result<FileBytes> bytes = unpack_gzip(packed, most);
  EXPECT_FALSE(bytes.ok());
  if (bytes) return {};
  EXPECT_EQ(bytes.failure().exit_code, ExitCode::input_malformed);
  EXPECT_TRUE(bytes.failure().message.byte.has_value());
  EXPECT_FALSE(bytes.failure().message.text.ja.empty());
  return bytes.failure();
}

void put_file(const std::filesystem::path& path, std::string_view bytes) {
  std::ofstream(path, std::ios::binary).write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
}

// The code of the refusal of a file of this name and content, or the id of the format it was read as.
std::string read_as(std::string_view bytes, const std::string& name) {
  const TemporaryFolder folder;
  put_file(folder / name, bytes);
  const Result<MeshFile> file = read_mesh_file(folder / name);
  return std::string(file ? file->format->id : std::string_view(file.failure().message.code));
}

TEST(gzip, what_is_packed_comes_back) {
  std::string long_text;
  for (int i = 0; i < 100000; ++i) long_text += std::to_string(i * 7919 % 10007) + (i % 9 == 0 ? "\n" : " ");
  for (const std::string& text : {std::string(), std::string("x"), std::string(packed_obj), std::string(1 << 16, 'a'),
                                  std::string((1 << 17) + 1, '\0'), long_text}) {
    const std::string packed = pack_gzip(text);
    EXPECT_TRUE(is_gzip(packed));
    EXPECT_EQ(text_of(unpack_gzip(packed)), text);
    EXPECT_EQ(unpacked_head(packed, 5), text.substr(0, 5));
  }
}

TEST(gzip, a_packed_file_has_neither_time_nor_name) {
  const std::string packed = pack_gzip(packed_obj);
  EXPECT_EQ(packed, pack_gzip(packed_obj));
  EXPECT_EQ(packed.substr(3, 5), std::string(5, '\0')) << "flags and time";
}

TEST(gzip, members_follow_one_another) {
  const std::string packed = pack_gzip("one ") + pack_gzip("") + pack_gzip("two");
  EXPECT_EQ(text_of(unpack_gzip(packed)), "one two");
  EXPECT_EQ(text_of(unpack_gzip(packed + std::string(512, '\0'))), "one two") << "the last block of a tape";
}

TEST(gzip, damage_is_refused_with_its_place) {
  const std::string packed = pack_gzip(packed_obj);
  for (std::size_t size = 2; size < packed.size(); ++size) {
    const Failure cut = refusal(std::string_view(packed).substr(0, size));
    EXPECT_EQ(cut.message.code, "gzip_cut") << size;
    EXPECT_EQ(cut.message.byte, size);
  }
  const Failure more = refusal(packed + "hello");
  EXPECT_EQ(more.message.code, "gzip_extra_data");
  EXPECT_EQ(more.message.byte, packed.size());
  std::string other = packed;
  other[other.size() - 6] ^= 1;  // of the check sum
  EXPECT_EQ(refusal(other).message.code, "gzip_damaged");
  other = packed;
  other[other.size() - 2] ^= 1;  // of the size
  EXPECT_EQ(refusal(other).message.code, "gzip_damaged");
  other = packed;
  other[10] = '\x07';  // a block of no kind
  EXPECT_EQ(refusal(other).message.code, "gzip_damaged");
}

TEST(gzip, any_change_is_refused_or_changes_nothing) {
  const std::string packed = pack_gzip(io_test::whole_file(RYOSEN_SOURCE_DIR "/assets/torus.off"));
  const std::string text = text_of(unpack_gzip(packed));
  for (std::size_t at = 0; at < packed.size(); ++at) {
    std::string other = packed;
    other[at] = static_cast<char>(other[at] ^ (1 << at % 8));
    const Result<FileBytes> bytes = unpack_gzip(other);
    if (bytes) {  // in the head, or in bits that fill a byte
      EXPECT_EQ(bytes->view(), text) << at;
    } else {
      EXPECT_LE(bytes.failure().message.byte.value_or(~0u), other.size());
    }
  }
}

TEST(gzip, more_than_the_limit_is_refused_and_named) {
  const std::string packed = pack_gzip(std::string(100, 'x')), two = packed + packed;
  EXPECT_EQ(text_of(unpack_gzip(two, 200)).size(), 200u);
  EXPECT_EQ(refusal(two, 199).message.code, "gzip_too_large");
  const Failure large = refusal(pack_gzip(std::string(5 << 20, '\0')), 4 << 20);
  EXPECT_NE(large.message.text.en.find("4194304 bytes"), std::string::npos);
}

TEST(gzip, a_bomb_costs_no_memory) {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
  GTEST_SKIP() << "sanitizers take memory of their own";
#endif
  const std::size_t limit = std::size_t{test::is_long_run() ? 256u : 64u} << 20;
  const std::string member = pack_gzip(std::string(limit / 8, '0'));
  std::string bomb;
  for (int i = 0; i < 16; ++i) bomb += member;
  const auto peak_kib = [] {
    rusage usage{};
    ::getrusage(RUSAGE_SELF, &usage);
    return usage.ru_maxrss;
  };
  const pid_t child = ::fork();
  if (child == 0) {
    const long before = peak_kib();
    const Result<FileBytes> bytes = unpack_gzip(bomb, limit);
    const bool is_refused = !bytes && bytes.failure().message.code == "gzip_too_large";
    ::_exit(is_refused && peak_kib() - before < 8 << 10 ? 0 : 1);
  }
  int status = 0;
  ::waitpid(child, &status, 0);
  EXPECT_EQ(status, 0);
}

TEST(gzip, names_say_what_is_packed) {
  EXPECT_TRUE(has_gzip_name("a/b.OFF.Gz"));
  EXPECT_FALSE(has_gzip_name("a/b.gzx"));
  EXPECT_FALSE(has_gzip_name(".gz"));
  EXPECT_EQ(without_gzip("a.b/c.obj.gz"), "a.b/c.obj");
  EXPECT_EQ(without_gzip("c.obj"), "c.obj");
  EXPECT_EQ(format_of_extension("a.STL.GZ"), find_format("stl"));
  EXPECT_EQ(format_of_extension("a.gz"), nullptr);
}

TEST(gzip, every_format_is_read_and_written_packed) {
  const TemporaryFolder folder;
  const MeshFile file = io_test::read_sound("obj", packed_obj);
  for (const Format& format : formats()) {
    if (!format.write) continue;
    const std::filesystem::path path = folder / ("x" + std::string(format.extensions[0]) + ".gz");
    ASSERT_TRUE(write_mesh_file(path, file).ok()) << path;
    EXPECT_EQ(text_of(unpack_gzip(whole_file(path))), bytes_of(file, format));
    EXPECT_TRUE(may_be_mesh(path)) << path;
    const Result<MeshFile> again = read_mesh_file(path);
    ASSERT_TRUE(again.ok()) << path << again.failure().message.text.en;
    EXPECT_EQ(again->format, &format);
    EXPECT_EQ(again->mesh.corners, file.mesh.corners);
    for (const Message& message : again->messages) EXPECT_EQ(message.severity, Severity::info) << message.text.en;
  }
}

TEST(gzip, the_name_and_the_content_say_the_format) {
  const std::string packed = pack_gzip(packed_obj);
  EXPECT_EQ(read_as(packed, "a.obj.gz"), "obj");
  EXPECT_EQ(read_as(packed, "a.off.gz"), "obj") << "by its content, with a warning";
  EXPECT_EQ(read_as(packed, "a.gz"), "obj");
  EXPECT_EQ(read_as(packed, "a"), "obj") << "a name that says nothing";
  EXPECT_EQ(read_as(packed, "a.obj"), "compressed_file") << "a name that says it is not packed";
  EXPECT_EQ(read_as(packed, "a.stl.gz"), "content_mismatch");
  EXPECT_EQ(read_as(pack_gzip(packed), "a.obj.gz"), "compressed_twice");
  EXPECT_EQ(read_as(pack_gzip("PK\x03\x04"), "a.obj.gz"), "compressed_file");
  EXPECT_EQ(read_as(pack_gzip(""), "a.obj.gz"), "empty_file");
  EXPECT_EQ(read_as(packed.substr(0, 20), "a.obj.gz"), "gzip_cut");
  EXPECT_EQ(read_as(pack_gzip("hello\n"), "notes.txt.gz"), "unreadable_index")
      << "may_be_mesh passes it over in folders";
}

TEST(gzip, texts_that_are_no_meshes_are_told_by_what_is_packed) {
  const TemporaryFolder folder;
  put_file(folder / "notes.txt.gz", pack_gzip("hello 3 4\n"));
  put_file(folder / "list.txt.gz", pack_gzip("3 1\n0 0 0\n1 0 0\n0 1 0\n1 2 3\n"));
  put_file(folder / "cut.txt.gz", pack_gzip("3 1\n0 0 0\n").substr(0, 10));
  EXPECT_FALSE(may_be_mesh(folder / "notes.txt.gz"));
  EXPECT_TRUE(may_be_mesh(folder / "list.txt.gz"));
  EXPECT_FALSE(may_be_mesh(folder / "cut.txt.gz"));
}

TEST(gzip, places_are_those_of_what_is_packed) {
  const TemporaryFolder folder;
  put_file(folder / "a.obj.gz", pack_gzip("v 0 0 0\nv 1 x 0\n"));
  const Result<MeshFile> file = read_mesh_file(folder / "a.obj.gz");
  ASSERT_FALSE(file.ok());
  EXPECT_EQ(file.failure().message.line, 2u);
  EXPECT_EQ(file.failure().message.column, 5u);
}

TEST(gzip, a_name_that_says_it_where_nothing_is_packed_is_reported) {
  const TemporaryFolder folder;
  put_file(folder / "a.obj.gz", packed_obj);
  const Result<MeshFile> file = read_mesh_file(folder / "a.obj.gz");
  ASSERT_TRUE(file.ok());
  const Message* const message = io_test::find_message(*file, "content_mismatch");
  ASSERT_NE(message, nullptr);
  EXPECT_NE(message->text.en.find("gzip"), std::string::npos);
}

TEST(gzip, a_format_given_beside_the_name_is_packed_too) {
  const TemporaryFolder folder;
  const MeshFile file = io_test::read_sound("obj", packed_obj);
  ASSERT_TRUE(write_mesh_file(folder / "a.gz", file, *find_target("ply-ascii")).ok());
  EXPECT_EQ(read_as(whole_file(folder / "a.gz"), "b.gz"), "ply");
  ASSERT_TRUE(write_mesh_file(folder / "a.obj.gz", file, *find_target("off")).ok());
  EXPECT_TRUE(is_gzip(whole_file(folder / "a.obj.gz")));
}

}  // namespace
}  // namespace ryosen
