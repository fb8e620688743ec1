// Reader for binary PLY. Tables with fixed-size rows are read column by column, faces with only a corner list in one
// loop, anything else value by value.
#include <algorithm>
#include <atomic>
#include <bit>
#include <cmath>
#include <cstring>
#include <type_traits>

#include "ryosen/base/column_memory.h"
#include "ryosen/base/parallel.h"
#include "ryosen/io/numbers.h"
#include "ryosen/io/ply_builder.h"

namespace ryosen {
namespace {

// An unsigned type of so many bytes: 1, 2, 4 or 8.
template <std::size_t size>
using BitsOf = std::conditional_t<
    size == 1, std::uint8_t,
    std::conditional_t<size == 2, std::uint16_t, std::conditional_t<size == 4, std::uint32_t, std::uint64_t>>>;

template <class Number, bool Swap>
Number load(const char* at) {
  using Bits = BitsOf<sizeof(Number)>;
  Bits bits;
  std::memcpy(&bits, at, sizeof bits);
  if constexpr (Swap && sizeof(Number) > 1) {
    Bits turned = 0;
    for (std::size_t i = 0; i < sizeof(Number); ++i) {
      turned = static_cast<Bits>(turned << 8 | (bits & 0xff));
      bits = static_cast<Bits>(bits >> 8);
    }
    bits = turned;
  }
  return std::bit_cast<Number>(bits);
}

// The minimum size of a row in bytes.
std::size_t least_bytes(const PropertyTable& table) {
  std::size_t bytes = 0;
  for (const Property& property : table.properties)
    bytes += bytes_of(property.is_list ? property.count_type : property.type);
  return bytes;
}

bool has_lists(const PropertyTable& table) {
  return std::any_of(table.properties.begin(), table.properties.end(), [](const Property& p) { return p.is_list; });
}

// Every step returns false after the first failure.
template <bool Swap>
class PlyBinaryReader {
 public:
  PlyBinaryReader(std::string_view bytes, const PlyHeader& header, PlyBuilder& builder)
      : begin_(bytes.data()),
        end_(bytes.data() + bytes.size()),
        at_(bytes.data() + header.bytes),
        header_(header),
        builder_(builder) {}

  std::optional<Failure> read() {
    for (std::size_t t = 0; t < builder_.tables().size(); ++t)
      if (!read_table(t)) return std::move(failure_);
    if (at_ != end_) {
      builder_.reporter().leave_out(&LeftOut::rest, left());
      builder_.reporter().warn("extra_data", here(), [&] {
        const std::string count = std::to_string(left());
        return Text{count + " bytes after the last row are left out.",
                    "最後の行の後の " + count + " バイトを無視しました。"};
      });
    }
    return std::nullopt;
  }

 private:
  std::size_t left() const { return static_cast<std::size_t>(end_ - at_); }
  FilePlace place(const char* at) const { return FilePlace::at_byte(static_cast<std::uint64_t>(at - begin_)); }
  FilePlace here() const { return place(at_); }
  bool ends_early(const PropertyTable& table, std::size_t row) {
    failure_ = ply_early_end(table, row, place(end_));
    return false;
  }

  bool read_table(std::size_t number) {
    PropertyTable& table = builder_.tables()[number];
    const std::size_t least = least_bytes(table);
    if (is_absurd(table.rows, least, left())) {
      failure_ = ply_count_too_large(header_, number);
      return false;
    }
    if (least == 0) return true;
    if (table.rows > left() / least) return ends_early(table, left() / least);
    constexpr std::size_t most_values = no_index;
    if (has_lists(table) && left() >= 2 * most_values) {
      failure_ = too_many_corners(here());
      return false;
    }
    const std::vector<PlyTarget> targets = builder_.begin_table(number, here());
    if (!has_lists(table)) {
      read_columns(table, targets);
      return true;
    }
    return has_corners_alone(table) ? read_corners(table) : read_rows(table, targets);
  }

  void read_columns(PropertyTable& table, const std::vector<PlyTarget>& targets) {
    const std::size_t stride = least_bytes(table);
    for (std::size_t p = 0; p < targets.size(); ++p) {
      Property& property = table.properties[p];
      if (!targets[p].first) property.data.resize(table.rows * bytes_of(property.type));
    }
    std::atomic<bool> all_sound = true;
    for_each_part(static_cast<std::uint32_t>(table.rows), threads_for(table.rows * targets.size()),
                  [&](unsigned, std::uint32_t begin, std::uint32_t end) {
                    for_each_column(
                        table, begin, end,
                        [&](auto zero, std::size_t p, const char* column, std::size_t first, std::size_t last) {
                          using Number = decltype(zero);
                          if (!targets[p].first)
                            copy_column<Number>(column, stride, first, last, table.properties[p].data.data());
                          else if (!read_reals<Number>(column, stride, first, last, targets[p]))
                            all_sound = false;
                        });
                  });
    if (!all_sound) warn_of_columns(table, targets, stride);
    at_ += table.rows * stride;
  }

