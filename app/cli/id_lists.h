// The tables of the product whose ids are printed as values.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "app/cli/contract/shape.h"
#include "ryosen/base/message.h"
#include "ryosen/ops/parameters/op_parameter.h"

namespace ryosen::cli {

struct IdEntry {
  std::string id;
  Text text;
  std::vector<std::string_view> severities;  // with which it occurs; empty where it has none
  std::optional<std::string> syntax = {};    // of its arguments, where it may have some
  const OpLine* line = nullptr;              // of an operator
};

// Entries from the source texts: textbook/help_topics.cpp
std::vector<IdEntry> form_entries(), relation_entries(), pairing_entries(), steps_entries(), role_entries();

struct IdList {
  Ids ids;
  std::string_view id;
  std::string_view en, ja;
  std::vector<IdEntry> (*entries)();
};

// In the order of Ids.
std::span<const IdList> id_lists();
const IdList& list_of(Ids ids);

}  // namespace ryosen::cli
