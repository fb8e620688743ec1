// The rules that every repair and every recipe keeps on every mesh.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "ryosen/algo/repair/recipe.h"
#include "ryosen/io/mesh_file.h"

namespace ryosen::test {

struct NamedRecipe {
  std::string name;  // as --kinds has it
  std::vector<RecipeStep> steps;
};

// From the words of --kinds, without default; a length as a share of the diagonal of the mesh: weld_close=0.1%.
NamedRecipe recipe_of(const std::string& kinds);
// Every repair alone, as --kinds has it.
std::vector<std::string> single_repairs();
// Two to five different ones in the order of the table.
std::string random_recipe(std::uint64_t seed);

// Runs a recipe on the mesh of a file, again on its result, and again on its result written in each of these formats
// and read. What is broken of the rules, one line each; empty: nothing.
//  - sound columns, and those that reading gives
//  - no more findings of a kind that must_not_grow, but for duplicates by the pockets that closed
//  - no step is refused by its guard (run_guarded): the repairs themselves judge what is sound
//  - running it again changes nothing; not asked of a format that loses lines or points, which use vertices
std::vector<std::string> broken_rules(MeshFile file, const std::string& kinds,
                                      const std::vector<std::string>& formats = {"obj", "ply", "off"});

// The mesh files of a folder and those below it that can be read and have at most so many bytes, in byte order.
std::vector<std::filesystem::path> mesh_files_in(const std::filesystem::path& folder, std::uintmax_t most_bytes);

}  // namespace ryosen::test
