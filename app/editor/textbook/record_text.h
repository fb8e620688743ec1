// The fields of a record as they are written, on the command line and in the panel.
#pragma once

#include <string>
#include <vector>

#include "ryosen/base/message.h"
#include "ryosen/textbook/forms/form.h"

namespace ryosen {

struct RecordLine {
  std::string key, word;            // Ryosen's and the text's
  std::vector<std::string> values;  // slot names, or places; one "none" where there is nothing
  std::vector<Element> links;       // where they lead, one by one; empty for places, and where there are none
  std::string stored;               // "= 5", or the numbers of a list; empty for places
};
std::vector<RecordLine> record_lines(const forms::Fields& fields, Language language);

}  // namespace ryosen