  // Calls visit(zero of its type, property, where its column begins, rows from .. to) for blocks of rows that stay in
  // the L1 cache while all their columns are read.
  template <class Visit>
  void for_each_column(const PropertyTable& table, std::size_t begin, std::size_t end, Visit visit) const {
    constexpr std::size_t block = 2048;
    for (std::size_t first = begin; first < end; first += block) {
      const std::size_t last = std::min(first + block, end);
      std::size_t offset = 0;
      for (std::size_t p = 0; p < table.properties.size(); ++p) {
        const Scalar type = table.properties[p].type;
        with_scalar(type, [&](auto zero) {
          visit(zero, p, at_ + offset, first, last);
          return 0;
        });
        offset += bytes_of(type);
      }
    }
  }

  template <class Number>
  static constexpr bool may_be_rounded = std::is_integral_v<Number> && sizeof(Number) == 8;

  // Returns whether all values are finite and exact.
  template <class Number>
  static bool read_reals(const char* column, std::size_t stride, std::size_t first, std::size_t last,
                         PlyTarget target) {
    double nothing = 0;  // stays zero while all are finite
    bool are_exact = true;
    const auto read = [&](auto put) {
      for (std::size_t row = first; row < last; ++row) {
        const Number number = load<Number, Swap>(column + row * stride);
        const auto value = static_cast<double>(number);
        nothing += value * 0.0;
        if constexpr (may_be_rounded<Number>) are_exact = are_exact && is_exact_double(number);
        put(row, value);
      }
    };
    if (target.divisor == 1.0)
      read([&](std::size_t row, double value) { target.first[row * target.stride] = value; });
    else
      read([&](std::size_t row, double value) { target.put(row, value); });
    return nothing == 0.0 && are_exact;
  }

  void warn_of_columns(const PropertyTable& table, const std::vector<PlyTarget>& targets, std::size_t stride) {
    for_each_column(table, 0, table.rows,
                    [&](auto zero, std::size_t p, const char* column, std::size_t first, std::size_t last) {
                      if (!targets[p].first) return;
                      for (std::size_t row = first; row < last; ++row) {
                        const char* const at = column + row * stride;
                        warn_of(load<decltype(zero), Swap>(at), at);
                      }
                    });
  }

  template <class Number>
  void warn_of(Number value, const char* at) {
    if (!std::isfinite(static_cast<double>(value))) builder_.warn_non_finite(place(at));
    if constexpr (may_be_rounded<Number>) {
      if (!is_exact_double(value)) builder_.warn_rounded(place(at));
    }
  }

  template <class Number>
  static void copy_column(const char* column, std::size_t stride, std::size_t first, std::size_t last, std::byte* out) {
    for (std::size_t row = first; row < last; ++row) {
      const Number value = load<Number, Swap>(column + row * stride);
      std::memcpy(out + row * sizeof value, &value, sizeof value);
    }
  }

  static bool has_corners_alone(const PropertyTable& table) {
    if (table.properties.size() != 1 || table.properties[0].role != PropertyRole::corners) return false;
    const Property& corners = table.properties[0];
    return bytes_of(corners.count_type) == 1 && bytes_of(corners.type) == 4;
  }

  bool read_corners(const PropertyTable& table) {
    IndexedMesh& mesh = builder_.mesh();
    const bool is_signed = table.properties[0].type == Scalar::int32;
    const bool has_signed_count = table.properties[0].count_type == Scalar::int8;
    const std::size_t expected = std::min(3 * table.rows, left() / 4);
    reserve_large(mesh.corners, expected);
    if (mesh.corners.empty()) touch_pages(mesh.corners.data(), expected * sizeof(std::uint32_t));
    mesh.corners.resize(expected);
    mesh.face_offsets.resize(table.rows + 1);
    const std::size_t triangles = read_triangles(mesh, std::min(table.rows, left() / triangle_bytes));
    std::size_t used = 3 * triangles;
    at_ += triangles * triangle_bytes;
    for (std::size_t row = triangles; row < table.rows; ++row) {
      if (at_ == end_) return ends_early(table, row);
      const auto count = static_cast<unsigned char>(*at_);
      if (has_signed_count && count > 127) return negative_length(at_);
      const char* from = at_ + 1;
      if (static_cast<std::size_t>(end_ - from) < 4 * std::size_t{count}) return ends_early(table, row);
      if (mesh.corners.size() - used < count) mesh.corners.resize(2 * mesh.corners.size() + count);
      std::uint32_t* const to = mesh.corners.data() + used;
      std::uint32_t wide = 0;
      for (unsigned i = 0; i < count; ++i, from += 4) {
        to[i] = load<std::uint32_t, Swap>(from);
        wide |= to[i];
      }
      if (wide >> 31 != 0) note_wide(to, used, count, is_signed);
      used += count;
      mesh.face_offsets[row + 1] = static_cast<std::uint32_t>(used);
      at_ = from;
    }
    mesh.corners.resize(used);
    return true;
  }

  static constexpr std::size_t triangle_bytes = 13;  // with the length of the list

