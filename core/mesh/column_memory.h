// Memory for columns: large blocks lie on huge pages where the system offers them, so that fresh ones are filled
// several times faster and random access seldom misses the table of pages.
#pragma once

#include <cstddef>
#include <memory>
#include <new>
#include <type_traits>
#include <utility>
#include <vector>

namespace ryosen {

// Blocks of at least the second size are aligned to the first, and so rounded up to it, and offered huge pages.
inline constexpr std::size_t huge_page = std::size_t{1} << 21;
inline constexpr std::size_t large_block = 2 * huge_page;

// Throws std::bad_alloc. Blocks are given back with the size they were taken with.
void* allocate_column(std::size_t bytes);
// For large memory that others have taken, before it is written: asks for huge pages where whole ones lie in it.
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

// As ColumnAllocator, but resize() leaves new elements unwritten: for whoever writes each of them right afterwards.
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

// Reserves room in a vector with an allocator of its own, on huge pages if that is much.
template <class Vector>
void reserve_large(Vector& values, std::size_t count) {
  if (count <= values.capacity()) return;
  values.reserve(count);
  offer_huge_pages(values.data(), values.capacity() * sizeof(typename Vector::value_type));
}

template <class T>
using ColumnVector = std::vector<T, ColumnAllocator<T>>;
template <class T>
using UnwrittenVector = std::vector<T, UnwrittenAllocator<T>>;

}  // namespace ryosen
