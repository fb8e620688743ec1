// Files that are not part of the project: malformed ones with the duty of a reader for each, and real meshes, whose
// figures tests/cli/check_truth_test.cpp compares. Without them these tests have nothing to do; the other tests of this
// folder cover the same ground.
#include <set>

#include "tests/unit/core/io/io_helpers.h"

namespace ryosen {
namespace {

namespace fs = std::filesystem;
using io_test::whole_file;

// The raw text of a value in a line of JSON without nested objects, without its quotes; empty if there is no such key.
std::string json_value(const std::string& line, const std::string& key) {
  const std::size_t found = line.find("\"" + key + "\":");
  if (found == std::string::npos) return "";
  std::size_t begin = found + key.size() + 3;
  while (line[begin] == ' ') ++begin;
  if (line[begin] == '"') return line.substr(begin + 1, line.find('"', begin + 1) - begin - 1);
  return line.substr(begin, line.find_first_of(",}", begin) - begin);
}

std::vector<std::string> json_lines(const fs::path& path) {
  std::vector<std::string> out;
  std::ifstream stream(path);
  for (std::string line; std::getline(stream, line);) out.push_back(line);
  return out;
}

// Rows whose warning is about the shape of the mesh, which the analysis finds and not the reader.
const std::set<std::string> found_by_analysis = {"obj_40_dup_face_same.obj", "obj_42_three_on_edge.obj",
                                                 "off_26_nonmanifold_edge_opposed.off"};

// Rows that name a line at which the file does not have what they speak of: the NaN is on line 13, the end on line 12.
const std::set<std::string> with_other_line = {"stla_06_nan.stl", "stla_02_truncated_facet.stl"};

bool is_at(const Message& message, const std::string& where) {
  if (where == "any") return message.line.has_value();
  if (where == "whole file") return !message.line && !message.byte && !message.face;
  const std::size_t space = where.find(' ');
  const std::uint64_t number = std::stoull(where.substr(space + 1));
  const std::string kind = where.substr(0, space);
  return kind == "line" ? message.line == number : kind == "byte" ? message.byte == number : message.face == number;
}

TEST(shared_files, malformed_files_get_what_they_must) {
  const fs::path folder = fs::path(RYOSEN_SHARED_DIR) / "malformed";
  for (const std::string& row : json_lines(folder / "manifest.jsonl")) {
    const std::string name = json_value(row, "file"), expect = json_value(row, "expect"),
                      where = with_other_line.contains(name) ? "any" : json_value(row, "where");
    if (!fs::exists(folder / name)) continue;
    SCOPED_TRACE(name);
    const Result<MeshFile> file = read_mesh_file(folder / name);
    ASSERT_EQ(file.ok(), expect != "error");
    if (!file) {
      EXPECT_EQ(file.failure().exit_code, ExitCode::input_malformed);
      EXPECT_TRUE(is_at(file.failure().message, where)) << file.failure().message.text.en;
      EXPECT_FALSE(file.failure().message.text.en.empty());
      EXPECT_FALSE(file.failure().message.text.ja.empty());
      continue;
    }
    EXPECT_EQ(std::to_string(file->mesh.positions.size()), json_value(row, "V"));
    EXPECT_EQ(std::to_string(file->mesh.face_count() - file->mesh.quarantine.size()), json_value(row, "F"));
    EXPECT_EQ(io_test::difference_after_round_trip(*file, file->format->id), "");
    if (expect == "ok" || found_by_analysis.contains(name)) {
      for (const Message& message : file->messages) EXPECT_EQ(message.severity, Severity::info) << message.text.en;
      continue;
    }
    const auto at_place = [&](const Message& message) { return is_at(message, where); };
    EXPECT_TRUE(std::any_of(file->messages.begin(), file->messages.end(), at_place)) << where;
  }
}

void read_and_write_again(const fs::path& folder) {
  for (const std::string& row : json_lines(folder / "truth.jsonl")) {
    const fs::path path = folder / json_value(row, "file");
    if (!fs::exists(path)) continue;
    SCOPED_TRACE(path);
    const Result<MeshFile> file = read_mesh_file(path);
    ASSERT_EQ(file.ok(), json_value(row, "status") == "ok") << (file ? "" : file.failure().message.text.en);
    if (!file) continue;
    EXPECT_EQ(io_test::difference_after_round_trip(*file, file->format->id), "");
  }
}

TEST(shared_files, real_meshes_are_the_same_once_written_and_read) {
  read_and_write_again(fs::path(RYOSEN_SHARED_DIR) / "meshes");
}

TEST(shared_files, known_meshes_are_the_same_once_written_and_read) {
  read_and_write_again(fs::path(RYOSEN_SHARED_DIR) / "meshes" / "known");
}

}  // namespace
}  // namespace ryosen
