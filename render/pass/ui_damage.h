// Finds which parts of a user interface, as Dear ImGui has laid it out, look different from the last time. Reads its
// draw data and makes no GL calls.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/view/size.h"

struct ImDrawData;
struct ImDrawList;

namespace ryosen {

// Remembers the triangles of the last draw data and compares them with the next, list by list, from both ends.
class UiDamage {
 public:
  // The rectangles, cut to `size`, some perhaps empty, outside of which both draw data give the same pixels. Textures
  // are taken as unchanged. Linear in the triangles.
  std::vector<PixelRect> update(const ImDrawData& data, Size size);
  // Makes the next update return everything.
  void forget() { known_ = false; }

 private:
  struct Vertex {
    std::array<float, 4> places;
    std::uint32_t colour;
    friend bool operator==(const Vertex&, const Vertex&) = default;
  };
  struct Command {
    std::array<float, 4> clip;
    std::uintptr_t texture;
    std::uint32_t first_index, first_vertex, indices;
  };
  struct List {
    std::vector<Vertex> vertices;
    std::vector<std::uint32_t> indices;  // three per triangle
    std::vector<Command> commands;
  };
  static List copied(const ImDrawList& list);
  static bool same_commands(const List& before, const List& now);
  static PixelRect difference(const List& before, const List& now);

  bool known_ = false;
  std::vector<List> lists_;
};

}  // namespace ryosen
