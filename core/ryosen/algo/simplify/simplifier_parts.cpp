// How a simplifier removes parts of the surface that are smaller than the error.
#include <algorithm>

#include "ryosen/algo/simplify/simplifier.h"
#include "ryosen/mesh/circulate.h"

namespace ryosen {

namespace {

bool is_larger(const std::pair<double, Vertex>& a, const std::pair<double, Vertex>& b) {
  return a.first != b.first ? a.first > b.first : a.second.index > b.second.index;
}

}  // namespace

void Simplifier::note_small_part(Halfedge h) {
  const std::optional<SmallPart> part = find_small_part(surface_, mesh_.from(h));
  if (!part) return;
  noted_parts_.emplace_back(part->size, part->vertices.front());
  std::push_heap(noted_parts_.begin(), noted_parts_.end(), is_larger);
}

// One may have been noted several times, and may have collapsed further since.
void Simplifier::remove_noted_parts() {
  while (!is_at_goal() && !noted_parts_.empty() && noted_parts_.front().first <= small_size()) {
    std::pop_heap(noted_parts_.begin(), noted_parts_.end(), is_larger);
    const Vertex v = noted_parts_.back().second;
    noted_parts_.pop_back();
    if (!mesh_.is_alive(v)) continue;
    const std::optional<SmallPart> part = find_small_part(surface_, v);
    if (part && part->size <= small_size()) remove(*part);
  }
}

void Simplifier::remove_small_parts() {
  for (const SmallPart& part : find_small_parts(surface_, small_size())) {
    if (is_at_goal()) return;
    remove(part);
  }
}

void Simplifier::remove(const SmallPart& part) {
  if (guard_)
    for (Vertex v : part.vertices)
      for (Halfedge h : outgoing(mesh_, v))
        if (!mesh_.is_outside(h)) guard_->forget(mesh_.face(h));
  if (steps_) edit_.emplace(writable_, steps_);
  remove_part(*edit_, part.vertices);
  if (steps_) {
    edit_->commit();
    edit_.reset();
  }
  ++removed_parts_;
}

}  // namespace ryosen
