#include "app/cli/outputs.h"

#include <algorithm>
#include <filesystem>

#include "app/cli/console.h"
#include "core/io/formats.h"

namespace ryosen::cli {

std::optional<Failure> fault_of_output(const std::string& path) {
  const Format* const format = format_of_extension(path);
  if (format) return refusal_of_target(path, format);
  return usage_failure("unknown_format",
                       {"The name " + path + " does not say in which format to write (see ryosen formats).",
                        "ファイル名 " + path + " からは、書き出す形式が決まりません（ryosen formats を参照）。"});
}

std::optional<Failure> fault_of_replacing(const std::string& path, const std::vector<std::string>& inputs) {
  const bool is_input = std::any_of(inputs.begin(), inputs.end(), [&](const std::string& input) {
    std::error_code error;
    return std::filesystem::equivalent(input, path, error);
  });
  if (!is_input) return std::nullopt;
  Failure failure;
  failure.exit_code = ExitCode::output_not_writable;
  failure.message.code = "input_would_be_replaced";
  failure.message.text = {path + " is an input; --overwrite allows to replace it.",
                          path + " は入力ファイルです。置き換えるには --overwrite を指定してください。"};
  return failure;
}

}  // namespace ryosen::cli
