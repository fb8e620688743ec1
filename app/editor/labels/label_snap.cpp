#include "app/editor/labels/labels.h"
#include "app/editor/shown/gesturing.h"

namespace ryosen {

void add_snap(const Gesturing& gesturing, std::vector<Label>& labels) {
  const SnapTarget& target = *gesturing.transform()->snapped_to();
  labels.push_back({.at = target.place,
                    .text = target.name,
                    .priority = snap_priority,
                    .shift_px = {0, -22},
                    .else_px = {{0, 22}, {36, 0}, {-36, 0}},
                    .through = true});
}

}  // namespace ryosen
