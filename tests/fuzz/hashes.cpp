// Prints a line per mesh and computation: its name and a digest of what came out, to the last bit. The lines must be
// the same whichever compiler built the library; tests/run.sh compares them.
#include <algorithm>
#include <bit>
#include <filesystem>
#include <fstream>
#include <iomanip>
#include <iostream>

#include "ryosen/analysis/figures.h"
#include "ryosen/indexed/from_indexed.h"
#include "ryosen/io/formats.h"
#include "ryosen/ops/preview/preview.h"
#include "tests/fuzz/any_op.h"
#include "tests/fuzz/failure.h"
#include "tests/fuzz/starts.h"
#include "tests/support/core/random_meshes.h"
#include "tests/support/core/shapes.h"

namespace ryosen::fuzz {
namespace {

constexpr std::uint64_t random_meshes_walked = 300;
constexpr std::size_t bytes_per_walk = 400;
constexpr std::uint32_t stride = 41;  // between the elements of a large mesh that are worked on

std::uint64_t digest_of(std::string_view bytes) {
  std::uint64_t digest = 0xcbf29ce484222325ull;
  for (const char c : bytes) digest = (digest ^ static_cast<std::uint8_t>(c)) * 0x100000001b3ull;
  return digest;
}

void print(const std::string& name, std::uint64_t digest) {
  std::cout << name << " " << std::hex << std::setw(16) << std::setfill('0') << digest << std::dec << "\n";
}

// The figures that are sums of doubles, bit by bit.
void print_figures(const std::string& name, const Mesh& mesh) {
  const Figures figures = compute_figures(mesh);
  print(name + " area", std::bit_cast<std::uint64_t>(figures.area));
  print(name + " volume", std::bit_cast<std::uint64_t>(figures.volume.value_or(0)));
  print(name + " degenerate", figures[ProblemKind::degenerate_area]);
}

bool commit(Mesh& mesh, const AnyOp& op) {
  if (!check(mesh, op).legal()) return false;
  Edit edit(mesh, nullptr);
  apply(edit, op);
  edit.commit();
  return true;
}

// What an operator warns of depends on the signs of computed numbers.
std::uint64_t warned_of(const Mesh& mesh, const AnyOp& op) {
  std::string text;
  for (const Reason& reason : warnings(mesh, op)) {
    text += text_of(reason.rule).id;
    for (const Element& witness : reason.witnesses) text += " " + std::to_string(witness.index);
  }
  return digest_of(text);
}

void work_on(const std::string& name, Mesh mesh) {
  const std::uint32_t halfedges = mesh.halfedge_slots(), faces = mesh.face_slots();
  std::uint64_t warned = 0;
  const auto run = [&](const AnyOp& op) {
    if (!check(mesh, op).legal()) return;
    warned = warned * 31 + warned_of(mesh, op);
    commit(mesh, op);
  };
  for (std::uint32_t i = 0; i < halfedges; i += stride) {
    const Halfedge h(i);
    if (!is_there(mesh, h)) continue;
    if (i % 3 == 0) run(CollapseEdge{h, CollapseEdge::Place::middle});
    if (i % 3 == 1) run(SwapEdge{h, false});
    if (i % 3 == 2) run(SplitEdge{h, 1.0 / 3});
  }
  for (std::uint32_t i = 0; i < faces; i += stride) {
    const Face f(i);
    if (!is_there(mesh, f)) continue;
    if (i % 4 == 0) run(Extrude{{f}});
    if (i % 4 == 1) run(Poke{f});
    if (i % 4 == 2) run(Dissolve{mesh.halfedge(f), {}});
  }
  run(Triangulate{});
  print(name + " worked on", mesh.hash());
  print(name + " warned of", warned);
  print_figures(name + " worked on", mesh);
}

void hash_file(const std::string& name, const std::filesystem::path& path) {
  Result<MeshFile> file = read_mesh_file(path);
  if (!file) return print(name + " refused " + std::string(file.failure().message.code), 0);
  for (const Format& format : formats())
    if (format.write)
      print(name + " as " + std::string(format.id), digest_of(format.write(*file, Encoding::automatic)));
  Mesh mesh = from_indexed(std::move(file->mesh));
  print(name, mesh.hash());
  print_figures(name, mesh);
  work_on(name, std::move(mesh));
}

void hash_script(const std::string& name, const std::filesystem::path& path) {
  Mesh mesh;
  std::ifstream in(path);
  for (std::string line; std::getline(in, line);) {
    const ParsedOp parsed = parse_line(mesh, line);
    if (parsed.op) expect(commit(mesh, *parsed.op), path.string() + ": " + line);
  }
  print(name, mesh.hash());
}

// Whatever operators the bytes of a seed say.
void walk(const std::string& name, Mesh mesh, std::uint64_t seed) {
  Dice dice(seed);
  std::vector<std::uint8_t> data;
  for (std::size_t i = 0; i < bytes_per_walk; ++i) data.push_back(static_cast<std::uint8_t>(dice.below(256)));
  Bytes bytes(data);
  std::uint64_t digest = mesh.hash();
  while (!bytes.at_end()) {
    std::string line;
    const std::optional<AnyOp> op = any_op(mesh, bytes, line);
    if (!op) continue;
    digest = digest * 31 + check(mesh, *op).reasons.size();
    if (!check(mesh, *op).legal()) continue;
    digest = digest * 31 + warned_of(mesh, *op);
    commit(mesh, *op);
    digest = digest * 31 + mesh.hash();
    tell(name + ": " + by_slots(*op) + " " + std::to_string(digest));
  }
  print(name, digest);
}

std::vector<std::filesystem::path> files_in(const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder))
    if (entry.is_regular_file()) files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  return files;
}

}  // namespace
}  // namespace ryosen::fuzz

int main() {
  using namespace ryosen;
  using namespace ryosen::fuzz;
  const std::filesystem::path root = RYOSEN_SOURCE_DIR;
  for (const std::filesystem::path& folder : {root / "assets", root / "tests/data"})
    for (const std::filesystem::path& path : files_in(folder)) {
      const std::string name = path.lexically_relative(root).generic_string();
      if (path.extension() == ".ryosen") hash_script(name, path);
      if (format_of_extension(path)) hash_file(name, path);
    }
  for (std::size_t i = 0; i < start_count(); ++i)
    for (std::uint64_t seed = 0; seed < 8; ++seed)
      walk("start " + std::to_string(i) + " seed " + std::to_string(seed), start(i).mesh, seed * 1000 + i);
  for (std::uint64_t seed = 0; seed < random_meshes_walked; ++seed) {
    const test::SeededMesh random = test::seeded_mesh(seed);
    walk("random " + std::to_string(seed), test::make_mesh(random.faces, random.points), seed);
  }
  return 0;
}
