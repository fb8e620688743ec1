#include "ryosen/io/file_state.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <charconv>
#include <cstring>
#include <vector>

#include "ryosen/base/number_text.h"
#include "ryosen/io/descriptor.h"

namespace ryosen {

namespace {

constexpr std::size_t piece_bytes = std::size_t{1} << 18;  // a multiple of 8

std::uint64_t mixed(std::uint64_t hash, std::uint64_t word) {
  hash = (hash ^ word) * 0x9e3779b97f4a7c15u;
  return hash ^ (hash >> 29);
}

// Fills the piece as far as there is anything; none on failure.
std::optional<std::size_t> read_piece(int descriptor, std::vector<char>& piece) {
  std::size_t size = 0;
  while (size < piece.size()) {
    const ssize_t count = retried([&] { return ::read(descriptor, piece.data() + size, piece.size() - size); });
    if (count < 0) return std::nullopt;
    if (count == 0) break;
    size += static_cast<std::size_t>(count);
  }
  return size;
}

}  // namespace

std::optional<FileState::Seen> FileState::look(const std::filesystem::path& path) {
  struct stat status {};
  if (stat(path.c_str(), &status) != 0 || !S_ISREG(status.st_mode)) return std::nullopt;
  return Seen{status.st_size, status.st_mtim.tv_sec, status.st_mtim.tv_nsec,
              Status{static_cast<std::int64_t>(status.st_ino), status.st_ctim.tv_sec, status.st_ctim.tv_nsec}};
}

FileState FileState::of(const std::filesystem::path& path) {
  FileState state;
  state.seen_ = look(path);
  return state;
}

void FileState::learn_content(const std::filesystem::path& path) {
  const std::optional<Seen> now = look(path);
  if (!seen_ || content_ || change_to(now, path) != Change::none) return;
  const std::optional<std::uint64_t> content = content_hash(path);
  if (look(path) != now) return;  // it may be that of a later state
  content_ = content;
  seen_ = now;
}

FileState FileState::of_none_that_is() {
  FileState state;
  state.seen_ = Seen{-1, 0, 0, {}};
  return state;
}

FileState::Change FileState::change_to(const std::optional<Seen>& now, const std::filesystem::path& path) const {
  if (!seen_) return Change::none;
  if (!now) return Change::gone;
  if (now == seen_) return Change::none;
  if (now->bytes != seen_->bytes) return Change::changed;
  if (content_) return content_hash(path) == content_ ? Change::none : Change::changed;
  return now->seconds == seen_->seconds && now->nanoseconds == seen_->nanoseconds ? Change::none : Change::changed;
}

FileState::Change FileState::since(const std::filesystem::path& path) const { return change_to(look(path), path); }

FileState::Change FileState::follow(const std::filesystem::path& path) {
  const std::optional<Seen> now = look(path);
  if (now && now == other_) return Change::changed;
  const Change change = change_to(now, path);
  other_ = change == Change::changed ? now : std::nullopt;
  if (change == Change::none && seen_) seen_ = now;
  return change;
}

std::string FileState::text() const {
  if (!seen_) return {};
  std::string text =
      std::to_string(seen_->bytes) + " " + std::to_string(seen_->seconds) + " " + std::to_string(seen_->nanoseconds);
  return content_ ? text + " " + hash_text(*content_) : text;
}

FileState FileState::from_text(std::string_view text) {
  Seen seen{};
  const char* at = text.data();
  const char* const end = at + text.size();
  bool is_right = true;
  const auto read = [&](auto& value) {
    const auto [behind, error] = std::from_chars(at, end, value);
    is_right = is_right && error == std::errc() && (behind == end || *behind == ' ');
    at = behind == end ? end : behind + 1;
  };
  read(seen.bytes);
  read(seen.seconds);
  read(seen.nanoseconds);
  FileState state;
  if (!is_right) return state;
  state.seen_ = seen;
  std::uint64_t content = 0;
  const auto [behind, error] = std::from_chars(at, end, content, 16);
  if (error == std::errc() && behind == end) state.content_ = content;
  return state;
}

std::optional<std::uint64_t> content_hash(const std::filesystem::path& path) {
  const Descriptor file(retried([&] { return ::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK); }));
  struct stat status {};
  if (!file.is_open() || ::fstat(file.number(), &status) != 0 || !S_ISREG(status.st_mode)) return std::nullopt;
  std::vector<char> piece(piece_bytes);
  std::uint64_t hash = 0, all = 0;
  while (const std::optional<std::size_t> size = read_piece(file.number(), piece)) {
    std::memset(piece.data() + *size, 0, (8 - *size % 8) % 8);
    for (std::size_t i = 0; i < *size; i += 8) {
      std::uint64_t word;
      std::memcpy(&word, piece.data() + i, sizeof word);
      hash = mixed(hash, word);
    }
    all += *size;
    if (*size < piece.size()) return mixed(hash, all);
  }
  return std::nullopt;
}

}  // namespace ryosen
