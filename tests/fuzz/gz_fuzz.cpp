// Any bytes to the unpacking of gzip, and what is packed back again.
#include "ryosen/io/gzip.h"
#include "tests/fuzz/failure.h"
#include "tests/fuzz/reading.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace ryosen;
  const std::string_view bytes(reinterpret_cast<const char*>(data), size);
  constexpr std::uint64_t most = 1 << 20;
  const std::string head = unpacked_head(bytes, 64);
  const Result<FileBytes> unpacked = unpack_gzip(bytes, most);
  if (!unpacked) {
    const Message& message = unpacked.failure().message;
    fuzz::expect(message.byte && *message.byte <= size, "a refusal outside of the file");
  } else {
    fuzz::expect(unpacked->view().starts_with(head) && unpacked->size <= most,
                 "what is unpacked is not what it begins with");
  }
  const Result<FileBytes> again = unpack_gzip(pack_gzip(bytes));
  fuzz::expect(again.ok() && again->view() == bytes, "what is packed does not come back");
  return 0;
}
