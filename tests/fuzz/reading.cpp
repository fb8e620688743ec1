#include "tests/fuzz/reading.h"

#include "ryosen/analysis/figures.h"
#include "ryosen/analysis/problems.h"
#include "ryosen/indexed/from_indexed.h"
#include "ryosen/mesh/invariants.h"
#include "tests/fuzz/failure.h"

namespace ryosen::fuzz {
namespace {

void expect_told(const Message& message) {
  expect(!message.text.en.empty() && !message.text.ja.empty(), "a message says nothing");
}

// Every range and number of a list that from_indexed and the writers take for granted.
void expect_sound(const IndexedMesh& mesh) {
  expect(mesh.face_offsets.front() == 0 && mesh.face_offsets.back() == mesh.corners.size(), "face offsets are off");
  for (std::size_t f = 0; f < mesh.face_count(); ++f)
    expect(mesh.face_offsets[f] <= mesh.face_offsets[f + 1], "face offsets descend");
  for (std::uint32_t corner : mesh.corners) expect(corner < mesh.positions.size(), "a corner past the last vertex");
  std::optional<std::uint32_t> last;
  for (const QuarantinedFace& face : mesh.quarantine) {
    expect(!last || *last < face.face, "faces set aside are out of order");
    expect(face.face < mesh.face_count() && mesh.face(face.face).empty(), "a face is both kept and set aside");
    expect(!face.cause().en.empty() && !face.cause().ja.empty(), "a face is set aside without a cause");
    last = face.face;
  }
  for (const CornerValues* values : {&mesh.texcoords, &mesh.normals}) {
    expect(values->index.empty() || values->index.size() == mesh.corners.size(), "not one value per corner");
    for (std::uint32_t i : values->index) expect(i == no_index || i < values->pool.size(), "a value past the pool");
  }
  for (const FaceNames* names : {&mesh.materials, &mesh.groups, &mesh.objects, &mesh.smoothing}) {
    expect(names->index.empty() || names->index.size() == mesh.face_count(), "not one name per face");
    for (std::uint32_t i : names->index) expect(i == no_index || i < names->names.size(), "a name past the table");
  }
  expect(mesh.vertex_colours.empty() || mesh.vertex_colours.size() == mesh.positions.size(), "not one colour a vertex");
}

void connect(const MeshFile& file) {
  const Mesh mesh = from_indexed(file.mesh);
  if (const auto broken = check_invariants(mesh)) fail("connected: " + broken->sentence);
  expect(mesh.live().faces + file.mesh.quarantine.size() == file.mesh.face_count(), "kept and set aside are not all");
  for (const Problem& problem : find_problems(mesh, ProblemSets(mesh), {file.mesh.quarantine, file.mesh.face_lines}))
    expect(problem.count() > 0 && !problem.text.en.empty() && !problem.text.ja.empty(), "a problem says nothing");
  compute_figures(mesh);
}

}  // namespace

std::optional<MeshFile> read_any(const Format& format, std::string_view bytes) {
  Result<MeshFile> file = read_mesh(bytes, format);
  if (!file) {
    tell("refused: " + file.failure().message.text.en);
    expect_told(file.failure().message);
    expect(file.failure().exit_code == ExitCode::input_malformed, "a refusal with another exit code");
    return std::nullopt;
  }
  for (const Message& message : file->messages) expect_told(message);
  expect_sound(file->mesh);
  connect(*file);
  return std::move(*file);
}

}  // namespace ryosen::fuzz
