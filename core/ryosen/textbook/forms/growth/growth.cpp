#include "ryosen/textbook/forms/growth/growth.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <list>
#include <numeric>

#include "ryosen/base/stopwatch.h"
#include "ryosen/indexed/to_indexed.h"
#include "ryosen/mesh/circulate.h"
#include "ryosen/mesh/edit.h"
#include "ryosen/ops/collapse_edge.h"
#include "ryosen/textbook/forms/all.h"
#include "ryosen/textbook/forms/comparison.h"
#include "ryosen/textbook/forms/pairing.h"
#include "ryosen/textbook/forms/polygons.h"
#include "ryosen/textbook/forms/reading/relation_answer.h"
#include "ryosen/textbook/forms/source_operators.h"

namespace ryosen::forms {

namespace {

constexpr std::uint32_t most_edges = 8;

// Edges that may collapse and that the listing can: between two faces, with no boundary in sight. They lie apart, so
// that one goes with the others.
std::vector<Halfedge> edges_to_collapse(const Mesh& mesh) {
  std::vector<Halfedge> found;
  std::vector<bool> is_near(mesh.vertex_slots(), false);
  const auto is_free = [&](Vertex v) {
    for (const Halfedge h : outgoing(mesh, v))
      if (is_near[mesh.to(h).index] || mesh.is_outside(h) || mesh.is_outside(twin(h))) return false;
    return !is_near[v.index];
  };
  const std::uint32_t stride = mesh.edge_slots() / (4 * most_edges) + 1;
  for (std::uint32_t e = 0; e < mesh.edge_slots() && found.size() < most_edges; e += stride) {
    if (!mesh.is_alive(Edge(e))) continue;
    const Halfedge h = halfedge(Edge(e));
    if (!is_free(mesh.from(h)) || !is_free(mesh.to(h)) || !CollapseEdge{h}.check(mesh).legal()) continue;
    for (const Vertex end : {mesh.from(h), mesh.to(h)}) {
      is_near[end.index] = true;
      for (const Vertex v : neighbours(mesh, end)) is_near[v.index] = true;
    }
    found.push_back(h);
  }
  return found;
}

void add_seconds(double taken, CollapseFigures& sum) {
  sum.seconds = sum.seconds > 0 ? std::min(sum.seconds, taken) : taken;
}

// The lists of the listing, whose remove() looks at every entry.
class Lists {
 public:
  explicit Lists(const HalfedgeTable& table)
      : vertices_(table.vertex_halfedge.size()), faces_(table.face_halfedge.size()) {
    std::iota(vertices_.begin(), vertices_.end(), 0u);
    std::iota(faces_.begin(), faces_.end(), 0u);
  }
  void remove_vertex(std::uint32_t v) { remove(vertices_, v); }
  void remove_face(std::uint32_t f) { remove(faces_, f); }
  std::size_t compared() const { return compared_; }

