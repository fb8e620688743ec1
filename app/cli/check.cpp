// `check`: figures and problems of files and folders.
#include <sys/stat.h>

#include <algorithm>
#include <exception>
#include <filesystem>
#include <mutex>
#include <new>
#include <optional>
#include <set>
#include <string>
#include <system_error>
#include <thread>
#include <utility>
#include <vector>

#include "app/cli/check_report.h"
#include "app/cli/subcommand_table.h"
#include "app/editor/commands/text/script.h"
#include "ryosen/base/parallel.h"
#include "ryosen/base/resource_limits.h"
#include "ryosen/base/result.h"
#include "ryosen/base/split_list.h"
#include "ryosen/io/folder_entries.h"
#include "ryosen/io/formats.h"
#include "ryosen/io/system_reason.h"

namespace ryosen::cli {

namespace {

struct Input {
  std::string path;
  std::optional<Failure> failure;  // a folder that cannot be read or holds no mesh
};

namespace fs = std::filesystem;

Failure folder_failure(Code code, Text text) { return make_failure(ExitCode::input_missing, code, std::move(text)); }

// Recursive directory walk. Links to folders are followed, but each folder is visited once: under its own path if it is
// below the start, else through the first link in byte order.
class FolderWalk {
 public:
  explicit FolderWalk(const fs::path& folder) {
    enter(folder);
    while (!links_.empty()) {
      const std::set<std::string>::node_type link = links_.extract(links_.begin());
      enter(link.value());
    }
  }

  std::vector<Input> take() { return std::move(found_); }

 private:
  void enter(const fs::path& folder) {
    struct stat status;
    if (::stat(folder.c_str(), &status) == 0 && !entered_.emplace(status.st_dev, status.st_ino).second) return;
    std::error_code error;
    for (const ListedEntry& entry : folder_entries(folder, error)) {
      if (entry.is_folder) {
        if (entry.is_link)
          links_.insert(entry.path.native());
        else
          enter(entry.path);
      } else if (may_be_mesh(entry.path)) {
        found_.push_back({entry.path.generic_string(), {}});
      }
    }
    if (!error) return;
    const Text reason = system_reason(error.value());
    found_.push_back(
        {folder.generic_string(), folder_failure("folder_unreadable", {"The folder cannot be read: " + reason.en + ".",
                                                                       "フォルダを読めません：" + reason.ja + "。"})});
  }

  std::vector<Input> found_;
  std::set<std::pair<dev_t, ino_t>> entered_;
  std::set<std::string> links_;  // paths of links to folders, not visited yet
};

// Folders are walked recursively, in byte order of the paths, for the extensions of the format table (see may_be_mesh).
// Links to folders are followed, but each folder is visited once. Other operands are kept as given, existing or not.
std::vector<Input> find_inputs(const std::vector<std::string>& operands) {
  std::vector<Input> inputs;
  for (const std::string& operand : operands) {
    std::error_code ignored;
    if (!fs::is_directory(operand, ignored)) {
      inputs.push_back({operand, {}});
      continue;
    }
    std::vector<Input> found = FolderWalk(operand).take();
    std::sort(found.begin(), found.end(), [](const Input& a, const Input& b) { return a.path < b.path; });
    if (found.empty())
      found.push_back({operand, folder_failure("folder_empty", {"The folder holds no mesh that can be read.",
                                                                "フォルダに読み込めるメッシュがありません。"})});
    std::move(found.begin(), found.end(), std::back_inserter(inputs));
  }
  return inputs;
}

// The combined exit code of at least one input.
ExitCode combine(const std::vector<ExitCode>& codes) {
  if (codes.size() == 1) return codes[0];
  const auto is_there = [&](ExitCode code) { return std::find(codes.begin(), codes.end(), code) != codes.end(); };
  const auto is_read = [](ExitCode code) { return code == ExitCode::done || code == ExitCode::found_problems; };
  const auto count = std::count_if(codes.begin(), codes.end(), is_read);
  if (count == static_cast<std::ptrdiff_t>(codes.size()))
    return is_there(ExitCode::found_problems) ? ExitCode::found_problems : ExitCode::done;
  if (is_there(ExitCode::internal_error)) return ExitCode::internal_error;
  if (count > 0) return ExitCode::some_inputs_failed;
  if (is_there(ExitCode::out_of_memory)) return ExitCode::out_of_memory;
  const bool all_missing =
      std::all_of(codes.begin(), codes.end(), [](ExitCode c) { return c == ExitCode::input_missing; });
  return all_missing ? ExitCode::input_missing : ExitCode::input_malformed;
}

struct Options {
  std::optional<std::vector<std::string>> fail_on;  // ids of kinds
  unsigned jobs = 1;
  bool unordered = false;
  bool self_intersections = false;
};

std::optional<Failure> read_fail_on(const std::string& list, std::vector<std::string>& kinds) {
  if (list == "none") return std::nullopt;
  for (const std::string_view part : split_list(list)) {
    const std::string kind(part);
    if (kind == "none")
      return usage_failure("bad_value", {"--fail-on: none stands for itself, without other kinds.",
                                         "--fail-on：none は他の種類と一緒には使えません。"});
    if (!find_problem_row(kind)) {
      std::vector<std::string> known{"none"};
      for (const ProblemRow& row : problem_table()) known.emplace_back(row.id);
      return usage_failure("bad_value", Text{"--fail-on: '" + kind + "' is not a kind of problem.",
                                             "--fail-on：「" + kind + "」という種類の問題はありません。"} +
                                            did_you_mean(kind, known, HintForm::sentence));
    }
    kinds.push_back(kind);
  }
  return std::nullopt;
}

Result<Options> read_options(const Arguments& arguments) {
  Options options;
  options.unordered = arguments.has("--unordered");
  options.jobs = std::max(1u, std::thread::hardware_concurrency());
  if (const std::string* const jobs = arguments.value("--jobs")) {
    const auto number = whole_number(*jobs, 1, 1024);
    if (!number)
      return usage_failure("bad_value", {"--jobs is a number from 1 to 1024, not '" + *jobs + "'.",
                                         "--jobs は 1 から 1024 の数です（「" + *jobs + "」は使えません）。"});
    options.jobs = static_cast<unsigned>(*number);
  }
  if (const std::string* const list = arguments.value("--fail-on"))
    if (auto failure = read_fail_on(*list, options.fail_on.emplace())) return std::move(*failure);
  const auto names_it = [](const std::vector<std::string>& kinds) {
    return std::find(kinds.begin(), kinds.end(), row_of(ProblemKind::self_intersection).id) != kinds.end();
  };
  options.self_intersections = arguments.has("--self-intersections") || (options.fail_on && names_it(*options.fail_on));
  return options;
}

ExitCode code_of(const CheckReport& report, const Options& options) {
  if (report.failure) return report.failure->exit_code;
  if (!options.fail_on) return report.has_findings() ? ExitCode::found_problems : ExitCode::done;
  const bool found = std::any_of(report.problems.begin(), report.problems.end(), [&](const NamedProblem& p) {
    return std::find(options.fail_on->begin(), options.fail_on->end(), p.problem.row().id) != options.fail_on->end();
  });
  return found ? ExitCode::found_problems : ExitCode::done;
}

// Checks files on several threads and passes each result to the calling thread.
class Checker {
 public:
  struct Done {
    std::string output;
    std::vector<Message> messages;
    ExitCode code = ExitCode::done;
  };

