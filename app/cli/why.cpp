// `why`: whether an operator is legal, and if not, the reasons and remedies.
#include <algorithm>
#include <compare>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/cli/console.h"
#include "app/cli/contract/json.h"
#include "app/cli/contract/operators.h"
#include "app/cli/subcommand_table.h"
#include "app/editor/commands/text/script.h"
#include "app/editor/texts/remedy_text.h"
#include "ryosen/document/document.h"
#include "ryosen/document/outcome.h"
#include "ryosen/indexed/from_indexed.h"
#include "ryosen/io/formats.h"
#include "ryosen/mesh/copies.h"
#include "ryosen/mesh/mesh.h"
#include "ryosen/mesh/names.h"
#include "ryosen/ops/all.h"
#include "ryosen/ops/preview/known_answers.h"
#include "ryosen/ops/preview/preview.h"
#include "ryosen/ops/preview/remedy.h"

namespace ryosen::cli {

namespace {

// An edge of `why --all` between points a < b; if it is non-manifold or misoriented on points, one of its face sides.
struct EdgeSide {
  Vertex a, b;
  Face face;          // none if the points suffice to name the edge
  Halfedge halfedge;  // from a to b

  friend auto operator<=>(const EdgeSide&, const EdgeSide&) = default;
};

// Sorted by smaller point, larger point, face. O(edges log edges), plus the one-rings of points with copies.
std::vector<EdgeSide> find_edge_sides(const Mesh& mesh) {
  std::vector<EdgeSide> sides;
  sides.reserve(mesh.live().edges);
  for (std::uint32_t i = 0; i < mesh.edge_slots(); ++i) {
    if (!mesh.is_alive(Edge(i))) continue;
    Halfedge h = halfedge(Edge(i));
    Vertex a = point(mesh, mesh.from(h)), b = point(mesh, mesh.to(h));
    if (b < a) {
      std::swap(a, b);
      h = twin(h);
    }
    if (!is_cut_on_points(mesh, h)) {
      sides.push_back({a, b, Face(), h});
      continue;
    }
    for (Face f : {mesh.face(h), mesh.face(twin(h))})
      if (f) sides.push_back({a, b, f, h});
  }
  std::sort(sides.begin(), sides.end());
  return sides;
}

// "3-7" or "3-7@f5"; reversed: points swapped.
std::string name_of(const EdgeSide& side, bool reversed = false) {
  std::string name = std::to_string((reversed ? side.b : side.a).index) + "-";
  name += std::to_string((reversed ? side.a : side.b).index);
  if (side.face) name += "@f" + std::to_string(side.face.index);
  return name;
}

// The verdict on an operator with reasons, warnings and remedy.
struct VerdictReport {
  std::string_view op;
  std::string edge;       // empty if the operator has none
  std::string arguments;  // of the operator; for an operator on an edge only that edge
  Verdict verdict;
  std::vector<Reason> warnings;
  std::vector<std::string> remedy;  // if refused; empty if none was found
  std::optional<Text> quarantined;  // for a quarantined face: replaces the rule's sentence
};

// One line of JSON. Its remedy is "never" if the bounded search found nothing, whether or not a remedy can exist; the
// text output distinguishes the two.
std::string to_json_line(const Mesh& mesh, const VerdictReport& report) {
  Record<why_shape> json;
  json["op"] = report.op;
  json["edge"] = report.edge.empty() ? Json() : Json(report.edge);
  json["legal"] = report.verdict.legal();
  json["reasons"] = cli::to_json(mesh, report.verdict.reasons);
  json["warnings"] = cli::to_json(mesh, report.warnings);
  if (report.quarantined) {
    json["reasons"][0]["en"] = report.quarantined->en;
    json["reasons"][0]["ja"] = report.quarantined->ja;
  }
  const bool never = !report.verdict.legal() && report.remedy.empty();
  json["remedy"] = never ? Json("never") : Json(report.remedy);
  return line_of(json);
}

std::string to_text(const Mesh& mesh, const VerdictReport& report, const Console& console) {
  std::string text(report.op);
  if (!report.arguments.empty()) text += " " + report.arguments;
  text += report.verdict.legal() ? console.text(": legal\n", "：可能\n") : console.text(": refused\n", "：不可\n");
  const auto add = [&](const Reason& reason, std::string_view label) {
    text.append("  ").append(label).append(text_of(reason.rule).id) +=
        ": " + console.text(report.quarantined.value_or(describe(mesh, reason))) + "\n";
  };
  for (const Reason& reason : report.verdict.reasons) add(reason, "");
  for (const Reason& warning : report.warnings) add(warning, console.text("warning: ", "警告："));
  if (report.verdict.legal()) return text;
  text += console.text("  remedy: ", "  対処：");
  if (report.remedy.empty()) text += console.text(without_remedy(report.verdict));
  for (std::size_t i = 0; i < report.remedy.size(); ++i) text += (i ? "; " : "") + report.remedy[i];
  return text + "\n";
}

// The operator with this id on an edge, without further arguments.
AnyOp on_edge(const Mesh& mesh, std::string_view id, Halfedge h) {
  AnyOp op;
  const auto choose = [&]<class Op>(Op candidate) {
    if constexpr (requires { candidate.halfedge; }) {
      if (Op::info.id != id) return;
      candidate.halfedge = h;
      if constexpr (requires { Op::of_edge(mesh, h); }) candidate = Op::of_edge(mesh, h);
      op = candidate;
    } else if constexpr (requires { Halfedge(candidate.edges[0]); }) {
      if (Op::info.id == id) op = Op{{h}};
    }
  };
  [&]<std::size_t... I>(std::index_sequence<I...>) { (choose(std::variant_alternative_t<I, AnyOp>()), ...); }
  (std::make_index_sequence<std::variant_size_v<AnyOp>>());
  return op;
}

class Why {
 public:
  Why(std::string file, IndexedMesh mesh, const Console& console)
      : file_(std::move(file)),
        quarantine_(std::move(mesh.quarantine)),
        mesh_(from_indexed(std::move(mesh))),
        console_(console) {}

