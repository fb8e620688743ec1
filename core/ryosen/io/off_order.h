// The order of normal and colour behind the place of an OFF vertex.
#pragma once

#include <cstddef>

namespace ryosen {

// The format says the normal. Some programs write the colour first; the numbers tell, since normals have the length 1
// (to 0.01) and colours lie in 0..255.
class OffOrder {
 public:
  // The numbers of a vertex behind its place: the three of a normal and `colours` of a colour, 3 or 4.
  void add(const double* numbers, std::size_t colours) {
    has_vertex_ = true;
    normals_first_ = normals_first_ && is_normal(numbers) && is_colour(numbers + 3, colours);
    colours_first_ = colours_first_ && is_colour(numbers, colours) && is_normal(numbers + colours);
  }
  // Whether only this order makes sense of all vertices.
  bool is_colours_first() const { return has_vertex_ && colours_first_ && !normals_first_; }

 private:
  static bool is_normal(const double* n) {
    constexpr double least = 0.99 * 0.99, most = 1.01 * 1.01;
    const double square = n[0] * n[0] + n[1] * n[1] + n[2] * n[2];
    return square >= least && square <= most;
  }
  static bool is_colour(const double* numbers, std::size_t count) {
    for (std::size_t i = 0; i < count; ++i)
      if (!(numbers[i] >= 0 && numbers[i] <= 255)) return false;
    return true;
  }

  bool has_vertex_ = false, normals_first_ = true, colours_first_ = true;
};

}  // namespace ryosen
