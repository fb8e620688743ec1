// The growth of the forms' work, measured beside the frames.
#pragma once

#include <atomic>
#include <exception>
#include <optional>
#include <span>
#include <thread>
#include <vector>

#include "ryosen/textbook/forms/growth/growth.h"

namespace ryosen {

class GrowthWork {
 public:
  GrowthWork() = default;
  ~GrowthWork() { cancel(); }
  GrowthWork(const GrowthWork&) = delete;
  GrowthWork& operator=(const GrowthWork&) = delete;

  // Begins to measure on parts of a mesh, of which it takes a copy, or on tori where there is none. What was begun
  // before is cancelled.
  void begin(const Mesh* mesh, const forms::GrowthEffort& effort = {});
  // Ends it; what was found before stays.
  void cancel();
  void wait();

  bool is_running() const { return is_running_; }
  double share() const { return share_; }
  // Of what ended last; empty where nothing did. Throws what was thrown when it was measured. Not while it runs.
  std::span<const forms::GrowthCurve> curves();

 private:
  void measure(const Mesh* mesh, const forms::GrowthEffort& effort);

  std::vector<forms::GrowthCurve> curves_;
  std::exception_ptr thrown_;
  std::atomic<bool> is_running_ = false, is_cancelled_ = false;
  std::atomic<double> share_ = 0;
  std::thread thread_;
};

}  // namespace ryosen
