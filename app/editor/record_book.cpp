#include "app/editor/record_book.h"

#include <system_error>

#include "core/forms/all.h"

namespace ryosen {

void RecordBook::begin(const Document& document) {
  wait();
  is_begun_ = true;
  is_done_ = false;
  thrown_ = nullptr;
  serial_ = document.serial();
  revision_ = document.revision();
  auto mesh = std::make_shared<const Mesh>(document.mesh());
  try {
    thread_ = std::thread([this, mesh] { build(*mesh); });
  } catch (const std::system_error&) {
    build(*mesh);
  }
}

void RecordBook::build(const Mesh& mesh) {
  try {
    records_.clear();
    for (const forms::FormRow& row : forms::all_forms()) records_.emplace_back(mesh, row);
  } catch (...) {
    thrown_ = std::current_exception();
  }
  is_done_ = true;
}

std::span<const forms::Records> RecordBook::records() const {
  if (thrown_) std::rethrow_exception(thrown_);
  return records_;
}

}  // namespace ryosen
