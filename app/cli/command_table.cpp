#include "app/cli/command_table.h"

#include <array>

#include "app/cli/commands.h"

namespace ryosen::cli {

namespace {

constexpr std::size_t any_number = static_cast<std::size_t>(-1);

const std::array common{
    Flag{"--json", "", false, "results as JSON, one object per line, also on failure",
         "結果を JSON で出力（一行に一つ、失敗時も）"},
    Flag{"-q", "", false, "no messages but errors", "エラー以外のメッセージを出さない"},
    Flag{"-v", "", false, "shorten nothing", "省略せずに出力"},
    Flag{"--lang", "en|ja", false, "language of texts; else that of the environment", "表示言語（省くと環境に従う）"},
    Flag{"--help", "", false, "the help of the command", "コマンドの使い方"},
};

const std::vector<Command>& table() {
  static const std::vector<Command> rows{
      Command{"check",
              "FILE|FOLDER...",
              1,
              any_number,
              "figures and problems of meshes",
              "メッシュの諸量と問題点",
              {
                  {"--fail-on", "KIND,...|none", false, "only problems of these kinds lead to exit code 1",
                   "ここに挙げた種類の問題だけを終了コード 1 にする"},
                  {"--jobs", "N", false, "how many files are checked at once; else one per processor",
                   "同時に調べるファイル数（省くとプロセッサ数）"},
                  {"--unordered", "", false, "report each file as soon as it is done",
                   "入力順を待たず、終わったものから出力"},
              },
              "",
              "",
              check_command},
      Command{
          "why",
          "FILE",
          1,
          1,
          "may an operator be done, and if not, why not and what would help",
          "操作が可能か、不可能なら理由と対処",
          {
              {"--op", "collapse|swap|split", false, "the operator", "操作"},
              {"--edge", "A-B", false, "asks about one edge", "一本の稜線について答える"},
              {"--all", "", false, "asks about every edge", "すべての稜線について答える"},
              {"--do", "COMMAND", false, "asks about a command as scripts write it", "スクリプトの一行について答える"},
              {"--geometry", "", false, "with --all: the geometric warnings too", "--all で幾何的な警告も出す"},
          },
          "",
          "",
          why_command},
      Command{"help",
              "[COMMAND]",
              0,
              1,
              "what the program and its commands do",
              "プログラムとコマンドの使い方",
              {},
              "",
              "",
              help_command},
      Command{"--version", "", 0, 0, "the version of the program", "プログラムの版", {}, "", "", version_command},
  };
  return rows;
}

}  // namespace

std::span<const Command> commands() { return table(); }

std::span<const Flag> common_flags() { return common; }

const Command* find_command(std::string_view id) {
  for (const Command& command : table())
    if (command.id == id) return &command;
  return nullptr;
}

bool Arguments::has(std::string_view flag) const { return value(flag) != nullptr; }

const std::string* Arguments::value(std::string_view flag) const {
  const std::string* last = nullptr;
  for (const Given& given : given_)
    if (given.flag->name == flag) last = &given.value;
  return last;
}

std::vector<std::string> Arguments::values(std::string_view flag) const {
  std::vector<std::string> all;
  for (const Given& given : given_)
    if (given.flag->name == flag) all.push_back(given.value);
  return all;
}

}  // namespace ryosen::cli
