// What the questions and their answers share.
#pragma once

#include <optional>
#include <string>

#include "app/editor/practice.h"
#include "core/forms/all.h"
#include "core/forms/records.h"
#include "core/mesh/names.h"

namespace ryosen {

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
