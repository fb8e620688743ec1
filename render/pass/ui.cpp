#include "render/pass/ui.h"

#include <imgui.h>

#include <cmath>
#include <cstddef>
#include <cstdint>

#include "render/pass/frame.h"

namespace ryosen {

UiPass::UiPass(std::optional<Failure>& failure) : program_(failure, "ui.vert", "ui.frag") {
  if (failure) return;
  program_.use();
  program_.set("image", 0);
}

void UiPass::set_fonts(ImFontAtlas& atlas) {
  unsigned char* alpha = nullptr;
  int width = 0, height = 0;
  atlas.GetTexDataAsAlpha8(&alpha, &width, &height);
  fonts_ = GlObject<TextureKind>("fonts");
  glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
  glTexImage2D(GL_TEXTURE_2D, 0, GL_R8, width, height, 0, GL_RED, GL_UNSIGNED_BYTE, alpha);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  constexpr GLint white_times_alpha[] = {GL_RED, GL_RED, GL_RED, GL_RED};
  glTexParameteriv(GL_TEXTURE_2D, GL_TEXTURE_SWIZZLE_RGBA, white_times_alpha);
  atlas.SetTexID(reinterpret_cast<ImTextureID>(static_cast<std::uintptr_t>(fonts_.id())));
}

void UiPass::draw(const ImDrawData& data, const Framebuffer& target, const PixelRect& rect) {
  target.bind(rect);
  set_drawing(Blend::over);
  glActiveTexture(GL_TEXTURE0);
  program_.use();
  program_.set("size_px", glm::vec2(data.DisplaySize.x, data.DisplaySize.y));
  glBindVertexArray(vertex_array_.id());
  for (int i = 0; i < data.CmdListsCount; ++i) draw_list(*data.CmdLists[i], data, target.size(), rect);
}

void UiPass::draw_list(const ImDrawList& list, const ImDrawData& data, Size size, const PixelRect& rect) {
  const auto bytes = [](const auto& array) { return static_cast<std::size_t>(array.size_in_bytes()); };
  vertices_.reserve(bytes(list.VtxBuffer));
  vertices_.write(0, list.VtxBuffer.Data, bytes(list.VtxBuffer));
  indices_.reserve(bytes(list.IdxBuffer));
  indices_.write(0, list.IdxBuffer.Data, bytes(list.IdxBuffer));
  glBindBuffer(GL_ARRAY_BUFFER, vertices_.id());
  glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, indices_.id());
  const auto attribute = [](GLuint location, GLint count, GLenum type, GLboolean normalised, std::size_t offset) {
    glEnableVertexAttribArray(location);
    glVertexAttribPointer(location, count, type, normalised, sizeof(ImDrawVert), reinterpret_cast<void*>(offset));
  };
  attribute(0, 2, GL_FLOAT, GL_FALSE, offsetof(ImDrawVert, pos));
  attribute(1, 2, GL_FLOAT, GL_FALSE, offsetof(ImDrawVert, uv));
  attribute(2, 4, GL_UNSIGNED_BYTE, GL_TRUE, offsetof(ImDrawVert, col));
  constexpr GLenum index_type = sizeof(ImDrawIdx) == 2 ? GL_UNSIGNED_SHORT : GL_UNSIGNED_INT;
  for (const ImDrawCmd& command : list.CmdBuffer) {
    if (command.UserCallback) continue;
    const ImVec2 scale = data.FramebufferScale, origin = data.DisplayPos;
    const ImVec4& clip = command.ClipRect;
    const PixelRect shown = intersection({static_cast<int>(std::floor((clip.x - origin.x) * scale.x)),
                                          static_cast<int>(std::floor((clip.y - origin.y) * scale.y)),
                                          static_cast<int>(std::ceil((clip.z - origin.x) * scale.x)),
                                          static_cast<int>(std::ceil((clip.w - origin.y) * scale.y))},
                                         rect);
    if (shown.empty()) continue;
    glScissor(shown.x0, size.height - shown.y1, shown.width(), shown.height());
    glBindTexture(GL_TEXTURE_2D, static_cast<GLuint>(reinterpret_cast<std::uintptr_t>(command.GetTexID())));
    glDrawElementsBaseVertex(GL_TRIANGLES, static_cast<GLsizei>(command.ElemCount), index_type,
                             reinterpret_cast<void*>(command.IdxOffset * sizeof(ImDrawIdx)),
                             static_cast<GLint>(command.VtxOffset));
  }
}

}  // namespace ryosen
