// `convert`: writes a mesh in another format, after saying what would be lost.
#include "app/cli/contract/convert.h"
#include "app/cli/contract/json.h"
#include "app/cli/outputs.h"
#include "app/cli/subcommand_table.h"
#include "app/editor/commands/text/script.h"
#include "ryosen/io/file_target.h"
#include "ryosen/io/formats.h"
#include "ryosen/io/safe_write.h"
#include "ryosen/io/triangulated.h"

namespace ryosen::cli {

namespace {

Result<WriteOptions> find_wanted(const Arguments& arguments, const std::string& output) {
  const std::string* const id = arguments.value("--format");
  if (!id) {
    if (auto fault = fault_of_output(output, false)) return std::move(*fault);
    return WriteOptions{format_of_extension(output)};
  }
  const std::optional<WriteOptions> target = find_target(*id);
  if (target && target->format->write) return *target;
  if (target) return *refusal_of_target(output, target->format);
  std::vector<std::string> known;
  for (const Format& format : formats()) {
    if (!format.write) continue;
    known.emplace_back(format.id);
    for (const FormatVariant& variant : format.variants) known.emplace_back(variant.id);
  }
  return usage_failure("bad_value", Text{"--format: '" + *id + "' is not a format (see ryosen formats).",
                                         "--format：「" + *id + "」という形式はありません（ryosen formats を参照）。"} +
                                        did_you_mean(*id, known, HintForm::sentence));
}

class Conversion {
 public:
  Conversion(std::string input, std::string output, WriteOptions target, const Console& console)
      : input_(std::move(input)), output_(std::move(output)), target_(target), console_(console) {}

  ExitCode run(bool is_strict, bool triangulates) {
    Result<MeshFile> file = read_mesh_file(input_);
    if (!file) return console_.fail(file.failure(), input_);
    for (const Message& message : file->messages) console_.show(message, input_);
    messages_ = file->messages;
    if (triangulates && has_polygons(file->mesh)) *file = triangulated(*file);
    losses_ = losses_of(*file, *target_.format, target_.encoding);
    for (const Loss& loss : losses_) console_.show(loss.message(target_.format->name), output_);
    ExitCode code = ExitCode::done;
    if (is_strict && !losses_.empty())
      code = fail(refusal_of_losses());
    else if (const auto fault = fault_of_name(*file))
      code = fail(*fault);
    else
      code = write(*file);
    report(*file, code);
    return code;
  }

 private:
  ExitCode fail(const Failure& failure) {
    messages_.push_back(failure.message);
    console_.show(failure.message, output_);
    return failure.exit_code;
  }

  // A name that says another format may keep the file from being read again.
  std::optional<Failure> fault_of_name(const MeshFile& file) const {
    if (format_of_extension(output_) == target_.format || is_stream(output_)) return std::nullopt;
    const Result<const Format*> read = recognise(bytes_of(file, *target_.format, target_.encoding), output_);
    if (read && *read == target_.format) return std::nullopt;
    const std::string extension(target_.format->extensions[0]);
    return usage_failure("name_hides_format",
                         {"Under the name " + output_ + " this would not be read as " + target_.format->name.en +
                              " again; choose a name with " + extension + ".",
                          output_ + " という名前では " + target_.format->name.ja + " として読み直せません。" +
                              extension + " の付く名前にしてください。"});
  }

  ExitCode write(const MeshFile& file) {
    const Status status = write_mesh_file(output_, file, target_);
    is_written_ = is_in_place(status);
    return status ? ExitCode::done : fail(status.failure());
  }

  void report(const MeshFile& file, ExitCode code) const {
    if (!console_.json) {
      console_.conclude(written_text(is_written_ ? &output_ : nullptr, console_), code);
      return;
    }
    Record<convert_shape> json;
    json["file"] = input_;
    json["output"] = is_written_ ? Json(output_) : Json();
    json["from"] = file.format->id;
    json["format"] = target_.format->id;
    json["status"] = code != ExitCode::done ? "error" : losses_.empty() ? "ok" : "warnings";
    json["vertices"] = file.mesh.positions.size();
    json["faces"] = file.mesh.face_count();
    json["losses"] = Json::array();
    for (const Loss& loss : losses_) {
      const Message message = loss.message(target_.format->name);
      Record<loss_shape> lost;
      lost["code"] = message.code.row().id;
      lost["count"] = loss.count;
      lost.put(message.text);
      json["losses"].push_back(std::move(lost).json());
    }
    json["messages"] = to_json(messages_);
    console_.conclude(line_of(json), code);
  }

  std::string input_, output_;
  WriteOptions target_;
  const Console& console_;
  std::vector<Loss> losses_;
  std::vector<Message> messages_;
  bool is_written_ = false;
};

}  // namespace

ExitCode convert_command(const Arguments& arguments, const Console& given) {
  const std::string& input = arguments.operands()[0];
  const std::string* const output = arguments.value("-o");
  if (!output) return given.fail(usage_failure("usage", {"convert needs -o OUT.", "convert には -o OUT が必要です。"}));
  const Result<WriteOptions> target = find_wanted(arguments, *output);
  if (!target) return given.fail(target.failure());
  RunFiles files = files_of_run(arguments, input);
  if (const Status may = files.may_write(*output, FileRole::result); !may) return given.fail(may.failure(), input);
  files.writes(*output, FileRole::result);
  Console console = given;
  console.leaves_stdout = files.uses_stdout();
  return Conversion(input, *output, *target, console).run(arguments.has("--strict"), arguments.has("--triangulate"));
}

}  // namespace ryosen::cli
