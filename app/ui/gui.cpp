#include "app/ui/gui.h"

#include <imgui.h>
#include <imgui_internal.h>  // closing of menus, and where Tab goes

#include <algorithm>
#include <cmath>
#include <new>
#include <utility>

#include "app/editor/commands/commands.h"
#include "app/editor/session/session.h"
#include "app/editor/shown/player.h"
#include "app/ui/widgets.h"

namespace ryosen {

namespace {

// What is framed goes beside it.
void cover_view(ViewState& view, const OwnPanel& own) {
  if (!own.panel->leaves_view()) return;
  const double end = view.origin.x + view.size.width;
  view.covered_px.y = std::max(view.covered_px.y, end - own.begins_px);
}

void draw_over(PanelContext& context, OwnPanel& own) {
  const bool is_over = begin_over(context, own.row, own.panel->size(), own.panel->leaves_view());
  if (is_over) {
    own.begins_px = ImGui::GetWindowPos().x;
    cover_view(context.view, own);
    own.panel->draw(context);
    end_over();
  }
  if (std::exchange(own.was_over, is_over) && !is_over) own.panel->closed(context);
}

// Tab goes on from what has the keyboard, which ImGui does from fields alone: from a button it would begin anew. What
// it comes to is marked.
void go_on_by_tab(bool had_keyboard) {
  ImGuiContext& imgui = *GImGui;
  const ImGuiNavMoveFlags of_key = imgui.NavMoveFlags & (ImGuiNavMoveFlags_Tabbing | ImGuiNavMoveFlags_FocusApi);
  if (!imgui.NavMoveSubmitted || of_key != ImGuiNavMoveFlags_Tabbing) return;
  if (imgui.NavTabbingDir == 0 && had_keyboard) imgui.NavTabbingDir = 1;
  imgui.NavDisableHighlight = false;
}

// ImGui itself does not ask whether there was memory.
ImGuiContext* make_context() {
  ImGui::SetAllocatorFunctions([](std::size_t bytes, void*) { return ::operator new(bytes); },
                               [](void* block, void*) { ::operator delete(block); });
  return ImGui::CreateContext();
}

}  // namespace

Gui::Gui(float scale) : imgui_(make_context()), display_scale_(scale), size_(scale), styled_(scale) {
  ImGui::SetCurrentContext(imgui_);
  ImGuiIO& io = ImGui::GetIO();
  io.IniFilename = nullptr;
  io.LogFilename = nullptr;
  io.MousePos = {-1e9f, -1e9f};
  for (int key = 0; key < ImGuiKey_COUNT; ++key) io.KeyMap[key] = key;
  io.BackendFlags |= ImGuiBackendFlags_RendererHasVtxOffset;
  apply_style(theme_, size_.scale);
  const std::span<const PanelRow> rows = panel_list();
  for (std::unique_ptr<Panel>& panel : make_panels()) panels_.push_back({rows[panels_.size()], std::move(panel), {}});
}

Gui::~Gui() { ImGui::DestroyContext(imgui_); }

void Gui::add_panel(const PanelRow& row, std::unique_ptr<Panel> panel) {
  panels_.push_back({row, std::move(panel), std::make_unique<ScopedPanel>(row)});
}

void Gui::set_scale(float scale) {
  size_.scale *= scale / display_scale_;
  display_scale_ = scale;
}

void Gui::place_view(Session& session, Size window) const {
  const PixelRect area = view_area(window, session.layout);
  session.place_view({area.width(), area.height()}, {area.x0, area.y0});
}

// One that nobody has moved is framed anew where its size has changed.
void Gui::follow_view(Session& session, Size window) const {
  const Size before = session.view.size;
  const bool is_framed = session.framing.is_framed();
  place_view(session, window);
  if (is_framed && session.view.size != before) session.framing.frame_all();
}

// What is played goes out of the way of what a tab has opened, and what has been framed beside that has all of the view
// again when it is closed. Else nothing moves under who opens a tab.
void Gui::follow_covered(ViewState& view, Framing& framing, const Shown& shown, const Layout& layout, Size window) {
  const glm::dvec2 before = std::exchange(view.covered_px, columns_.covered_px(view_area(window, layout)));
  for (const OwnPanel& own : panels_)
    if (own.was_over) cover_view(view, own);
  const glm::dvec2 covered = view.covered_px;
  if (!framing.is_framed()) return;
  if (std::exchange(framed_, view.camera) != view.camera) is_framed_beside_ = before != glm::dvec2(0);
  const bool is_free_again = covered == glm::dvec2(0) && is_framed_beside_;
  if (covered == before || !(shown.player() || is_free_again)) return;
  framing.frame_all();
  framed_ = view.camera;
  is_framed_beside_ = covered != glm::dvec2(0);
}

PanelContext Gui::context(Session& session) {
  Fonts fonts = fonts_;
  // One weight only for Japanese: a bold one would need all glyphs twice.
  if (session.preferences.language == Language::japanese) fonts.bold = fonts.normal;
  return {session, state_, fonts, session.view.settings.theme, size_.scale, size_.of_columns()};
}

bool Gui::prepare(const Session& session) {
  ImGui::SetCurrentContext(imgui_);
  const Theme theme = session.view.settings.theme;
  size_ = {display_scale_ * static_cast<float>(session.preferences.ui_scale), session.preferences.font_size_px};
  has_fonts_ = has_fonts_ && size_ == styled_;
  if (theme != theme_ || size_ != styled_) apply_style(theme, size_.scale);
  theme_ = theme;
  styled_ = size_;
  const auto names_need_it = [&] {
    return needs_japanese(session.document().path().c_str()) ||
           std::any_of(session.lost.begin(), session.lost.end(),
                       [](const LostSession& lost) { return needs_japanese(lost.file.c_str()); });
  };
  const bool japanese =
      has_japanese_ || state_.shows_japanese || session.preferences.language == Language::japanese || names_need_it();
  if (has_fonts_ && japanese == has_japanese_) return false;
  fonts_ = load_fonts(*ImGui::GetIO().Fonts, std::round(static_cast<float>(size_.font_px) * size_.scale), japanese);
  unsigned char* alpha = nullptr;
  int width = 0, height = 0;
  ImGui::GetIO().Fonts->GetTexDataAsAlpha8(&alpha, &width, &height);
  whole_lines_.learn(*ImGui::GetIO().Fonts);
  has_fonts_ = true;
  has_japanese_ = japanese;
  return true;
}

void Gui::begin_frame(Size window, double seconds) {
  ImGui::SetCurrentContext(imgui_);
  ImGuiIO& io = ImGui::GetIO();
  io.DisplaySize = {static_cast<float>(window.width), static_cast<float>(window.height)};
  io.DeltaTime = static_cast<float>(std::max(seconds, 1e-4));
  for (int i = 0; i < 3; ++i) {
    const bool was_pressed = std::exchange(was_pressed_[i], false);
    io.MouseDown[i] = is_down_[i] || was_pressed;
  }
  // Arrows walk through menus and what lies over the view; Enter presses there as Space does.
  const bool walks = ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopup);
  state_.menus.had_keys = walks;
  io.ConfigFlags = walks ? io.ConfigFlags | ImGuiConfigFlags_NavEnableKeyboard
                         : io.ConfigFlags & ~ImGuiConfigFlags_NavEnableKeyboard;
  const bool enters = io.KeysDown[ImGuiKey_Enter] && io.KeysDownDuration[ImGuiKey_Enter] < 0;
  if (walks && enters) io.NavInputs[ImGuiNavInput_Activate] = 1;
  const bool has_keyboard = GImGui->NavId != 0 && GImGui->NavIdIsAlive;
  ImGui::NewFrame();
  if (walks) go_on_by_tab(has_keyboard);
}

