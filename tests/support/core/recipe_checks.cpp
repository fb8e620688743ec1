#include "tests/support/core/recipe_checks.h"

#include <algorithm>

#include "ryosen/algo/algorithm_table.h"
#include "ryosen/algo/repair/pockets.h"
#include "ryosen/algo/repair/recipe.h"
#include "ryosen/analysis/problem_sets.h"
#include "ryosen/base/split_list.h"
#include "ryosen/indexed/from_indexed.h"
#include "ryosen/io/edited_file.h"
#include "ryosen/io/formats.h"
#include "ryosen/mesh/invariants.h"
#include "tests/support/core/proof.h"
#include "tests/support/core/random_meshes.h"

namespace ryosen::test {

namespace {

// A file and its mesh, as a document holds them.
struct Opened {
  explicit Opened(MeshFile from) : file(std::move(from)), tables(take_file_tables(file.mesh)) {
    points = file.mesh.positions.size();
    on_lines = vertices_on_lines(file, points);
    mesh = from_indexed(std::move(file.mesh));
    used = used_beside_the_mesh(file, tables.quarantine, points);
    used_later = used_beside_the_mesh(file, {}, points);
  }
  RecipeInput input() const { return {tables.quarantine, used, used_later, on_lines}; }

  MeshFile file;
  FileTables tables;
  std::size_t points = 0;
  Mesh mesh;
  std::vector<Vertex> on_lines, used, used_later;
};

// Then vertices are isolated in the new file that were not.
bool loses_what_uses_vertices(const MeshFile& file, const Format& format) {
  const Holds held = format.holds(encoding_of(file, format, Encoding::automatic));
  return (!file.elements.items.empty() && !holds(held, Holds::elements)) ||
         (!vertices_named(file.properties).empty() && !holds(held, Holds::properties));
}

std::string id_of(ProblemKind kind) { return std::string(row_of(kind).id); }

class RuleCheck {
 public:
  RuleCheck(std::string kinds) : kinds_(std::move(kinds)) {}

  std::vector<std::string> run(MeshFile file, const std::vector<std::string>& formats) {
    Opened opened(std::move(file));
    const NamedRecipe recipe = recipe_of(kinds_);
    const bool is_as_read = differs_from_reading(opened.mesh).empty();
    std::optional<RecipeResult> first = run_one(opened, recipe, "");
    judge(opened, *first, is_as_read);
    if (!broken_.empty()) return broken_;
    opened.mesh = std::move(first->mesh);
    if (first->drops_quarantined) {
      opened.tables.quarantine.clear();
      opened.used = opened.used_later;
    }
    if (run_one(opened, recipe, "again: ")->is_changed) broken_.push_back("again: changes something");
    for (const std::string& id : formats) {
      const Format& format = *find_format(id);
      const MeshFile written = edited_file(opened.file, opened.mesh, opened.tables);
      if (loses_what_uses_vertices(written, format)) continue;
      const std::string bytes = bytes_of(written, format);
      Result<MeshFile> back = read_mesh(bytes, format);
      if (!back) {
        broken_.push_back(id + ": cannot be read again");
        continue;
      }
      Opened again(std::move(back).value());
      if (run_one(again, recipe, id + ": ")->is_changed) broken_.push_back(id + ": changes something");
    }
    return broken_;
  }

 private:
  std::optional<RecipeResult> run_one(const Opened& opened, const NamedRecipe& recipe, const std::string& where) {
    RecipeEvents events;
    events.step_done = [&](const RecipeStep& step, std::size_t round, const AlgorithmResult& done) {
      if (done.changed == 0 && done.text.en.starts_with("Nothing was changed: "))
        broken_.push_back(where + "round " + std::to_string(round) + ", " + std::string(step.row->id) +
                          " is refused: " + done.text.en);
    };
    return run_recipe(opened.mesh, recipe.steps, opened.input(), events);
  }

  void judge(const Opened& before, const RecipeResult& result, bool is_as_read) {
    if (const auto fault = check_invariants(result.mesh)) return broken_.push_back("invariant: " + fault->sentence);
    if (const std::string fault = is_as_read ? differs_from_reading(result.mesh) : ""; !fault.empty())
      broken_.push_back("differs from reading: " + fault);
    const FindingCounts had = count_findings(before.mesh), has = count_findings(result.mesh);
    for (const ProblemRow& row : problem_table()) {
      const auto k = static_cast<std::size_t>(row.kind);
      if (!must_not_grow(row) || has[k] <= had[k]) continue;
      const std::size_t more = has[k] - had[k];
      const bool may_close = row.kind == ProblemKind::duplicate_face;
      if (!may_close || pockets_of(before.mesh).size() + more > pockets_of(result.mesh).size())
        broken_.push_back(id_of(row.kind) + " grows from " + std::to_string(had[k]) + " to " + std::to_string(has[k]));
    }
    if (!result.is_changed && result.mesh.columns() != before.mesh.columns())
      broken_.push_back("a recipe that changes nothing leaves a trace");
  }

  std::string kinds_;
  std::vector<std::string> broken_;
};

}  // namespace

NamedRecipe recipe_of(const std::string& kinds) {
  NamedRecipe recipe{kinds, {}};
  for (const std::string_view word : split_list(kinds)) {
    const std::size_t equals = std::min(word.find('='), word.size());
    const AlgorithmRow* const row = find_algorithm(word.substr(0, equals));
    ParameterValues values(row->parameters);
    if (equals < word.size()) values.set(row->parameters[0].id, word.substr(equals + 1), {});
    recipe.steps.push_back({row, std::move(values)});
  }
  return recipe;
}

std::vector<std::string> single_repairs() {
  std::vector<std::string> all;
  for (const AlgorithmRow& row : algorithm_table()) {
    if (!row.is_repair()) continue;
    const std::string id(row.id);
    if (row.parameters.empty() || !row.parameters[0].is_required) {
      all.push_back(id);
    } else {
      for (const char* share : {"=0", "=0.1%", "=1%", "=5%"}) all.push_back(id + share);
    }
  }
  return all;
}

std::string random_recipe(std::uint64_t seed) {
  Dice dice(seed);
  const std::vector<std::string> all = single_repairs();
  const int wanted = 2 + dice.below(4);
  std::vector<std::size_t> chosen;
  while (chosen.size() < static_cast<std::size_t>(wanted)) {
    const auto i = static_cast<std::size_t>(dice.below(static_cast<int>(all.size())));
    const std::string id = all[i].substr(0, all[i].find('='));
    const bool is_new = std::none_of(chosen.begin(), chosen.end(),
                                     [&](std::size_t k) { return all[k].substr(0, all[k].find('=')) == id; });
    if (is_new) chosen.push_back(i);
  }
  std::sort(chosen.begin(), chosen.end());
  std::string kinds;
  for (std::size_t i : chosen) kinds += (kinds.empty() ? "" : ",") + all[i];
  return kinds;
}

std::vector<std::string> broken_rules(MeshFile file, const std::string& kinds,
                                      const std::vector<std::string>& formats) {
  return RuleCheck(kinds).run(std::move(file), formats);
}

std::vector<std::filesystem::path> mesh_files_in(const std::filesystem::path& folder, std::uintmax_t most_bytes) {
  std::vector<std::filesystem::path> found;
  if (!std::filesystem::exists(folder)) return found;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder))
    if (entry.is_regular_file() && may_be_mesh(entry.path()) && entry.file_size() <= most_bytes)
      found.push_back(entry.path());
  std::sort(found.begin(), found.end());
  return found;
}

}  // namespace ryosen::test
