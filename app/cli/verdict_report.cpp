#include "app/cli/verdict_report.h"

#include "app/cli/contract/record.h"
#include "app/cli/contract/why.h"
#include "app/editor/texts/remedy_text.h"
#include "ryosen/document/document.h"

namespace ryosen::cli {

std::string to_json_line(const Mesh& mesh, const VerdictReport& report) {
  Record<why_shape> json;
  json["op"] = report.op;
  json["edge"] = report.edge.empty() ? Json() : Json(report.edge);
  json["legal"] = report.verdict.legal();
  json["reasons"] = to_json(mesh, report.verdict.reasons);
  json["warnings"] = to_json(mesh, report.warnings);
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

}  // namespace ryosen::cli