void Gui::end_frame() {
  ImGui::Render();
  whole_lines_.keep(*ImGui::GetDrawData(), columns_.scrolled());
  for (const int key : released_keys_) ImGui::GetIO().KeysDown[key] = false;
  unseen_keys_.clear();
  released_keys_.clear();
  if (const auto next = std::exchange(next_modifiers_, std::nullopt)) modifiers(next->shift, next->ctrl);
}

void Gui::frame(Session& session, Size window, double seconds) {
  begin_frame(window, seconds);
  play_on(session);
  follow_view(session, window);
  state_.unsettled_frames = std::max(state_.unsettled_frames - 1, 0);
  state_.waits_for_work = false;
  state_.is_laying_out = true;
  laid_out_panel_ = session.layout.open_panel;
  if (std::exchange(state_.menus.closes, false)) ImGui::ClosePopupsExceptModals();
  PanelContext panel_context = context(session);
  draw_menu(panel_context);
  columns_.draw(panel_context, areas_of(session.layout, window, size_), panels_);
  follow_covered(session.view, session.framing, session.shown, session.layout, window);
  draw_status(panel_context);
  draw_notes(panel_context);
  start_.draw(panel_context);
  draw_pointer_tip(panel_context);
  draw_band(panel_context);
  draw_element_menu(panel_context);
  for (OwnPanel& own : panels_)
    if (own.row.place == PanelPlace::over) draw_over(panel_context, own);
  // Read when the frame ends.
  const bool leaves_view = std::any_of(panels_.begin(), panels_.end(),
                                       [](const OwnPanel& own) { return own.was_over && own.panel->leaves_view(); });
  ImGui::GetStyle().Colors[ImGuiCol_ModalWindowDimBg] = leaves_view ? ImVec4() : ui_colours(theme_).backdrop;
  state_.is_laying_out = false;
  end_frame();
  for (WaitingCommand& waiting : std::exchange(state_.waiting, {}))
    if (waiting.frames-- > 0)
      state_.waiting.push_back(std::move(waiting));
    else
      context(session).run_from(waiting.command, waiting.asks_again);
  if (!rest_records(state_)) state_.waits_for_work = true;
}

