// The repairs of the problems panel: what each would do, its numbers, and its button.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "app/ui/panels.h"

namespace ryosen {

class Shown;

// What stands in the fields of the repairs, and which of them are unfolded.
class RepairRows {
 public:
  // All repairs of a kind. True when one was pressed. None can be where nothing is left to mend, or what is shown is
  // not the mesh that is open. A row takes as much room whatever it says.
  bool draw(PanelContext& context, ProblemKind kind, bool is_mended);
  // The button of all that keep the geometry, and what it would do. True when it was pressed.
  bool draw_all(PanelContext& context, bool is_mended);
  // Shows the other repairs for a kind: those that move geometry and need no values. True when one was pressed.
  bool draw_beyond_all(PanelContext& context, ProblemKind kind, bool is_mended);
  // A trial that nobody looks at any more ends. Behind all rows of a frame.
  void end_frame(PanelContext& context);

 private:
  struct Fields {
    bool are_open = false, begin = false;
    std::vector<std::string> texts;
  };
  Fields& fields_of(const AlgorithmRow& row);
  static Text why_off(const Shown& shown, bool is_mended);
  bool draw_repair(PanelContext& context, const AlgorithmRow& row, const Text& why_off);
  bool draw_fields(PanelContext& context, const AlgorithmRow& row, Fields& fields);
  // Below the button that was drawn last, in whose group it is; ends that.
  void draw_report(PanelContext& context, const std::string& line, const char* name, const char* help,
                   const Text& why_off);

  std::map<std::string, Fields, std::less<>> fields_;  // by the id of the repair
  bool wants_trial_ = false;
};

}  // namespace ryosen
