// `shot`: a picture of a mesh or of the whole editor, written or compared with another.
#include "app/cli/contract/shot.h"

#include <filesystem>

#include "app/cli/console.h"
#include "app/cli/contract/json.h"
#include "app/cli/shot_options.h"
#include "app/cli/subcommand_table.h"
#include "app/cli/sudden_end.h"
#include "app/editor/preferences/user_files.h"
#include "app/editor/session/session.h"
#include "ryosen/base/number_text.h"
#include "ryosen/base/parallel.h"
#include "ryosen/base/resource_limits.h"
#include "ryosen/io/safe_write.h"

namespace ryosen::cli {

namespace {

constexpr std::uint64_t much_memory = std::uint64_t{1} << 30;  // worth saying before

class Shot {
 public:
  Shot(const ShotOptions& options, Session& session, Headless& headless, const Console& console)
      : options_(options), session_(session), headless_(headless), console_(console) {}

  ExitCode run() {
    session_.frontend.take_picture = [this](const std::filesystem::path& path) {
      return write_png(headless_.picture(session_), path);
    };
    session_.files = options_.files;
    session_.preferences.language = console_.language;
    if (options_.preferences && !read_preferences()) return finish();
    if (options_.has_language) session_.preferences.language = console_.language;
    if (options_.shown) session_.view.highlights = *options_.shown;
    headless_.place_view(session_);
    steps();
    // Malformed lines and names produce no picture; refusals and failed expectations do.
    if (code_ != ExitCode::done && code_ != ExitCode::refused && code_ != ExitCode::found_problems) return finish();
    begin_another_step();
    if (options_.hover) session_.pointing.point_at(*options_.hover);
    const Image picture = headless_.picture(session_);
    if (options_.output) is_written_ = write(picture, *options_.output, FileRole::picture);
    if (options_.reference) compare_with_reference(picture);
    return finish();
  }

 private:
  void steps() {
    if (options_.view) take("view " + *options_.view);
    if (options_.camera) take("camera " + *options_.camera);
    for (const auto& [row, value] : options_.switches) row.set(session_, value);  // of which one cuts across the camera
    if (!options_.tool.empty()) take("tool " + options_.tool);
    for (const ScriptLine& line : options_.script.lines) take(line.text, line.line);
    if (!options_.selected.empty()) {
      std::string line = "select";
      for (const std::string& name : options_.selected) line += " " + name;
      take(line);
    }
    for (const ShotClick& click : options_.clicks)
      if (code_ == ExitCode::done) note(session_.pointing.click(click.pixel, click.tool), 0);
  }

  // Before what flags say.
  bool read_preferences() {
    std::error_code ignored;
    const std::filesystem::path file = *options_.preferences;
    Outcome outcome;
    if (!std::filesystem::exists(file, ignored))
      outcome = failed(ExitCode::input_missing, {"There is no file " + file.string() + " of preferences.",
                                                 "設定ファイル " + file.string() + " がありません。"});
    else if (const auto read = ryosen::read_preferences(session_, file); !read)
      outcome = failed(read.failure().exit_code, read.failure().message.text);
    else if (!read->warning.en.empty())
      console_.note(read->warning);
    note(outcome, 0);
    return outcome.done();
  }

  void take(const std::string& line, int number = 0) {
    begin_another_step();
    if (code_ == ExitCode::done) note(session_.run(line), number);
  }

  void note(const Outcome& outcome, int line) {
    if (outcome.done()) return;
    code_ = outcome.exit_code;
    Message message;
    message.code = code_of(outcome);
    message.text = outcome.sentence;
    if (line > 0) message.line = static_cast<std::uint64_t>(line);
    console_.show(message, line > 0 ? options_.script.file : std::string());
    messages_.push_back(message);
  }

  // Whether the picture is there.
  bool write(const Image& picture, const std::string& path, FileRole role) {
    Status status = session_.files.may_write(path, role);
    if (status) status = write_png(picture, path);
    const bool is_there = is_in_place(status);
    if (is_there) session_.files.writes(path, role);
    if (!status)
      fail(status.failure());
    else if (!console_.json && !console_.quiet && console_.verbose)
      console_.print(visible_line(path) + "\n");
    return is_there;
  }

  void fail(const Failure& failure) {
    code_ = failure.exit_code;
    console_.show(failure.message);
    messages_.push_back(failure.message);
  }

