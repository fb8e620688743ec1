// `hull`: the convex hull of the points of a file.
#include <algorithm>
#include <numeric>
#include <string>
#include <vector>

#include "app/cli/console.h"
#include "app/cli/contract/hull.h"
#include "app/cli/contract/json.h"
#include "app/cli/outputs.h"
#include "app/cli/subcommand_table.h"
#include "ryosen/geometry/is_finite.h"
#include "ryosen/hull/hull_extent.h"
#include "ryosen/hull/hull_shape.h"
#include "ryosen/hull/projection.h"
#include "ryosen/io/file_target.h"
#include "ryosen/io/formats.h"
#include "ryosen/io/input_file.h"
#include "ryosen/io/safe_write.h"

namespace ryosen::cli {

namespace {

struct HullWishes {
  HullFaces faces = HullFaces::facets;
  Projection projection = Projection::none;
  bool per_component = false, measure = false;
};

struct MadeHull {
  std::size_t points = 0;   // of which it is the hull
  std::uint32_t first = 0;  // the lowest of them
  ConvexHull hull;
  HullSize size;
  HullExtent extent;
};

using Facets = std::vector<std::vector<std::uint32_t>>;

void add_facets(const ConvexHull& hull, Facets& to) {
  for (std::size_t f = 0; f < hull.facet_count(); ++f) to.emplace_back(hull.facet(f).begin(), hull.facet(f).end());
}

template <const Shape& shape>
void put_extent(Record<shape>& json, const HullExtent& extent) {
  json["diameter"] = extent.diameter;
  json["farthest"] = extent.farthest;
  json["width"] = extent.width;
  json["between"] = Json::array();
  if (!extent.between[0].empty()) json["between"] = extent.between;
}

Json component_json(const MadeHull& made, const HullWishes& wishes, bool is_verbose) {
  Record<hull_component_shape> json;
  json["dimension"] = made.hull.dimension;
  json["vertices"] = made.hull.vertices.size();
  json["facets"] = made.hull.facet_count();
  json["volume"] = made.size.volume;
  json["area"] = made.size.area;
  json["used"] = made.hull.used;
  json["points"] = made.points;
  if (is_verbose) {
    Facets facets;
    add_facets(made.hull, facets);
    json["facet_list"] = facets;
    json["extreme"] = made.hull.vertices;
  }
  if (wishes.measure) put_extent(json, made.extent);
  return std::move(json).json();
}

// The sums over all hulls.
struct Sums {
  explicit Sums(const std::vector<MadeHull>& hulls) {
    for (const MadeHull& made : hulls) {
      vertices += made.hull.vertices.size();
      facets += made.hull.facet_count();
      used += made.hull.used;
      size.volume += made.size.volume;
      size.area += made.size.area;
    }
  }
  std::size_t vertices = 0, facets = 0, used = 0;
  HullSize size;
};

void put_lists(Record<hull_shape>& json, const std::vector<MadeHull>& hulls) {
  Facets facets;
  std::vector<std::uint32_t> extreme;
  for (const MadeHull& made : hulls) {
    add_facets(made.hull, facets);
    extreme.insert(extreme.end(), made.hull.vertices.begin(), made.hull.vertices.end());
  }
  std::sort(facets.begin(), facets.end());
  std::sort(extreme.begin(), extreme.end());
  json["facet_list"] = facets;
  json["extreme"] = extreme;
}

std::string lines_of_hull(const MadeHull& made, const HullWishes& wishes, const Console& console) {
  std::string text = console.text(hull_sentence(made.hull)) + "\n";
  const auto add = [&](const Text& line) {
    if (!line.en.empty()) text += console.text(line) + "\n";
  };
  add(size_sentence(made.hull, made.size));
  if (wishes.measure) add(extent_sentence(made.extent));
  if (!console.verbose) return text;
  for (std::size_t f = 0; f < made.hull.facet_count(); ++f) {
    for (const std::uint32_t i : made.hull.facet(f)) text += "v" + std::to_string(i) + " ";
    text.back() = '\n';
  }
  return text;
}

Text whole_sentence(const std::vector<MadeHull>& hulls) {
  if (hulls.size() == 1) return hull_sentence(hulls[0].hull);
  const Sums sums(hulls);
  return hulls_sentence(hulls.size(), sums.vertices, sums.facets, sums.size);
}

// The hulls that were made, and how the command says so.
struct HullReport {
  HullReport(std::string file, HullWishes what) : input(std::move(file)), wishes(what) {}

