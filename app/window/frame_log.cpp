#include "app/window/frame_log.h"

#include <algorithm>
#include <cstdlib>
#include <sstream>
#include <string>

#include "app/editor/session/session.h"
#include "ryosen/mesh/names.h"

namespace ryosen {

namespace {

std::string hovered(const Mesh& mesh, const Selecting& selecting, const Pointing& pointing) {
  if (pointing.pointed_handle() || pointing.pointed_axis_end()) return "handle";
  return selecting.hover() ? name_of(mesh, selecting.hover()->picked.element) : "-";
}

std::string first_selected(const Mesh& mesh, const Selecting& selecting) {
  return selecting.selection.empty() ? "-" : name_of(mesh, selecting.selection[0]);
}

std::string over_the_view(const Layout& layout) { return layout.open_panel.empty() ? "-" : layout.open_panel; }

std::string in_one_line(std::string text) {
  std::replace(text.begin(), text.end(), '\n', ' ');
  return text;
}

std::string words_of(const glm::dvec3& place) {
  std::ostringstream words;
  words << place.x << ' ' << place.y << ' ' << place.z;
  return words.str();
}

}  // namespace

FrameLog::FrameLog() {
  if (const char* const path = std::getenv("RYOSEN_FRAME_LOG")) log_.open(path, std::ios::app);
}

void FrameLog::reading(const Layout& layout, const std::filesystem::path& file) {
  if (log_.is_open()) log_ << "reading " << file.string() << " panel " << over_the_view(layout) << std::endl;
}

void FrameLog::progress(double share) {
  if (log_.is_open()) log_ << "progress " << share << std::endl;
}

void FrameLog::frame(const Session& session, const Text& said, std::int64_t pixels, double took_ms) {
  if (!log_.is_open()) return;
  const ElementCounts live = session.mesh().live();
  log_ << "frame " << ++frames_ << " pixels " << pixels << " ms " << took_ms << " V " << live.vertices << " E "
       << live.edges << " F " << live.faces << " history " << session.document().position() << " hover "
       << hovered(session.mesh(), session.selecting, session.pointing) << " held "
       << session.selecting.is_verdict_held() << " selected " << session.selecting.selection.size() << " eye "
       << words_of(session.view.camera.eye) << " first " << first_selected(session.mesh(), session.selecting)
       << " panel " << over_the_view(session.layout) << " target " << words_of(session.view.camera.target)
       << " gesture " << session.gesturing.is_active() << " said " << in_one_line(said.en) << std::endl;
}

}  // namespace ryosen
