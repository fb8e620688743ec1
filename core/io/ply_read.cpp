#include "core/io/ply.h"

#include "core/io/ply_values.h"
#include "core/io/text_lines.h"

namespace ryosen {

Failure ply_count_too_large(const PropertyTable& table, std::uint64_t line) {
  const std::string count = std::to_string(table.rows);
  return malformed("count_too_large",
                   {"The count " + count + " of " + shown(table.name) + " is more than a file of this size can hold.",
                    shown(table.name) + " の個数 " + count + " は、このファイルの大きさに収まりません。"},
                   FilePlace::at_line(line));
}

Failure ply_early_end(const PropertyTable& table, std::size_t there, FilePlace place) {
  const std::string claimed = std::to_string(table.rows), found = std::to_string(there);
  return malformed(
      "unexpected_end",
      {"The file ends too early: it has " + found + " of " + claimed + " rows of " + shown(table.name) + ".",
       "ファイルが途中で終わっています: " + shown(table.name) + " " + claimed + " 個のうち " + found +
           " 個しかありません。"},
      place);
}

bool is_absurd(std::size_t rows, std::size_t least_bytes_each, std::size_t bytes_left) {
  if (least_bytes_each == 0) return false;
  return rows / 4 > bytes_left / least_bytes_each || rows >= no_index;
}

Likeness looks_like_ply(std::string_view head, std::uint64_t) {
  const std::size_t end = head.find_first_of("\r\n");
  return trimmed(head.substr(0, end)) == "ply" ? Likeness::sure : Likeness::no;
}

Result<MeshFile> read_ply(std::string_view bytes, const std::filesystem::path&) {
  Result<PlyHeader> header = read_ply_header(bytes);
  if (!header) return std::move(header).failure();
  PlyBuilder builder(*header);
  std::optional<Failure> failure = header->encoding == Encoding::ascii ? read_ply_text(bytes, *header, builder)
                                                                       : read_ply_binary(bytes, *header, builder);
  if (failure) return header->explained(std::move(*failure));
  return builder.finish();
}

}  // namespace ryosen