  // The largest; -1 where there is no hull.
  int dimension() const {
    int largest = -1;
    for (const MadeHull& made : hulls) largest = std::max(largest, made.hull.dimension);
    return largest;
  }

  // `output`: where it was written, null where it was not.
  std::string json_line(ExitCode code, const std::string* output, const Console& console) const {
    const bool warns =
        std::any_of(messages.begin(), messages.end(), [](const Message& m) { return m.severity == Severity::warning; });
    const Sums sums(hulls);
    Record<hull_shape> json;
    json["file"] = input;
    json["output"] = output ? Json(*output) : Json();
    json["status"] = code != ExitCode::done ? "error" : warns ? "warnings" : "ok";
    json["dimension"] = dimension();
    json["vertices"] = sums.vertices;
    json["facets"] = sums.facets;
    json["volume"] = sums.size.volume;
    json["area"] = sums.size.area;
    json["used"] = sums.used;
    json["points"] = points.size();
    if (console.verbose) put_lists(json, hulls);
    if (wishes.per_component) {
      Json& components = json["components"] = Json::array();
      for (const MadeHull& made : hulls) components.push_back(component_json(made, wishes, console.verbose));
    } else if (wishes.measure) {
      put_extent(json, hulls[0].extent);
    }
    json["messages"] = cli::to_json(messages);
    json.put(whole_sentence(hulls));
    return line_of(json);
  }
  std::string text(const std::string* output, const Console& console) const {
    std::string text;
    const bool are_several = hulls.size() != 1;
    if (are_several) text = console.text(whole_sentence(hulls)) + "\n";
    for (const MadeHull& made : hulls) {
      if (are_several) text += "\nv" + std::to_string(made.first) + ": ";
      text += lines_of_hull(made, wishes, console);
    }
    return text + written_text(output, console);
  }

  std::string input;
  HullWishes wishes;
  std::vector<glm::dvec3> points = {};
  std::vector<MadeHull> hulls = {};
  std::vector<Message> messages = {};
};

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
std::optional<Failure> fault_of_format(const Format& format, const MeshFile& source, int dimension) {
  const bool holds_points = holds(format.holds(encoding_of(source, format)), Holds::vertices);
  if (holds_points || dimension >= 2) return std::nullopt;
  return make_failure(ExitCode::refused, "refused",
                      {"A hull of dimension " + std::to_string(dimension) + " has no face, and " + format.name.en +
                           " holds nothing else; write it as OBJ, PLY or OFF.",
                       "次元 " + std::to_string(dimension) + " の凸包には面がなく、" + format.name.ja +
                           " は面しか保存できません。OBJ・PLY・OFF で書き出してください。"});
}

// The ends of the edges that the file has without a face.
PointPairs lines_of(const MeshFile& file) {
  PointPairs pairs = file.wires;
  const auto count = static_cast<std::int64_t>(file.mesh.positions.size());
  for (const LineElement& line : file.elements.items)
    for (std::uint32_t k = 1; !line.is_points && k < line.count; ++k) {
      const std::int64_t a = file.elements.vertices[line.first + k - 1], b = file.elements.vertices[line.first + k];
      if (std::min(a, b) >= 0 && std::max(a, b) < count) pairs.emplace_back(a, b);
    }
  return pairs;
}

class HullRun {
 public:
  HullRun(std::string input, const std::string* output, HullWishes wishes, const Console& console)
      : output_(output), console_(console), report_(std::move(input), wishes) {}

  ExitCode run(bool skips_nonfinite) {
    Result<MeshFile> file = read_points(report_.input);
    if (!file) return console_.fail(file.failure(), report_.input);
    report_.messages = file->messages;
    for (const Message& message : report_.messages) console_.show(message, report_.input);
    const std::vector<std::vector<std::uint32_t>> parts =
        report_.wishes.per_component ? joined_points(file->mesh, lines_of(*file)) : all_together(*file);
    report_.points = std::move(file->mesh.positions);
    if (const auto fault = skips_nonfinite ? std::nullopt : fault_of_points(report_.points))
      return console_.fail(*fault, report_.input);
    project(report_.points, report_.wishes.projection);
    make_hulls(parts);
    ExitCode code = ExitCode::done;
    if (output_) code = write(*file);
    const std::string* const written = is_written_ ? output_ : nullptr;
    return console_.end(console_.json ? report_.json_line(code, written, console_) : report_.text(written, console_),
                        code);
  }

