#include "app/editor/document/run_files.h"

#include <unistd.h>

#include <algorithm>
#include <array>
#include <cctype>

#include "ryosen/base/enum_table.h"

namespace ryosen {

namespace {

struct RoleRow {
  FileRole role;
  bool is_read, is_picture;
  std::string_view en, ja;          // what the file is
  std::string_view new_en, new_ja;  // what would take its place; nothing does that is only read
};

constexpr std::array role_rows{
    RoleRow{FileRole::mesh, true, false, "a mesh that this run reads", "この実行で読み込むメッシュ", "", ""},
    RoleRow{FileRole::script, true, false, "the script of this run", "この実行のスクリプト", "", ""},
    RoleRow{FileRole::reference, true, true, "the reference of --compare", "比較の基準画像（--compare）", "", ""},
    RoleRow{FileRole::saved, false, false, "a mesh that this run saves", "この実行で保存するメッシュ", "a saved mesh",
            "保存するメッシュ"},
    RoleRow{FileRole::result, false, false, "the mesh of -o", "出力のメッシュ（-o）", "the mesh of -o",
            "出力のメッシュ（-o）"},
    RoleRow{FileRole::picture, false, true, "a picture that this run makes", "この実行で作る画像", "a picture", "画像"},
    RoleRow{FileRole::difference, false, true, "the picture of --diff", "差分画像（--diff）", "the picture of --diff",
            "差分画像（--diff）"},
};

static_assert(rows_are_in_order(role_rows, &RoleRow::role));

const RoleRow& role_row(FileRole role) { return role_rows[static_cast<std::size_t>(role)]; }

// Also the file that standard output was sent to.
bool is_standard_output(const FileTarget& target) {
  if (target.descriptor == STDOUT_FILENO) return true;
  const FileTarget out = target_of("/dev/stdout");
  return out.kind == FileTarget::Kind::file && target.kind == FileTarget::Kind::file && out.number == target.number;
}

Failure taken_by_results(const std::filesystem::path& path) {
  const std::string name = path.string();
  return make_failure(ExitCode::usage, "flags_exclude",
                      {name + " is where --json writes; choose another output, or leave --json out.",
                       name + " には --json の結果を書き出します。別の出力先にするか、--json を外してください。"});
}

// The extension by which a name claims another format than PNG; empty for none. Digits alone are a number, as in
// shot.001.
std::string claimed_format(const std::filesystem::path& path) {
  std::string extension = path.extension().string();
  const auto is = [](int (*kind)(int)) { return [kind](unsigned char c) { return kind(c) != 0; }; };
  if (extension.size() < 2 || std::none_of(extension.begin(), extension.end(), is(std::isalpha)) ||
      !std::all_of(extension.begin() + 1, extension.end(), is(std::isalnum)))
    return {};
  std::string lower = extension;
  std::transform(lower.begin(), lower.end(), lower.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return lower == ".png" ? std::string() : extension;
}

Failure another_format(const std::filesystem::path& path, const std::string& extension) {
  const std::string name = path.string();
  return make_failure(
      ExitCode::usage, "unknown_format",
      {name + ": pictures are PNG files, so the name cannot end in " + extension + "; let it end in .png.",
       name + "：画像は PNG で書き出すため、名前の末尾を " + extension + " にはできません。.png にしてください。"});
}

}  // namespace

bool RunFiles::may_replace(const Known& known, FileRole role) const {
  if (policy_ == Policy::overwrite) return true;
  if (policy_ == Policy::by_kind) return role_row(known.role).is_picture == role_row(role).is_picture;
  return role == FileRole::saved && known.role == role && known.document == document_;
}

// One of those that the program was handed takes one output; a device takes any number.
Status RunFiles::may_write_to_stream(const std::filesystem::path& path, const FileTarget& target) const {
  for (const Known& known : known_) {
    if (!target.descriptor || known.target.descriptor != target.descriptor) continue;
    const std::string name = path.string();
    return make_failure(
        ExitCode::output_not_writable, "output_would_be_replaced",
        {name + " gets " + std::string(role_row(known.role).en) + " already; choose another output.",
         name + " には" + std::string(role_row(known.role).ja) + "を書き出します。別の出力先にしてください。"});
  }
  return success();
}

void RunFiles::reads(const std::filesystem::path& path, FileRole role) {
  known_.push_back({path, target_of(path), role, document_});
}

Status RunFiles::may_write(const std::filesystem::path& path, FileRole role) const {
  const FileTarget target = target_of(path);
  if (stdout_is_taken_ && is_standard_output(target)) return taken_by_results(path);
  if (target.kind == FileTarget::Kind::stream) return may_write_to_stream(path, target);
  for (const Known& known : known_) {
    if (!is_same_file(known.target, target) || may_replace(known, role)) continue;
    const std::string name = path.string(), other = known.path.string();
    const RoleRow &is = role_row(known.role), &becomes = role_row(role);
    const bool is_linked = name != other;
    Text text;
    text.en = name + (is_linked ? " is the file " + other + ", " : " is ") + std::string(is.en) + "; " +
              (known.role == role ? "another one" : std::string(becomes.new_en)) + " would replace it. ";
    text.ja = name + (is_linked ? " は " + other + " と同じファイルで、" : " は") + std::string(is.ja) + "です。" +
              (known.role == role ? "別のもの" : std::string(becomes.new_ja)) + "で置き換えることになります。";
    const bool by_kind = policy_ == Policy::by_kind;
    text.en += by_kind ? "Choose another name." : "Choose another name, or allow it by --overwrite.";
    text.ja += by_kind ? "別の名前にしてください。" : "別の名前にするか、--overwrite を指定してください。";
    return make_failure(ExitCode::output_not_writable,
                        is.is_read ? Code("input_would_be_replaced") : Code("output_would_be_replaced"),
                        std::move(text));
  }
  const std::string extension = role_row(role).is_picture ? claimed_format(path) : std::string();
  return extension.empty() ? success() : Status(another_format(path, extension));
}

void RunFiles::writes(const std::filesystem::path& path, FileRole role) {
  FileTarget target = target_of(path);
  uses_stdout_ = uses_stdout_ || target.descriptor == STDOUT_FILENO;
  std::erase_if(known_, [&](const Known& known) {
    return known.role == role && known.document == document_ && is_same_file(known.target, target);
  });
  // What had this name is another file now.
  for (Known& known : known_)
    if (known.target.path == target.path) known.target = target;
  known_.push_back({path, std::move(target), role, document_});
}

bool RunFiles::is_free(const std::filesystem::path& path) const {
  std::error_code ignored;
  if (std::filesystem::exists(std::filesystem::symlink_status(path, ignored))) return false;
  const FileTarget target = target_of(path);
  return std::none_of(planned_.begin(), planned_.end(),
                      [&](const Known& planned) { return is_same_file(planned.target, target); });
}

}  // namespace ryosen
