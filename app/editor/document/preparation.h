// What hovering and the lists of problems need of a large mesh, found in the background.
#pragma once

#include <atomic>
#include <exception>
#include <functional>
#include <memory>
#include <optional>
#include <thread>
#include <vector>

#include "ryosen/analysis/boundary_loops.h"
#include "ryosen/analysis/euler_poincare.h"
#include "ryosen/analysis/mesh_kind.h"
#include "ryosen/scene/highlights/highlight_sets.h"
#include "ryosen/scene/pick/picker.h"

namespace ryosen {

// Finds it on a thread of its own, or at once where none is to be had. It reads the mesh: no edit is opened while this
// lives. The destructor cancels and waits.
class Preparation {
 public:
  // What the mesh belongs to: the vertices that lines use and the number of lines of the file, and the highlights
  // shown.
  struct Beside {
    std::vector<Vertex> on_lines;
    std::uint64_t lines = 0;
    std::vector<const HighlightRow*> shown;
  };

  // What it finds beside the picker's tree.
  struct Found {
    HighlightSets highlights;
    BoundaryLoopCount boundary_loops;
    EulerPoincare euler;
    KindOfMesh kind;
  };

  // The picker's tree is built too; nobody picks meanwhile. Cancelled, it ends within milliseconds.
  Preparation(const Mesh& mesh, Picker& picker, Beside beside);
  ~Preparation();
  Preparation(const Preparation&) = delete;
  Preparation& operator=(const Preparation&) = delete;

  // From 0 to 1.
  double share() const { return share_; }
  bool is_done() const { return is_done_; }
  // Waits until it is done; throws what was thrown there.
  Found take();

 private:
  void run();
  void find();
  // Tells the share that is done; false when it is to end.
  bool go_on(double share);

  const Mesh& mesh_;
  Picker& picker_;
  Beside beside_;
  Found found_;
  std::exception_ptr thrown_ = nullptr;
  std::atomic<double> share_ = 0;
  std::atomic<bool> is_done_ = false, is_cancelled_ = false;
  std::thread thread_;
};

}  // namespace ryosen
