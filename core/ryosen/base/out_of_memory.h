// The answer to std::bad_alloc.
#pragma once

#include "ryosen/base/result.h"

namespace ryosen {

inline constexpr std::string_view out_of_memory_en =
    "There is not enough memory; allow more (ulimit -v), close other programs, or take a smaller mesh.";
inline constexpr std::string_view out_of_memory_ja =
    "メモリが足りません。上限（ulimit -v）を上げるか、他のプログラムを閉じるか、小さいメッシュを使ってください。";

inline Failure out_of_memory() {
  return make_failure(ExitCode::out_of_memory, "out_of_memory",
                      {std::string(out_of_memory_en), std::string(out_of_memory_ja)});
}

}  // namespace ryosen
