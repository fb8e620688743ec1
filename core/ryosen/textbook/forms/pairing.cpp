#include "ryosen/textbook/forms/pairing.h"

#include <algorithm>
#include <array>
#include <unordered_map>

#include "ryosen/indexed/pair_corners.h"

namespace ryosen {

namespace {

struct DirectedSide {
  std::uint32_t from, to;
};

// The directed side that starts at each corner.
std::vector<DirectedSide> sides_of(const IndexedMesh& source) {
  std::vector<DirectedSide> sides(source.corners.size());
  for (std::size_t f = 0; f < source.face_count(); ++f) {
    const std::uint32_t begin = source.face_offsets[f], end = source.face_offsets[f + 1];
    for (std::uint32_t c = begin; c < end; ++c)
      sides[c] = {source.corners[c], source.corners[c + 1 < end ? c + 1 : begin]};
  }
  return sides;
}

// Collects the sides between the two points of a side and joins it if there is exactly one in each direction.
template <class Counter>
class Candidates {
 public:
  Candidates(const std::vector<DirectedSide>& sides, std::uint32_t corner, Counter& counter)
      : sides_(sides), corner_(corner), counter_(counter) {}
  void consider(std::uint32_t other) {
    counter_.count();
    const DirectedSide &mine = sides_[corner_], &side = sides_[other];
    if (side.from == mine.to && side.to == mine.from) {
      ++against_;
      partner_ = other;
    } else if (side.from == mine.from && side.to == mine.to) {
      ++along_;
    }
  }
  std::uint32_t partner() const { return along_ == 1 && against_ == 1 ? partner_ : no_index; }

 private:
  const std::vector<DirectedSide>& sides_;
  std::uint32_t corner_;
  Counter& counter_;
  std::uint32_t along_ = 0, against_ = 0, partner_ = no_index;
};

template <class Counter>
SidePartners by_brute_force(const IndexedMesh& source, Counter& counter) {
  const std::vector<DirectedSide> sides = sides_of(source);
  SidePartners partners(sides.size());
  for (std::uint32_t c = 0; c < sides.size(); ++c) {
    Candidates candidates(sides, c, counter);
    for (std::uint32_t other = 0; other < sides.size(); ++other) candidates.consider(other);
    partners[c] = candidates.partner();
  }
  return partners;
}

// The splitmix64 finalizer over both numbers: every input bit affects every bit of the key.
std::uint64_t mixed_key(std::uint32_t from, std::uint32_t to) {
  std::uint64_t key = std::uint64_t{std::min(from, to)} << 32u | std::max(from, to);
  key = (key ^ (key >> 30u)) * 0xbf58476d1ce4e5b9ull;
  key = (key ^ (key >> 27u)) * 0x94d049bb133111ebull;
  return key ^ (key >> 31u);
}

template <class Counter>
struct EqualKeys {
  Counter* counter;
  bool operator()(std::uint64_t a, std::uint64_t b) const {
    counter->count();
    return a == b;
  }
};

// One container for all keys, so that what differs in time is due to the key. Keys are compared, and then sides.
template <class Counter, auto key_of>
SidePartners by_hash(const IndexedMesh& source, Counter& counter) {
  const std::vector<DirectedSide> sides = sides_of(source);
  std::unordered_multimap<std::uint64_t, std::uint32_t, std::hash<std::uint64_t>, EqualKeys<Counter>> corners_by_key(
      sides.size(), {}, {&counter});
  for (std::uint32_t c = 0; c < sides.size(); ++c) corners_by_key.emplace(key_of(sides[c].from, sides[c].to), c);
  SidePartners partners(sides.size());
  for (std::uint32_t c = 0; c < sides.size(); ++c) {
    Candidates candidates(sides, c, counter);
    const auto [begin, end] = corners_by_key.equal_range(key_of(sides[c].from, sides[c].to));
    for (auto i = begin; i != end; ++i) candidates.consider(i->second);
    partners[c] = candidates.partner();
  }
  return partners;
}

// Every point lists its outgoing sides; the partner of a side is searched in the list of its end.
template <class Counter>
SidePartners by_vertex_lists(const IndexedMesh& source, Counter& counter) {
  const std::vector<DirectedSide> sides = sides_of(source);
  std::vector<std::uint32_t> head(source.positions.size(), no_index), next(sides.size());
  for (std::uint32_t c = 0; c < sides.size(); ++c) {
    next[c] = head[sides[c].from];
    head[sides[c].from] = c;
  }
  SidePartners partners(sides.size());
  for (std::uint32_t c = 0; c < sides.size(); ++c) {
    Candidates candidates(sides, c, counter);
    for (const std::uint32_t end : {sides[c].from, sides[c].to})
      for (std::uint32_t other = head[end]; other != no_index; other = next[other]) candidates.consider(other);
    partners[c] = candidates.partner();
  }
  return partners;
}

// Element (i, j) of the matrix holds the sides from i to j: compressed sparse rows, each sorted by column.
template <class Counter>
class SparseMatrix {
 public:
  SparseMatrix(const std::vector<DirectedSide>& sides, std::size_t points, Counter& counter)
      : counter_(counter), row_(points + 1, 0), elements_(sides.size()) {
    for (const DirectedSide& side : sides) ++row_[side.from + 1];
    for (std::size_t i = 0; i < points; ++i) row_[i + 1] += row_[i];
    std::vector<std::uint32_t> at(row_.begin(), row_.end() - 1);
    for (std::uint32_t c = 0; c < sides.size(); ++c) elements_[at[sides[c].from]++] = {sides[c].to, c};
    for (std::size_t i = 0; i < points; ++i)
      std::sort(elements_.begin() + row_[i], elements_.begin() + row_[i + 1], [&](const Element& a, const Element& b) {
        counter_.count();
        return a.column < b.column;
      });
  }
  // The side, if the element has exactly one entry, else no_index.
  std::uint32_t only(std::uint32_t i, std::uint32_t j) const {
    const auto begin = elements_.begin() + row_[i], end = elements_.begin() + row_[i + 1];
    const auto found = std::lower_bound(begin, end, j, [&](const Element& e, std::uint32_t column) {
      counter_.count();
      return e.column < column;
    });
    if (found == end || !is_in(*found, j)) return no_index;
    return found + 1 != end && is_in(found[1], j) ? no_index : found->corner;
  }

