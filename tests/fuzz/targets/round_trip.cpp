// Any file that can be read, edited a little, goes through any format: what the list of losses does not name must come
// back, and what comes back must stay as it is from then on.
#include <array>

#include "ryosen/indexed/from_indexed.h"
#include "ryosen/io/edited_file.h"
#include "tests/fuzz/any_op.h"
#include "tests/fuzz/failure.h"
#include "tests/fuzz/reading.h"
#include "tests/fuzz/targets/targets.h"
#include "tests/support/core/all_targets.h"
#include "tests/support/core/file_difference.h"

namespace ryosen::fuzz {
namespace {

constexpr std::size_t choice_bytes = 12;  // the rest of an input is the file
constexpr std::size_t most_edits = 3;

void edit(MeshFile& file, Bytes& choices) {
  const FileTables tables = file_tables(file.mesh);
  Mesh mesh = from_indexed(std::move(file.mesh));
  for (std::size_t left = choices.below(most_edits + 1); left > 0; --left) {
    std::string read;
    const std::optional<AnyOp> op = any_op(mesh, choices, read);
    if (!op || !check(mesh, *op).legal()) continue;
    tell(command_of(mesh, *op));
    Edit edit(mesh, nullptr);
    apply(edit, *op);
    edit.commit();
  }
  file = edited_file(file, mesh, tables);
}

// The file with its vertices numbered as facets name them one after the other, as a format of facets gives them back.
MeshFile in_order_of_corners(MeshFile file) {
  IndexedMesh& mesh = file.mesh;
  std::vector<std::uint32_t> number(mesh.positions.size(), no_index);
  std::vector<glm::dvec3> positions;
  const auto renumber = [&](auto& corner) {
    std::uint32_t& own = number[static_cast<std::size_t>(corner)];
    if (own == no_index) {
      own = static_cast<std::uint32_t>(positions.size());
      positions.push_back(mesh.positions[static_cast<std::size_t>(corner)]);
    }
    corner = own;
  };
  auto aside = mesh.quarantine.begin();
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    if (aside != mesh.quarantine.end() && aside->face == f) {
      for (std::int64_t& corner : aside++->corners) renumber(corner);
      continue;
    }
    for (std::uint32_t i = mesh.face_offsets[f]; i < mesh.face_offsets[f + 1]; ++i) renumber(mesh.corners[i]);
  }
  mesh.positions = std::move(positions);
  return file;
}

void expect_nothing_lost(const MeshFile& file, const MeshFile& read, const WriteOptions& target) {
  MeshFile was = test::without_form(file);
  MeshFile is = test::without_form(read);
  if (!holds(target.format->holds(target.encoding), Holds::vertices)) was = in_order_of_corners(std::move(was));
  if (holds(target.format->holds(target.encoding), Holds::properties)) {
    was = test::as_in_ply(std::move(was));
    is = test::as_in_ply(std::move(is));
  }
  const std::string lost = test::difference(was, is);
  expect(lost.empty(), "differs without a word of loss: " + lost);
}

std::string bytes_in(const MeshFile& file, const WriteOptions& target) {
  return bytes_of(file, *target.format, target.encoding);
}

void send_through(const MeshFile& file, const WriteOptions& target) {
  tell("through " + std::string(target.format->id) + " " + std::to_string(static_cast<int>(target.encoding)));
  for (const Loss& loss : losses_of(file, *target.format, target.encoding))
    tell("loses " + std::string(loss.kind->code));
  const std::string first = bytes_in(file, target);
  if (is_telling()) tell(first);
  const std::optional<MeshFile> read = read_any(*target.format, first);
  // Without a point a face that was set aside has nothing but numbers past the end, whatever its cause was.
  if (file.mesh.positions.empty()) return;
  expect(read.has_value(), "what was written is not read");
  if (losses_of(file, *target.format, target.encoding).empty()) expect_nothing_lost(file, *read, target);
  const std::string second = bytes_in(*read, target);
  const std::optional<MeshFile> again = read_any(*target.format, second);
  expect(again.has_value(), "what was written again is not read");
  const std::string changed = test::difference(*read, *again);
  expect(changed.empty(), "differs after the second time: " + changed);
  expect(bytes_in(*again, target) == second, "the third file differs from the second:\n" + second);
}

void round_trip(Bytes choices, std::string_view bytes) {
  const Result<const Format*> format = recognise(bytes, {});
  if (!format.ok()) return;
  std::optional<MeshFile> file = read_any(**format, bytes);
  if (!file) return;
  file->format = *format;
  static const std::vector<WriteOptions> targets = test::all_targets();
  const WriteOptions& target = targets[choices.below(targets.size())];
  edit(*file, choices);
  send_through(*file, target);
}

}  // namespace

void fuzz_round_trip(Input input) {
  const std::size_t head = std::min(input.size(), choice_bytes);
  round_trip(Bytes(input.first(head)), Bytes(input.subspan(head)).rest());
}

}  // namespace ryosen::fuzz
