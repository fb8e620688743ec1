// Sequences of operators, undo, redo, previews, remedies and round trips through files on small meshes: every state
// must be sound, every refusal and every way back exact, every logged line replayable.
#include <algorithm>
#include <cmath>

#include "ryosen/analysis/figures.h"
#include "ryosen/base/enum_table.h"
#include "ryosen/geometry/is_finite.h"
#include "ryosen/indexed/from_indexed.h"
#include "ryosen/io/formats.h"
#include "ryosen/mesh/attribute.h"
#include "ryosen/mesh/attribute_text.h"
#include "ryosen/mesh/invariants.h"
#include "ryosen/ops/preview/preview.h"
#include "ryosen/ops/preview/remedy.h"
#include "tests/fuzz/any_op.h"
#include "tests/fuzz/failure.h"
#include "tests/fuzz/starts.h"
#include "tests/fuzz/targets/targets.h"
#include "tests/support/core/kernel_sum.h"

namespace ryosen::fuzz {
namespace {

constexpr std::size_t most_steps = 24;
constexpr std::uint32_t most_halfedges = 400;

std::string text_of_mesh(const Mesh& mesh) {
  const CompactMesh compact = to_indexed(mesh);
  std::string text = "mesh on points:";
  for (std::size_t f = 0; f < compact.mesh.face_count(); ++f) {
    text += " (";
    for (std::uint32_t corner : compact.mesh.face(f)) text += " " + std::to_string(corner);
    text += " )";
  }
  return text;
}

class Session {
 public:
  explicit Session(Start start) : mesh_(std::move(start.mesh)), tables_(std::move(start.tables)) {
    if (is_telling()) tell(text_of_mesh(mesh_));
    expect_sound("the start");
  }

  void step(Bytes& bytes) {
    switch (bytes.below(16)) {
      case 0:
        return undo();
      case 1:
        return redo();
      case 2:
        return save_and_read(bytes.below(formats().size()));
      case 3:
        return look_ahead(bytes);
      case 4:
        return change_attributes(bytes);
      default:
        return run(bytes);
    }
  }

  bool is_large() const { return mesh_.halfedge_slots() > most_halfedges; }

  // All the way back, forth and back.
  void finish() {
    const MeshColumns end = mesh_.columns();
    const std::size_t position = journal_.position();
    while (journal_.can_undo()) journal_.undo(mesh_);
    expect_sound("all undone");
    while (journal_.position() < position) journal_.redo(mesh_);
    expect(mesh_.columns() == end, "undoing and redoing all is not exact");
  }

 private:
  void expect_sound(const std::string& what) {
    const auto broken = check_invariants(mesh_);
    if (broken) fail(what + ": " + broken->rule + ": " + broken->sentence);
    const test::KernelSum sum = test::kernel_sum(mesh_);
    expect(sum.left() == sum.right() && sum.genus >= 0, what + ": the Euler-Poincaré sum does not hold");
  }

  void undo() {
    tell("undo");
    if (!journal_.can_undo()) return;
    const MeshColumns before = mesh_.columns();
    journal_.undo(mesh_);
    expect_sound("undo");
    journal_.redo(mesh_);
    expect(mesh_.columns() == before, "redo is not exact");
    journal_.undo(mesh_);
  }

  void redo() {
    tell("redo");
    if (!journal_.can_redo()) return;
    journal_.redo(mesh_);
    expect_sound("redo");
  }

  // Adds, removes or writes an attribute of any type and rule.
  void change_attributes(Bytes& bytes) {
    constexpr ElementKind kinds[] = {ElementKind::vertex, ElementKind::edge, ElementKind::corner, ElementKind::face};
    const std::size_t way = bytes.below(4);
    const std::vector<const AttributeColumn*> all = free_attributes(mesh_);
    Edit edit(mesh_, &journal_);
    if (way == 0 || all.empty()) {
      AttributeColumn column;
      column.element = kinds[bytes.below(4)];
      column.type = {static_cast<Scalar>(bytes.below(enum_count<Scalar>)),
                     static_cast<std::uint32_t>(1 + bytes.below(3))};
      column.rule = static_cast<ValueRule>(bytes.below(4));
      column.name = std::string(name_of(column.element)) + ".a" + std::to_string(mesh_.attributes().size());
      column.fill = value(column.type, bytes);
      tell("add " + words_of(column));
      edit.add_attribute(std::move(column));
    } else {
      const AttributeColumn& column = *all[bytes.below(std::min<std::size_t>(all.size(), 256))];
      const auto attribute = static_cast<std::size_t>(mesh_.find_attribute(column.name));
      const std::size_t rows = column.data.size() / column.words();
      tell((way == 1 ? "remove " : "set ") + column.name);
      if (way == 1) edit.remove_attribute(attribute);
      if (way > 1 && rows > 0)
        edit.set_attribute(attribute, static_cast<std::uint32_t>(bytes.below(std::min<std::size_t>(rows, 256))),
                           value(column.type, bytes));
    }
    edit.commit();
  }