  // Reads up to `rows` rows while they are triangles with numbers that fit; their size is fixed, so they are read in
  // parallel. Returns their number; entries after these in the mesh are unspecified.
  std::size_t read_triangles(IndexedMesh& mesh, std::size_t rows) const {
    const unsigned parts = threads_for(3 * rows);
    std::vector<std::uint32_t> ends(parts);
    for_each_part(static_cast<std::uint32_t>(rows), parts, [&](unsigned t, std::uint32_t begin, std::uint32_t end) {
      const char* at = at_ + begin * triangle_bytes;
      std::uint32_t* corners = mesh.corners.data() + 3 * std::size_t{begin};
      std::uint32_t* const offsets = mesh.face_offsets.data() + 1;
      std::uint32_t row = begin;
      for (; row < end; ++row, at += triangle_bytes, corners += 3) {
        for (std::size_t i = 0; i < 3; ++i) corners[i] = load<std::uint32_t, Swap>(at + 1 + 4 * i);
        offsets[row] = 3 * (row + 1);
        if (*at != 3 || (corners[0] | corners[1] | corners[2]) >> 31 != 0) break;
      }
      ends[t] = row;
    });
    for (unsigned t = 0; t < parts; ++t)
      if (ends[t] < part_begin(static_cast<std::uint32_t>(rows), t + 1, parts)) return ends[t];
    return rows;
  }

  // Records corners that do not fit in 32 bits.
  void note_wide(std::uint32_t* corners, std::size_t place, unsigned count, bool is_signed) {
    for (unsigned i = 0; i < count; ++i) {
      const bool is_wide = is_signed ? corners[i] >> 31 != 0 : corners[i] == no_index;
      if (!is_wide) continue;
      const std::int64_t value = is_signed ? std::int64_t{static_cast<std::int32_t>(corners[i])} : corners[i];
      builder_.faces().note_wide(place + i, value);
      corners[i] = no_index;
    }
  }

  bool negative_length(const char* at) {
    failure_ = malformed("negative_count", {"The length of a list is negative.", "リストの長さが負です。"}, place(at));
    return false;
  }

  bool read_rows(PropertyTable& table, const std::vector<PlyTarget>& targets) {
    const bool are_strips = strip_corners(table) != nullptr;
    for (std::size_t row = 0; row < table.rows; ++row) {
      if (are_strips) builder_.note_strip(static_cast<std::uint64_t>(at_ - begin_));
      for (std::size_t p = 0; p < targets.size(); ++p) {
        Property& property = table.properties[p];
        const bool done = with_scalar(property.type, [&](auto zero) {
          using Number = decltype(zero);
          return property.is_list ? read_list<Number>(table, property, row)
                                  : read_number<Number>(table, property, targets[p], row);
        });
        if (!done) return false;
      }
    }
    return true;
  }

  template <class Number>
  bool read_number(const PropertyTable& table, Property& property, const PlyTarget& target, std::size_t row) {
    if (left() < sizeof(Number)) return ends_early(table, row);
    const Number value = load<Number, Swap>(at_);
    if (!target.first) {
      append(property, value);
    } else {
      warn_of(value, at_);
      target.put(row, static_cast<double>(value));
    }
    at_ += sizeof(Number);
    return true;
  }

  template <class Number>
  static void append(Property& property, Number value) {
    const auto* const bytes = reinterpret_cast<const std::byte*>(&value);
    property.data.insert(property.data.end(), bytes, bytes + sizeof value);
  }

  template <class Number>
  bool read_list(const PropertyTable& table, Property& property, std::size_t row) {
    const std::size_t count_size = bytes_of(property.count_type);
    if (left() < count_size) return ends_early(table, row);
    const auto count = with_scalar(
        property.count_type, [&](auto zero) { return static_cast<std::int64_t>(load<decltype(zero), Swap>(at_)); });
    if (count < 0) return negative_length(at_);
    at_ += count_size;
    if (left() / sizeof(Number) < static_cast<std::uint64_t>(count)) return ends_early(table, row);
    const bool are_corners = property.role == PropertyRole::corners;
    for (std::int64_t i = 0; i < count; ++i, at_ += sizeof(Number)) {
      const Number value = load<Number, Swap>(at_);
      if (are_corners)
        builder_.faces().add_corner(static_cast<std::int64_t>(value));
      else
        append(property, value);
    }
    if (are_corners)
      builder_.faces().end_face(0);
    else
      property.ends.push_back(static_cast<std::uint32_t>(property.data.size() / sizeof(Number)));
    return true;
  }

  const char* begin_;
  const char* end_;
  const char* at_;
  const PlyHeader& header_;
  PlyBuilder& builder_;
  std::optional<Failure> failure_;
};

}  // namespace

std::optional<Failure> read_ply_binary(std::string_view bytes, const PlyHeader& header, PlyBuilder& builder) {
  const bool is_big = header.encoding == Encoding::binary_big;
  if (is_big != (std::endian::native == std::endian::big)) return PlyBinaryReader<true>(bytes, header, builder).read();
  return PlyBinaryReader<false>(bytes, header, builder).read();
}

}  // namespace ryosen
