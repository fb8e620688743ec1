// Algorithms by the lines of scripts that call them.
#pragma once

#include <gtest/gtest.h>

#include "ryosen/algo/algorithm_table.h"
#include "ryosen/ops/all.h"

namespace ryosen::test {

// "cube size=3", as an entry of the history where it changes anything.
inline AlgorithmResult run_algorithm(Mesh& mesh, Journal& journal, std::string_view line) {
  const std::vector<std::string_view> words = split_words(line);
  const AlgorithmRow* const row = find_algorithm(words[0]);
  const ReadValues read = read_values(row->parameters, std::span(words).subspan(1));
  EXPECT_TRUE(read.values) << line << ": " << read.sentence.en;
  Progress unheard;
  Edit edit(mesh, &journal);
  AlgorithmResult result = row->run(edit, {*read.values->on(mesh).values}, unheard);
  if (result.changed > 0) edit.commit();
  return result;
}

// What it makes of an empty mesh.
inline Mesh made_by(std::string_view line) {
  Mesh mesh;
  Journal journal;
  EXPECT_GT(run_algorithm(mesh, journal, line).changed, 0u) << line;
  return mesh;
}

}  // namespace ryosen::test
