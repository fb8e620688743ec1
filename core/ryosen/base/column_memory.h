// Memory for columns: large blocks are placed on huge pages where available, which makes first-touch page faults
// several times cheaper and TLB misses on random access rare.
#pragma once

#include <cstddef>
#include <memory>
#include <new>
#include <type_traits>
#include <utility>
#include <vector>

namespace ryosen {

// Blocks of at least large_block bytes are aligned to huge_page and marked for huge pages.
inline constexpr std::size_t huge_page = std::size_t{1} << 21;
inline constexpr std::size_t large_block = 2 * huge_page;

// Throws std::bad_alloc. Release a block with the size it was allocated with.
void* allocate_column(std::size_t bytes);
// For large blocks from another allocator, before they are written: requests huge pages for those that lie wholly
// inside.
void offer_huge_pages(void* memory, std::size_t bytes);
void release_column(void* block, std::size_t bytes) noexcept;

template <class T>
struct ColumnAllocator {
  using value_type = T;

  ColumnAllocator() = default;
  template <class U>
  ColumnAllocator(const ColumnAllocator<U>&) {}
  T* allocate(std::size_t n) { return static_cast<T*>(allocate_column(n * sizeof(T))); }
  void deallocate(T* block, std::size_t n) noexcept { release_column(block, n * sizeof(T)); }
  friend bool operator==(const ColumnAllocator&, const ColumnAllocator&) { return true; }
};

// As ColumnAllocator, but resize() leaves new elements uninitialised: for code that writes all of them right
// afterwards.
template <class T>
struct UnwrittenAllocator : ColumnAllocator<T> {
  static_assert(std::is_trivially_copyable_v<T>);
  using value_type = T;
  template <class U>
  struct rebind {
    using other = UnwrittenAllocator<U>;
  };

  UnwrittenAllocator() = default;
  template <class U>
  UnwrittenAllocator(const UnwrittenAllocator<U>&) {}
  void construct(T*) {}
  template <class... Arguments>
  void construct(T* place, Arguments&&... arguments) {
    std::construct_at(place, std::forward<Arguments>(arguments)...);
  }
};

// For a large block that nothing has been written to and that is then filled by one thread: the system gives and clears
// its pages now, for several threads at once. What the block holds is unspecified afterwards.
void touch_pages(void* memory, std::size_t bytes);

// reserve() for a vector with any allocator, on huge pages if the block is large.
template <class Vector>
void reserve_large(Vector& values, std::size_t count) {
  if (count <= values.capacity()) return;
  values.reserve(count);
  offer_huge_pages(values.data(), values.capacity() * sizeof(typename Vector::value_type));
}

// Frees the memory of a vector, which neither clear() nor assigning {} does.
template <class Value>
void release(std::vector<Value>& values) {
  std::vector<Value>().swap(values);
}

template <class T>
using ColumnVector = std::vector<T, ColumnAllocator<T>>;
template <class T>
using UnwrittenVector = std::vector<T, UnwrittenAllocator<T>>;

}  // namespace ryosen
