// A hand on the mesh of a real window: where the window shows what, and what it says and saves.
#pragma once

#include <memory>
#include <string>
#include <utility>

#include "app/editor/session/session.h"
#include "ryosen/scene/view/camera.h"
#include "tests/support/app/laid.h"
#include "tests/support/app/real_window.h"

namespace ryosen::test {

class WindowHand : public RealWindow {
 protected:
  // A copy of an asset, which may be saved.
  void open_copy(const std::string& name);
  // What the program makes with these words.
  void open_made(std::vector<std::string> words);
  // The same panels about the same file, without a window: they know where it shows what.
  Laid& beside() { return *laid_; }
  Session& session() { return laid_->session; }
  // The camera of the window, as the picture says.
  Camera camera() const;

  // A click there, with keys held down meanwhile.
  void click(glm::dvec2 pixel, const std::string& keys = "", int button = 1) const;

  glm::dvec2 pixel_of(const glm::dvec3& place) const { return pixel_of(place, laid_->session.view.camera); }
  glm::dvec2 pixel_of(const glm::dvec3& place, const Camera& camera) const;
  // A place at a share of an edge that is seen and long on the screen.
  struct OnEdge {
    glm::dvec2 pixel{0};
    Edge edge;
    glm::dvec3 from{0}, to{0};
  };
  OnEdge on_edge(double share, int which = 0);
  // The middle of the corners of a face that is seen there.
  struct OnFace {
    glm::dvec2 pixel{0};
    Face face;
  };
  OnFace on_a_face(int which = 0);
  glm::dvec2 on_face() { return on_a_face().pixel; }
  struct OnVertex {
    glm::dvec2 pixel{0};
    Vertex vertex;
  };
  OnVertex on_a_vertex(int which = 0);
  // Two corners of a box around all of the mesh, beside it.
  std::pair<glm::dvec2, glm::dvec2> around_all() const;

  bool has_selected(long n) {
    return shows([n](const Frame& frame) { return frame.selected == n; });
  }
  bool is_at(long entry) {
    return shows([entry](const Frame& frame) { return frame.history == entry; });
  }
  bool has_faces(long n) {
    return shows([n](const Frame& frame) { return frame.faces == n; });
  }
  // The file as the editor writes it now.
  Mesh saved();
  static bool has_point(const Mesh& m, const glm::dvec3& place, double within = 1e-9);

  std::string file_;

 private:
  void open_file();

  std::unique_ptr<Laid> laid_;
};

}  // namespace ryosen::test
