#include "app/editor/textbook/growth_work.h"

#include <memory>
#include <system_error>
#include <utility>

#include "ryosen/textbook/forms/growth/meshes.h"

namespace ryosen {

void GrowthWork::begin(const Mesh* mesh, const forms::GrowthEffort& effort) {
  cancel();
  is_cancelled_ = false;
  is_running_ = true;
  share_ = 0;
  const std::shared_ptr<const Mesh> copy = mesh ? std::make_shared<const Mesh>(*mesh) : nullptr;
  try {
    thread_ = std::thread([this, copy, effort] { measure(copy.get(), effort); });
  } catch (const std::system_error&) {
    measure(copy.get(), effort);
  }
}

void GrowthWork::measure(const Mesh* mesh, const forms::GrowthEffort& effort) {
  try {
    Progress progress([this](double share) {
      share_ = share;
      return !is_cancelled_;
    });
    const std::vector<Mesh> meshes =
        mesh ? forms::growing_parts(*mesh, effort.most_faces) : forms::growing_tori(effort.most_faces);
    std::vector<forms::GrowthCurve> found = forms::measure_growth(meshes, effort, progress);
    if (!progress.is_cancelled()) curves_ = std::move(found);
  } catch (...) {
    thrown_ = std::current_exception();
  }
  is_running_ = false;
}

void GrowthWork::cancel() {
  is_cancelled_ = true;
  wait();
}

void GrowthWork::wait() {
  if (thread_.joinable()) thread_.join();
}

std::span<const forms::GrowthCurve> GrowthWork::curves() {
  wait();
  if (thrown_) std::rethrow_exception(std::exchange(thrown_, nullptr));
  return curves_;
}

}  // namespace ryosen
