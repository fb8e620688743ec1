// What was selected around each entry of the history, and what was selected once and kept under a name.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "ryosen/algo/algorithm.h"
#include "ryosen/base/element.h"
#include "ryosen/mesh/mesh.h"

namespace ryosen {

// Takes out what is deleted; is_renumbered: all columns have been replaced, so that only points and faces have kept
// their numbers.
void drop_lost(Elements& elements, const Mesh& mesh, bool is_renumbered);

// Pass the mesh as it is behind the change. A selection that stays the same from entry to entry is held once.
class SelectionMemory {
 public:
  // A selection by its name. Members may be deleted; undo may bring them back.
  std::map<std::string, Elements, std::less<>> kept;

  // How elements go on behind an entry that has replaced all columns.
  struct Passage {
    Lineage lineage = Lineage::numbers;
    const Descent* descent = nullptr;  // where the lineage is told; none where it was not asked for
  };

  // An entry was made, on a mesh of these lengths; entries behind it are gone, and with them what they had made and was
  // kept. What it deleted is no longer selected; of what it has put in the place of other elements, that is selected
  // and kept in their place. A name under which nothing is left goes. No passage: elements keep their numbers.
  void made(std::size_t entry, Elements& selection, const Mesh& mesh, const std::optional<Passage>& passage,
            const ColumnLengths& before);
  // What was selected when the entry was made is selected again; what is selected now, when it is redone.
  void undone(std::size_t entry, Elements& selection, const Mesh& mesh, bool is_renumbered);
  void redone(std::size_t entry, Elements& selection, const Mesh& mesh, bool is_renumbered);
  void clear() { *this = SelectionMemory(); }

 private:
  using Shared = std::shared_ptr<const Elements>;
  struct Around {
    Shared before, after;
    std::map<std::string, Elements, std::less<>> other_kept;  // on the other side of one that renumbers
  };

  Shared shared(const Elements& selection);

  std::vector<Around> around_;
  Shared last_;
};

}  // namespace ryosen
