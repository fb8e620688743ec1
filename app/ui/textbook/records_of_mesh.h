// The forms of the source texts for the mesh of a panel.
#pragma once

#include "app/editor/textbook/record_book.h"
#include "app/ui/panels.h"

namespace ryosen {

// The forms of the mesh as it is, built in the background, where there are many faces when a button is pressed. Null
// while they are not there: it has drawn why not.
const RecordBook* records_of_mesh(PanelContext& context);
// Keeps them for this frame where they are those of the mesh as it is.
void keep_records(PanelContext& context);

}  // namespace ryosen
