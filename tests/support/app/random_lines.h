// Random command lines, made of the tables of commands, operators and algorithms, so that a new row is tried too.
#pragma once

#include <string>
#include <vector>

#include "app/editor/session/session.h"
#include "tests/support/core/random_meshes.h"

namespace ryosen::test {

class RandomLines {
 public:
  // `ids` are those of the commands that may come. Files are named o.EXT and in.EXT, without a folder.
  RandomLines(std::vector<std::string> ids, std::uint64_t seed);

  // A line that fits the syntax of its command more often than not; its elements mostly live.
  std::string next(const Session& session);

 private:
  std::string operator_line(const Session& session);
  std::string algorithm_line(const Session& session);
  // One of the forms that a syntax allows, with values in its places.
  std::string filled(const Session& session, std::string_view syntax);
  std::string word_for(const Session& session, std::string_view placeholder);
  std::string element(const Session& session);
  std::string number();
  template <class List>
  const auto& one_of(const List& list) {
    return list[static_cast<std::size_t>(dice_.below(static_cast<int>(std::size(list))))];
  }

  std::vector<std::string> ids_;
  std::vector<std::string> words_;  // ids of problems, highlights, maps, selectors
  Dice dice_;
};

}  // namespace ryosen::test
