#include "ryosen/analysis/self_intersections.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <deque>
#include <utility>

#include "ryosen/analysis/overlap_tree.h"
#include "ryosen/base/parallel.h"
#include "ryosen/base/sort_unique.h"
#include "ryosen/geometry/triangles_meet.h"

namespace ryosen {

namespace {

struct SlotRange {
  std::uint32_t begin, end;
  std::uint32_t size() const { return end - begin; }
};

// How many triangles the face of each slot has, and which pairs of faces have too many to be told by FirstMeeting.
class FaceSizes {
 public:
  explicit FaceSizes(const NumberedSurface& surface) {
    for_each_face(surface, [&](SlotRange slots) {
      if (slots.size() > least_large) large_.push_back(slots);
    });
    if (large_.empty()) return;
    sizes_.resize(surface.slots());
    for_each_face(surface, [&](SlotRange slots) {
      const auto size = static_cast<std::uint8_t>(std::min(slots.size(), most_told));
      std::fill(sizes_.begin() + slots.begin, sizes_.begin() + slots.end, size);
    });
  }

  // More than 64 pairs of triangles. One of the faces is large then.
  bool are_many(std::uint32_t a, std::uint32_t b) const {
    return !sizes_.empty() && unsigned{sizes_[a]} * sizes_[b] > least_large * least_large;
  }
  // With whatever other face.
  bool are_many_with_any(std::uint32_t slot) const {
    return !sizes_.empty() && sizes_[slot] > least_large * least_large;
  }
  // Whether such a pair of faces is searched from that of a.
  bool is_searched_from(std::uint32_t a, std::uint32_t b) const {
    return sizes_[a] != sizes_[b] ? sizes_[a] > sizes_[b] : a < b;
  }
  // The slots of each large face.
  const std::vector<SlotRange>& large() const { return large_; }

 private:
  static constexpr std::uint32_t least_large = 8, most_told = 255;

  template <class Visit>
  static void for_each_face(const NumberedSurface& surface, const Visit& visit) {
    for (std::uint32_t begin = 0, end = 0; begin < surface.slots(); begin = end) {
      while (end < surface.slots() && surface.face(end) == surface.face(begin)) ++end;
      visit(SlotRange{begin, end});
    }
  }

  std::vector<SlotRange> large_;
  std::vector<std::uint8_t> sizes_;  // by slot, none above most_told; empty where no face is large
};

// Finds each pair of faces with few triangles once, although several of them may meet: where the first ones do.
class FirstMeeting {
 public:
  explicit FirstMeeting(const NumberedSurface& surface) : surface_(surface) {}

  bool is_between(std::uint32_t a, std::uint32_t b) const {
    if (surface_.face(b) < surface_.face(a)) std::swap(a, b);
    if (surface_.face(a) == surface_.face(b) || !meet(a, b)) return false;
    const SlotRange of_f = triangles_about(a), of_g = triangles_about(b);
    for (std::uint32_t i = of_f.begin; i <= a; ++i)
      for (std::uint32_t k = of_g.begin; k < (i == a ? b : of_g.end); ++k)
        if (!surface_.is_flat(i) && !surface_.is_flat(k) && meet(i, k)) return false;
    return true;
  }
  bool meet(std::uint32_t a, std::uint32_t b) const {
    return meet_elsewhere(surface_.triangle(a), surface_.triangle(b));
  }

 private:
  // The triangles of a face, which follow each other.
  SlotRange triangles_about(std::uint32_t slot) const {
    SlotRange range{slot, slot + 1};
    const Face f = surface_.face(slot);
    while (range.begin > 0 && surface_.face(range.begin - 1) == f) --range.begin;
    while (range.end < surface_.slots() && surface_.face(range.end) == f) ++range.end;
    return range;
  }

  const NumberedSurface& surface_;
};

// A range of nodes or of large faces, where its search stopped because that was enough, and what it found.
struct Part {
  SlotRange left;
  std::vector<FacePair> pairs;
  std::size_t uncounted = 0;  // pairs that were not kept
};

class Search {
 public:
  enum class Beyond { counts, stops };  // beyond the pairs that are kept

