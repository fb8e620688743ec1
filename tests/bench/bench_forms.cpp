// Pairing methods and queries of the forms of the source texts, over their tables. RYOSEN_DRAGON=FILE.ply.gz adds the
// dragon.
#include <benchmark/benchmark.h>

#include <random>

#include "ryosen/indexed/from_indexed.h"
#include "ryosen/textbook/forms/all.h"
#include "ryosen/textbook/forms/pairing.h"
#include "tests/bench/bench_meshes.h"

namespace ryosen::bench {
namespace {

using Source = const IndexedMesh& (*)();

constexpr double most_steps = 1e9;  // a method that needs more would take longer than anybody waits

void pair_sides(benchmark::State& state, Source source, const PairingMethod& method) {
  if (source().positions.empty()) return state.SkipWithError("RYOSEN_DRAGON is not set");
  if (method.steps(source()) > most_steps) return state.SkipWithError("it would take too many steps");
  for (auto _ : state) benchmark::DoNotOptimize(method.pair(source()));
  state.counters["Mfaces/s"] = benchmark::Counter(1e-6 * static_cast<double>(source().face_count()),
                                                  benchmark::Counter::kIsIterationInvariantRate);
}

std::vector<std::uint32_t> random_elements(const Mesh& mesh, const forms::Form& form, forms::ElementOf kind) {
  std::mt19937 random(1);
  std::vector<std::uint32_t> elements;
  for (int i = 0; i < 64; ++i) {
    const Halfedge h(random() % mesh.halfedge_slots());
    if (kind == forms::ElementOf::vertex)
      elements.push_back(mesh.from(h).index);
    else if (kind == forms::ElementOf::face)
      elements.push_back(mesh.face(mesh.is_outside(h) ? twin(h) : h).index);
    else
      elements.push_back(form.find_edge(mesh.from(h).index, mesh.to(h).index));
  }
  return elements;
}

// The mesh must be free of copies and gaps, so that its numbers are those of the form.
void ask(benchmark::State& state, Source source, const forms::FormRow& row, const forms::RelationRow& relation) {
  if (source().positions.empty()) return state.SkipWithError("RYOSEN_DRAGON is not set");
  const Mesh mesh = from_indexed(source());
  if (mesh.has_copies() || why_unsuitable(mesh, row)) return state.SkipWithError("the mesh does not suit");
  const std::unique_ptr<forms::Form> form = row.make(mesh);
  const std::vector<std::uint32_t> elements = random_elements(mesh, *form, relation.asks);
  forms::Answer answer;
  if (!form->answer(relation.relation, elements[0], answer)) return state.SkipWithError("the form cannot tell");
  std::size_t i = 0;
  for (auto _ : state) {
    form->answer(relation.relation, elements[i], answer);
    benchmark::DoNotOptimize(answer);
    i = (i + 1) % elements.size();
  }
  state.counters["bytes/face"] = static_cast<double>(form->bytes()) / mesh.live().faces;
}

void register_all(const std::string& mesh, Source source) {
  for (const PairingMethod& method : pairing_methods())
    benchmark::RegisterBenchmark(("pair/" + std::string(method.id) + "/" + mesh).c_str(), pair_sides, source, method)
        ->Unit(benchmark::kMillisecond);
  for (const forms::FormRow& row : forms::all_forms())
    for (const forms::RelationRow& relation : forms::relations())
      benchmark::RegisterBenchmark(
          ("query/" + std::string(row.id) + "/" + std::string(relation.id) + "/" + mesh).c_str(), ask, source, row,
          relation);
}

}  // namespace
}  // namespace ryosen::bench

int main(int argc, char** argv) {
  ryosen::bench::register_all("bunny", ryosen::bench::bunny);
  ryosen::bench::register_all("dragon", ryosen::bench::dragon);
  benchmark::Initialize(&argc, argv);
  benchmark::RunSpecifiedBenchmarks();
}
