#include "app/cli/outputs.h"

#include "app/cli/console.h"
#include "ryosen/io/file_target.h"
#include "ryosen/io/formats.h"
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

}  // namespace ryosen::cli
