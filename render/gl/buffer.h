// Growable arrays in GPU memory, as vertex data or as buffer textures that shaders read by index, and lists of numbers.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <type_traits>

#include "render/gl/object.h"
#include "ryosen/base/column_memory.h"

namespace ryosen {

// Memory of this process that a buffer of the driver lies in. A driver that draws with the processor takes a buffer's
// memory page by page and clears it; here the pages are large ones, and nothing is cleared. It ends behind the buffer,
// and in its context.
class OwnMemory {
 public:
  // Gives a new buffer this size; false where the driver does not take such memory, or a small buffer does not need it.
  bool put_under(GLuint buffer, std::size_t bytes);

 private:
  struct Release {
    std::size_t bytes;
    void operator()(void* block) const;
  };
  std::unique_ptr<void, Release> block_;
};

// A growable array of T in GPU memory. Writing costs what is written; growing beyond the capacity copies.
template <class T>
class GpuArray;

// The untyped part of GpuArray; sizes and offsets in bytes.
class Buffer {
 public:
  explicit Buffer(const char* label) : label_(label), object_(label) {}

  // Reserves at least `bytes`, keeping the content. True if the storage, and so id(), changed.
  bool reserve(std::size_t bytes);
  void write(std::size_t offset, const void* data, std::size_t bytes);
  void read(std::size_t offset, void* data, std::size_t bytes) const;
  // The memory of a part, to be written as a whole before unmap(); null if the driver does not give it. Nothing may use
  // the buffer meanwhile.
  void* map(std::size_t offset, std::size_t bytes);
  // False if what was written is lost.
  bool unmap();
  GLuint id() const { return object_.id(); }
  std::size_t capacity() const { return capacity_; }

 private:
  std::string label_;
  OwnMemory memory_;  // of the object, where the driver takes it
  GlObject<BufferKind> object_;
  std::size_t capacity_ = 0;
};

template <class T>
class GpuArray {
  static_assert(std::is_trivially_copyable_v<T>);

 public:
  explicit GpuArray(const char* label) : buffer_(label) {}

  // Writes `values` from element `first` on, growing if needed. True if the storage changed.
  bool write(std::size_t first, std::span<const T> values) {
    if (values.empty()) return false;
    const bool moved = buffer_.reserve((first + values.size()) * sizeof(T));
    buffer_.write(first * sizeof(T), values.data(), values.size_bytes());
    return moved;
  }
  // True if the storage changed.
  bool reserve(std::size_t count) { return buffer_.reserve(count * sizeof(T)); }
  // As write(), of `count` values that put(T*) writes where they stay: drivers that draw in main memory hold no copy.
  template <class Put>
  bool fill(std::size_t first, std::size_t count, const Put& put) {
    if (count == 0) return false;
    const bool moved = buffer_.reserve((first + count) * sizeof(T));
    if (void* const place = buffer_.map(first * sizeof(T), count * sizeof(T))) {
      offer_huge_pages(place, count * sizeof(T));
      put(static_cast<T*>(place));
      if (buffer_.unmap()) return moved;
    }
    UnwrittenVector<T> values(count);
    put(values.data());
    buffer_.write(first * sizeof(T), values.data(), count * sizeof(T));
    return moved;
  }
  // Reads elements that have been written; waits for what is being drawn.
  void read(std::size_t first, std::span<T> values) const {
    if (!values.empty()) buffer_.read(first * sizeof(T), values.data(), values.size_bytes());
  }
  GLuint id() const { return buffer_.id(); }

 private:
  Buffer buffer_;
};

// A GpuArray that shaders read with texelFetch; `format` is the texel format, T is one or more texels.
template <class T>
class TexelArray {
 public:
  TexelArray(const char* label, GLenum format) : array_(label), texture_(label), format_(format) {}

  void write(std::size_t first, std::span<const T> values) {
    if (array_.write(first, values)) attach();
  }
  void reserve(std::size_t count) {
    if (array_.reserve(count)) attach();
  }
  template <class Put>
  void fill(std::size_t first, std::size_t count, const Put& put) {
    if (array_.fill(first, count, put)) attach();
  }
  void read(std::size_t first, std::span<T> values) const { array_.read(first, values); }
  void bind(GLuint unit) const {
    glActiveTexture(GL_TEXTURE0 + unit);
    glBindTexture(GL_TEXTURE_BUFFER, texture_.id());
  }

 private:
  void attach() {
    glBindTexture(GL_TEXTURE_BUFFER, texture_.id());
    glTexBuffer(GL_TEXTURE_BUFFER, format_, array_.id());
  }

  GpuArray<T> array_;
  GlObject<BufferTextureKind> texture_;
  GLenum format_;
};

// Lists of numbers that shaders read, a new one for each draw: which of many things are drawn, all of them at once. So
// many draws of a few each would cost more than what they draw.
class NumberLists {
 public:
  // Writes a list and binds it, as texels of one number each, to a texture unit.
  void bind(std::span<const std::uint32_t> numbers, GLuint unit) {
    TexelArray<std::uint32_t>& list = lists_[next_++ % lists_.size()];
    glActiveTexture(GL_TEXTURE0 + unit);  // where it grows it is bound to the one that is active
    list.write(0, numbers);
    list.bind(unit);
  }

 private:
  // One that is still being read would be waited for, so they take turns.
  std::array<TexelArray<std::uint32_t>, 4> lists_{
      TexelArray<std::uint32_t>{"numbers", GL_R32UI}, TexelArray<std::uint32_t>{"numbers", GL_R32UI},
      TexelArray<std::uint32_t>{"numbers", GL_R32UI}, TexelArray<std::uint32_t>{"numbers", GL_R32UI}};
  std::size_t next_ = 0;
};

}  // namespace ryosen
