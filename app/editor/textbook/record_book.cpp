#include "app/editor/textbook/record_book.h"

#include <system_error>
#include <utility>

#include "ryosen/textbook/forms/all.h"

namespace ryosen {

RecordBook::~RecordBook() {
  if (built_) built_->is_cancelled = true;
  if (thread_.joinable()) thread_.join();
}

void RecordBook::ask(const Document& document) {
  serial_ = document.serial();
  revision_ = document.revision();
  is_asked_ = true;
  if (!built_) return begin(document);
  if (built_->is_of(serial_, revision_) && !built_->is_cancelled) return;
  built_->is_cancelled = true;
  if (built_->is_done) begin(document);
}

template <class Work>
void RecordBook::go_on_with(Work work) {
  const auto run = [before = std::make_shared<std::thread>(std::move(thread_)),
                    shared = std::make_shared<Work>(std::move(work))] {
    if (before->joinable()) before->join();
    (*shared)();
  };
  try {
    thread_ = start_(run);
  } catch (const std::system_error&) {
    run();
  }
}

void RecordBook::begin(const Document& document) {
  std::shared_ptr<Build> old = std::exchange(built_, std::make_shared<Build>());
  built_->serial = document.serial();
  built_->revision = document.revision();
  auto mesh = std::make_shared<const Mesh>(document.mesh());
  go_on_with([old = std::move(old), work = built_, mesh]() mutable {
    old.reset();
    build(*work, *mesh);
  });
}

void RecordBook::build(Build& build, const Mesh& mesh) {
  try {
    for (const forms::FormRow& row : forms::all_forms()) {
      if (build.is_cancelled) break;
      build.records.emplace_back(mesh, row);
    }
  } catch (...) {
    build.thrown = std::current_exception();
  }
  build.is_done = true;
}

void RecordBook::wait_for(const Document& document) {
  for (ask(document); !is_ready(); ask(document))
    if (thread_.joinable()) thread_.join();
}

std::span<const forms::Records> RecordBook::records() const {
  if (built_->thrown) std::rethrow_exception(built_->thrown);
  return built_->records;
}

bool RecordBook::rest() {
  is_asked_ = false;
  if (!built_) return true;
  built_->is_cancelled = true;
  if (!built_->is_done) return false;
  go_on_with([old = std::exchange(built_, nullptr)]() mutable { old.reset(); });
  return true;
}

}  // namespace ryosen
