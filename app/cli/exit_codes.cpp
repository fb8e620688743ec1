#include "app/cli/exit_codes.h"

namespace ryosen::cli {

namespace {

constexpr ExitCodeText exit_code_rows[] = {
    {ExitCode::done, "done, nothing found", "完了、問題なし"},
    {ExitCode::found_problems, "done; problems, differences or warnings about the file found, or a failed expect",
     "完了、問題・差異・ファイルへの警告あり、または expect の不一致"},
    {ExitCode::usage, "usage, a line that does not parse, an element that never existed",
     "使い方の誤り、解釈できない行、存在したことのない要素"},
    {ExitCode::input_missing, "input missing or unreadable", "入力がない、または読めない"},
    {ExitCode::input_malformed, "input malformed", "入力の内容が不正"},
    {ExitCode::output_not_writable, "output not writable", "出力を書き込めない"},
    {ExitCode::refused, "operation refused", "操作を実行できない"},
    {ExitCode::no_backend, "no display or no render backend", "画面または描画バックエンドがない"},
    {ExitCode::cancelled, "cancelled", "中止された"},
    {ExitCode::some_inputs_failed, "some of several inputs failed", "複数の入力の一部が失敗"},
    {ExitCode::out_of_memory, "not enough memory", "メモリが足りない"},
    {ExitCode::internal_error, "internal error", "内部エラー"},
};

}  // namespace

std::span<const ExitCodeText> exit_code_texts() { return exit_code_rows; }

}  // namespace ryosen::cli