// Whatever panels are shown; they and the view are to show the same step.
void Gui::play_on(Session& session) {
  constexpr double seconds_per_step = 0.8;
  if (!session.shown.player() || !session.shown.player()->is_running) return next_step_at_.reset();
  const double now = ImGui::GetTime();
  if (!next_step_at_) next_step_at_ = now + seconds_per_step;
  if (now < *next_step_at_) return;
  next_step_at_ = now + seconds_per_step;
  run(session, "steps forward");
}

std::optional<double> Gui::seconds_to_step() const {
  ImGui::SetCurrentContext(imgui_);
  if (!next_step_at_) return std::nullopt;
  return std::max(0.0, *next_step_at_ - ImGui::GetTime());
}

bool Gui::progress_frame(Language language, Size window, double seconds, const WorkShown& work) {
  begin_frame(window, seconds);
  const bool wants_cancel = draw_progress_window(language, size_.scale, work);
  end_frame();
  return wants_cancel;
}

const ImDrawData& Gui::draw_data() const {
  ImGui::SetCurrentContext(imgui_);
  return *ImGui::GetDrawData();
}

ImFontAtlas& Gui::fonts() const {
  ImGui::SetCurrentContext(imgui_);
  return *ImGui::GetIO().Fonts;
}

void Gui::pointer(glm::dvec2 pixel) {
  state_.unsettle();
  ImGui::SetCurrentContext(imgui_);
  ImGui::GetIO().MousePos = {static_cast<float>(pixel.x), static_cast<float>(pixel.y)};
}

void Gui::button(int number, bool is_down) {
  if (number < 0 || number > 2) return;
  state_.unsettle();
  is_down_[number] = is_down;
  was_pressed_[number] = was_pressed_[number] || is_down;
}

void Gui::wheel(double steps) {
  state_.unsettle();
  ImGui::SetCurrentContext(imgui_);
  ImGui::GetIO().MouseWheel += static_cast<float>(steps);
}

