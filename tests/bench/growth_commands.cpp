#include "tests/bench/growth_commands.h"

#include "app/cli/algorithm_flags.h"
#include "ryosen/algo/algorithm_table.h"
#include "ryosen/base/number_text.h"
#include "ryosen/io/formats.h"
#include "ryosen/ops/all.h"
#include "ryosen/ops/collapse_edge.h"
#include "ryosen/ops/each.h"

namespace ryosen::bench {

namespace {

// A value for a parameter that has to be given.
std::string some_value(const ParameterRow& row) {
  switch (row.kind) {
    case ParameterKind::length:
      return row.excludes_smallest ? "2%" : "0.1%";
    case ParameterKind::place:
      return "0,0,0";
    case ParameterKind::choice:
      return std::string(row.choices.front().id);
    case ParameterKind::flag:
      return "on";
    case ParameterKind::elements:
      return "v0";
    default:
      return row.smallest ? format_double(*row.smallest) : "1";
  }
}

class CommandList {
 public:
  CommandList(const Mesh& mesh, std::string file, const std::filesystem::path& folder)
      : mesh_(mesh), file_(std::move(file)), folder_(folder) {}

  std::vector<GrowthCommand> all() {
    add("check", {"check"});
    add("check --self-intersections", {"check", "--self-intersections"});
    for (const OpInfo& op : all_ops())
      if (op.target == OpTargetKind::edge) {
        const std::string id(op.id);
        add("why --op " + id + " --all", {"why", "--op", id, "--all"});
        add("why --op " + id + " --all --geometry", {"why", "--op", id, "--all", "--geometry"});
      }
    for (const OpInfo& op : all_ops()) op.target == OpTargetKind::selection ? add_edit_of_points(op) : add_edit(op);
    for (const OpInfo& op : all_ops()) add_edit_of_all(op);
    add_writing("repair", {"repair"}, "ply");
    for (const AlgorithmRow& row : algorithm_table()) add_algorithm(row);
    add_writing("simplify --no-self-intersections", {"simplify", "--ratio", "10%", "--no-self-intersections"}, "ply");
    for (const Format& format : formats()) add_conversions(format);
    add("forms", {"forms"});
    add("distance", {"distance", file_});
    add_writing("shot", {"shot", "--size", "320x180"}, "png");
    return std::move(commands_);
  }

 private:
  void add(std::string name, std::vector<std::string> arguments) {
    arguments.insert(arguments.begin() + 1, file_);
    arguments.push_back("--json");
    commands_.push_back({std::move(name), std::move(arguments)});
  }

  void add_writing(std::string name, std::vector<std::string> arguments, const std::string& extension) {
    for (const std::string& word :
         {std::string("--overwrite"), std::string("-o"), (folder_ / ("out." + extension)).string()})
      arguments.push_back(word);
    add(std::move(name), std::move(arguments));
  }

  // On the first edge, vertex and face.
  void add_edit(const OpInfo& op) {
    const OpTarget target{Halfedge(0), 0.5, Vertex(0), op.target == OpTargetKind::any ? Face() : Face(0)};
    const std::string line =
        op.target == OpTargetKind::none ? std::string(op.id) : command_of(mesh_, op_at(mesh_, op.id, target));
    if (parse_line(mesh_, line).op) add_edit(op, line);
  }

  // On the first two or three points.
  void add_edit_of_points(const OpInfo& op) {
    const std::string id(op.id);
    for (const std::string& line : {id + " 0 1", id + " 0 1 2"})
      if (parse_line(mesh_, line).op) return add_edit(op, line);
  }

  // On all vertices, edges or faces, and taken back.
  void add_edit_of_all(const OpInfo& op) {
    if (op.on_selection == OnSelection::none) return;
    for (const auto& [kind, mode] : {std::pair(Element::Kind::vertex, "vertex"), std::pair(Element::Kind::edge, "edge"),
                                     std::pair(Element::Kind::face, "face")}) {
      const std::string on = std::string("mode ") + mode + "; select all; " + std::string(op.id) + " selected";
      if (op.in_place_of || op.on_selection == OnSelection::all || takes(op, kind, {}))
        add("edit --do " + std::string(op.id) + " selected, every " + mode, {"edit", "--do", on + "; undo"});
    }
  }

  void add_edit(const OpInfo& op, const std::string& line) {
    add_writing("edit --do " + std::string(op.id), {"edit", "--do", line}, "ply");
  }

  void add_algorithm(const AlgorithmRow& row) {
    std::vector<std::string> arguments{std::string(row.id)};
    for (const ParameterRow& parameter : row.parameters)
      if (must_be_given(row.parameters, parameter)) {
        arguments.push_back(cli::flag_of(parameter));
        arguments.push_back(some_value(parameter));
      }
    add_writing(std::string(row.id), std::move(arguments), "ply");
  }

  void add_conversions(const Format& format) {
    if (!format.write) return;
    std::vector<std::string> ids{std::string(format.id)};
    if (!format.variants.empty()) ids.clear();
    for (const FormatVariant& variant : format.variants) ids.emplace_back(variant.id);
    for (const std::string& id : ids)
      add_writing("convert --format " + id, {"convert", "--format", id}, std::string(format.extensions[0].substr(1)));
  }

  const Mesh& mesh_;
  std::string file_;
  std::filesystem::path folder_;
  std::vector<GrowthCommand> commands_;
};

}  // namespace

std::vector<GrowthCommand> growth_commands(const Mesh& mesh, const std::filesystem::path& file,
                                           const std::filesystem::path& folder) {
  return CommandList(mesh, file, folder).all();
}

}  // namespace ryosen::bench
