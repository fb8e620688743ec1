// Plays begun for a test, and what their rows say replayed on empty tables.
#pragma once

#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "ryosen/base/result.h"
#include "ryosen/textbook/steps/sequence.h"

namespace ryosen::test {

using PlayArguments = std::vector<std::string>;

Result<std::unique_ptr<steps::Sequence>> play_or_refuse(std::string_view id, const Mesh& mesh,
                                                        const PlayArguments& arguments);

// The same where it must succeed.
std::unique_ptr<steps::Sequence> played(std::string_view id, const Mesh& mesh, const PlayArguments& arguments);

// Table, row, field: value. Expects that what a row says was there is what the tables hold.
using PlayedTables = std::map<std::string, std::map<std::string, std::map<std::string, std::string>>>;
void replay(PlayedTables& tables, const steps::Step& step);

}  // namespace ryosen::test
