// The repairs of the command `repair`, run as often as the file that is to be written asks for, and their report.
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "app/cli/algorithm_call.h"
#include "app/editor/document/written_mesh.h"

namespace ryosen::cli {

class RepairRun {
 public:
  // The job must outlive it.
  RepairRun(AlgorithmJob& job, const Console& console) : job_(job), console_(console) {}

  // Runs the calls in rounds, and where the file gives other points back than were written, again on what the file
  // gives back, until they make that no better: the job has the document that was read last then, and what was lost for
  // that. Prints each step when it is done. The calls get their values and results.
  std::optional<Failure> run(std::vector<Call>& calls);

  const Document& document() const { return *job_.document; }
  std::size_t rounds() const { return rounds_; }
  // As the file has them, where that is another mesh.
  const std::vector<KindCount>& findings() const { return findings_; }
  const std::pair<std::size_t, std::size_t>& boundary_edges() const { return boundary_edges_; }  // before, after
  const std::vector<Element>& loose() const { return loose_; }  // the first faces of loose pieces

 private:
  void print(std::string line);
  RecipeEvents events_of(std::span<const RecipeStep> steps, const std::vector<std::string>& names);
  void run_as_written(std::span<const RecipeStep> steps, const std::string& command, const RecipeEvents& events);
  bool run_once(std::span<const RecipeStep> steps, const std::string& command, const RecipeEvents& events);
  void add_run(RecipeResult result);
  void count_as_written(const WrittenMesh& mesh);
  void read_again();

  AlgorithmJob& job_;
  const Console& console_;
  std::vector<Call>* calls_ = nullptr;
  std::unique_ptr<Document> reread_;  // where the document is read again
  bool waits_ = false;
  std::vector<std::string> waiting_;  // lines
  bool was_no_better_ = false;        // a run was undone
  std::size_t rounds_ = 0;
  std::vector<KindCount> findings_;
  std::pair<std::size_t, std::size_t> boundary_edges_;
  std::vector<Element> loose_;
};

// The rounds, each kind of finding of which the number is another now, and the loose pieces.
void print_repair(const RepairRun& run, const Console& console);

// The keys of repairs_keys.
void add_repair(Record<repair_shape>& json, const RepairRun& run, std::span<const Call> calls);

}  // namespace ryosen::cli
