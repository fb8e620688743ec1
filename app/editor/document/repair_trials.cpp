#include "app/editor/document/repair_trials.h"

#include <new>
#include <system_error>
#include <utility>

#include "ryosen/base/interruption.h"

namespace ryosen {

namespace {

RepairReport no_memory() {
  return {0, {}, {}, {}, Text{"there is no memory for a copy to try it on", "試すための写しを作るメモリがありません"}};
}

}  // namespace

class RepairTrials::Running {
 public:
  Running(const Document& document, std::string of_line, RepairCall call)
      : line(std::move(of_line)), document_(document), call_(std::move(call)), beside_(document.beside_repairs()) {
    try {
      thread_ = std::thread([this] { run(); });
    } catch (const std::system_error&) {
      run();
    }
  }
  ~Running() {
    is_cancelled_ = true;
    if (thread_.joinable()) thread_.join();
  }

  const std::string line;
  double share() const { return share_; }
  bool is_done() const { return is_done_; }
  void wait_for_copy() const { is_copied_.wait(false); }
  RepairReport take() {
    if (thread_.joinable()) thread_.join();
    return lacks_memory_ ? no_memory() : std::move(report_);
  }

 private:
  void run() {
    try {
      const Interruptible interruptible(&is_cancelled_);
      Mesh mesh = document_.mesh();
      set_copied();
      const auto go_on = [this](double share) {
        share_ = share;
        return !is_cancelled_;
      };
      if (auto report = try_repair(std::move(mesh), call_, beside_.input(), go_on)) report_ = std::move(*report);
    } catch (const Interrupted&) {  // nobody takes it
    } catch (const std::bad_alloc&) {
      lacks_memory_ = true;  // even its sentence needs some
    }
    set_copied();
    is_done_ = true;
  }

  void set_copied() {
    is_copied_ = true;
    is_copied_.notify_all();
  }

  const Document& document_;  // until it is copied
  RepairCall call_;
  BesideRepairs beside_;
  RepairReport report_;
  bool lacks_memory_ = false;
  std::atomic<double> share_ = 0;
  std::atomic<bool> is_copied_ = false, is_done_ = false, is_cancelled_ = false;
  std::thread thread_;
};

void RepairTrials::RunningDeleter::operator()(Running* running) const { delete running; }

std::optional<double> RepairTrials::share() const { return running_ ? std::optional(running_->share()) : std::nullopt; }

void RepairTrials::forget() {
  running_.reset();
  reports_.clear();
}

void RepairTrials::let_write() {
  if (running_) running_->wait_for_copy();
}

void RepairTrials::follow(const Document& document) {
  if (serial_ != document.serial() || revision_ != document.revision()) {
    forget();
    serial_ = document.serial();
    revision_ = document.revision();
  }
  if (!running_ || !running_->is_done()) return;
  const auto done = std::exchange(running_, nullptr);
  reports_[done->line] = done->take();
}

const RepairReport* RepairTrials::of(const Document& document, const std::string& line, const RepairCall& call,
                                     bool replaces) {
  constexpr std::size_t most_reports = 100;
  follow(document);
  if (const auto known = reports_.find(line); known != reports_.end()) return &known->second;
  if (replaces && running_ && running_->line != line) cancel();
  if (running_) return nullptr;
  if (reports_.size() >= most_reports) reports_.clear();
  if (in_background) {
    running_.reset(new Running(document, line, call));
    return nullptr;
  }
  RepairReport report;
  try {
    const BesideRepairs beside = document.beside_repairs();
    report = try_repair(document.mesh(), call, beside.input(), {}).value();
  } catch (const std::bad_alloc&) {
    report = no_memory();
  }
  return &(reports_[line] = std::move(report));
}

}  // namespace ryosen