 private:
  static std::vector<std::vector<std::uint32_t>> all_together(const MeshFile& file) {
    std::vector<std::vector<std::uint32_t>> all(1);
    all[0].resize(file.mesh.positions.size());
    std::iota(all[0].begin(), all[0].end(), 0u);
    return all;
  }

  void make_hulls(const std::vector<std::vector<std::uint32_t>>& parts) {
    Progress progress(report_on(console_, "hull"));
    for (const std::vector<std::uint32_t>& part : parts) {
      progress.begin_part(report_.hulls.size(), parts.size());
      MadeHull& made = report_.hulls.emplace_back();
      made.points = part.size();
      made.first = part.empty() ? 0 : part[0];
      made.hull = hull_of_some(report_.points, part, progress);
      made.size = hull_size(report_.points, made.hull);
      if (report_.wishes.measure) made.extent = hull_extent(report_.points, made.hull, progress);
    }
  }

  ExitCode fail(const Failure& failure) {
    report_.messages.push_back(failure.message);
    console_.show(failure.message, *output_);
    return failure.exit_code;
  }

  ExitCode write(const MeshFile& source) {
    HullList list;
    for (const MadeHull& made : report_.hulls) add_hull(report_.points, made.hull, report_.wishes.faces, list);
    MeshFile out;
    out.mesh = std::move(list.list);
    out.wires = std::move(list.wires);
    const Format& format = *format_to_write(*output_, source);
    if (const auto fault = fault_of_format(format, out, report_.dimension())) return fail(*fault);
    const std::vector<Message> losses = loss_messages(out, format);
    for (const Message& loss : losses) console_.show(loss, *output_);
    report_.messages.insert(report_.messages.end(), losses.begin(), losses.end());
    const Status status = write_mesh_file(*output_, out, {&format});
    is_written_ = is_in_place(status);
    return status ? ExitCode::done : fail(status.failure());
  }

  const std::string* output_;
  const Console& console_;
  HullReport report_;
  bool is_written_ = false;
};

// What is asked for; none where --project names nothing.
std::optional<HullWishes> wishes_of(const Arguments& arguments) {
  HullWishes wishes;
  if (arguments.has("--triangles")) wishes.faces = HullFaces::triangles;
  wishes.per_component = arguments.has("--per-component");
  wishes.measure = arguments.has("--measure");
  if (const std::string* const id = arguments.value("--project")) {
    const ProjectionRow* const row = find_projection(*id);
    if (!row || row->projection == Projection::none) return std::nullopt;
    wishes.projection = row->projection;
  }
  return wishes;
}

}  // namespace

ExitCode hull_command(const Arguments& arguments, const Console& given) {
  const std::string& input = arguments.operands()[0];
  const std::string* const output = arguments.value("-o");
  if (arguments.has("--facets") && arguments.has("--triangles"))
    return given.fail(usage_failure("flags_exclude", {"--facets and --triangles exclude each other.",
                                                      "--facets と --triangles は同時に指定できません。"}));
  const std::optional<HullWishes> wishes = wishes_of(arguments);
  if (!wishes)
    return given.fail(usage_failure(
        "bad_value", {"--project takes x, y, z or best.", "--project の値は x、y、z、best のいずれかです。"}));
  RunFiles files = files_of_run(arguments, input == "-" ? std::string() : input);
  if (output) {
    if (const auto fault = fault_of_output(*output, false)) return given.fail(*fault);
    if (const Status may = files.may_write(*output, FileRole::result); !may) return given.fail(may.failure(), input);
    files.writes(*output, FileRole::result);
  }
  Console console = given;
  console.leaves_stdout = files.uses_stdout();
  return HullRun(input, output, *wishes, console).run(arguments.has("--skip-nonfinite"));
}

}  // namespace ryosen::cli
