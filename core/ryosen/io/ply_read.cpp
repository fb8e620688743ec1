#include "ryosen/io/ply.h"

#include "ryosen/io/ply_builder.h"
#include "ryosen/io/text_lines.h"

namespace ryosen {

Failure ply_count_too_large(const PlyHeader& header, std::size_t number) {
  const PropertyTable& table = header.tables.tables[number];
  constexpr std::size_t most_digits = 40;
  const std::string& spelt = header.counts[number];
  const std::string count = spelt.size() <= most_digits ? spelt : spelt.substr(0, most_digits) + "...";
  return malformed("count_too_large",
                   {"The count " + count + " of " + shown(table.name) + " is more than a file of this size can hold.",
                    shown(table.name) + " の個数 " + count + " は、このファイルの大きさに収まりません。"},
                   FilePlace::at_line(header.element_lines[number]));
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

namespace {

// Numbers that are not laid out line by line, where their count comes out exactly.
std::optional<MeshFile> read_words(std::string_view bytes, const PlyHeader& header) {
  PlyBuilder builder(header);
  if (!read_ply_words(bytes, header, builder)) return std::nullopt;
  Result<MeshFile> file = builder.finish();
  return file ? std::optional(std::move(*file)) : std::nullopt;
}

Result<MeshFile> read_ascii(std::string_view bytes, const PlyHeader& header) {
  std::optional<Failure> failure = header.missing_z;
  std::optional<Result<MeshFile>> by_lines;
  if (!failure) {
    PlyBuilder builder(header);
    failure = read_ply_text(bytes, header, builder);
    const LeftOut& left_out = builder.reporter().left_out();
    const bool are_numbers_left = left_out.values != 0 || left_out.rest != 0;  // lists may have been read too short
    if (!failure) by_lines = builder.finish();
    if (!failure && !are_numbers_left) return std::move(*by_lines);
  }
  if (std::optional<MeshFile> file = read_words(bytes, header)) return std::move(*file);
  return by_lines ? std::move(*by_lines) : header.explained(std::move(*failure));
}

Result<MeshFile> read_binary(std::string_view bytes, const PlyHeader& header) {
  PlyBuilder builder(header);
  std::optional<Failure> failure = read_ply_binary(bytes, header, builder);
  if (header.missing_z && (failure || builder.reporter().left_out().rest != 0)) failure = header.missing_z;
  if (failure) return header.explained(std::move(*failure));
  return builder.finish();
}

}  // namespace

Result<MeshFile> read_ply(std::string_view bytes, const std::filesystem::path&) {
  const Result<PlyHeader> header = read_ply_header(bytes);
  if (!header) return header.failure();
  if (header->encoding != Encoding::ascii) return read_binary(bytes, *header);
  if (ply_line_end(bytes) != PlyLineEnd::lf_cr) return read_ascii(bytes, *header);
  return read_ascii(with_single_line_ends(bytes), *header);
}

}  // namespace ryosen
