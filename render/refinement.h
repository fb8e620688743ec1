// Which parts of a picture have been drawn with several samples a pixel, and which are to be.
#pragma once

#include <optional>
#include <vector>

#include "ryosen/scene/view/size.h"

namespace ryosen {

// The tiles of a picture, in rows from the top. A tile is always refined alike, whatever was refined before.
class Refinement {
 public:
  static constexpr int samples = 4;  // a side of a pixel
  static constexpr int tile_px = 128;

  struct Part {
    PixelRect tile, rect;  // what is to be drawn of the tile
  };

  // Of a picture of this size nothing is refined.
  void begin(Size size);
  // What was drawn in this rectangle has one sample a pixel again.
  void spoil(const PixelRect& rect);

  bool is_done() const { return !next_tile() && parts_.empty(); }
  // What is to be refined next; none if all is. Unless it is told to be halved, it counts as done.
  std::optional<Part> take();
  // A part is taken again next, after all.
  void put_back(const Part& part) { parts_.push_back(part); }
  // A part was too much at once: its halves come next.
  void halve(const Part& part);

 private:
  std::optional<std::size_t> next_tile() const;
  PixelRect place(std::size_t tile) const;

  Size size_{0, 0};
  int columns_ = 0;
  std::vector<bool> is_coarse_;  // of tiles
  std::vector<Part> parts_;      // of one tile, the next one last
};

}  // namespace ryosen