 private:
  struct Element {
    std::uint32_t column, corner;
  };
  bool is_in(const Element& element, std::uint32_t column) const {
    counter_.count();
    return element.column == column;
  }

  Counter& counter_;
  std::vector<std::uint32_t> row_;
  std::vector<Element> elements_;
};

template <class Counter>
SidePartners by_sparse_matrix(const IndexedMesh& source, Counter& counter) {
  const std::vector<DirectedSide> sides = sides_of(source);
  const SparseMatrix<Counter> matrix(sides, source.positions.size(), counter);
  SidePartners partners(sides.size(), no_index);
  for (std::uint32_t c = 0; c < sides.size(); ++c)
    if (matrix.only(sides[c].from, sides[c].to) == c) partners[c] = matrix.only(sides[c].to, sides[c].from);
  return partners;
}

template <class Counter>
SidePartners by_sort(const IndexedMesh& source, Counter& counter) {
  const std::vector<DirectedSide> sides = sides_of(source);
  struct Entry {
    std::uint64_t key;
    std::uint32_t corner;
  };
  std::vector<Entry> entries(sides.size());
  for (std::uint32_t c = 0; c < sides.size(); ++c) {
    const auto [low, high] = std::minmax(sides[c].from, sides[c].to);
    entries[c] = {std::uint64_t{low} << 32u | high, c};
  }
  std::sort(entries.begin(), entries.end(), [&](const Entry& a, const Entry& b) {
    counter.count();
    return a.key < b.key;
  });
  SidePartners partners(sides.size(), no_index);
  const auto are_equal = [&](const Entry& a, const Entry& b) {
    counter.count();
    return a.key == b.key;
  };
  for (std::size_t i = 0, last = 0; i < entries.size(); i = last) {
    for (last = i + 1; last < entries.size() && are_equal(entries[last], entries[i]);) ++last;
    const std::uint32_t a = entries[i].corner, b = entries[last - 1].corner;
    if (last - i != 2 || sides[a].from == sides[b].from) continue;
    partners[a] = b;
    partners[b] = a;
  }
  return partners;
}

CornerPairing pair_as_in_use(const IndexedMesh& source, NotCounted&) { return pair_corners(source); }
CornerPairing pair_as_in_use(const IndexedMesh& source, Counted& counter) { return pair_counting(source, counter); }

template <class Counter>
SidePartners by_pair_corners(const IndexedMesh& source, Counter& counter) {
  const CornerPairing pairing = pair_as_in_use(source, counter);
  std::vector<std::uint32_t> corner_of(std::size_t{2} * pairing.edges, no_index);
  for (std::uint32_t c = 0; c < pairing.halfedge.size(); ++c) corner_of[pairing.halfedge[c].index] = c;
  SidePartners partners(pairing.halfedge.size());
  for (std::size_t c = 0; c < partners.size(); ++c) partners[c] = corner_of[twin(pairing.halfedge[c]).index];
  return partners;
}

double one_step_per_side(const IndexedMesh& source) { return static_cast<double>(source.corners.size()); }

double all_against_all(const IndexedMesh& source) { return one_step_per_side(source) * one_step_per_side(source); }

// The list of a point is scanned once per outgoing and once per incoming side.
double squares_of_valences(const IndexedMesh& source) {
  std::vector<double> valence(source.positions.size(), 0.0);
  for (const std::uint32_t corner : source.corners) valence[corner] += 1;
  double steps = 0;
  for (const double v : valence) steps += 2 * v * v;
  return steps;
}

// Both ways to run a method: with nothing but the work, and with its comparisons counted.
template <SidePartners (*pair)(const IndexedMesh&, NotCounted&), SidePartners (*count)(const IndexedMesh&, Counted&)>
constexpr PairingMethod method(std::string_view id, std::string_view en, std::string_view ja,
                               double (*steps)(const IndexedMesh&)) {
  return {id,
          en,
          ja,
          [](const IndexedMesh& source) {
            NotCounted none;
            return pair(source, none);
          },
          [](const IndexedMesh& source, std::uint64_t& comparisons) {
            Counted counter;
            SidePartners partners = count(source, counter);
            comparisons = counter.comparisons;
            return partners;
          },
          steps};
}

constexpr std::array methods{
    method<by_brute_force, by_brute_force>("brute_force", "every side against every other", "総当たり",
                                           all_against_all),
    method<by_hash<NotCounted, sixteen_bit_key>, by_hash<Counted, sixteen_bit_key>>(
        "hash_16", "hash with the 16-bit key of the source texts", "ハッシュ（テキストの 16 ビットのキー）",
        one_step_per_side),
    method<by_hash<NotCounted, mixed_key>, by_hash<Counted, mixed_key>>(
        "hash", "hash with a key of both numbers in full", "ハッシュ（両端の番号全体のキー）", one_step_per_side),
    method<by_vertex_lists, by_vertex_lists>("vertex_lists", "lists of sides at the vertices", "頂点ごとのリスト",
                                             squares_of_valences),
    method<by_sparse_matrix, by_sparse_matrix>("sparse_matrix", "sparse matrix of vertex against vertex",
                                               "頂点×頂点の疎行列", one_step_per_side),
    method<by_sort, by_sort>("sort", "sorting all sides", "全体の整列", one_step_per_side),
    method<by_pair_corners, by_pair_corners>("in_use", "counting sort, as files are read here",
                                             "計数整列（ファイルの読み込みで使用）", one_step_per_side),
};

}  // namespace

std::span<const PairingMethod> pairing_methods() { return methods; }

IndexedMesh first_faces(const IndexedMesh& source, std::size_t count) {
  IndexedMesh part;
  part.positions = source.positions;
  part.face_offsets.assign(source.face_offsets.begin(),
                           source.face_offsets.begin() + static_cast<std::ptrdiff_t>(count) + 1);
  part.corners.assign(source.corners.begin(), source.corners.begin() + part.face_offsets.back());
  return part;
}

}  // namespace ryosen
