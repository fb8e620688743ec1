// The legend of highlights shows what the view draws.
#include <gtest/gtest.h>
#include <imgui.h>

#include <map>

#include "app/editor/session/session.h"
#include "app/ui/overlays.h"
#include "app/ui/style.h"
#include "app/ui/swatch.h"
#include "tests/support/app/laid.h"

namespace ryosen {
namespace {

struct Drawn {
  bool line = false, point = false;
};

// What the view draws of each highlight, over meshes that have about all of them.
std::map<std::string_view, Drawn> drawn_of_all() {
  std::map<std::string_view, Drawn> all;
  for (const char* const name : {"three_tri_edge.off", "bow_tie.obj", "misoriented.obj", "duplicate_face.obj",
                                 "hanging_pair.obj", "isolated_vertex.obj", "collinear.obj", "cube.obj", "seam.obj"}) {
    Session session(Document::open(test::asset(name)).value());
    for (const HighlightRow& row : highlight_table()) session.view.highlights.insert(std::string(row.id));
    for (const HighlightRow& row : highlight_table())
      for_each_mark(row, [&](Mark mark) {
        const Overlay overlay = highlight_overlay(session.findings(), session.gesturing.drawn_positions(), row, mark, 0,
                                                  1000, session.view.settings, 0);
        if (overlay.empty()) return;
        all[row.id].line |= !overlay.lines.empty();
        all[row.id].point |= !overlay.points.empty();
      });
  }
  return all;
}

TEST(legend, has_a_line_and_a_point_where_the_view_draws_them) {
  const auto all = drawn_of_all();
  EXPECT_GE(all.size(), 8u);
  for (const auto& [id, drawn] : all) {
    const SwatchParts parts = parts_of(*find_highlight(id));
    EXPECT_EQ(parts.has_line, drawn.line) << id;
    EXPECT_EQ(parts.has_point, drawn.point) << id;
    EXPECT_EQ(parts.tint, find_highlight(id)->tint) << id;
  }
}

// Corners of triangles in a colour, of a sample drawn by itself.
int corners_in(const HighlightRow& row, ImU32 colour) {
  test::Laid laid("cube.obj");
  ImGui::NewFrame();
  ImGui::Begin("sample");
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const int before = list.VtxBuffer.Size;
  swatch(row, Theme::dark, 30, 1);
  int count = 0;
  for (int i = before; i < list.VtxBuffer.Size; ++i) count += list.VtxBuffer[i].col == colour;
  ImGui::End();
  ImGui::EndFrame();
  return count;
}

TEST(legend, samples_have_the_dashes_shapes_and_patterns_of_the_view) {
  const auto own = [](std::string_view id) {
    const HighlightRow& row = *find_highlight(id);
    return corners_in(row, to_imgui32(style(row.looks, Theme::dark).colour));
  };
  EXPECT_EQ(own("boundary"), 4) << "one stroke, and its loops have no points";
  EXPECT_GT(own("misoriented"), 8) << "dashes";
  EXPECT_GT(own("degenerate"), 60) << "dots and a cross";
  EXPECT_GT(own("nonmanifold"), own("misoriented")) << "dashes, dots and a diamond";
  // The tint, in two strengths of its colour over that of the surface.
  const HighlightRow& degenerate = *find_highlight("degenerate");
  const Rgba face = palette(Theme::dark).front, tint = style(degenerate.looks, Theme::dark).colour;
  for (const double share : {0.5, 1.0}) {
    Rgba mixed = face;
    for (std::size_t i = 0; i < 3; ++i)
      mixed[i] = static_cast<std::uint8_t>(
          std::lround(face[i] + share * double(degenerate.tint->strength) * (double(tint[i]) - face[i])));
    EXPECT_GE(corners_in(degenerate, to_imgui32(mixed)), 16) << share;
  }
}

}  // namespace
}  // namespace ryosen