void Gui::character(unsigned code) {
  state_.unsettle();
  ImGui::SetCurrentContext(imgui_);
  ImGui::GetIO().AddInputCharacter(code);
}

void Gui::text(const std::string& utf8) {
  state_.unsettle();
  ImGui::SetCurrentContext(imgui_);
  ImGui::GetIO().AddInputCharactersUTF8(utf8.c_str());
}

void Gui::key(int imgui_key, bool is_down) {
  state_.unsettle();
  ImGui::SetCurrentContext(imgui_);
  if (is_down) unseen_keys_.insert(imgui_key);
  if (!is_down && unseen_keys_.contains(imgui_key)) {
    released_keys_.insert(imgui_key);
    return;
  }
  released_keys_.erase(imgui_key);
  ImGui::GetIO().KeysDown[imgui_key] = is_down;
}

void Gui::modifiers(bool shift, bool ctrl) {
  if (!unseen_keys_.empty()) {
    next_modifiers_ = {shift, ctrl};
    return;
  }
  ImGui::SetCurrentContext(imgui_);
  ImGui::GetIO().KeyShift = shift;
  ImGui::GetIO().KeyCtrl = ctrl;
}

bool Gui::owns_pointer(const Layout& layout, Size window, glm::dvec2 pixel) const {
  ImGui::SetCurrentContext(imgui_);
  const auto is_in = [&](const PixelRect& rect) {
    return pixel.x >= rect.x0 && pixel.x < rect.x1 && pixel.y >= rect.y0 && pixel.y < rect.y1;
  };
  return !is_in(view_area(window, layout)) || columns_.covers(pixel) ||
         std::any_of(state_.notes.begin(), state_.notes.end(), is_in) || !layout.open_panel.empty() ||
         ImGui::IsAnyItemActive() || ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopup);
}

bool Gui::has_menu(const Layout& layout) const {
  ImGui::SetCurrentContext(imgui_);
  return layout.open_panel.empty() && ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopup);
}

bool Gui::wants_chord(const Layout& layout) const { return state_.asks_for_key && !layout.open_panel.empty(); }

bool Gui::take_chord(const Layout& layout, const std::string& chord) {
  if (!wants_chord(layout) || chord.empty()) return false;
  state_.unsettle();
  state_.asks_for_key = false;
  state_.asked_key = chord;
  return true;
}

void Gui::close_menus() {
  state_.unsettle();
  state_.menus.closes = true;
}

bool Gui::awaits_frame(const Layout& layout) const {
  return !unseen_keys_.empty() || layout.asked_menu || layout.open_panel != laid_out_panel_ || wants_frames();
}

bool Gui::owns_keys() const {
  ImGui::SetCurrentContext(imgui_);
  return ImGui::GetIO().WantTextInput;
}

PointerShape Gui::pointer_shape() const {
  ImGui::SetCurrentContext(imgui_);
  switch (ImGui::GetMouseCursor()) {
    case ImGuiMouseCursor_TextInput:
      return PointerShape::text;
    case ImGuiMouseCursor_Hand:
      return PointerShape::hand;
    case ImGuiMouseCursor_ResizeEW:
      return PointerShape::sideways;
    default:
      return PointerShape::arrow;
  }
}

Outcome Gui::run(Session& session, const std::string& line) { return context(session).run(line); }
Outcome Gui::click(Session& session, const Navigation::Click& click) { return context(session).click(click); }
void Gui::open_element_menu() {
  state_.unsettle();
  state_.menus.opens = true;
}

void Gui::set_clipboard(void* system, const char* (*get)(void*), void (*set)(void*, const char*)) {
  ImGui::SetCurrentContext(imgui_);
  ImGuiIO& io = ImGui::GetIO();
  io.ClipboardUserData = system;
  io.GetClipboardTextFn = get;
  io.SetClipboardTextFn = set;
}

Outcome Gui::keep(Session& session, Outcome outcome) { return context(session).keep(std::move(outcome)); }

void Gui::leave(Session& session, PendingLeave where) { context(session).leave(std::move(where)); }

}  // namespace ryosen
