#include "ryosen/analysis/coincident_points.h"

#include "ryosen/base/interruption.h"
#include "ryosen/geometry/is_finite.h"
#include "ryosen/geometry/place_keys.h"
#include "ryosen/mesh/copies.h"

namespace ryosen {

namespace {

bool takes_part(const Mesh& mesh, Vertex v) {
  return mesh.exists(v) && mesh.is_alive(v) && point(mesh, v) == v && is_finite(mesh.position(v));
}

}  // namespace

CoincidentPoints::CoincidentPoints(const Mesh& mesh) : places_(mesh.vertex_slots()), rings_(mesh.vertex_slots()) {
  std::size_t buckets = 64;
  while (buckets < mesh.live().vertices) buckets *= 2;
  buckets_.assign(buckets, no_index);
  for (Vertex v(0); v.index < mesh.vertex_slots(); ++v.index) {
    stop_if_interrupted(v.index);
    insert(mesh, v);
  }
}

std::vector<Vertex> CoincidentPoints::update(const Mesh& mesh, std::span<const Vertex> changed) {
  std::vector<Vertex> asked(changed.begin(), changed.end());
  for (Vertex v(mesh.vertex_slots()); v.index < rings_.size(); ++v.index) asked.push_back(v);
  const std::size_t own = asked.size();
  // The only other one at a place: alone when this one leaves, no longer alone when it comes.
  const auto ask_other = [&](Vertex v) {
    if (is_on_another(v) && rings_[v.index].next == rings_[v.index].prev) asked.emplace_back(rings_[v.index].next);
  };
  for (std::size_t i = 0; i < own; ++i) {
    const Vertex v = asked[i];
    if (v.index >= rings_.size()) continue;
    ask_other(v);
    erase(v);
  }
  places_.resize(mesh.vertex_slots());
  rings_.resize(mesh.vertex_slots());
  for (std::size_t i = 0; i < own; ++i) {
    const Vertex v = asked[i];
    if (v.index >= rings_.size()) continue;
    insert(mesh, v);
    ask_other(v);
  }
  return asked;
}

void CoincidentPoints::insert(const Mesh& mesh, Vertex v) {
  if (!takes_part(mesh, v)) return;
  if (count_ >= buckets_.size()) grow();
  Ring& ring = rings_[v.index];
  Place& place = places_[v.index];
  place.hash = hash_of_place(mesh.position(v));
  std::uint32_t& bucket = bucket_of(place.hash);
  for (std::uint32_t i = bucket; i != no_index; i = places_[i].chain) {
    if (places_[i].hash != place.hash || mesh.position(Vertex(i)) != mesh.position(v)) continue;
    ring = {rings_[i].next, i};
    rings_[rings_[i].next].prev = v.index;
    rings_[i].next = v.index;
    return;
  }
  ring = {v.index, v.index};
  place.chain = bucket;
  bucket = v.index;
  ++count_;
}

void CoincidentPoints::erase(Vertex v) {
  const Ring ring = rings_[v.index];
  if (ring.next == no_index) return;
  const bool is_alone = ring.next == v.index;
  const std::uint32_t chain = places_[v.index].chain;
  if (is_alone) {
    replace_first(v.index, chain);
    --count_;
  } else if (chain != not_first) {
    replace_first(v.index, ring.next);
    places_[ring.next].chain = chain;
  }
  rings_[ring.prev].next = ring.next;
  rings_[ring.next].prev = ring.prev;
  rings_[v.index] = {};
  places_[v.index] = {};
}

// In the chain of its bucket.
void CoincidentPoints::replace_first(std::uint32_t i, std::uint32_t other) {
  std::uint32_t* at = &bucket_of(places_[i].hash);
  while (*at != i) at = &places_[*at].chain;
  *at = other;
}

void CoincidentPoints::grow() {
  buckets_.assign(2 * buckets_.size(), no_index);
  for (std::uint32_t i = 0; i < places_.size(); ++i) {
    Place& place = places_[i];
    if (place.chain == not_first) continue;
    place.chain = bucket_of(place.hash);
    bucket_of(place.hash) = i;
  }
}

std::vector<std::uint32_t> find_coincident_points(Neighbourhood& around) {
  const CoincidentPoints points(around.mesh());
  std::vector<std::uint32_t> found;
  for (Vertex v(0); v.index < around.mesh().vertex_slots(); ++v.index)
    if (points.is_on_another(v)) found.push_back(v.index);
  return found;
}

}  // namespace ryosen
