#include "ryosen/algo/crossings/faces_at_hubs.h"

namespace ryosen {

FacesAtHubs::FacesAtHubs(std::span<const glm::dvec3> ends) : places_(ends.begin(), ends.end()) {}

FacesAtHubs::Slot FacesAtHubs::add(Face f, const TriangleCorners& corners) {
  auto slot = static_cast<Slot>(faces_.size());
  if (free_slots_.empty()) {
    faces_.emplace_back();
  } else {
    slot = free_slots_.back();
    free_slots_.pop_back();
  }
  faces_[slot] = f;
  change(slot, corners);
  return slot;
}

void FacesAtHubs::change(Slot slot, const TriangleCorners& corners) {
  seen_.resize(2 * faces_.size());
  reach_.add(box_of(corners));
  if (places_.size() == 1) {
    for (std::uint32_t i : {0u, 1u}) seen_[2 * slot + i] = directions::direction(places_[0], corners[i + 1]);
  } else {
    const Box page = directions::page_of({places_[0], places_[1]}, corners[2]);
    seen_[2 * slot] = page.lowest;
    seen_[2 * slot + 1] = page.highest;
  }
  tree_.insert(seen_, slot, Primitive::segment(2 * slot, 2 * slot + 1, slot));
}

void FacesAtHubs::erase(Slot slot) {
  tree_.erase(slot);
  faces_[slot] = Face();
  free_slots_.push_back(slot);
}

Frustum FacesAtHubs::region_of(const NumberedTriangle& triangle, std::span<const std::uint32_t> numbers) const {
  return places_.size() == 1 ? directions::cone_of(triangle, numbers[0], places_[0])
                             : directions::wedge_of(triangle, numbers, {places_[0], places_[1]});
}

}  // namespace ryosen
