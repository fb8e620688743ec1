// What repairs would do, tried on a copy of the mesh before anybody presses anything.
#pragma once

#include <atomic>
#include <exception>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <thread>

#include "ryosen/algo/repair/report.h"
#include "ryosen/document/document.h"

namespace ryosen {

// Whether a mesh is so large that only what somebody points at is worth trying.
inline bool is_costly_to_try(const Mesh& mesh) { return mesh.live().faces > 20000; }

// One trial at a time; reports are kept until the document changes.
class RepairTrials {
 public:
  // For windows: on a thread of its own, of() then tells nothing until it is done. Else of() tries at once.
  bool in_background = false;

  // The report of a call as this line says it on the document as it is. Null while it, or another one, is being tried.
  // `replaces`: that other one is cancelled.
  const RepairReport* of(const Document& document, const std::string& line, const RepairCall& call, bool replaces);
  // Takes over what has been done in the background.
  void follow(const Document& document);
  // From 0 to 1, while one goes on.
  std::optional<double> share() const;
  // Ends the trial that goes on. Ends within milliseconds.
  void cancel() { running_.reset(); }
  // Of another document, or before that changes.
  void forget();
  // The mesh may be written to behind it: waits while it is being copied.
  void let_write();

 private:
  class Running;
  struct RunningDeleter {
    void operator()(Running* running) const;
  };

  std::uint64_t serial_ = 0, revision_ = 0;  // that the reports are of
  std::map<std::string, RepairReport> reports_;
  std::unique_ptr<Running, RunningDeleter> running_;
};

}  // namespace ryosen
