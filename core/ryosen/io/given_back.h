// The mesh that a file gives back when it is read again.
#pragma once

#include "ryosen/io/formats.h"

namespace ryosen {

// Whether a file in a writable format may give back other vertices and faces than were written: one without a list of
// vertices makes one of those at one place.
bool gives_back_others(const MeshFile& file, const Format& format);
// The file as writing it and reading it again gives it; itself where that gives the same vertices and faces. Cost: that
// of both.
MeshFile given_back(MeshFile file, const Format& format);

}  // namespace ryosen