  ExitCode answer_line(const std::string& line) {
    const std::vector<std::string_view> words = split_words(line);
    const OpInfo* const info = find_op(words[0]);
    const auto arguments = std::span(words).subspan(1);
    const ParsedOp parsed = parse_op(mesh_, info->id, op_arguments(arguments));
    const std::string edge = info->target == OpTargetKind::edge && words.size() > 1 ? std::string(words[1]) : "";
    return answer(*info, edge, parsed, arguments);
  }

  ExitCode answer_edge(const OpInfo& info, const std::string& name) {
    const std::string_view argument = name;
    return answer(info, name, parse_op(mesh_, info.id, op_arguments({&argument, 1})), {&argument, 1});
  }

  ExitCode answer_all(const OpInfo& info, bool geometry) {
    std::size_t questions = 0;
    for (const EdgeSide& side : find_edge_sides(mesh_)) {
      ask_edge(info, name_of(side), side.halfedge, geometry);
      ++questions;
      if (info.id != CollapseEdge::info.id) continue;
      ask_edge(info, name_of(side, true), twin(side.halfedge), geometry);
      ++questions;
    }
    const std::string legal = std::to_string(legal_), all = std::to_string(questions);
    const Text summary{legal + " of " + all + " legal\n", all + " のうち " + legal + " が可能\n"};
    return console_.end(console_.json ? std::string() : console_.text(summary));
  }

 private:
  // A query as text: the parts shown in the report, and the whole line.
  struct Asked {
    std::string edge, arguments, line;
  };

  ExitCode answer(const OpInfo& info, const std::string& edge, const ParsedOp& parsed,
                  std::span<const std::string_view> arguments) {
    std::string words = edge;
    if (edge.empty())
      for (const std::string_view argument : arguments) words.append(words.empty() ? "" : " ").append(argument);
    if (parsed.op) {
      std::string line(info.id);
      for (const std::string_view argument : arguments) line.append(" ").append(argument);
      Preview seen = preview(mesh_, journal_, *parsed.op);
      Answer alone{std::move(seen.verdict), std::move(seen.warnings)};
      return console_.end(text_of(report(info, {edge, words, std::move(line)}, std::move(alone))));
    }
    if (parsed.error != NameError::deleted) return console_.fail(failure_of_name(parsed.error, parsed.sentence), file_);
    VerdictReport report{info.id, edge, std::move(words), {}, {}, {}, quarantine_text(quarantine_, arguments)};
    report.verdict.refuse(Rule::deleted, {});
    return console_.end(text_of(report));
  }

