#include "app/window/window_cursor.h"

namespace ryosen {

namespace {

struct CursorRow {
  PointerShape shape;
  int glfw;
};
constexpr CursorRow cursors[] = {
    {PointerShape::arrow, GLFW_ARROW_CURSOR},
    {PointerShape::text, GLFW_IBEAM_CURSOR},
    {PointerShape::hand, GLFW_HAND_CURSOR},
    {PointerShape::sideways, GLFW_HRESIZE_CURSOR},
};
static_assert(rows_are_in_order(cursors, &CursorRow::shape));

}  // namespace

void WindowCursor::show(GLFWwindow* window, PointerShape shape) {
  if (shape == shown_) return;
  shown_ = shape;
  GLFWcursor*& cursor = made_[static_cast<std::size_t>(shape)];
  if (!cursor) cursor = load_glfw()->create_standard_cursor(cursors[static_cast<std::size_t>(shape)].glfw);
  load_glfw()->set_cursor(window, cursor);  // null, where it cannot be made: the usual one
}

}  // namespace ryosen
