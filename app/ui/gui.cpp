#include "app/ui/gui.h"

#include <imgui.h>

#include <cmath>

#include "core/mesh/copies.h"

namespace ryosen {

namespace {

constexpr float font_px = 15;
constexpr float left_px = 240, right_px = 292;  // widths of the columns at scale 1

constexpr ImGuiWindowFlags column_flags =
    ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoCollapse |
    ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoBringToFrontOnFocus | ImGuiWindowFlags_NoFocusOnAppearing;

void draw_column(PanelContext& context, Side side, float x, float y, float width, float height) {
  ImGui::SetNextWindowPos({x, y});
  ImGui::SetNextWindowSize({width, height});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, 0);
  ImGui::Begin(side == Side::left ? "##left" : "##right", nullptr, column_flags);
  ImGui::PopStyleVar();
  for (const Panel& panel : panels()) {
    if (panel.side != side) continue;
    // The part behind ### keeps a panel open or closed when the language changes.
    const std::string title = std::string(context.text(panel.title)) + "###" + text(panel.title, Language::english);
    ImGui::PushFont(context.fonts.bold);
    const bool is_open = ImGui::CollapsingHeader(title.c_str(), ImGuiTreeNodeFlags_DefaultOpen);
    ImGui::PopFont();
    if (!is_open) continue;
    ImGui::PushID(title.c_str());
    panel.draw(context);
    ImGui::PopID();
    ImGui::Dummy({0, 3 * context.scale});
  }
  ImGui::End();
}

}  // namespace

Gui::Gui(float scale) : imgui_(ImGui::CreateContext()), scale_(scale) {
  ImGui::SetCurrentContext(imgui_);
  ImGuiIO& io = ImGui::GetIO();
  io.IniFilename = nullptr;
  io.LogFilename = nullptr;
  io.MousePos = {-1e9f, -1e9f};
  io.BackendFlags |= ImGuiBackendFlags_RendererHasVtxOffset;
  apply_style(theme_, scale_);
}

Gui::~Gui() { ImGui::DestroyContext(imgui_); }

PixelRect Gui::view_area(Size window) const {
  const int left = static_cast<int>(std::lround(left_px * scale_)),
            right = static_cast<int>(std::lround(right_px * scale_));
  const int bar = static_cast<int>(std::lround((font_px + 8) * scale_));
  PixelRect area{left, bar, window.width - right, window.height - bar};
  // Of a window that is too small for the columns the view keeps at least a corner.
  area.x1 = std::max(area.x1, area.x0 + 1);
  area.y1 = std::max(area.y1, area.y0 + 1);
  return area;
}

void Gui::place_view(Session& session, Size window) const {
  const PixelRect area = view_area(window);
  session.view = {area.width(), area.height()};
  session.view_origin = {area.x0, area.y0};
}

PanelContext Gui::context(Session& session) {
  return {session, state_, fonts_, session.light_theme ? Theme::light : Theme::dark, scale_};
}

bool Gui::prepare(const Session& session) {
  ImGui::SetCurrentContext(imgui_);
  const Theme theme = session.light_theme ? Theme::light : Theme::dark;
  if (theme != theme_) apply_style(theme, scale_);
  theme_ = theme;
  const bool japanese =
      has_japanese_ || session.language == Language::japanese || needs_japanese(session.document().path().c_str());
  if (has_fonts_ && japanese == has_japanese_) return false;
  fonts_ = load_fonts(*ImGui::GetIO().Fonts, std::round(font_px * scale_), japanese);
  unsigned char* alpha = nullptr;
  int width = 0, height = 0;
  ImGui::GetIO().Fonts->GetTexDataAsAlpha8(&alpha, &width, &height);
  has_fonts_ = true;
  has_japanese_ = japanese;
  return true;
}

void Gui::follow(Session& session) {
  const Document& document = session.document();
  if (state_.known_document == &document && state_.known_revision == document.revision()) return;
  const Mesh& mesh = session.mesh();
  state_.problems =
      find_problems(mesh, session.highlights(), {document.tables().quarantine, document.tables().face_lines});
  state_.on_points.reset();
  if (mesh.has_copies()) {
    const ElementCounts counts = counts_on_points(mesh);
    if (counts.vertices != mesh.live().vertices || counts.edges != mesh.live().edges) state_.on_points = counts;
  }
  state_.known_document = &document;
  state_.known_revision = document.revision();
}

void Gui::frame(Session& session, Size window, double seconds) {
  ImGui::SetCurrentContext(imgui_);
  follow(session);
  ImGuiIO& io = ImGui::GetIO();
  io.DisplaySize = {static_cast<float>(window.width), static_cast<float>(window.height)};
  io.DeltaTime = static_cast<float>(std::max(seconds, 1e-4));
  ImGui::NewFrame();
  PanelContext panel_context = context(session);
  draw_menu(panel_context);
  const PixelRect area = view_area(window);
  const auto top = static_cast<float>(area.y0), height = static_cast<float>(window.height - 2 * area.y0);
  draw_column(panel_context, Side::left, 0, top, static_cast<float>(area.x0), height);
  draw_column(panel_context, Side::right, static_cast<float>(area.x1), top, static_cast<float>(window.width - area.x1),
              height);
  draw_status(panel_context);
  draw_pointer_tip(panel_context);
  draw_keys_window(panel_context);
  draw_file_window(panel_context);
  draw_unsaved_window(panel_context);
  ImGui::Render();
}

const ImDrawData& Gui::draw_data() const {
  ImGui::SetCurrentContext(imgui_);
  return *ImGui::GetDrawData();
}

ImFontAtlas& Gui::fonts() const {
  ImGui::SetCurrentContext(imgui_);
  return *ImGui::GetIO().Fonts;
}

bool Gui::wants_pointer() const {
  ImGui::SetCurrentContext(imgui_);
  return ImGui::GetIO().WantCaptureMouse;
}

bool Gui::wants_keys() const {
  ImGui::SetCurrentContext(imgui_);
  return ImGui::GetIO().WantTextInput;
}

Outcome Gui::run(Session& session, const std::string& line) { return context(session).run(line); }
Outcome Gui::click(Session& session, glm::dvec2 pixel) { return context(session).click(pixel); }
void Gui::leave(Session& session, PendingLeave where) { context(session).leave(std::move(where)); }

void Gui::say(Outcome::Kind kind, Text text) {
  state_.last_kind = kind;
  state_.last_outcome = std::move(text);
}

}  // namespace ryosen
