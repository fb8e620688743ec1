// `distance`: how far two surfaces are from each other.
#include <array>

#include "app/cli/columns.h"
#include "app/cli/console.h"
#include "app/cli/distance_report.h"
#include "app/cli/subcommand_table.h"
#include "ryosen/analysis/measure/distance.h"
#include "ryosen/base/parallel.h"
#include "ryosen/indexed/from_indexed.h"
#include "ryosen/io/formats.h"
#include "ryosen/io/numbers.h"
#include "ryosen/mesh/names.h"

namespace ryosen::cli {

namespace {

Result<DistanceOptions> wanted_options(const Arguments& arguments) {
  DistanceOptions options;
  if (const std::string* const gap = arguments.value("--gap"))
    if (read_real(*gap, options.gap) != NumberRead::finite || options.gap < 1e-12 || options.gap > 1)
      return usage_failure("bad_value",
                           {"--gap takes a number from 1e-12 to 1.", "--gap は 1e-12 から 1 までの数です。"});
  if (const std::string* const samples = arguments.value("--samples")) {
    std::int64_t number = 0;
    if (!read_integer(*samples, number) || number < 1 || number > 1000000000)
      return usage_failure("bad_value", {"--samples takes a number from 1 to 1000000000.",
                                         "--samples は 1 から 1000000000 までの数です。"});
    options.samples = static_cast<std::uint64_t>(number);
  }
  return options;
}

// A file as it is measured.
struct ReadSurface {
  std::string path;
  std::optional<Failure> failure;
  std::vector<Message> messages;
  std::size_t quarantined = 0;
  Mesh mesh;

  void read() {
    Result<MeshFile> file = read_mesh_file(path);
    if (!file) {
      failure = file.failure();
      return;
    }
    messages = std::move(file->messages);
    quarantined = file->mesh.quarantine.size();
    mesh = from_indexed(std::move(file->mesh));
    if (!has_surface(mesh))
      failure =
          make_failure(ExitCode::refused, "refused",
                       {"There is nothing to measure: the file has no face with finite corners. Give one that has.",
                        "計測できません。座標が有限な面がありません。面のあるファイルを指定してください。"});
  }
};

Json direction_json(const OneWayDistance& way, const ReadSurface& from, double diagonal) {
  Record<direction_shape> json;
  add_figures(json, way, diagonal);
  json["from"] = to_json(way.from);
  json["to"] = to_json(way.to);
  json["face"] = name_of(from.mesh, way.face);
  json["samples"] = way.samples;
  json["area"] = number_or_null(way.area);
  json["faces"] = way.faces;
  json["left_out"] = way.left_out + from.quarantined;
  return std::move(json).json();
}

std::string line_of(const SurfaceDistance& found, const ReadSurface& a, const ReadSurface& b) {
  Record<distance_shape> json;
  json["file"] = a.path;
  json["other"] = b.path;
  json["status"] = a.messages.empty() && b.messages.empty() ? "ok" : "warnings";
  json["diagonal"] = number_or_null(found.diagonal);
  add_figures(json, found, found.diagonal);
  json["forward"] = direction_json(found.forward, a, found.diagonal);
  json["backward"] = direction_json(found.backward, b, found.diagonal);
  std::vector<Message> messages = a.messages;
  messages.insert(messages.end(), b.messages.begin(), b.messages.end());
  json["messages"] = to_json(messages);
  return line_of(json);
}

// Reading has said why they are left out.
std::string left_out_text(const OneWayDistance& way, const ReadSurface& from, const Console& console) {
  const std::size_t faces = way.left_out + from.quarantined;
  if (faces == 0) return {};
  return std::string(console.text("  not measured: ", "  計測しなかった面：")) + std::to_string(faces) +
         std::string(console.text(faces == 1 ? " face of " : " faces of ", " 枚、")) + visible_line(from.path) +
         std::string(console.text(", set aside or with a corner that is not finite",
                                  "（隔離されているか、座標が有限でない）")) +
         "\n";
}

std::string place_text(const OneWayDistance& way, const ReadSurface& from, const Console& console) {
  const auto place = [](const glm::dvec3& p) {
    return short_number(p.x) + " " + short_number(p.y) + " " + short_number(p.z);
  };
  return std::string(console.text("  farthest: ", "  最大の箇所：")) + visible_line(from.path) + " " +
         name_of(from.mesh, way.face) + ", " + place(way.from) + " -> " + place(way.to) + "\n";
}

std::string text_of(const SurfaceDistance& found, const ReadSurface& a, const ReadSurface& b, const Console& console) {
  DistanceTable table(console);
  table.add(std::string(console.text("both", "両方向")), found, found.diagonal);
  table.add(std::string(console.text("forward", "一つ目から")), found.forward, found.diagonal);
  table.add(std::string(console.text("backward", "二つ目から")), found.backward, found.diagonal);
  return table.text() + place_text(found.forward, a, console) + place_text(found.backward, b, console) +
         left_out_text(found.forward, a, console) + left_out_text(found.backward, b, console);
}

}  // namespace

ExitCode distance_command(const Arguments& arguments, const Console& console) {
  const Result<DistanceOptions> options = wanted_options(arguments);
  if (!options) return console.fail(options.failure());
  std::array<ReadSurface, 2> files;
  for (std::size_t i = 0; i < 2; ++i) files[i].path = arguments.operands()[i];
  do_beside([&] { files[0].read(); }, [&] { files[1].read(); });
  for (const ReadSurface& file : files)
    if (file.failure) return console.fail(*file.failure, file.path);
  Progress progress(report_on(console, "distance"));
  const std::optional<SurfaceDistance> found = surface_distance(files[0].mesh, files[1].mesh, *options, progress);
  if (!found) return console.fail(make_failure(ExitCode::cancelled, "cancelled", {"Cancelled.", "中止しました。"}));
  for (const ReadSurface& file : files)
    for (const Message& message : file.messages) console.show(message, file.path);
  return console.end(console.json ? line_of(*found, files[0], files[1]) : text_of(*found, files[0], files[1], console));
}

}  // namespace ryosen::cli