  Checker(const std::vector<Input>& inputs, const Options& options, const Console& console)
      : inputs_(inputs), options_(options), console_(console) {}

  // Visits (index, result) in the order of the inputs, or in order of completion.
  template <class Visit>
  void run(Visit visit) const {
    std::mutex visiting;
    std::vector<std::optional<Done>> waiting(inputs_.size());
    std::size_t next = 0;  // in the order of the inputs
    for_each_task(static_cast<unsigned>(inputs_.size()), options_.jobs, [&](unsigned i) {
      Done done = check(inputs_[i]);
      const std::lock_guard lock(visiting);
      if (options_.unordered) return visit(i, done);
      waiting[i] = std::move(done);
      for (; next < waiting.size() && waiting[next]; ++next) {
        visit(next, *waiting[next]);
        waiting[next].reset();
      }
    });
  }

 private:
  Done check(const Input& input) const {
    CheckReport report;
    const auto fail = [&](Failure failure) {
      report.file = input.path;
      report.failure = std::move(failure);
    };
    try {
      if (input.failure)
        fail(*input.failure);
      else
        report = check_file(input.path, {.self_intersections = options_.self_intersections});
    } catch (const std::bad_alloc&) {
      fail(out_of_memory());
    } catch (const std::exception& error) {
      const std::string what = error.what();
      fail(
          make_failure(ExitCode::internal_error, "internal_error", {"Internal error: " + what, "内部エラー：" + what}));
    }
    Done done;
    done.output = console_.json ? json_line_of(report) : to_text(report, console_);
    done.code = code_of(report, options_);
    done.messages = std::move(report.messages);
    if (report.failure) done.messages.push_back(report.failure->message);
    return done;
  }

  const std::vector<Input>& inputs_;
  const Options& options_;
  const Console& console_;
};

void print_summary(const std::vector<ExitCode>& codes, const Console& console) {
  const auto count = [&](ExitCode code) { return std::count(codes.begin(), codes.end(), code); };
  const auto good = count(ExitCode::done), bad = count(ExitCode::found_problems);
  const auto failed = static_cast<std::ptrdiff_t>(codes.size()) - good - bad;
  console.print(
      console.text(Text{std::to_string(codes.size()) + " files: " + std::to_string(good) + " good, " +
                            std::to_string(bad) + " with problems, " + std::to_string(failed) + " not read\n",
                        std::to_string(codes.size()) + " ファイル：問題なし " + std::to_string(good) + "、問題あり " +
                            std::to_string(bad) + "、読めないもの " + std::to_string(failed) + "\n"}));
}

}  // namespace

ExitCode check_command(const Arguments& arguments, const Console& console) {
  const Result<Options> options = read_options(arguments);
  if (!options) return console.fail(options.failure());
  const std::vector<Input> inputs = find_inputs(arguments.operands());
  std::vector<ExitCode> codes(inputs.size());
  std::size_t left = inputs.size();
  Checker(inputs, *options, console).run([&](std::size_t i, const Checker::Done& done) {
    codes[i] = done.code;
    const bool is_last = --left == 0 && console.json;  // without JSON a summary or messages follow
    if (!is_last) console.print_now(done.output);
    for (const Message& message : done.messages)  // the JSON carries the warnings
      if (!console.json || message.severity == Severity::error) console.show(message, inputs[i].path);
    if (is_last) console.conclude(done.output, combine(codes));
  });
  if (inputs.size() > 1 && !console.json) print_summary(codes, console);
  return combine(codes);
}

}  // namespace ryosen::cli
