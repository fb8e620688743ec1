// The files of one run: what it reads and what it has written, so that no output takes the place of one of them
// unasked.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "ryosen/base/result.h"
#include "ryosen/io/file_target.h"

namespace ryosen {

// What a file is in a run: the first three are read, the others written.
enum class FileRole { mesh, script, reference, saved, result, picture, difference };

class RunFiles {
 public:
  enum class Policy {
    keep,      // nothing of the run is replaced, but what it saved of the same document
    by_kind,   // the user decides, but no picture takes the place of a mesh, and no mesh that of a picture
    overwrite  // everything is, as --overwrite asks
  };
  explicit RunFiles(Policy policy) : policy_(policy) {}

  // Results go to standard output, which nothing else may be written to then.
  void leave_stdout_to_results() { stdout_is_taken_ = true; }
  // Another document from here on.
  void begin_document() { ++document_; }
  void reads(const std::filesystem::path& path, FileRole role);
  // Whether the file may be written. Files that the run has nothing to do with may, devices and pipes too.
  Status may_write(const std::filesystem::path& path, FileRole role) const;
  // It has been written, or will have been when what follows is asked about.
  void writes(const std::filesystem::path& path, FileRole role);
  // All that `plan` writes is named by this run, though nothing is there yet.
  void plans(const RunFiles& plan) { planned_ = plan.known_; }
  // Whether nothing is there and nothing is planned: for a name that nobody gave.
  bool is_free(const std::filesystem::path& path) const;

  // Whether something of that goes to standard output.
  bool uses_stdout() const { return uses_stdout_; }

 private:
  struct Known {
    std::filesystem::path path;  // as it was named
    FileTarget target;
    FileRole role;
    std::uint64_t document;
  };
  bool may_replace(const Known& known, FileRole role) const;
  Status may_write_to_stream(const std::filesystem::path& path, const FileTarget& target) const;

  Policy policy_;
  std::vector<Known> known_, planned_;
  std::uint64_t document_ = 0;
  bool uses_stdout_ = false;
  bool stdout_is_taken_ = false;
};

}  // namespace ryosen
