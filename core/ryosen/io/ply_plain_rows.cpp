// Reads on several threads what nearly all rows of a large ascii PLY look like.
#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstring>
#include <vector>

#include "ryosen/base/column_memory.h"
#include "ryosen/base/interruption.h"
#include "ryosen/base/parallel.h"
#include "ryosen/io/numbers.h"
#include "ryosen/io/ply_builder.h"

namespace ryosen {
namespace {

constexpr std::size_t block_bytes = 1 << 18;

// Whole lines, which are rows from a number on if all before are.
struct Block {
  std::string_view text;
  std::size_t first = 0, lines = 0;
  PlainRows read = {};
};

std::vector<Block> blocks_of(std::string_view text) {
  std::vector<Block> blocks;
  while (!text.empty()) {
    const std::size_t end = text.find('\n', std::min(text.size(), block_bytes) - 1);
    if (end == std::string_view::npos) break;
    blocks.push_back({text.substr(0, end + 1)});
    text.remove_prefix(end + 1);
  }
  return blocks;
}

const char* behind_blanks(const char* at) {
  while (*at == ' ' || *at == '\t') ++at;
  return at;
}

// Behind the end of the line if nothing but blanks is left of it, else null. Every line ends in a line feed.
const char* behind_line(const char* at) {
  at = behind_blanks(at);
  if (*at == '\r') ++at;
  return *at == '\n' ? at + 1 : nullptr;
}

bool ends_number(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r'; }

// Each reads one row and returns where the next one begins, or null if it is not plain.

const char* read_numbers(const char* at, const char* end, std::span<const PlyTarget> targets, std::size_t row) {
  for (const PlyTarget& target : targets) {
    at = behind_blanks(at);
    double value = 0;
    const auto [stop, error] = std::from_chars(at, end, value);
    if (error != std::errc() || !ends_number(*stop) || !std::isfinite(value)) return nullptr;
    target.put(row, value);
    at = stop;
  }
  return behind_line(at);
}

const char* read_index(const char* at, std::uint32_t& index) {
  at = behind_blanks(at);
  constexpr int most_digits = 9;  // no more fits in any case
  std::uint32_t value = 0;
  int digits = 0;
  for (; is_digit(*at) && digits <= most_digits; ++at, ++digits)
    value = 10 * value + static_cast<std::uint32_t>(*at - '0');
  index = value;
  return digits > 0 && digits <= most_digits && ends_number(*at) ? at : nullptr;
}

const char* read_triangle(const char* at, std::uint32_t* corners) {
  std::uint32_t count = 0;
  at = read_index(at, count);
  if (!at || count != 3) return nullptr;
  for (int i = 0; i < 3; ++i)
    if (!(at = read_index(at, corners[i]))) return nullptr;
  return behind_line(at);
}

template <class ReadRow>
void read_rows(Block& block, std::size_t most, const ReadRow& read_row) {
  const char* at = block.text.data();
  const char* const end = at + block.text.size();
  while (at != end && block.read.rows < most) {
    const char* const next = read_row(at, end, block.first + block.read.rows);
    if (!next) break;
    at = next;
    ++block.read.rows;
  }
  block.read.bytes = static_cast<std::size_t>(at - block.text.data());
}

template <class ReadRow>
PlainRows read_in_blocks(std::vector<Block>& blocks, unsigned threads, std::size_t first, std::size_t most,
                         const ReadRow& read_row) {
  for_each_task(static_cast<unsigned>(blocks.size()), threads, [&](unsigned i) {
    stop_if_interrupted();
    Block& block = blocks[i];
    if (block.first < first + most) read_rows(block, first + most - block.first, read_row);  // else it is of others
  });
  PlainRows all;
  for (const Block& block : blocks) {
    all.rows += block.read.rows;
    all.bytes += block.read.bytes;
    if (block.read.bytes != block.text.size()) break;
  }
  return all;
}

bool goes_to_the_mesh(const Property& property, const PlyTarget& target) {
  const bool may_be_rounded = !is_floating(property.type) && bytes_of(property.type) == 8;
  return !property.is_list && target.first && !may_be_rounded;
}

PlainRows read_triangles(std::vector<Block>& blocks, unsigned threads, std::size_t first, std::size_t most,
                         std::uint64_t lines, IndexedMesh& mesh) {
  const std::size_t before = mesh.corners.size();
  const std::size_t there = std::min(most, blocks.back().first + blocks.back().lines - first);
  reserve_large(mesh.corners, before + 3 * there);
  reserve_large(mesh.face_lines, mesh.face_lines.size() + there);
  mesh.corners.resize(before + 3 * there);
  const PlainRows read =
      read_in_blocks(blocks, threads, first, there, [&](const char* at, const char*, std::size_t row) {
        return read_triangle(at, mesh.corners.data() + before + 3 * (row - first));
      });
  mesh.corners.resize(before + 3 * read.rows);
  const std::size_t offsets = mesh.face_offsets.size(), of_lines = mesh.face_lines.size();
  mesh.face_offsets.resize(offsets + read.rows);
  mesh.face_lines.resize(of_lines + read.rows);
  for (std::size_t i = 0; i < read.rows; ++i) {
    mesh.face_offsets[offsets + i] = static_cast<std::uint32_t>(before + 3 * (i + 1));
    mesh.face_lines[of_lines + i] = static_cast<std::uint32_t>(lines + i + 1);
  }
  return read;
}

// Numbers the lines of the first blocks, those that `most` rows may be in, and leaves out the others.
void number_lines(std::vector<Block>& blocks, unsigned threads, std::size_t first, std::size_t most) {
  constexpr std::size_t at_once = 32;
  std::size_t row = first, numbered = 0;
  while (numbered < blocks.size() && row < first + most) {
    const auto part = std::span(blocks).subspan(numbered, std::min(at_once, blocks.size() - numbered));
    for_each_task(static_cast<unsigned>(part.size()), threads, [&](unsigned i) {
      part[i].lines = static_cast<std::size_t>(std::count(part[i].text.begin(), part[i].text.end(), '\n'));
    });
    for (Block& block : part) {
      block.first = row;
      row += block.lines;
    }
    numbered += part.size();
  }
  blocks.resize(numbered);
}

}  // namespace

PlainRows read_plain_rows(std::string_view text, PropertyTable& table, std::span<const PlyTarget> targets,
                          std::size_t first, std::size_t most, std::uint64_t lines, PlyBuilder& builder) {
  constexpr std::size_t worth_it = 10000;
  const bool are_triangles = table.properties.size() == 1 && table.properties[0].role == PropertyRole::corners;
  const bool are_numbers =
      std::equal(table.properties.begin(), table.properties.end(), targets.begin(), targets.end(), goes_to_the_mesh);
  // No row of them is shorter: a digit and a separator for each number. What may be announced beyond that is not there,
  // and the table has no room for it.
  most = std::min(most, text.size() / (are_triangles ? 8 : std::max<std::size_t>(2 * table.properties.size(), 1)));
  if (most < worth_it || !(are_triangles || are_numbers)) return {};
  if (lines + builder.mesh().corners.size() + text.size() >= no_index) return {};  // numbers might not fit
  std::vector<Block> blocks = blocks_of(text);
  if (blocks.empty()) return {};
  const unsigned threads = threads_for(most);
  number_lines(blocks, threads, first, most);
  if (are_triangles) return read_triangles(blocks, threads, first, most, lines, builder.mesh());
  const PlainRows read = read_in_blocks(
      blocks, threads, first, most,
      [&](const char* at, const char* end, std::size_t in_row) { return read_numbers(at, end, targets, in_row); });
  if (table.kind == TableKind::vertices) builder.mesh().vertex_lines.add(lines + 1, read.rows);
  return read;
}

}  // namespace ryosen
