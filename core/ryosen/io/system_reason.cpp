#include "ryosen/io/system_reason.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <string>
#include <string_view>
#include <system_error>

namespace ryosen {
namespace {

struct ReasonRow {
  int error;
  std::string_view en, ja;
};

constexpr std::array system_reasons{
    ReasonRow{ENOSPC, "the disk is full; make room on it or choose another place",
              "ディスクに空きがありません（空きを作るか、別の場所を選んでください）"},
    ReasonRow{EDQUOT, "your share of the disk is used up; make room or choose another place",
              "ディスクの割り当て量を使い切っています（空きを作るか、別の場所を選んでください）"},
    ReasonRow{EFBIG, "files may not become that large here", "ここではこの大きさのファイルを作れません"},
    ReasonRow{EIO, "the disk reports an input/output error; choose another place and check the disk",
              "ディスクで入出力エラーが起きました（別の場所を選び、ディスクを確認してください）"},
    ReasonRow{EROFS, "the file system is read-only; choose another place",
              "読み取り専用のファイルシステムです（別の場所を選んでください）"},
    ReasonRow{ENOENT, "there is no such folder or file; it may have been removed",
              "フォルダまたはファイルがありません（削除された可能性があります）"},
    ReasonRow{ENOTDIR, "a part of the path is not a folder", "パスの途中にフォルダでないものがあります"},
    ReasonRow{EISDIR, "it is a folder", "フォルダです"},
    ReasonRow{EACCES, "permission is denied", "アクセス権がありません"},
    ReasonRow{EPERM, "the system does not permit it", "システムが許可していません"},
    ReasonRow{ELOOP, "its symbolic links lead in a circle", "シンボリックリンクが循環しています"},
    ReasonRow{ENAMETOOLONG, "the name is too long", "名前が長すぎます"},
    ReasonRow{EMFILE, "this program has too many files open", "このプログラムが開いているファイルが多すぎます"},
    ReasonRow{ENFILE, "the system has too many files open", "システムで開いているファイルが多すぎます"},
    ReasonRow{EPIPE, "whoever read the pipe has closed it", "パイプの読み手が閉じました"},
    ReasonRow{EBADF, "it is not open for that", "その向きには開かれていません"},
    ReasonRow{ENOMEM, "there is not enough memory", "メモリが足りません"},
};

}  // namespace

Text system_reason(int error) {
  const auto row =
      std::find_if(system_reasons.begin(), system_reasons.end(), [&](const ReasonRow& r) { return r.error == error; });
  if (row != system_reasons.end()) return {std::string(row->en), std::string(row->ja)};
  const std::string words = std::generic_category().message(error);
  return {words, words};
}

Text empty_name() { return {"The name of the file is empty.", "ファイル名が空です。"}; }

}  // namespace ryosen
