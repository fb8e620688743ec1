// `hull`: the convex hull of the points of a file.
#include <algorithm>

#include "app/cli/contract/hull.h"
#include "app/cli/contract/record.h"
#include "app/cli/outputs.h"
#include "app/cli/progress_line.h"
#include "app/cli/subcommands.h"
#include "app/cli/write_output.h"
#include "core/geometry/is_finite.h"
#include "core/hull/hull_shape.h"
#include "core/io/file_target.h"
#include "core/io/formats.h"
#include "core/io/input_file.h"
#include "core/io/safe_write.h"

namespace ryosen::cli {

namespace {

// A name of one dash stands for points on standard input.
Result<MeshFile> read_points(const std::string& input) {
  if (input != "-") return read_mesh_file(input);
  const Result<FileBytes> bytes = read_whole_file("/dev/stdin");
  if (!bytes) return bytes.failure();
  const Result<const Format*> format = recognise(bytes->view(), "standard_input.xyz");
  if (!format) return format.failure();
  return read_mesh(bytes->view(), **format);
}

// Where a point is not finite.
std::optional<Failure> fault_of_points(const std::vector<glm::dvec3>& points) {
  const auto is_bad = [](const glm::dvec3& p) { return !is_finite(p); };
  const auto first = std::find_if(points.begin(), points.end(), is_bad);
  if (first == points.end()) return std::nullopt;
  const std::string name = "v" + std::to_string(first - points.begin());
  const std::string count = std::to_string(std::count_if(first, points.end(), is_bad));
  return make_failure(ExitCode::refused, "refused",
                      {"Points without a finite place have no hull: " + count + ", the first of them " + name +
                           ". --skip-nonfinite leaves them out.",
                       "座標が有限でない点には凸包がありません（" + count + " 個、最初は " + name +
                           "）。--skip-nonfinite で除けます。"});
}

// Where the format holds nothing but triangles and there is none.
std::optional<Failure> fault_of_format(const Format& format, const MeshFile& source, const ConvexHull& hull) {
  const bool holds_points = holds(format.holds(encoding_of(source, format)), Holds::vertices);
  if (holds_points || hull.dimension >= 2) return std::nullopt;
  return make_failure(ExitCode::refused, "refused",
                      {"A hull of dimension " + std::to_string(hull.dimension) + " has no face, and " + format.name.en +
                           " holds nothing else; write it as OBJ, PLY or OFF.",
                       "次元 " + std::to_string(hull.dimension) + " の凸包には面がなく、" + format.name.ja +
                           " は面しか保存できません。OBJ・PLY・OFF で書き出してください。"});
}

class HullRun {
 public:
  HullRun(std::string input, const std::string* output, HullFaces faces, const Console& console)
      : input_(std::move(input)), output_(output), faces_(faces), console_(console) {}

  ExitCode run(bool skips_nonfinite) {
    Result<MeshFile> file = read_points(input_);
    if (!file) return console_.fail(file.failure(), input_);
    messages_ = file->messages;
    for (const Message& message : messages_) console_.show(message, input_);
    points_ = std::move(file->mesh.positions);
    if (const auto fault = skips_nonfinite ? std::nullopt : fault_of_points(points_))
      return console_.fail(*fault, input_);
    Progress progress(report_on(console_, "hull"));
    hull_ = convex_hull(points_, progress);
    ExitCode code = ExitCode::done;
    if (output_) code = write(*file);
    report(code);
    return code;
  }

 private:
  ExitCode fail(const Failure& failure) {
    messages_.push_back(failure.message);
    console_.show(failure.message, *output_);
    return failure.exit_code;
  }

