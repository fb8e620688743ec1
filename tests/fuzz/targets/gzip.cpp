// Any bytes to the unpacking of gzip, and what is packed back again.
#include "ryosen/io/gzip.h"
#include "tests/fuzz/failure.h"
#include "tests/fuzz/targets/targets.h"

namespace ryosen::fuzz {

void fuzz_gzip(Input input) {
  const std::string_view bytes(reinterpret_cast<const char*>(input.data()), input.size());
  constexpr std::uint64_t most = 1 << 20;
  const std::string head = unpacked_head(bytes, 64);
  const Result<FileBytes> unpacked = unpack_gzip(bytes, most);
  if (!unpacked) {
    const Message& message = unpacked.failure().message;
    expect(message.byte && *message.byte <= input.size(), "a refusal outside of the file");
  } else {
    expect(unpacked->view().starts_with(head) && unpacked->size <= most, "what is unpacked is not what it begins with");
  }
  const Result<FileBytes> again = unpack_gzip(pack_gzip(bytes));
  expect(again.ok() && again->view() == bytes, "what is packed does not come back");
}

}  // namespace ryosen::fuzz
