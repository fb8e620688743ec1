#include "ryosen/base/sort_unique.h"

namespace ryosen {

template void sort_unique(std::vector<Vertex>&);
template void sort_unique(std::vector<Halfedge>&);
template void sort_unique(std::vector<Edge>&);
template void sort_unique(std::vector<Face>&);
template void sort_unique(std::vector<std::uint32_t>&);

}  // namespace ryosen
