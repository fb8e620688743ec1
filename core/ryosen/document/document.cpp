#include "ryosen/document/document.h"

#include <algorithm>
#include <atomic>
#include <cassert>
#include <new>
#include <unordered_map>
#include <unordered_set>
#include <utility>

#include "ryosen/algo/duplicate/part.h"
#include "ryosen/algo/repair/recipe.h"
#include "ryosen/base/count_text.h"
#include "ryosen/document/outcome.h"
#include "ryosen/indexed/from_indexed.h"
#include "ryosen/io/edited_file.h"
#include "ryosen/io/file_target.h"
#include "ryosen/io/safe_write.h"
#include "ryosen/mesh/copies.h"

namespace ryosen {

namespace {

// Whether an argument is not syntactically an element name (a number or keyword).
bool is_value(std::string_view argument) {
  return find_vertex(Mesh(), argument).error == NameError::malformed &&
         find_edge(Mesh(), argument).error == NameError::malformed &&
         find_face(Mesh(), argument).error == NameError::malformed;
}

// As names_of, but distinguishes the copies of a point, unless all its copies are included: then the point is named.
std::vector<std::string> names_with_copies(const Mesh& mesh, const std::vector<Element>& elements) {
  std::unordered_set<std::uint32_t> vertices;
  for (const Element& element : elements)
    if (element.kind == Element::Kind::vertex) vertices.insert(element.index);
  std::unordered_map<Vertex, bool> known;
  const auto is_whole = [&](Vertex v) {
    const auto [entry, is_new] = known.try_emplace(point(mesh, v));
    if (is_new) entry->second = !any_of_copies(mesh, v, [&](Vertex copy) { return !vertices.contains(copy.index); });
    return entry->second;
  };
  std::vector<std::string> names;
  for (const Element& element : elements) {
    const bool is_copy = element.kind == Element::Kind::vertex && has_copies(mesh, element.vertex());
    if (!is_copy)
      names.push_back(name_of(mesh, element));
    else if (!is_whole(element.vertex()))
      names.push_back(name_of_copy(mesh, element.vertex()));
    else if (element.vertex() == point(mesh, element.vertex()))
      names.push_back(name_of(mesh, element));
  }
  return names;
}

// Whether the coordinates are of type float: those of a binary STL file, and of a PLY file whose properties are. A
// binary PLY file with other types has none. Not known for texts, whose digits alone tell it, and other files.
std::optional<bool> holds_float_coordinates(const MeshFile& file) {
  const bool is_binary = file.encoding == Encoding::binary_little || file.encoding == Encoding::binary_big;
  if (!file.properties.has_layout()) {
    if (is_binary && file.format && file.format->id == "stl") return true;
    return std::nullopt;
  }
  bool are_floats = true;
  for (const PropertyTable& table : file.properties.tables)
    for (const Property& property : table.properties)
      if (property.role == PropertyRole::position) are_floats = are_floats && property.type == Scalar::float32;
  if (are_floats || is_binary) return are_floats;
  return std::nullopt;
}

std::uint64_t next_serial() {
  static std::atomic<std::uint64_t> last = 0;
  return ++last;
}

}  // namespace

Document::Document() : Document(MeshFile()) {}

Document::Document(MeshFile file, std::filesystem::path path)
    : tables_(take_file_tables(file.mesh)), path_(std::move(path)), serial_(next_serial()) {
  mesh_ = from_indexed(std::move(file.mesh));
  file.mesh = {};
  file_ = std::move(file);
}

Result<std::unique_ptr<Document>> Document::open(const std::filesystem::path& path) {
  const FileState on_disk = FileState::of(path);  // before, so that what changes meanwhile is noticed
  Result<MeshFile> file = read_mesh_file(path);
  if (!file) return file.failure();
  auto document = std::make_unique<Document>(std::move(file).value(), path);
  document->on_disk_ = on_disk;
  return document;
}

Outcome Document::refuse(const std::string& command, std::vector<Reason> reasons) {
  Outcome outcome;
  outcome.kind = Outcome::Kind::refused;
  outcome.exit_code = ExitCode::refused;
  outcome.sentence = join(describe_first(mesh_, reasons));
  outcome.sentence.en = command + " is refused: " + outcome.sentence.en;
  outcome.sentence.ja = command + " は実行できません：" + outcome.sentence.ja;
  outcome.reasons = std::move(reasons);
  return outcome;
}

Outcome Document::apply(const AnyOp& op, bool strict, std::string command) {
  Preview before = preview(op);
  if (command.empty()) command = command_of(mesh_, op);
  if (!before.verdict.legal()) return refuse(command, std::move(before.verdict.reasons));
  if (strict && !before.warnings.empty()) return refuse(command, std::move(before.warnings));
  if (const auto fault = fault_of_values(mesh_, op)) {
    const std::string id(info_of(op).id);
    return failed(ExitCode::usage, {id + ": " + fault->en, id + "：" + fault->ja});
  }
  Outcome outcome;
  outcome.warnings = std::move(before.warnings);
  outcome.deleted = names_with_copies(mesh_, before.deleted);
  {
    Edit edit(writable(), &journal_);
    ryosen::apply(edit, op);
    outcome.created = names_with_copies(mesh_, before.created);
    make_room_in_history();
    edit.commit();
  }
  committed({std::move(command)});
  return outcome;
}

std::optional<EachResult> Document::apply_to_each(const OpInfo& op, std::span<const Element> elements,
                                                  std::span<const std::string_view> arguments, std::string command,
                                                  bool strict, Progress::Report report) {
  EachResult result;
  {
    Progress progress(std::move(report));
    Edit edit(writable(), &journal_);
    result = ryosen::apply_to_each(edit, op, elements, arguments, strict, progress);
    if (progress.is_cancelled()) return std::nullopt;
    if (result.done == 0 || result.error != NameError::none) return result;
    make_room_in_history();
    edit.commit();
  }
  committed({std::move(command)});
  return result;
}

AlgorithmResult Document::run_in(Edit& edit, const AlgorithmRow& row, const ParameterValues& values,
                                 AlgorithmWants wants, Progress& progress) const {
  const std::vector<Vertex> used = used_beside_the_mesh(file_, tables_.quarantine, mesh_.file_vertices());
  const std::vector<Vertex> on_lines = vertices_on_lines(file_, mesh_.file_vertices());
  FindingCounts counts{};
  if (row.is_repair()) counts = count_findings(mesh_, on_lines);
  return run_guarded(edit, row,
                     {values, used, tables_.quarantine.size(), on_lines, wants, holds_float_coordinates(file_)},
                     progress, counts);
}

std::optional<AlgorithmResult> Document::run(const AlgorithmRow& row, const ParameterValues& values,
                                             std::string command, Progress::Report report, AlgorithmWants wants) {
  AlgorithmResult result;
  OtherQuarantine other;
  HistoryEntry entry{std::move(command)};
  Mesh& mesh = writable();
  Descent descent = wants.descent && row.lineage == Lineage::told ? Descent(mesh) : Descent();
  {
    Progress progress(std::move(report));
    Edit edit(mesh, &journal_, &descent);
    result = run_in(edit, row, values, wants, progress);
    if (progress.is_cancelled()) return std::nullopt;
    if (result.changed == 0) return result;
    if (result.drops_quarantined) other[journal_.position()];
    entry.has_normals = result.has_normals;
    entry.lineage = row.lineage;
    if (descent.is_recording()) entry.descent = std::make_shared<const Descent>(std::move(descent));
    make_room_in_history();
    edit.commit();
  }
  committed(std::move(entry), std::move(other));
  return result;
}

std::optional<AlgorithmResult> Document::goal_report_of(const AlgorithmRow& row, const ParameterValues& values,
                                                        Progress::Report report) {
  Mesh mesh = is_on_trial() ? without_trial() : before_last_entry();
  const ReadValues found = values.on(mesh);
  if (!found.values) return std::nullopt;
  const std::vector<Vertex> used = used_beside_the_mesh(file_, tables_.quarantine, mesh_.file_vertices());
  const std::vector<Vertex> on_lines = vertices_on_lines(file_, mesh_.file_vertices());
  Progress progress(std::move(report));
  Edit edit(mesh, nullptr);
  AlgorithmResult result =
      row.run(edit, {*found.values, used, tables_.quarantine.size(), on_lines, {.edge_rules = true}}, progress);
  if (progress.is_cancelled()) return std::nullopt;
  return result;
}

BesideRepairs Document::beside_repairs() const {
  const std::size_t vertices = mesh_.file_vertices();
  return {tables_.quarantine, used_beside_the_mesh(file_, tables_.quarantine, vertices),
          used_beside_the_mesh(file_, {}, vertices), vertices_on_lines(file_, vertices),
          holds_float_coordinates(file_)};
}

std::optional<RecipeResult> Document::run(std::span<const RecipeStep> recipe, std::string command,
                                          const RecipeEvents& events) {
  const BesideRepairs beside = beside_repairs();
  std::optional<RecipeResult> result = run_recipe(mesh_, recipe, beside.input(), events);
  if (!result || !result->is_changed) return result;
  OtherQuarantine other;
  {
    Edit edit(writable(), &journal_);
    edit.replace(std::move(result->mesh).columns(), result->descent);
    if (result->drops_quarantined) other[journal_.position()];
    make_room_in_history();
    edit.commit();
  }
  result->mesh = Mesh();
  committed({std::move(command)}, std::move(other));
  return result;
}

Text Document::append(MeshFile file, std::string command) {
  const std::size_t unusable = file.mesh.quarantine.size(), lines = file.elements.items.size();
  const bool has_values = !file.mesh.texcoords.index.empty() || !file.mesh.normals.index.empty() ||
                          (!file.mesh.vertex_colours.empty() && !find_column(mesh_, attribute_names::colour)) ||
                          !file.mesh.materials.index.empty();
  const bool has_attributes =
      std::any_of(file.mesh.attributes.begin(), file.mesh.attributes.end(), [&](const AttributeColumn& column) {
        const AttributeColumn* const same = find_column(mesh_, column.name);
        return !same || same->type != column.type;
      });
  file.mesh.quarantine.clear();
  const Mesh added = from_indexed(std::move(file.mesh));
  Part part = part_of(added, all_elements(added));
  {
    Edit edit(writable(), &journal_);
    add_part(edit, std::move(part), false);
    make_room_in_history();
    edit.commit();
  }
  committed({std::move(command)});
  Text left_out;
  const auto say = [&](bool is_so, const char* en, const char* ja) {
    if (!is_so) return;
    left_out.en += (left_out.en.empty() ? "Left out of that file: " : ", ") + std::string(en);
    left_out.ja += (left_out.ja.empty() ? "追加しなかったもの：" : "、") + std::string(ja);
  };
  say(has_values, "texture coordinates, normals, colours and materials", "テクスチャ座標・法線・色・材質");
  say(has_attributes, "attributes that this mesh does not have", "このメッシュにない属性");
  say(lines > 0, "lines and points", "線と点");
  say(unusable > 0, "faces that cannot be used", "使えない面");
  return left_out.en.empty() ? left_out : left_out + Text{".", "。"};
}

MeshFile Document::part(std::span<const Element> elements) const {
  assert(!is_on_trial() && "the elements are of the mesh without it");
  Part taken = part_of(mesh_, elements, tables_);
  MeshFile file;
  file.mesh = std::move(taken.list);
  file.wires = std::move(taken.wires);
  file.format = file_.format;
  file.encoding = file_.encoding;
  file.material_libraries = file_.material_libraries;
  return file;
}

std::optional<Text> Document::quarantine_text(std::span<const std::string_view> arguments) const {
  return ryosen::quarantine_text(tables_.quarantine, arguments);
}

bool Document::is_known(std::string_view name) const {
  const auto finds = [](NameError error) { return error == NameError::none || error == NameError::ambiguous; };
  return finds(find_edge(mesh_, name).error) || finds(find_vertex(mesh_, name).error) ||
         finds(find_face(mesh_, name).error);
}

bool Document::are_known(std::span<const std::string_view> names) const {
  return std::all_of(names.begin(), names.end(), [&](std::string_view name) { return is_known(name); });
}

Document::Elsewhere Document::exists_elsewhere(NameError error, std::span<const std::string_view> arguments) {
  if (arguments.empty() || quarantine_text(arguments)) return Elsewhere::no;
  if (error == NameError::deleted) return Elsewhere::earlier;
  if (error != NameError::never_existed) return Elsewhere::no;
  std::vector<std::string_view> missing;
  for (std::string_view name : arguments)
    if (!is_known(name) && !is_value(name)) missing.push_back(name);
  if (missing.empty()) return Elsewhere::no;
  const std::size_t now = journal_.position();
  const auto go_back = [&] {  // the way back needs no memory
    while (journal_.position() < now) journal_.redo(writable());
    while (journal_.position() > now) journal_.undo(writable());
  };
  Elsewhere found = Elsewhere::no;
  try {
    while (found == Elsewhere::no && journal_.can_undo()) {
      journal_.undo(writable());
      if (are_known(missing)) found = Elsewhere::earlier;
    }
    go_back();
    while (found == Elsewhere::no && journal_.can_redo()) {
      journal_.redo(writable());
      if (are_known(missing)) found = Elsewhere::later;
    }
  } catch (const std::bad_alloc&) {
    go_back();
    throw;
  }
  go_back();
  return found;
}

MeshFile Document::contents() const {
  MeshFile file = is_on_trial() ? edited_file(file_, without_trial(), tables_) : edited_file(file_, mesh_, tables_);
  if (position() != 0) drop_unused_values(file);
  return file;
}

MeshFile Document::contents_as_read() const {
  Mesh mesh = without_trial();
  for (Journal journal = journal_; journal.can_undo();) journal.undo(mesh);
  FileTables tables = tables_;
  if (const auto first = other_quarantine_.begin(); first != other_quarantine_.end() && first->first < position())
    tables.quarantine = first->second;
  return edited_file(file_, mesh, tables);
}

std::vector<Message> Document::losses(const std::filesystem::path& path) const {
  const Format* const format = format_to_write(path.empty() ? path_ : path, file_);
  if (!format || !format->write) return {};
  return loss_messages(contents(), *format);
}

Status Document::save(const std::filesystem::path& path, WriteOptions options) {
  std::filesystem::path target = path.empty() ? path_ : path;
  if (!options.format) options.format = format_to_write(target, file_);
  Status status = write_mesh_file(target, contents(), options);
  if (!is_in_place(status) || is_stream(target)) return status;
  const bool is_open_here = !path_.empty() && is_same_file(target_of(target), target_of(path_));
  if (status) path_.swap(target);
  if (status || is_open_here) take_file_as_known();
  if (!status) return status;
  saved_position_ = journal_.position();
  mark_saved();
  return status;
}

}  // namespace ryosen
