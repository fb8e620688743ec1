#include "ryosen/textbook/forms/comparison.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <random>

#include "ryosen/base/stopwatch.h"
#include "ryosen/indexed/to_indexed.h"
#include "ryosen/mesh/copies.h"
#include "ryosen/mesh/live_elements.h"
#include "ryosen/textbook/forms/polygons.h"

namespace ryosen::forms {

Questions::Questions(const Mesh& mesh) {
  constexpr std::size_t count = 256;
  const Numbering numbers(mesh);
  std::mt19937 random(1);
  const auto pick = [&](std::uint32_t end) { return static_cast<std::uint32_t>(random() % end); };
  std::vector<EdgeEnds> all;
  for (const Edge e : live_edges(mesh))
    all.push_back(edge_ends(numbers.point[mesh.from(halfedge(e)).index], numbers.point[mesh.to(halfedge(e)).index]));
  for (std::size_t i = 0; i < count; ++i) {
    if (numbers.points > 0) vertices.push_back(pick(numbers.points));
    if (numbers.faces > 0) faces.push_back(pick(numbers.faces));
    if (!all.empty()) edges.push_back(all[pick(static_cast<std::uint32_t>(all.size()))]);
  }
}

std::vector<std::uint32_t> handles_of(const Form& form, const std::vector<EdgeEnds>& edges, double seconds) {
  std::vector<std::uint32_t> handles;
  const Stopwatch watch;
  for (const EdgeEnds& ends : edges) {
    const std::uint32_t handle = form.find_edge(ends.a, ends.b);
    if (handle != no_index) handles.push_back(handle);
    if (watch.seconds() > seconds) break;
  }
  return handles;
}

// The fastest of several rounds, each long enough for the clock's resolution: other load only makes a round slower. A
// round length is accepted only if two rounds in a row are long enough.
std::optional<double> time_per_query(const Form& form, Relation relation, const std::vector<std::uint32_t>& elements,
                                     double seconds) {
  Answer answer;
  if (elements.empty() || !form.answer(relation, elements[0], answer)) return {};
  const auto time_round = [&](std::size_t count) {
    const Stopwatch watch;
    for (std::size_t i = 0; i < count; ++i) form.answer(relation, elements[i % elements.size()], answer);
    return watch.seconds();
  };
  const double long_enough = seconds / 8;
  std::size_t count = 1;
  double best = time_round(count);
  while (best < long_enough || (best = std::min(best, time_round(count))) < long_enough) best = time_round(count *= 2);
  for (int round = 0; round < 3; ++round) best = std::min(best, time_round(count));
  return best / static_cast<double>(count);
}

namespace {

FormFigures measure(const Mesh& mesh, const FormRow& row, const Questions& questions, const Effort& effort) {
  FormFigures figures{&row, why_unsuitable(mesh, row), 0, 0, {}};
  if (figures.unsuitable) return figures;
  const Stopwatch watch;
  const std::unique_ptr<Form> form = row.make(mesh);
  figures.build_seconds = watch.seconds();
  figures.bytes = form->bytes();
  const std::vector<std::uint32_t> edges = handles_of(*form, questions.edges, effort.query_seconds);
  for (const RelationRow& relation : relations()) {
    const auto& elements = relation.asks == ElementOf::vertex ? questions.vertices
                           : relation.asks == ElementOf::edge ? edges
                                                              : questions.faces;
    const auto i = static_cast<std::size_t>(relation.relation);
    figures.query_seconds[i] = time_per_query(*form, relation.relation, elements, effort.query_seconds);
  }
  return figures;
}

}  // namespace

std::size_t faces_within(const IndexedMesh& source, const PairingMethod& method, double steps) {
  if (method.steps(source) <= steps) return source.face_count();
  std::size_t enough = 0, too_many = source.face_count();
  while (too_many - enough > 1) {
    const std::size_t middle = enough + (too_many - enough) / 2;
    (method.steps(first_faces(source, middle)) <= steps ? enough : too_many) = middle;
  }
  return enough;
}

PairingFigures measure_pairing(const IndexedMesh& source, const PairingMethod& method, const Effort& effort) {
  PairingFigures figures{&method, faces_within(source, method, effort.pairing_steps), source.face_count(), 1, 0};
  const IndexedMesh part = figures.is_whole() ? IndexedMesh() : first_faces(source, figures.faces);
  if (!figures.is_whole()) figures.steps_of_all = method.steps(source) / std::max(1.0, method.steps(part));
  figures.seconds = fastest_of(3, 0.1, [&] { return method.pair(figures.is_whole() ? source : part); });
  return figures;
}

std::string figure_text(double value) {
  char text[32];
  std::snprintf(text, sizeof text, value < 99.95 ? "%.3g" : "%.0f", value);
  return text;
}

std::string duration_text(double seconds) {
  if (seconds < 1e-6) return figure_text(1e9 * seconds) + " ns";
  if (seconds < 1e-3) return figure_text(1e6 * seconds) + " \u00b5s";
  return figure_text(1e3 * seconds) + " ms";
}

namespace {

constexpr std::array size_claims{
    SizeClaim{
        "halfedge_loop", "polygon_set", "halfedges take less memory than a polygon set",
        "半稜線はポリゴンセットよりメモリ効率が良い",
        "Per side both take 24 bytes. Beside these a polygon takes 24 for its list, halfedges take 4 for a loop and "
        "32 for a vertex: less in a closed mesh with under 5 vertices to 8 faces, as of triangles.",
        "半稜線一本あたりではどちらも 24 バイト。ほかにポリゴンはリストに 24 バイト、半稜線はループに 4 バイト、頂点に "
        "32 "
        "バイト要り、閉じた三角形メッシュのように面 8 に対し頂点が 5 未満なら半稜線の方が小さくなります。"},
    SizeClaim{"indexed_face_set", "halfedge_loop", "halfedges take more memory than an indexed face set",
              "半稜線はインデックスフェースセットよりメモリ効率が悪い",
              "Each link of a halfedge is one more number beside the corner that both store.",
              "どちらも角ごとに頂点の番号を一つ持ち、半稜線はそれにリンクの番号が加わります。"},
};

std::string per_face(std::size_t bytes, std::uint32_t faces) {
  return figure_text(static_cast<double>(bytes) / std::max(1u, faces));
}

}  // namespace

std::vector<ComparedClaim> compare_claims(const Comparison& comparison) {
  const auto bytes_of_form = [&](std::string_view id) -> std::optional<std::size_t> {
    for (const FormFigures& figures : comparison.forms)
      if (figures.row->id == id && !figures.unsuitable) return figures.bytes;
    return std::nullopt;
  };
  std::vector<ComparedClaim> compared;
  for (const SizeClaim& claim : size_claims) {
    const auto smaller = bytes_of_form(claim.smaller), larger = bytes_of_form(claim.larger);
    if (!smaller || !larger || comparison.faces == 0) continue;
    const std::string a = per_face(*smaller, comparison.faces), b = per_face(*larger, comparison.faces);
    const bool holds = *smaller < *larger;
    const Text said{"Text 002, section 2.3: " + std::string(claim.en) + ". ",
                    "テキスト 002 の 2.3 節「" + std::string(claim.ja) + "」："};
    const FormRow &one = *find_form(claim.smaller), &other = *find_form(claim.larger);
    const Text figures{std::string(one.en) + " " + a + ", " + std::string(other.en) + " " + b,
                       std::string(one.ja) + " " + a + "、" + std::string(other.ja) + " " + b};
    const Text so = holds ? Text{"So it is here", "ここでもそのとおりです"} : Text{"Not so here", "ここでは違います"};
    compared.push_back(
        {&claim, holds,
         said + so + Text{" (bytes per face: ", "（面あたりのバイト数："} + figures + Text{").", "）。"}});
  }
  return compared;
}

Comparison compare_forms(const Mesh& mesh, const Effort& effort) {
  const ElementCounts counts = counts_on_points(mesh);
  Comparison comparison{counts.vertices, counts.edges, counts.faces, {}, {}, sources_on_boundaries()};
  const Questions questions(mesh);
  for (const FormRow& row : all_forms()) comparison.forms.push_back(measure(mesh, row, questions, effort));
  const IndexedMesh list = to_indexed(mesh).mesh;
  for (const PairingMethod& method : pairing_methods())
    comparison.pairing.push_back(measure_pairing(list, method, effort));
  return comparison;
}

}  // namespace ryosen::forms