 private:
  void remove(std::list<std::uint32_t>& list, std::uint32_t element) {
    list.remove_if([&](std::uint32_t one) {
      ++compared_;
      return one == element;
    });
  }
  std::list<std::uint32_t> vertices_, faces_;
  std::size_t compared_ = 0;
};

std::optional<CollapseFigures> by_listing(const Mesh& mesh, bool has_lists) {
  if (why_unsuitable(mesh, find_form("halfedge")->needs | triangles)) return {};
  const std::vector<Halfedge> edges = edges_to_collapse(mesh), corners = corner_halfedges(mesh);
  if (edges.empty()) return {};
  std::vector<std::uint32_t> corner_of(mesh.halfedge_slots(), no_index);
  for (std::uint32_t c = 0; c < corners.size(); ++c) corner_of[corners[c].index] = c;
  HalfedgeTable table = inner_halfedges(mesh);
  std::optional<Lists> lists;
  if (has_lists) lists.emplace(table);
  CollapseFigures sum;
  for (const Halfedge edge : edges) {
    const std::uint32_t h = corner_of[edge.index];
    const std::uint32_t start = table.from(h), left = table.face(h), right = table.face(table.pair(h));
    const Stopwatch watch;
    const SourceOutcome outcome = source_collapse(table, h);
    if (lists) {
      lists->remove_vertex(start);
      lists->remove_face(right);
      lists->remove_face(left);
    }
    add_seconds(watch.seconds(), sum);
    sum.count += static_cast<double>(outcome.links_followed);
  }
  if (lists) sum.count += static_cast<double>(lists->compared());
  const auto n = static_cast<double>(edges.size());
  return CollapseFigures{sum.count / n, sum.seconds};
}

std::optional<CollapseFigures> in_lists(const Mesh& mesh) { return by_listing(mesh, true); }
std::optional<CollapseFigures> in_arrays(const Mesh& mesh) { return by_listing(mesh, false); }

// With its check, and recorded so that it can be undone.
std::optional<CollapseFigures> by_kernel(const Mesh& mesh) {
  const std::vector<Halfedge> edges = edges_to_collapse(mesh);
  if (edges.empty()) return {};
  Mesh changed = mesh;
  Journal journal;
  CollapseFigures sum;
  for (const Halfedge h : edges) {
    const Stopwatch watch;
    const CollapseEdge collapse{h};
    if (!collapse.check(changed).legal()) continue;
    Edit edit(changed, &journal);
    collapse.apply(edit);
    edit.commit();
    add_seconds(watch.seconds(), sum);
    sum.count += static_cast<double>(journal.touched(journal.size() - 1).size());
  }
  const auto n = static_cast<double>(journal.size());
  if (n == 0) return {};
  return CollapseFigures{sum.count / n, sum.seconds};
}

constexpr std::array ways{
    CollapseWay{"halfedge_lists", "halfedge, with the listing's lists", "半稜線（テキストのリスト）", in_lists},
    CollapseWay{"halfedge", "halfedge, in arrays", "半稜線（配列）", in_arrays},
    CollapseWay{"ryosen", "Ryosen, with its check", "Ryosen（判定も含む）", by_kernel},
};

}  // namespace

std::span<const CollapseWay> collapse_ways() { return ways; }

namespace {

constexpr std::array rows{
    GrowthRow{GrowthOf::pairing, "pairing", "Pairing the halfedges", "半稜線の対を見つける", "comparisons", "比較回数"},
    GrowthRow{GrowthOf::query, "query", "One query", "問い合わせ 1 回", "records read", "読むデータの数"},
    GrowthRow{GrowthOf::collapse, "collapse", "One edge collapse", "稜線削除 1 回",
              "links followed, list entries compared, cells written", "たどるリンク・比べるリスト要素・書くデータの数"},
};
static_assert(rows_are_in_order(rows, &GrowthRow::of));

// The slope of the straight line nearest to the logarithms.
template <class Value>
std::optional<double> slope_of(const GrowthCurve& curve, Value value) {
  double n = 0, x = 0, y = 0, xx = 0, xy = 0;
  for (const GrowthPoint& point : curve.points) {
    if (!(value(point) > 0)) continue;
    const double a = std::log(static_cast<double>(point.faces)), b = std::log(value(point));
    n += 1, x += a, y += b, xx += a * a, xy += a * b;
  }
  const double spread = n * xx - x * x;
  if (n < 2 || !(spread > 0)) return {};
  return (n * xy - x * y) / spread;
}

class GrowthRun {
 public:
  GrowthRun(const GrowthEffort& effort, Progress& progress) : effort_(effort), progress_(progress) {
    for (const PairingMethod& method : pairing_methods())
      curves_.push_back({GrowthOf::pairing, method.id, {}, method.en, method.ja, {}});
    for (const FormRow& form : all_forms())
      for (const RelationRow& relation : relations())
        curves_.push_back({GrowthOf::query, form.id, relation.relation, form.en, form.ja, {}});
    for (const CollapseWay& way : collapse_ways())
      curves_.push_back({GrowthOf::collapse, way.id, {}, way.en, way.ja, {}});
  }

  // False when it is cancelled.
  bool measure(const Mesh& mesh) {
    faces_ = mesh.live().faces;
    curve_ = curves_.begin();
    return measure_pairings(mesh) && measure_queries(mesh) && measure_collapses(mesh);
  }
  std::vector<GrowthCurve> curves() && {
    std::erase_if(curves_, [](const GrowthCurve& curve) { return curve.points.empty(); });
    return std::move(curves_);
  }

 private:
  // The curves come in the order of the tables.
  GrowthCurve& next() { return *curve_++; }

