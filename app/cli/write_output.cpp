#include "app/cli/write_output.h"

#include <algorithm>
#include <utility>

#include "app/cli/console.h"
#include "ryosen/io/formats.h"
#include "ryosen/io/safe_write.h"

namespace ryosen::cli {

WrittenOutput write_output(Document& document, RunFiles& files, const std::string& path, bool is_strict,
                           const Console& console, const std::vector<Message>& given_up) {
  WrittenOutput written;
  std::vector<Message> losses = given_up;
  for (Message& loss : document.losses(path))
    if (std::none_of(given_up.begin(), given_up.end(), [&](const Message& m) { return m.code == loss.code; }))
      losses.push_back(std::move(loss));
  const bool is_refused = is_strict && !losses.empty();
  Status status = is_refused ? Status(refusal_of_losses()) : files.may_write(path, FileRole::result);
  if (status) status = document.save(path);
  written.is_there = is_in_place(status);
  if (written.is_there) files.writes(path, FileRole::result);
  if (written.is_there || is_refused) written.losses = std::move(losses);
  for (const Message& loss : written.losses) console.show(loss, path);
  if (status) return written;
  written.failure = status.failure();
  console.show(written.failure->message, path);
  return written;
}

std::string written_text(const std::string* path, const Console& console) {
  if (!path) return std::string(console.text("nothing written\n", "書き出しなし\n"));
  return console.text(Text{"written: ", "書き出し："}) + visible_line(*path) + "\n";
}

}  // namespace ryosen::cli
