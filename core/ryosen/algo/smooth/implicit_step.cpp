#include "ryosen/algo/smooth/implicit_step.h"

#include <glm/geometric.hpp>

#include "ryosen/base/parallel.h"

namespace ryosen::smooth {

namespace {

constexpr std::size_t most_rounds = 2000;

double dot(const Places& a, const Places& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += glm::dot(a[i], b[i]);
  return sum;
}

// The system on the points that move; the others are 0 in every vector, or hold as constants.
class ImplicitSystem {
 public:
  ImplicitSystem(const Laplacian& laplacian, std::span<const double> strength)
      : laplacian_(laplacian), strength_(strength) {}

  bool moves(std::uint32_t i) const { return strength_[i] > 0 && laplacian_.sum(i) > 0; }
  double diagonal(std::uint32_t i) const { return laplacian_.sum(i) / strength_[i] + laplacian_.sum(i); }

  // What is left: the right side less the matrix times the places, with the constants.
  void residual(const Places& before, const Places& places, Places& out) const {
    for_each_point([&](std::uint32_t i) {
      out[i] = glm::dvec3(0);
      if (!moves(i)) return;
      out[i] = (laplacian_.sum(i) / strength_[i]) * (before[i] - places[i]);
      for (const Laplacian::Term& term : laplacian_.row(i)) out[i] += term.weight * (places[term.point] - places[i]);
    });
  }
  void times(const Places& x, Places& out) const {
    for_each_point([&](std::uint32_t i) {
      out[i] = glm::dvec3(0);
      if (!moves(i)) return;
      out[i] = diagonal(i) * x[i];
      for (const Laplacian::Term& term : laplacian_.row(i)) out[i] -= term.weight * x[term.point];
    });
  }
  void precondition(const Places& x, Places& out) const {
    for_each_point([&](std::uint32_t i) { out[i] = moves(i) ? x[i] / diagonal(i) : glm::dvec3(0); });
  }
  template <class Work>
  void for_each_point(const Work& work) const {
    const auto count = static_cast<std::uint32_t>(strength_.size());
    for_each_part(count, threads_for(count), [&](unsigned, std::uint32_t begin, std::uint32_t end) {
      for (std::uint32_t i = begin; i < end; ++i) work(i);
    });
  }

 private:
  const Laplacian& laplacian_;
  std::span<const double> strength_;
};

}  // namespace

bool implicit_step(const Laplacian& laplacian, std::span<const double> strength, Places& places, Progress& progress) {
  const ImplicitSystem system(laplacian, strength);
  const std::size_t n = places.size();
  Places x = places, rest(n), scaled(n), direction(n), image(n);
  system.residual(places, x, rest);
  system.precondition(rest, direction);
  double size = dot(rest, direction);
  const double enough = size * 1e-24;
  for (std::size_t round = 0; round < most_rounds && size > enough && size > 0; ++round) {
    if (!progress.go_on()) return false;
    system.times(direction, image);
    const double bend = dot(direction, image);
    if (!(bend > 0)) break;
    const double t = size / bend;
    system.for_each_point([&](std::uint32_t i) {
      x[i] += t * direction[i];
      rest[i] -= t * image[i];
    });
    system.precondition(rest, scaled);
    const double next = dot(rest, scaled), ratio = next / size;
    system.for_each_point([&](std::uint32_t i) { direction[i] = scaled[i] + ratio * direction[i]; });
    size = next;
  }
  places = std::move(x);
  return true;
}

}  // namespace ryosen::smooth