  void compare_with_reference(const Image& picture) {
    begin_another_step();
    const Result<Image> reference = read_png(*options_.reference);
    if (!reference) return fail(reference.failure());
    const Result<ImageDifference> difference = compare(*reference, picture);
    if (!difference) return fail(difference.failure());
    percent_ = 100 * difference->share;
    if (options_.difference) write(difference->picture, *options_.difference, FileRole::difference);
    if (*percent_ <= options_.tolerance_percent) return;
    const std::string share = format_double(*percent_), allowed = format_double(options_.tolerance_percent);
    fail(make_failure(ExitCode::found_problems, "pictures_differ",
                      {share + " % of the pixels differ, " + allowed + " % are allowed.",
                       "画素の " + share + " % が異なります（許容 " + allowed + " %）。"}));
  }

  ExitCode finish() const {
    if (!console_.json) return code_;
    Record<shot_shape> json;
    json["file"] = options_.file;
    json["output"] = is_written_ ? Json(*options_.output) : Json();
    json["status"] = code_ == ExitCode::done ? "ok" : "error";
    json["size"] = {options_.picture.size.width, options_.picture.size.height};
    json["backend"] = headless_.backend();
    json["reference"] = or_null(options_.reference);
    json["different_percent"] = or_null(percent_);
    json["messages"] = cli::to_json(messages_);
    return console_.end(line_of(json), code_);
  }

  const ShotOptions& options_;
  Session& session_;
  Headless& headless_;
  const Console& console_;
  ExitCode code_ = ExitCode::done;
  bool is_written_ = false;
  std::optional<double> percent_;
  std::vector<Message> messages_;
};

// Whether the mesh is to be known before the renderer is loaded, to compare what the picture needs with what there is.
bool needs_much(const ShotOptions& options) {
  constexpr std::uintmax_t large_file = std::uintmax_t{64} << 20;
  std::error_code error;
  const std::uintmax_t size = std::filesystem::file_size(options.file, error);
  return is_reserving_limited() || (!error && size >= large_file) ||
         Headless::need(options.picture, 0).resident >= much_memory;
}

// At least as many as are drawn: n - 2 of a face with n sides.
std::uint64_t most_triangles(const Mesh& mesh) {
  const ElementCounts live = mesh.live();
  return 2 * (std::uint64_t{live.edges} - std::min(live.edges, live.faces));
}

void announce_memory(const MemoryNeed& need, const Console& console) {
  if (need.resident < much_memory) return;
  const std::string bytes = memory_text(need.resident);
  console.note({"This picture needs about " + bytes + " of memory besides the mesh.",
                "この画像には、メッシュのほかに約 " + bytes + " のメモリが必要です。"});
}

}  // namespace

ExitCode shot_command(const Arguments& arguments, const Console& given) {
  const Result<ShotOptions> options = read_shot_options(arguments);
  if (!options) {
    const Message& message = options.failure().message;
    // A fault of the flags is about no file.
    const bool is_of_flags = options.failure().exit_code == ExitCode::usage && !message.line;
    given.show(message, message.line ? *arguments.value("--script") : std::string());
    const std::string object =
        given.json ? line_of(error_object(message, is_of_flags ? "" : arguments.operands()[0])) : std::string();
    return given.end(object, options.failure().exit_code);
  }
  Console console = given;
  console.leaves_stdout = options->leaves_stdout;
  std::optional<Result<std::unique_ptr<Headless>>> headless;
  std::optional<Result<std::unique_ptr<Document>>> document;
  const auto read = [&] { document.emplace(Document::open(options->file)); };
  if (needs_much(*options)) {
    read();
    if (*document) {
      const std::uint64_t triangles = most_triangles((**document)->mesh());
      announce_memory(Headless::need(options->picture, triangles), console);
      headless.emplace(Headless::make(options->picture, triangles));
    }
  } else {
    // Reading and creating a context take about equally long and are independent.
    do_beside([&] { headless.emplace(Headless::make(options->picture)); }, read);
  }
  if (!*document) return console.fail(document->failure(), options->file);
  if (!*headless) return console.fail(headless->failure());
  Session session(std::move(*document).value());
  return Shot(*options, session, *headless->value(), console).run();
}

}  // namespace ryosen::cli
