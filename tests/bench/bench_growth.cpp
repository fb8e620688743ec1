// How the cost of every command grows with ugly meshes, each as a whole process: processor time at n, 2n and 4n, the
// order of growth between them, the size of the answer (what it prints and writes), and the peak of memory beside
// 64 MiB + 64 times the file and the answer.
//   bench_growth [FAMILY|COMMAND...]   only those whose family or command contains one of the words
// Ends with 1 if a process died or ran into the limit of time.
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "ryosen/indexed/from_indexed.h"
#include "ryosen/io/formats.h"
#include "tests/bench/growth_commands.h"
#include "tests/bench/process.h"
#include "tests/support/core/ugly_meshes.h"

namespace ryosen::bench {
namespace {

namespace fs = std::filesystem;
using test::UglyFamily;

constexpr std::uint32_t least_n = 500;
constexpr std::array<std::uint32_t, 3> sizes{least_n, 2 * least_n, 4 * least_n};
constexpr rlim_t most_seconds = 150;
constexpr double measurable_seconds = 0.03;  // below this a time is mostly the start of the process

struct Row {
  std::string command, family;
  std::array<double, sizes.size()> seconds{}, answer{};
  double peak_share = 0;  // of the memory allowed, the largest of all sizes
  double peak_bytes = 0;
  std::string fault;

  // The exponent of n between the last two sizes, with the cost of an empty mesh taken away; none if too quick to tell.
  std::optional<double> order(double start) const {
    if (seconds[2] < measurable_seconds) return std::nullopt;
    return std::log2((seconds[2] - start) / std::max(seconds[1] - start, 1e-4));
  }
  double order_of_answer() const { return answer[2] < 1e5 ? 0 : std::log2(answer[2] / std::max(answer[1], 1.0)); }
};

void write(const IndexedMesh& mesh, const fs::path& path) {
  MeshFile file;
  file.mesh = mesh;
  if (!write_mesh_file(path, file, *find_target("ply-little"))) std::exit(5);
}

class Growth {
 public:
  explicit Growth(std::vector<std::string> words)
      : words_(std::move(words)),
        folder_(fs::temp_directory_path() / ("ryosen_bench_growth_" + std::to_string(getpid()))) {
    fs::create_directory(folder_);
    start_ = run_program({"--version"}).cost.cpu / 1e3;
  }
  ~Growth() { fs::remove_all(folder_); }

  int run() {
    print_heading("");
    for (const UglyFamily& family : test::ugly_families()) measure(family);
    print_heading("\nthe worst of each command\n");
    for (const Row& row : worst()) print(row);
    const auto faults = std::count_if(rows_.begin(), rows_.end(), [](const Row& row) { return !row.fault.empty(); });
    std::printf("%zu rows, %td with a fault\n", rows_.size(), faults);
    return faults > 0;
  }

 private:
  bool is_wanted(const std::string& name) const {
    return words_.empty() || std::any_of(words_.begin(), words_.end(),
                                         [&](const std::string& word) { return name.find(word) != std::string::npos; });
  }

  void measure(const UglyFamily& family) {
    std::array<std::vector<GrowthCommand>, sizes.size()> commands;
    for (std::size_t i = 0; i < sizes.size(); ++i) {
      const fs::path path = folder_ / (std::string(family.id) + std::to_string(sizes[i]) + ".ply");
      const IndexedMesh mesh = family.make(sizes[i]);
      write(mesh, path);
      commands[i] = growth_commands(from_indexed(mesh), path, folder_);
    }
    for (std::size_t k = 0; k < commands[0].size(); ++k) {
      Row row{commands[0][k].name, std::string(family.id), {}, {}, 0, 0, {}};
      if (!is_wanted(row.command + "@" + row.family)) continue;
      for (std::size_t i = 0; i < sizes.size() && row.fault.empty(); ++i) measure(commands[i][k], i, row);
      print(row);
      rows_.push_back(std::move(row));
    }
  }

  void measure(const GrowthCommand& command, std::size_t i, Row& row) {
    const fs::path answer = folder_ / "answer";
    const ProcessCost cost = run_program(command.arguments, answer, most_seconds);
    row.seconds[i] = cost.cost.cpu / 1e3;
    row.answer[i] = static_cast<double>(fs::file_size(answer)) + written_by(command);
    row.peak_bytes = std::max(row.peak_bytes, cost.peak_bytes);
    const double allowed = 64 * (1048576.0 + static_cast<double>(fs::file_size(command.arguments[1])) + row.answer[i]);
    row.peak_share = std::max(row.peak_share, cost.peak_bytes / allowed);
    if (WIFSIGNALED(cost.status))
      row.fault = row.seconds[i] >= most_seconds - 1 ? "too slow" : "signal " + std::to_string(WTERMSIG(cost.status));
    else if (WEXITSTATUS(cost.status) == 2 || WEXITSTATUS(cost.status) == 70)
      row.fault = "ends with " + std::to_string(WEXITSTATUS(cost.status));
  }

  // The size of what it has written behind `-o`, which is gone then.
  static double written_by(const GrowthCommand& command) {
    const auto option = std::find(command.arguments.begin(), command.arguments.end(), "-o");
    if (option == command.arguments.end() || !fs::exists(*std::next(option))) return 0;
    const auto size = static_cast<double>(fs::file_size(*std::next(option)));
    fs::remove(*std::next(option));
    return size;
  }

  static void print_heading(const char* title) {
    std::printf("%s%-36s %-10s", title, "processor time in seconds", "family");
    for (const std::uint32_t n : sizes) std::printf(" %7u", n);
    std::printf("   order  answer MB (order)  peak MB  of allowed\n");
  }

  void print(const Row& row) const {
    std::printf("%-36s %-10s", row.command.c_str(), row.family.c_str());
    for (const double seconds : row.seconds) std::printf(" %7.3f", seconds);
    const std::optional<double> order = row.order(start_);
    order ? std::printf(" %7.2f", *order) : std::printf(" %7s", "-");
    if (row.order_of_answer() > 0)
      std::printf(" %10.2f  (%4.2f) ", row.answer.back() / 1e6, row.order_of_answer());
    else
      std::printf(" %10s         ", "-");
    std::printf(" %8.0f %8.0f %%  %s\n", row.peak_bytes / 1e6, 100 * row.peak_share, row.fault.c_str());
    std::fflush(stdout);
  }

  // Of each command the row that takes longest at the largest size.
  std::vector<Row> worst() const {
    std::vector<Row> all;
    for (const Row& row : rows_) {
      const auto same = std::find_if(all.begin(), all.end(), [&](const Row& r) { return r.command == row.command; });
      if (same == all.end())
        all.push_back(row);
      else if (std::pair(!row.fault.empty(), row.seconds.back()) >
               std::pair(!same->fault.empty(), same->seconds.back()))
        *same = row;
    }
    return all;
  }

  std::vector<std::string> words_;
  fs::path folder_;
  double start_ = 0;  // seconds that the process takes without a mesh
  std::vector<Row> rows_;
};

}  // namespace
}  // namespace ryosen::bench

int main(int count, char** words) { return ryosen::bench::Growth({words + 1, words + count}).run(); }