  Search(const Mesh& mesh, std::size_t most, unsigned threads, Progress& progress, Beyond beyond = Beyond::counts)
      : mesh_(mesh),
        progress_(progress),
        surface_(mesh),
        sizes_(surface_),
        most_(most),
        stops_(beyond == Beyond::stops),
        threads_(threads == 0 ? threads_for(steps_for_each * surface_.slots()) : threads),
        tree_(surface_, threads_),
        meeting_(surface_) {}

  std::optional<SelfIntersections> run() {
    const std::size_t parts = sizes_.large().empty() ? 1 : 2;
    progress_.begin_part(0, parts);
    search_all(tree_.node_count(), part_of_nodes,
               [&](unsigned, Part& part, bool keeps) { search_node(part, part.left.begin, keeps); });
    if (!sizes_.large().empty()) {
      progress_.begin_part(1, parts);
      leaves_ = tree_.leaves_of_slots();
      for (auto& met : met_by_task_) met.assign(mesh_.face_slots(), 0);
      search_all(static_cast<std::uint32_t>(sizes_.large().size()), part_of_large,
                 [&](unsigned task, Part& part, bool keeps) {
                   search_large(part, sizes_.large()[part.left.begin], keeps, met_by_task_[task]);
                 });
    }
    if (progress_.is_cancelled()) return std::nullopt;
    if (is_beyond()) return SelfIntersections{{}, most_ + 1, {}};
    return take();
  }

 private:
  // None depends on the number of threads, so the pairs kept do not.
  static constexpr std::uint32_t part_of_nodes = 256, part_of_large = 64, tasks = 8;
  // Of a triangle's place in the tree, and of the search for what meets it.
  static constexpr std::size_t steps_for_each = 16;
  static constexpr std::size_t enough = 1 << 15;  // pairs that a part holds before it stops

  // Calls search_one(task, part, keeps) for each number below `count`, which begins what is left of the part.
  template <class SearchOne>
  void search_all(std::uint32_t count, std::uint32_t part_size, const SearchOne& search_one) {
    std::deque<SlotRange> left;
    for (std::uint32_t i = 0; i < count; i += part_size) left.push_back({i, std::min(i + part_size, count)});
    // By what has been begun; the rest of a part that was enough for once is little.
    std::uint32_t begun = 0;
    while (!left.empty() && !is_beyond() && progress_.go_on(begun, count)) {
      std::vector<Part> found;
      for (; found.size() < tasks && !left.empty(); left.pop_front()) found.push_back({left.front(), {}, 0});
      begun = std::max(begun, found.back().left.end);
      const bool keeps = result_.pairs.size() < most_;
      if (!keeps && met_.empty()) met_.resize(mesh_.face_slots());
      for_each_task(static_cast<unsigned>(found.size()), threads_, [&](unsigned i) {
        for (Part& part = found[i]; part.left.size() > 0 && part.pairs.size() < enough && !is_beyond(part);
             ++part.left.begin)
          search_one(i, part, keeps);
      });
      for (std::size_t i = found.size(); i-- > 0;)
        if (found[i].left.size() > 0) left.push_front(found[i].left);
      for (const Part& part : found) {
        result_.count += part.pairs.size() + part.uncounted;
        for (const FacePair& pair : part.pairs) keep(pair);
      }
    }
  }

  // Whether that is more than asked for, where it is enough to know so: then what is found any more does not matter.
  bool is_beyond() const { return stops_ && result_.count > most_; }
  bool is_beyond(const Part& part) const { return stops_ && part.pairs.size() + part.uncounted > most_; }

  void search_node(Part& part, std::uint32_t node, bool keeps) {
    if (tree_.holds_for_all(node, [&](std::uint32_t slot) { return sizes_.are_many_with_any(slot); })) return;
    const auto may = [&](std::uint32_t a, std::uint32_t b) { return !sizes_.are_many(a, b); };
    tree_.visit_pairs(node, may, [&](std::uint32_t a, std::uint32_t b) {
      if (meeting_.is_between(a, b)) note(part, surface_.face(a), surface_.face(b), keeps);
      return !is_beyond(part);
    });
  }

