#include "tests/support/app/table_lines.h"

#include <gtest/gtest.h>

#include <map>

#include "app/cli/subcommand_table.h"
#include "ryosen/algo/algorithm_table.h"
#include "ryosen/document/document.h"
#include "tests/support/app/algorithm_call.h"
#include "tests/support/core/all_targets.h"
#include "tests/support/core/random_ops.h"

namespace ryosen::test {

namespace {

// What a command needs besides its operand. A command that needs something and is not here ends as bad usage.
Words further_words(std::string_view id) {
  static const std::map<std::string_view, Words> needed{
      {"check", {"--self-intersections"}},
      {"why", {"--op", "swap", "--all"}},
      {"edit", {"--do", "poke f0", "-o", "o.obj"}},
      {"repair", {"-o", "o.obj"}},
      {"convert", {"-o", "o.ply"}},
      {"shot", {"-o", "o.png"}},
  };
  const auto found = needed.find(id);
  return found == needed.end() ? Words() : found->second;
}

// A mesh, unless the command takes more.
Words operands_of(std::string_view id, const std::string& mesh) {
  const std::map<std::string_view, Words> several{{"distance", {mesh, mesh}}, {"steps", {"walk v0", mesh}}};
  const auto found = several.find(id);
  return found == several.end() ? Words{mesh} : found->second;
}

Words line_of(const cli::Subcommand& row, const std::string& mesh) {
  if (row.is_algorithm) {
    Words words = words_for(*find_algorithm(row.id), mesh);
    words.insert(words.end(), {"-o", "o.obj"});
    return words;
  }
  Words words{std::string(row.id)};
  if (row.operand_is_command)
    words.push_back("json");
  else if (row.most_operands() > 0)
    for (const std::string& word : operands_of(row.id, mesh)) words.push_back(word);
  for (const std::string& word : further_words(row.id)) words.push_back(word);
  return words;
}

// With arguments that make it legal, where some chance finds them.
Words line_of_op(std::size_t place, const std::string& mesh_file, const Mesh& mesh) {
  std::string line;
  Dice dice(place);
  for (int i = 0; i < 200; ++i) {
    const AnyOp op = random_op(mesh, place, dice);
    if (info_of(op).id != all_ops()[place].id) continue;
    line = command_of(mesh, op);
    if (check(mesh, op).legal()) break;
  }
  if (line.empty()) return {"why", mesh_file, "--do", std::string(all_ops()[place].id) + " v0"};
  return {"edit", mesh_file, "--do", line, "-o", "o.obj"};
}

}  // namespace

std::vector<Words> lines_of_tables(const std::string& mesh, const std::filesystem::path& folder) {
  std::vector<Words> lines;
  for (const cli::Subcommand& row : cli::subcommands()) lines.push_back(line_of(row, mesh));
  const auto document = Document::open(mesh);
  EXPECT_TRUE(document.ok()) << mesh;
  for (std::size_t place = 0; place < all_ops().size(); ++place)
    lines.push_back(line_of_op(place, mesh, (*document)->mesh()));
  for (const WriteOptions& target : all_targets()) {
    std::string id(target.format->id);
    for (const FormatVariant& variant : target.format->variants)
      if (variant.encoding == target.encoding) id = variant.id;
    const std::string extension(target.format->extensions[0]), made = (folder / (id + extension)).string();
    lines.push_back({"convert", mesh, "-o", "o" + extension, "--format", id});
    EXPECT_TRUE(write_mesh_file(made, (*document)->contents(), target).ok()) << made;
    lines.push_back({"check", made});
  }
  return lines;
}

}  // namespace ryosen::test