  static std::vector<std::uint32_t> value(ValueType type, Bytes& bytes) {
    std::vector<std::uint32_t> words(type.words(), 0);
    auto* const at = reinterpret_cast<unsigned char*>(words.data());
    for (std::uint32_t i = 0; i < type.bytes(); ++i)
      at[i] = type.scalar == Scalar::boolean ? bytes.coin() : bytes.byte();
    // No word says which NaN a default is.
    if (is_floating(type.scalar) && value_text(type, words.data()).find("nan") != std::string::npos)
      std::fill(words.begin(), words.end(), 0u);
    return words;
  }

  // The line that the log would hold must do the same on another machine.
  void expect_replay(const std::string& line, std::uint64_t hash) {
    const ParsedOp parsed = parse_line(mesh_, line);
    expect(parsed.op.has_value(), "the logged line is not read: " + line + ": " + parsed.sentence.en);
    expect(check(mesh_, *parsed.op).legal(), "the logged line is refused: " + line);
    Edit edit(mesh_, &journal_);
    apply(edit, *parsed.op);
    expect(mesh_.hash() == hash, "the logged line does something else: " + line);
  }

  void run(Bytes& bytes) {
    std::string read;
    const std::optional<AnyOp> op = any_op(mesh_, bytes, read);
    if (!read.empty()) tell("read: " + read);
    if (!op) return;
    tell(by_slots(*op));
    const Verdict verdict = check(mesh_, *op);
    if (!verdict.legal()) return;
    const std::string line = command_of(mesh_, *op);
    tell("  = " + line);
    warnings(mesh_, *op);
    const MeshColumns before = mesh_.columns();
    {
      Edit edit(mesh_, &journal_);
      apply(edit, *op);
      edit.commit();
    }
    expect_sound(line);
    const MeshColumns after = mesh_.columns();
    const std::uint64_t hash = mesh_.hash();
    journal_.undo(mesh_);
    expect(mesh_.columns() == before, "undo is not exact: " + line);
    expect_replay(line, hash);
    expect(mesh_.columns() == before, "an edit that is not committed leaves a trace: " + line);
    journal_.redo(mesh_);
    expect(mesh_.columns() == after, "redo is not exact: " + line);
  }

  // A preview, or the way out of a refusal; the mesh and the redo list stay.
  void look_ahead(Bytes& bytes) {
    std::string read;
    const std::optional<AnyOp> op = any_op(mesh_, bytes, read);
    if (!op) return;
    tell("preview " + by_slots(*op));
    const MeshColumns before = mesh_.columns();
    const std::size_t position = journal_.position(), size = journal_.size();
    const Preview seen = preview(mesh_, journal_, *op);
    expect(mesh_.columns() == before && journal_.position() == position && journal_.size() == size,
           "a preview leaves a trace");
    if (seen.verdict.legal()) return;
    for (const std::string& line : find_remedy(mesh_, *op)) tell("  remedy: " + line);
    expect(mesh_.columns() == before, "the search for a remedy leaves a trace");
  }

  bool is_finite_all() const {
    for (const glm::dvec3& p : mesh_.positions())
      if (!is_finite(p)) return false;
    return true;
  }

  void save_and_read(std::size_t number) {
    const Format& format = formats()[number];
    constexpr Holds all_faces = Holds::polygons | Holds::vertices | Holds::quarantine;
    if (!format.write || !holds(format.holds(Encoding::automatic), all_faces)) return;
    tell("save and read " + std::string(format.id));
    MeshFile file;
    file.mesh = to_indexed(mesh_, tables_).mesh;
    const IndexedMesh& out = file.mesh;
    const std::string bytes = format.write(file, Encoding::automatic);
    Result<MeshFile> again = read_mesh(bytes, format);
    expect(again.ok(), "what was written is not read");
    const IndexedMesh& in = again->mesh;
    expect(in.positions.size() == out.positions.size(), "points are lost on the way through a file");
    expect(in.corners == out.corners && in.face_offsets == out.face_offsets, "faces change on the way through a file");
    expect(in.bridged == out.bridged, "bridged faces change on the way through a file");
    expect(in.quarantine.size() == out.quarantine.size(), "faces set aside change on the way through a file");
    const Mesh mesh = from_indexed(again->mesh);
    const auto broken = check_invariants(mesh);
    if (broken) fail("read again: " + broken->sentence);
    expect(mesh.live().faces == mesh_.live().faces, "faces are lost on the way through a file");
    if (!holds(format.holds(Encoding::automatic), Holds::properties)) return;
    for (const AttributeColumn& column : out.attributes)
      expect(std::count(in.attributes.begin(), in.attributes.end(), column) == 1,
             "an attribute changes on the way through a file: " + words_of(column));
  }

  Mesh mesh_;
  FileTables tables_;
  Journal journal_;
};

}  // namespace

void fuzz_ops(Input input) {
  Bytes bytes(input);
  const std::size_t number = bytes.below(start_count());
  tell("start " + std::to_string(number));
  Session session(start(number));
  for (std::size_t i = 0; i < most_steps && !bytes.at_end() && !session.is_large(); ++i) session.step(bytes);
  session.finish();
}

}  // namespace ryosen::fuzz