  bool measure_pairings(const Mesh& mesh) {
    const IndexedMesh list = to_indexed(mesh).mesh;
    for (const PairingMethod& method : pairing_methods()) {
      GrowthCurve& curve = next();
      if (method.steps(list) > effort_.pairing_steps) continue;
      std::uint64_t comparisons = 0;
      method.pair_counting(list, comparisons);
      if (!progress_.go_on()) return false;
      curve.points.push_back(
          {faces_, static_cast<double>(comparisons), fastest_of(5, 0.03, [&] { return method.pair(list); })});
      if (!progress_.go_on()) return false;
    }
    return true;
  }

  bool measure_queries(const Mesh& mesh) {
    const Questions questions(mesh);
    for (const FormRow& row : all_forms()) {
      if (why_unsuitable(mesh, row)) {
        curve_ += relation_count;
        continue;
      }
      const std::unique_ptr<Form> form = row.make(mesh);
      const std::vector<std::uint32_t> edges = handles_of(*form, questions.edges, 8 * effort_.query_seconds);
      RecordReader reader(mesh, row);
      for (const RelationRow& relation : relations()) {
        GrowthCurve& curve = next();
        const std::optional<double> records = records_read(mesh, reader, relation);
        const auto& elements = relation.asks == ElementOf::vertex ? questions.vertices
                               : relation.asks == ElementOf::edge ? edges
                                                                  : questions.faces;
        if (records)
          curve.points.push_back(
              {faces_, *records,
               time_per_query(*form, relation.relation, elements, effort_.query_seconds).value_or(0)});
        if (!progress_.go_on()) return false;
      }
    }
    return true;
  }

  // The mean over several elements that lie apart; of fewer where each reads many.
  static std::optional<double> records_read(const Mesh& mesh, RecordReader& reader, const RelationRow& row) {
    constexpr std::size_t most_asked = 8, enough_read = 2000;
    std::size_t asked = 0, read = 0;
    const auto ask = [&](Element element) {
      reader.begin_anew();
      Answer answer;
      if (!answer_by_records(reader, asked_about(mesh, row, element), answer)) return false;
      read += reader.read().size();
      return ++asked < most_asked && read < enough_read;
    };
    const auto ask_all = [&]<class Handle>(Handle, std::uint32_t slots) {
      for (std::uint32_t i = 0; i < most_asked; ++i)
        if (const Handle element(i * (slots / most_asked)); slots > 0 && !ask(element)) return;
    };
    if (row.asks == ElementOf::vertex) ask_all(Vertex(), mesh.vertex_slots());
    if (row.asks == ElementOf::edge) ask_all(Edge(), mesh.edge_slots());
    if (row.asks == ElementOf::face) ask_all(Face(), mesh.face_slots());
    if (asked == 0) return {};
    return static_cast<double>(read) / static_cast<double>(asked);
  }

  bool measure_collapses(const Mesh& mesh) {
    for (const CollapseWay& way : collapse_ways()) {
      GrowthCurve& curve = next();
      if (const std::optional<CollapseFigures> figures = way.measure(mesh))
        curve.points.push_back({faces_, figures->count, figures->seconds});
      if (!progress_.go_on()) return false;
    }
    return true;
  }

  const GrowthEffort& effort_;
  Progress& progress_;
  std::size_t faces_ = 0;
  std::vector<GrowthCurve> curves_;
  std::vector<GrowthCurve>::iterator curve_;
};

}  // namespace

std::span<const GrowthRow> growth_rows() { return rows; }

std::optional<double> slope_of_count(const GrowthCurve& curve) {
  return slope_of(curve, [](const GrowthPoint& point) { return point.count; });
}

std::optional<double> slope_of_time(const GrowthCurve& curve) {
  return slope_of(curve, [](const GrowthPoint& point) { return point.seconds; });
}

std::string slope_text(std::optional<double> slope) {
  if (!slope) return "-";
  char text[32];
  std::snprintf(text, sizeof text, "%.2f", *slope);
  return text == std::string("-0.00") ? "0.00" : text;
}

std::vector<GrowthCurve> measure_growth(std::span<const Mesh> meshes, const GrowthEffort& effort, Progress& progress) {
  GrowthRun run(effort, progress);
  std::size_t all = 0, done = 0;
  for (const Mesh& mesh : meshes) all += mesh.live().faces;
  for (const Mesh& mesh : meshes) {
    if (!progress.go_on(done, all) || !run.measure(mesh)) return {};
    done += mesh.live().faces;
  }
  return std::move(run).curves();
}

}  // namespace ryosen::forms
