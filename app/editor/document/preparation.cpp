#include "app/editor/document/preparation.h"

#include <new>
#include <system_error>
#include <utility>

#include "ryosen/base/interruption.h"

namespace ryosen {

namespace {

// The tree takes most of the time.
constexpr double share_of_tree = 0.6;
constexpr unsigned threads = 1;  // the others draw

}  // namespace

Preparation::Preparation(const Mesh& mesh, Picker& picker, Beside beside)
    : mesh_(mesh), picker_(picker), beside_(std::move(beside)) {
  try {
    thread_ = std::thread([this] { run(); });
  } catch (const std::system_error&) {
    run();
  } catch (const std::bad_alloc&) {
    run();
  }
}

Preparation::~Preparation() {
  is_cancelled_ = true;
  if (thread_.joinable()) thread_.join();
}

Preparation::Found Preparation::take() {
  if (thread_.joinable()) thread_.join();
  if (thrown_) std::rethrow_exception(thrown_);
  return std::move(found_);
}

bool Preparation::go_on(double share) {
  share_ = share;
  return !is_cancelled_;
}

void Preparation::run() {
  try {
    const Interruptible interruptible(&is_cancelled_);
    find();
  } catch (const Interrupted&) {  // nobody takes what is found
  } catch (...) {
    thrown_ = std::current_exception();
  }
  is_done_ = true;
}

void Preparation::find() {
  Progress of_tree([this](double share) { return go_on(share_of_tree * share); });
  picker_.prepare(mesh_, of_tree);
  const auto after = [](double share) { return share_of_tree + (1 - share_of_tree) * share; };
  if (!go_on(after(0))) return;
  found_.highlights = HighlightSets(mesh_, threads, beside_.on_lines);
  if (!go_on(after(0.4))) return;
  for (const HighlightRow* row : beside_.shown) found_.highlights.keep(mesh_, *row, threads);
  if (!go_on(after(0.5))) return;
  Neighbourhood around(mesh_, Neighbourhood::Reach::whole);
  found_.boundary_loops.search(around, found_.highlights.of(ProblemKind::boundary_loop));
  if (!go_on(after(0.6))) return;
  found_.euler = euler_poincare(mesh_, found_.highlights.problems());
  if (!go_on(after(0.8))) return;
  found_.kind = find_kind(mesh_, found_.highlights.problems(), beside_.lines);
  go_on(1);
}

}  // namespace ryosen