  void ask_edge(const OpInfo& info, const std::string& edge, Halfedge h, bool geometry) {
    const AnyOp op = on_edge(mesh_, info.id, h);
    Asked words{edge, edge, std::string(info.id) + " " + edge};
    console_.print(text_of(report(info, std::move(words), answers_.ask(mesh_, op, geometry))));
  }

  VerdictReport report(const OpInfo& info, Asked words, Answer answer) {
    VerdictReport report{info.id, std::move(words.edge), std::move(words.arguments), std::move(answer.verdict), {}, {},
                         {}};
    if (report.verdict.legal()) {
      report.warnings = std::move(answer.warnings);
      ++legal_;
    } else {
      report.remedy = remedies_.find(words.line);
    }
    return report;
  }

  std::string text_of(const VerdictReport& report) const {
    return console_.json ? to_json_line(mesh_, report) : to_text(mesh_, report, console_);
  }

  std::string file_;
  std::vector<QuarantinedFace> quarantine_;
  Mesh mesh_;
  const Console& console_;
  KnownAnswers answers_;  // about all edges
  Journal journal_;       // of the preview of one; nothing is committed
  RemedySearch remedies_{mesh_};
  std::size_t legal_ = 0;
};

// The operator of --op, or the one at the start of a line.
Result<const OpInfo*> operator_named(const std::string& id, bool needs_edge) {
  const OpInfo* const info = find_op(id);
  if (info && (!needs_edge || info->target == OpTargetKind::edge)) return info;
  std::vector<std::string> known;
  for (const OpInfo& row : all_ops())
    if (!needs_edge || row.target == OpTargetKind::edge) add_ids(row, known);
  return usage_failure("unknown_operator",
                       Text{"'" + id + "' is not an operator here.", "「" + id + "」という操作はここでは使えません。"} +
                           did_you_mean(id, known, HintForm::sentence));
}

// The query, checked as far as possible without the mesh.
struct Question {
  const OpInfo* info = nullptr;
  std::string line;                 // of --do
  std::optional<std::string> edge;  // of --edge
};

Result<Question> read_question(const Arguments& arguments) {
  const std::string *op = arguments.value("--op"), *line = arguments.value("--do"), *edge = arguments.value("--edge");
  const bool all = arguments.has("--all");
  const bool by_op = op && !line && (edge != nullptr) != all;
  const bool by_line = line && !op && !edge && !all;
  if (!by_op && !by_line)
    return usage_failure("usage", {"why needs either --op with --edge or --all, or --do.",
                                   "why には --op と --edge か --all の一方、または --do を指定してください。"});
  Question question;
  if (by_line) {
    const std::vector<ScriptLine> lines = split_script(*line);
    if (lines.size() != 1)
      return usage_failure("line_malformed", {"--do takes one command here.", "--do に書ける操作はここでは一つです。"});
    question.line = lines[0].text;
  }
  const std::string id = by_line ? std::string(split_words(question.line)[0]) : *op;
  const Result<const OpInfo*> info = operator_named(id, by_op);
  if (!info) return info.failure();
  question.info = *info;
  if (edge) question.edge = *edge;
  return question;
}

}  // namespace

ExitCode why_command(const Arguments& arguments, const Console& console) {
  const Result<Question> question = read_question(arguments);
  if (!question) return console.fail(question.failure());
  const std::string& path = arguments.operands()[0];
  Result<MeshFile> file = read_mesh_file(path);
  if (!file) return console.fail(file.failure(), path);
  for (const Message& message : file->messages) console.show(message, path);
  Why why(path, std::move(file->mesh), console);
  if (!question->line.empty()) return why.answer_line(question->line);
  if (question->edge) return why.answer_edge(*question->info, *question->edge);
  return why.answer_all(*question->info, arguments.has("--geometry"));
}

}  // namespace ryosen::cli
