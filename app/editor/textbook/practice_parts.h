// What the questions and their answers share.
#pragma once

#include <optional>
#include <string>

#include "app/editor/textbook/practice.h"
#include "ryosen/mesh/names.h"
#include "ryosen/textbook/forms/all.h"
#include "ryosen/textbook/forms/records.h"

namespace ryosen {

// The slot, and behind it the name where that is another one.
inline std::string full_name(const Mesh& mesh, Element e) {
  const std::string slot = slot_name(e), name = name_of(mesh, e);
  return name == slot ? slot : slot + " (" + name + ")";
}

// The records of a form: given, or built.
class RecordsOfForm {
 public:
  RecordsOfForm(const Mesh& mesh, const forms::FormRow& row, AllRecords given) {
    for (const forms::Records& records : given)
      if (&records.row() == &row) found_ = &records;
    if (!found_) found_ = &built_.emplace(mesh, row);
  }
  const forms::Records& operator*() const { return *found_; }
  const forms::Records* operator->() const { return found_; }

 private:
  std::optional<forms::Records> built_;
  const forms::Records* found_ = nullptr;
};

}  // namespace ryosen
