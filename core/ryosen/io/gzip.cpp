#include "ryosen/io/gzip.h"

#include <zlib.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <new>
#include <optional>

#include "ryosen/base/interruption.h"
#include "ryosen/io/reporter.h"

namespace ryosen {
namespace {

constexpr int gzip_window = 15 + 16;                              // the largest window, with gzip header and checksum
constexpr std::size_t most_at_once = std::size_t{1} << 30;        // zlib counts in 32 bits
constexpr std::size_t most_between_stops = std::size_t{1} << 22;  // of what is unpacked

// Sequential decompression over all members of a gzip file.
class Inflater {
 public:
  explicit Inflater(std::string_view packed) : packed_(packed) {
    if (::inflateInit2(&stream_, gzip_window) != Z_OK) throw std::bad_alloc();
  }
  ~Inflater() { ::inflateEnd(&stream_); }
  Inflater(const Inflater&) = delete;
  Inflater& operator=(const Inflater&) = delete;

  // Unpacks the next bytes into `room` and returns their number; less than `size` only at the end of the file or on
  // failure.
  std::size_t read(char* room, std::size_t size) {
    std::size_t done = 0;
    while (done < size && !is_at_end_ && !failure_) {
      stop_if_interrupted();
      done += step(room + done, std::min(size - done, most_between_stops));
    }
    return done;
  }

  std::optional<Failure>& failure() { return failure_; }
  FilePlace here() const { return FilePlace::at_byte(at_); }

 private:
  void fail(Code code, Text text) { failure_ = malformed(code, std::move(text), here()); }

  std::size_t step(char* room, std::size_t size) {
    const auto given = static_cast<uInt>(std::min(packed_.size() - at_, most_at_once));
    // zlib only reads; its API is not const-correct.
    stream_.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(packed_.data() + at_));
    stream_.avail_in = given;
    stream_.next_out = reinterpret_cast<Bytef*>(room);
    stream_.avail_out = static_cast<uInt>(size);
    const int result = ::inflate(&stream_, Z_NO_FLUSH);
    at_ += given - stream_.avail_in;
    const std::size_t done = size - stream_.avail_out;
    if (result == Z_STREAM_END)
      end_member();
    else if (result == Z_MEM_ERROR)
      throw std::bad_alloc();
    else if (result == Z_BUF_ERROR)  // no more input
      cut();
    else if (result != Z_OK)
      damaged();
    return done;
  }

  void end_member() {
    // Zeros may fill up the last block of a tape.
    is_at_end_ = packed_.find_first_not_of('\0', at_) == std::string_view::npos;
    if (is_at_end_) return;
    if (is_gzip(packed_.substr(at_))) {
      ::inflateReset(&stream_);
      return;
    }
    fail("gzip_extra_data",
         {"The gzip file goes on behind its end with something that is not packed; the byte is that of "
          "the packed file. Take it off or pack the file again.",
          "gzip ファイルの終わりの後に、圧縮されていないデータが続いています(バイト位置は圧縮ファイル"
          "のもの)。取り除くか、圧縮し直してください。"});
  }
  void cut() {
    fail("gzip_cut", {"The gzip file ends too early; the byte is that of the packed file. Get it again, whole.",
                      "gzip ファイルが途中で終わっています(バイト位置は圧縮ファイルのもの)。"
                      "ファイル全体を入手し直してください。"});
  }
  void damaged() {
    fail("gzip_damaged",
         {"The gzip file is damaged; the byte is that of the packed file. Get it again, or pack it again.",
          "gzip ファイルが壊れています(バイト位置は圧縮ファイルのもの)。"
          "入手し直すか、圧縮し直してください。"});
  }

  std::string_view packed_;
  z_stream stream_{};
  std::size_t at_ = 0;
  bool is_at_end_ = false;
  std::optional<Failure> failure_;
};

Failure too_large(std::uint64_t most, FilePlace place) {
  const std::string limit =
      most % (1 << 30) == 0 ? std::to_string(most >> 30) + " GiB" : std::to_string(most) + " bytes";
  return malformed("gzip_too_large",
                   {"The gzip file holds more than " + limit + ", the most that is unpacked; unpack it first.",
                    "gzip ファイルの中身が、展開の上限 " + limit + " を超えています。先に展開してください。"},
                   place);
}

// The unpacked size.
Result<std::uint64_t> count_unpacked(std::string_view packed, std::uint64_t most) {
  std::string room(std::size_t{1} << 16, '\0');
  Inflater inflater(packed);
  std::uint64_t count = 0;
  for (std::size_t done = room.size(); done == room.size();) {
    done = inflater.read(room.data(), room.size());
    count += done;
    if (count > most) return too_large(most, inflater.here());
  }
  if (inflater.failure()) return std::move(*inflater.failure());
  return count;
}

}  // namespace

bool is_gzip(std::string_view bytes) { return bytes.starts_with("\x1f\x8b"); }

bool has_gzip_name(const std::filesystem::path& path) {
  const std::string extension = path.extension().string();
  return extension.size() == 3 && extension[0] == '.' && (extension[1] | 0x20) == 'g' && (extension[2] | 0x20) == 'z';
}

std::filesystem::path without_gzip(const std::filesystem::path& path) {
  return has_gzip_name(path) ? path.parent_path() / path.stem() : path;
}

Result<FileBytes> unpack_gzip(std::string_view packed, std::uint64_t most) {
  const Result<std::uint64_t> count = count_unpacked(packed, most);
  if (!count) return count.failure();
  FileBytes out;
  out.size = static_cast<std::size_t>(*count);
  out.data.reset(new char[out.size + 1]);
  Inflater(packed).read(out.data.get(), out.size);
  return out;
}

std::string unpacked_head(std::string_view packed, std::size_t most) {
  std::string head(most, '\0');
  Inflater inflater(packed);
  head.resize(inflater.read(head.data(), most));
  return head;
}

std::string pack_gzip(std::string_view bytes) {
  z_stream stream{};
  constexpr int usual_memory = 8;
  if (::deflateInit2(&stream, Z_DEFAULT_COMPRESSION, Z_DEFLATED, gzip_window, usual_memory, Z_DEFAULT_STRATEGY) != Z_OK)
    throw std::bad_alloc();
  std::string packed;
  std::array<char, std::size_t{1} << 16> room;
  int result = Z_OK;
  while (result != Z_STREAM_END) {
    const std::string_view given = bytes.substr(0, most_at_once);
    stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(given.data()));
    stream.avail_in = static_cast<uInt>(given.size());
    stream.next_out = reinterpret_cast<Bytef*>(room.data());
    stream.avail_out = static_cast<uInt>(room.size());
    result = ::deflate(&stream, given.size() == bytes.size() ? Z_FINISH : Z_NO_FLUSH);
    packed.append(room.data(), room.size() - stream.avail_out);
    bytes.remove_prefix(given.size() - stream.avail_in);
  }
  ::deflateEnd(&stream);
  return packed;
}

}  // namespace ryosen