  ExitCode write(const MeshFile& source) {
    HullList list = hull_list(points_, hull_, faces_);
    MeshFile out;
    out.mesh = std::move(list.list);
    out.wires = std::move(list.wires);
    const Format& format = *format_to_write(*output_, source);
    if (const auto fault = fault_of_format(format, out, hull_)) return fail(*fault);
    const std::vector<Message> losses = loss_messages(out, format);
    for (const Message& loss : losses) console_.show(loss, *output_);
    messages_.insert(messages_.end(), losses.begin(), losses.end());
    const Status status = write_mesh_file(*output_, out, {&format});
    is_written_ = is_in_place(status);
    return status ? ExitCode::done : fail(status.failure());
  }

  void report(ExitCode code) const {
    if (console_.json) {
      console_.conclude(json_line(code), code);
      return;
    }
    std::string text = console_.text(hull_sentence(hull_)) + "\n";
    const HullSize size = hull_size(points_, hull_);
    const auto add = [&](std::string_view en, std::string_view ja, double value) {
      char number[32];
      std::snprintf(number, sizeof number, "%.9g", value);
      text.append(console_.text(en, ja)).append(console_.text(": ", "：")).append(number).append("\n");
    };
    if (hull_.dimension == 3) add("volume", "体積", size.volume);
    if (hull_.dimension >= 2) add("area", "面積", size.area);
    if (console_.verbose)
      for (std::size_t f = 0; f < hull_.facet_count(); ++f) {
        for (const std::uint32_t i : hull_.facet(f)) text += "v" + std::to_string(i) + " ";
        text.back() = '\n';
      }
    console_.conclude(text + written_text(is_written_ ? output_ : nullptr, console_), code);
  }

  std::string json_line(ExitCode code) const {
    const HullSize size = hull_size(points_, hull_);
    const bool warns = std::any_of(messages_.begin(), messages_.end(),
                                   [](const Message& m) { return m.severity == Severity::warning; });
    Record<hull_shape> json;
    json["file"] = input_;
    json["output"] = is_written_ ? Json(*output_) : Json();
    json["status"] = code != ExitCode::done ? "error" : warns ? "warnings" : "ok";
    json["dimension"] = hull_.dimension;
    json["vertices"] = hull_.vertices.size();
    json["facets"] = hull_.facet_count();
    json["volume"] = size.volume;
    json["area"] = size.area;
    json["used"] = hull_.used;
    json["points"] = points_.size();
    if (console_.verbose) {
      Json& facets = json["facet_list"] = Json::array();
      for (std::size_t f = 0; f < hull_.facet_count(); ++f)
        facets.push_back(std::vector<std::uint32_t>(hull_.facet(f).begin(), hull_.facet(f).end()));
    }
    json["messages"] = cli::to_json(messages_);
    json.put(hull_sentence(hull_));
    return line_of(json);
  }

  std::string input_;
  const std::string* output_;
  HullFaces faces_;
  const Console& console_;
  std::vector<glm::dvec3> points_;
  ConvexHull hull_;
  std::vector<Message> messages_;
  bool is_written_ = false;
};

}  // namespace

ExitCode hull_command(const Arguments& arguments, const Console& given) {
  const std::string& input = arguments.operands()[0];
  const std::string* const output = arguments.value("-o");
  if (arguments.has("--facets") && arguments.has("--triangles"))
    return given.fail(usage_failure("flags_exclude", {"--facets and --triangles exclude each other.",
                                                      "--facets と --triangles は同時に指定できません。"}));
  RunFiles files = files_of_run(arguments, input == "-" ? std::string() : input);
  if (output) {
    if (const auto fault = fault_of_output(*output, false)) return given.fail(*fault);
    if (const Status may = files.may_write(*output, FileRole::result); !may) return given.fail(may.failure(), input);
    files.writes(*output, FileRole::result);
  }
  Console console = given;
  console.leaves_stdout = files.uses_stdout();
  const HullFaces faces = arguments.has("--triangles") ? HullFaces::triangles : HullFaces::facets;
  return HullRun(input, output, faces, console).run(arguments.has("--skip-nonfinite"));
}

}  // namespace ryosen::cli
