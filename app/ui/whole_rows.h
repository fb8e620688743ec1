// A list that scrolls by whole rows: it begins with one and ends with one.
#pragma once

#include <vector>

namespace ryosen {

// Goes by where its rows were in the last frame in which it was seen.
class WholeRows {
 public:
  // Shows the first row again.
  void go_to_top() { goes_to_top_ = true; }
  // Begins a child window of at most this height, which takes as much of it as whole rows do.
  void begin(const char* name, float room);
  // A row begins here: in a table, or in lines of text.
  void row();
  void row_of_text();
  void end();
  // How high all rows are; 0 while it was not seen yet.
  float height() const { return places_.empty() ? 0 : places_.back(); }

 private:
  // Where the rows begin and the last one ends, from the top of the first; as they come up in this frame.
  std::vector<float> places_, coming_;
  bool goes_to_top_ = false;
  bool is_seen_ = false;  // the child window is not clipped away
  float first_ = 0;       // where the first row that is shown begins
  float bottom_ = 0;      // of the room, in the window around
};

}  // namespace ryosen
