#include "app/cli/outputs.h"

#include <algorithm>
#include <utility>

#include "app/cli/console.h"
#include "ryosen/io/file_target.h"
#include "ryosen/io/formats.h"
#include "ryosen/io/safe_write.h"
#include "ryosen/io/system_reason.h"

namespace ryosen::cli {

RunFiles files_of_run(const Arguments& arguments, const std::string& input) {
  RunFiles files(arguments.has("--overwrite") ? RunFiles::Policy::overwrite : RunFiles::Policy::keep);
  if (arguments.has("--json")) files.leave_stdout_to_results();
  if (!input.empty()) files.reads(input, FileRole::mesh);
  return files;
}

std::optional<Failure> fault_of_output(const std::string& path, bool has_input) {
  const Format* const format = format_of_extension(path);
  if (format) return refusal_of_target(path, format);
  if (has_input && is_stream(path)) return std::nullopt;
  if (path.empty()) return usage_failure("unknown_format", empty_name());
  return usage_failure("unknown_format",
                       {"The name " + path + " does not say in which format to write; give it an extension, or let " +
                            "convert --format ID say it (see ryosen formats).",
                        "ファイル名 " + path + " からは、書き出す形式が決まりません。拡張子を付けるか、" +
                            "convert の --format ID で指定してください（ryosen formats を参照）。"});
}

WrittenOutput write_output(Document& document, RunFiles& files, const std::string& path, bool is_strict,
                           const Console& console, const std::vector<Message>& given_up) {
  WrittenOutput written;
  std::vector<Message> losses = given_up;
  for (Message& loss : document.losses(path))
    if (std::none_of(given_up.begin(), given_up.end(), [&](const Message& m) { return m.code == loss.code; }))
      losses.push_back(std::move(loss));
  const bool is_refused = is_strict && !losses.empty();
  Status status = is_refused ? Status(refusal_of_losses()) : files.may_write(path, FileRole::result);
  if (status) status = document.save(path);
  written.is_there = is_in_place(status);
  if (written.is_there) files.writes(path, FileRole::result);
  if (written.is_there || is_refused) written.losses = std::move(losses);
  for (const Message& loss : written.losses) console.show(loss, path);
  if (status) return written;
  written.failure = status.failure();
  console.show(written.failure->message, path);
  return written;
}

std::string written_text(const std::string* path, const Console& console) {
  if (!path) return std::string(console.text("nothing written\n", "書き出しなし\n"));
  return console.text(Text{"written: ", "書き出し："}) + visible_line(*path) + "\n";
}

}  // namespace ryosen::cli
