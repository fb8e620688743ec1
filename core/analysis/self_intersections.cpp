#include "core/analysis/self_intersections.h"

#include <algorithm>
#include <atomic>
#include <deque>
#include <utility>

#include "core/analysis/overlap_tree.h"
#include "core/base/parallel.h"
#include "core/base/sort_unique.h"
#include "core/geometry/triangles_meet.h"

namespace ryosen {

namespace {

struct SlotRange {
  std::uint32_t begin, end;
  std::uint32_t size() const { return end - begin; }
};

// Finds each pair of faces once, although several of their triangles may meet: where the first ones do. Pairs of faces
// with too many triangles for that are found as often as their triangles meet.
class FirstMeeting {
 public:
  explicit FirstMeeting(const NumberedSurface& surface) : surface_(surface) {}

  enum class Answer { no, yes, one_of_many };
  Answer between(std::uint32_t a, std::uint32_t b) const {
    if (surface_.face(b) < surface_.face(a)) std::swap(a, b);
    const Face f = surface_.face(a), g = surface_.face(b);
    if (f == g || !meet(a, b)) return Answer::no;
    const SlotRange of_f = triangles_about(a), of_g = triangles_about(b);
    if (of_f.size() * of_g.size() > most_tests) return Answer::one_of_many;
    for (std::uint32_t i = of_f.begin; i <= a; ++i)
      for (std::uint32_t k = of_g.begin; k < (i == a ? b : of_g.end); ++k)
        if (!surface_.is_flat(i) && !surface_.is_flat(k) && meet(i, k)) return Answer::no;
    return Answer::yes;
  }

 private:
  static constexpr std::uint32_t most_tests = 64;

  bool meet(std::uint32_t a, std::uint32_t b) const {
    return meet_elsewhere(surface_.triangle(a), surface_.triangle(b));
  }
  // The triangles of a face, which follow each other; not all if there are more than most_tests on one side.
  SlotRange triangles_about(std::uint32_t slot) const {
    SlotRange range{slot, slot + 1};
    const Face f = surface_.face(slot);
    while (range.begin > 0 && slot - range.begin <= most_tests && surface_.face(range.begin - 1) == f) --range.begin;
    while (range.end < surface_.slots() && range.end - slot <= most_tests && surface_.face(range.end) == f) ++range.end;
    return range;
  }

  const NumberedSurface& surface_;
};

// What the search of a range of nodes found, and where it stopped because that was enough.
struct Part {
  SlotRange nodes;
  std::vector<FacePair> pairs, one_of_many;
  std::size_t uncounted = 0;  // pairs that were not kept
};

class Search {
 public:
  Search(const Mesh& mesh, std::size_t most, unsigned threads)
      : mesh_(mesh),
        surface_(mesh),
        most_(most),
        threads_(threads == 0 ? threads_for(surface_.slots()) : threads),
        tree_(surface_, threads_),
        meeting_(surface_) {}

  SelfIntersections run() {
    for (std::uint32_t node = 0; node < tree_.node_count(); node += part_size)
      left_.push_back({node, std::min(node + part_size, tree_.node_count())});
    while (!left_.empty()) search_some();
    return take();
  }

 private:
  // Neither depends on the number of threads, so the pairs kept do not.
  static constexpr std::uint32_t part_size = 256, parts = 8;
  static constexpr std::size_t enough = 1 << 15;  // pairs that a part holds

  void search_some() {
    std::vector<Part> found;
    for (; found.size() < parts && !left_.empty(); left_.pop_front()) found.push_back({left_.front(), {}, {}, 0});
    const bool keeps = result_.pairs.size() < most_;
    if (!keeps && met_.empty()) met_.resize(mesh_.face_slots());
    for_each_task(static_cast<unsigned>(found.size()), threads_, [&](unsigned i) { search(found[i], keeps); });
    for (std::size_t i = found.size(); i-- > 0;)
      if (found[i].nodes.size() > 0) left_.push_front(found[i].nodes);
    for (Part& part : found) add(part);
  }

  void search(Part& part, bool keeps) {
    for (; part.nodes.begin < part.nodes.end; ++part.nodes.begin) {
      if (part.pairs.size() + part.one_of_many.size() >= enough) return;
      tree_.visit_pairs(part.nodes.begin, [&](std::uint32_t a, std::uint32_t b) {
        const FirstMeeting::Answer answer = meeting_.between(a, b);
        if (answer == FirstMeeting::Answer::no) return true;
        const Face f = std::min(surface_.face(a), surface_.face(b)), g = std::max(surface_.face(a), surface_.face(b));
        if (answer == FirstMeeting::Answer::one_of_many) {
          part.one_of_many.push_back({f, g});
        } else if (keeps) {
          part.pairs.push_back({f, g});
        } else {
          ++part.uncounted;
          mark(f, g);
        }
        return true;
      });
    }
  }

  void mark(Face f, Face g) {
    for (Face face : {f, g}) std::atomic_ref(met_[face.index]).store(1, std::memory_order_relaxed);
  }

  void add(Part& part) {
    result_.count += part.pairs.size() + part.uncounted;
    for (const FacePair& pair : part.pairs) keep(pair);
    many_.insert(many_.end(), part.one_of_many.begin(), part.one_of_many.end());
    if (many_.size() < compact_at_) return;
    sort_unique(many_);
    compact_at_ = std::max(enough, 2 * many_.size());
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
    sort_unique(many_);
    result_.count += many_.size();
    for (const FacePair& pair : many_) keep(pair);
    std::sort(result_.pairs.begin(), result_.pairs.end());
    result_.faces = faces_of(result_.pairs);
    for (std::uint32_t i = 0; i < met_.size(); ++i)
      if (met_[i] != 0) result_.faces.emplace_back(i);
    sort_unique(result_.faces);
    return std::move(result_);
  }

  const Mesh& mesh_;
  NumberedSurface surface_;
  std::size_t most_;
  unsigned threads_;
  OverlapTree tree_;
  FirstMeeting meeting_;
  std::deque<SlotRange> left_;  // nodes
  SelfIntersections result_;
  std::vector<FacePair> many_;  // pairs of faces with many triangles
  std::size_t compact_at_ = enough;
  std::vector<std::uint8_t> met_;  // by face: whether a pair that was not kept has it; empty while all are kept
};

}  // namespace

SelfIntersections find_self_intersections(const Mesh& mesh, std::size_t most, unsigned threads) {
  return Search(mesh, most, threads).run();
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
