#include "ryosen/io/given_back.h"

#include <utility>

namespace ryosen {

bool gives_back_others(const MeshFile& file, const Format& format) {
  return format.holds && !holds(format.holds(encoding_of(file, format)), Holds::vertices);
}

MeshFile given_back(MeshFile file, const Format& format) {
  if (!gives_back_others(file, format)) return file;
  Result<MeshFile> read = read_mesh(bytes_of(file, format), format);
  return read ? std::move(read).value() : std::move(file);
}

}  // namespace ryosen
