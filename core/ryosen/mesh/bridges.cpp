#include "ryosen/mesh/bridges.h"

#include <algorithm>
#include <tuple>

namespace ryosen {

namespace {

constexpr std::uint32_t unknown = 0xffffffffu, nowhere = 0xfffffffeu;

// Side k runs from corner k to the next corner of its list.
struct Side {
  std::uint32_t low, high, place;
  bool up;
};

std::vector<std::uint32_t> next_places(const CornerLoops& loops) {
  std::vector<std::uint32_t> next(loops.corners.size());
  std::uint32_t begin = 0;
  for (std::uint32_t end : loops.ends) {
    for (std::uint32_t k = begin; k < end; ++k) next[k] = k + 1 < end ? k + 1 : begin;
    begin = end;
  }
  return next;
}

std::vector<Side> sorted_sides(const CornerLoops& loops, const std::vector<std::uint32_t>& next) {
  std::vector<Side> sides;
  sides.reserve(next.size());
  for (std::uint32_t k = 0; k < next.size(); ++k) {
    const std::uint32_t a = loops.corners[k], b = loops.corners[next[k]];
    sides.push_back({std::min(a, b), std::max(a, b), k, a < b});
  }
  std::sort(sides.begin(), sides.end(), [](const Side& s, const Side& t) {
    return std::tie(s.low, s.high, s.place) < std::tie(t.low, t.high, t.place);
  });
  return sides;
}

// Removes the two sides of each bridge from the cycles in `next`. Returns the number of bridges, or none if a side
// occurs twice in one direction. The entries of removed sides are meaningless afterwards.
std::optional<std::size_t> unlink_bridges(const CornerLoops& loops, std::vector<std::uint32_t>& next,
                                          std::vector<bool>& taken) {
  const std::vector<Side> sides = sorted_sides(loops, next);
  std::vector<std::uint32_t> opposite(next.size());
  std::size_t bridges = 0;
  for (std::size_t i = 1; i < sides.size(); ++i) {
    const Side &s = sides[i - 1], &t = sides[i];
    if (s.low != t.low || s.high != t.high) continue;
    if (s.up == t.up || taken[s.place]) return std::nullopt;
    taken[s.place] = taken[t.place] = true;
    opposite[s.place] = t.place;
    opposite[t.place] = s.place;
    ++bridges;
  }
  // A removed side is replaced by the successor of its opposite. Chains are followed once and memoised; one that closes
  // on itself (all edges at a corner are bridges) has no end: `nowhere`.
  std::vector<std::uint32_t> behind(next.size(), unknown);
  std::vector<std::uint32_t> chain;
  const auto find_behind = [&](std::uint32_t side) {
    chain.clear();
    while (taken[side] && behind[side] == unknown) {
      behind[side] = nowhere;
      chain.push_back(side);
      side = next[opposite[side]];
    }
    const std::uint32_t end = taken[side] ? behind[side] : side;
    for (std::uint32_t c : chain) behind[c] = end;
    return end;
  };
  std::vector<std::uint32_t> past(next.size());
  for (std::uint32_t k = 0; k < next.size(); ++k) {
    past[k] = find_behind(next[k]);
    if (past[k] == nowhere && !taken[k]) return std::nullopt;
  }
  next = std::move(past);
  return bridges;
}

bool are_simple(const CornerLoops& loops, const std::vector<std::vector<std::uint32_t>>& parts) {
  std::vector<std::uint32_t> vertices;
  for (const auto& part : parts) {
    if (part.size() < 3) return false;
    for (std::uint32_t place : part) vertices.push_back(loops.corners[place]);
  }
  std::sort(vertices.begin(), vertices.end());
  return std::adjacent_find(vertices.begin(), vertices.end()) == vertices.end();
}

}  // namespace

void CornerLoops::add(std::span<const std::uint32_t> loop) {
  corners.insert(corners.end(), loop.begin(), loop.end());
  ends.push_back(static_cast<std::uint32_t>(corners.size()));
}

std::optional<std::vector<std::vector<std::uint32_t>>> take_out_bridges(const CornerLoops& loops) {
  std::vector<std::uint32_t> next = next_places(loops);
  std::vector<bool> done(next.size(), false);
  const auto bridges = unlink_bridges(loops, next, done);
  if (!bridges) return std::nullopt;
  std::vector<std::vector<std::uint32_t>> parts;
  for (std::uint32_t start = 0; start < next.size(); ++start) {
    if (done[start]) continue;
    parts.emplace_back();
    for (std::uint32_t k = start; !done[k]; k = next[k]) {
      done[k] = true;
      parts.back().push_back(k);
    }
  }
  // Removing a bridge must split one loop in two; otherwise there are fewer parts.
  if (parts.size() != loops.ends.size() + *bridges || !are_simple(loops, parts)) return std::nullopt;
  return parts;
}

std::vector<std::vector<std::uint32_t>> normal_form(const CornerLoops& loops,
                                                    const std::vector<std::vector<std::uint32_t>>& parts) {
  std::vector<std::vector<std::uint32_t>> form = parts;
  for (auto& part : form) {
    for (std::uint32_t& place : part) place = loops.corners[place];
    std::rotate(part.begin(), std::min_element(part.begin(), part.end()), part.end());
  }
  std::sort(form.begin(), form.end());
  return form;
}

}  // namespace ryosen
