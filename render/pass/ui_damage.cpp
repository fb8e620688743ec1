#include "render/pass/ui_damage.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace ryosen {
UiDamage::List UiDamage::copied(const ImDrawList& list) {
  List copy;
  copy.vertices.reserve(static_cast<std::size_t>(list.VtxBuffer.Size));
  for (const ImDrawVert& v : list.VtxBuffer) copy.vertices.push_back({{v.pos.x, v.pos.y, v.uv.x, v.uv.y}, v.col});
  copy.indices.assign(list.IdxBuffer.begin(), list.IdxBuffer.end());
  for (const ImDrawCmd& c : list.CmdBuffer) {
    copy.commands.push_back({{c.ClipRect.x, c.ClipRect.y, c.ClipRect.z, c.ClipRect.w},
                             reinterpret_cast<std::uintptr_t>(c.GetTexID()),
                             c.ElemCount});
    for (std::uint32_t i = c.IdxOffset; i < c.IdxOffset + c.ElemCount; ++i) copy.indices[i] += c.VtxOffset;
  }
  return copy;
}

// True if clipping and textures are unchanged: at most one command has changed its length.
bool UiDamage::same_commands(const List& before, const List& now) {
  if (before.commands.size() != now.commands.size()) return false;
  int resized = 0;
  for (std::size_t i = 0; i < now.commands.size(); ++i) {
    const Command &a = before.commands[i], &b = now.commands[i];
    if (a.clip != b.clip || a.texture != b.texture) return false;
    resized += a.indices != b.indices;
  }
  return resized <= 1;
}

PixelRect UiDamage::difference(const List& before, const List& now) {
  const std::size_t old_size = before.vertices.size(), new_size = now.vertices.size();
  std::size_t head = 0, tail = 0, first = 0, last = 0;  // equal vertices and indices at both ends
  if (same_commands(before, now)) {
    const std::size_t vertices = std::min(old_size, new_size);
    while (head < vertices && before.vertices[head] == now.vertices[head]) ++head;
    while (tail < vertices - head && before.vertices[old_size - 1 - tail] == now.vertices[new_size - 1 - tail]) ++tail;
    const auto equal = [&](std::uint32_t old_vertex, std::uint32_t new_vertex) {
      if (old_vertex < head) return new_vertex == old_vertex;
      return old_vertex >= old_size - tail && old_size - old_vertex == new_size - new_vertex;
    };
    const std::size_t indices = std::min(before.indices.size(), now.indices.size());
    while (first < indices && equal(before.indices[first], now.indices[first])) ++first;
    first -= first % 3;
    while (last < indices - first &&
           equal(before.indices[before.indices.size() - 1 - last], now.indices[now.indices.size() - 1 - last]))
      ++last;
    last -= last % 3;
  }
  float x0 = std::numeric_limits<float>::max(), y0 = x0, x1 = -x0, y1 = -x0;
  const auto grow = [&](const List& list) {
    for (std::size_t i = first; i + last < list.indices.size(); ++i) {
      const Vertex& vertex = list.vertices[list.indices[i]];
      x0 = std::min(x0, vertex.places[0]);
      y0 = std::min(y0, vertex.places[1]);
      x1 = std::max(x1, vertex.places[0]);
      y1 = std::max(y1, vertex.places[1]);
    }
  };
  grow(before);
  grow(now);
  if (x0 > x1) return {};
  const auto whole = [](float value) { return static_cast<int>(std::clamp(value, -1e6f, 1e6f)); };
  return {whole(std::floor(x0)) - 1, whole(std::floor(y0)) - 1, whole(std::ceil(x1)) + 1, whole(std::ceil(y1)) + 1};
}

std::vector<PixelRect> UiDamage::update(const ImDrawData& data, Size size) {
  std::vector<List> now;
  for (int i = 0; i < data.CmdListsCount; ++i) now.push_back(copied(*data.CmdLists[i]));
  std::vector<PixelRect> rects;
  if (!known_) {
    rects.push_back(PixelRect::all(size));
  } else {
    const List nothing;
    for (std::size_t i = 0; i < std::max(now.size(), lists_.size()); ++i) {
      const List& before = i < lists_.size() ? lists_[i] : nothing;
      const PixelRect rect = difference(before, i < now.size() ? now[i] : nothing);
      rects.push_back(intersection(rect, PixelRect::all(size)));
    }
  }
  lists_ = std::move(now);
  known_ = true;
  return rects;
}

}  // namespace ryosen