  // The faces that a large one meets, each once; those with many triangles in common with it alone. `met` is all zero.
  void search_large(Part& part, SlotRange slots, bool keeps, std::vector<std::uint8_t>& met) {
    const Face f = surface_.face(slots.begin);
    std::vector<Face> found;
    for (std::uint32_t slot = slots.begin; slot < slots.end; ++slot) {
      if (leaves_[slot] == no_index) continue;
      const TrianglePlane plane(surface_.triangle(slot).places);
      const auto may = [&](std::uint32_t other) {
        const Face g = surface_.face(other);
        return met[g.index] == 0 && g != f && sizes_.are_many(slot, other) && sizes_.is_searched_from(slot, other) &&
               !plane.is_clear_of(surface_.triangle(other).places);
      };
      tree_.visit_overlaps(slot, leaves_[slot], may, [&](std::uint32_t other) {
        const Face g = surface_.face(other);
        if (!meeting_.meet(slot, other)) return;
        met[g.index] = 1;
        found.push_back(g);
      });
    }
    for (const Face g : found) {
      met[g.index] = 0;
      note(part, f, g, keeps);
    }
  }

  void note(Part& part, Face f, Face g, bool keeps) {
    if (keeps) {
      part.pairs.push_back({std::min(f, g), std::max(f, g)});
    } else {
      ++part.uncounted;
      mark(f, g);
    }
  }

  void mark(Face f, Face g) {
    for (Face face : {f, g}) std::atomic_ref(met_[face.index]).store(1, std::memory_order_relaxed);
  }

  void keep(const FacePair& pair) {
    if (result_.pairs.size() < most_) {
      result_.pairs.push_back(pair);
      return;
    }
    if (met_.empty()) met_.resize(mesh_.face_slots());
    mark(pair.first, pair.second);
  }

  SelfIntersections take() {
    std::sort(result_.pairs.begin(), result_.pairs.end());
    result_.faces = faces_of(result_.pairs);
    for (std::uint32_t i = 0; i < met_.size(); ++i)
      if (met_[i] != 0) result_.faces.emplace_back(i);
    sort_unique(result_.faces);
    return std::move(result_);
  }

  const Mesh& mesh_;
  Progress& progress_;
  NumberedSurface surface_;
  FaceSizes sizes_;
  std::size_t most_;
  bool stops_;
  unsigned threads_;
  OverlapTree tree_;
  FirstMeeting meeting_;
  SelfIntersections result_;
  std::vector<std::uint8_t> met_;  // by face: whether a pair that was not kept has it; empty while all are kept
  // Where a face is large:
  std::vector<std::uint32_t> leaves_;                         // by slot
  std::array<std::vector<std::uint8_t>, tasks> met_by_task_;  // by face
};

}  // namespace

SelfIntersections find_self_intersections(const Mesh& mesh, std::size_t most, unsigned threads) {
  Progress never_cancelled;
  return *find_self_intersections(mesh, most, threads, never_cancelled);
}

std::optional<SelfIntersections> find_self_intersections(const Mesh& mesh, std::size_t most, unsigned threads,
                                                         Progress& progress) {
  return Search(mesh, most, threads, progress).run();
}

std::optional<SelfIntersections> find_few_self_intersections(const Mesh& mesh, std::size_t most, Progress& progress) {
  return Search(mesh, most, 0, progress, Search::Beyond::stops).run();
}

std::vector<Face> faces_of(const std::vector<FacePair>& pairs) {
  std::vector<Face> faces;
  faces.reserve(2 * pairs.size());
  for (const FacePair& pair : pairs) {
    faces.push_back(pair.first);
    faces.push_back(pair.second);
  }
  sort_unique(faces);
  return faces;
}

}  // namespace ryosen
