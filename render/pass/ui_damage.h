// Damage tracking: the parts of the user interface that changed since the last frame, from Dear ImGui's draw data.
// Makes no GL calls.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "ryosen/scene/view/size.h"

struct ImDrawData;
struct ImDrawList;

namespace ryosen {

// Compares the triangles with those of the last draw data, list by list, from both ends.
class UiDamage {
 public:
  // Rectangles, clipped to `size` and possibly empty, outside of which both give the same pixels. Texture contents are
  // assumed unchanged. Linear in the triangles.
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
    std::uint32_t indices;
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
