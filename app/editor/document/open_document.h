// A document with what is found in it; the findings keep what is hidden, too, and the feed of its changes.
#pragma once

#include <memory>

#include "app/editor/document/findings.h"
#include "ryosen/document/document.h"

namespace ryosen {

struct OpenDocument {
  std::unique_ptr<Document> document;
  std::unique_ptr<Findings> findings;  // reads the document, so that it ends first
};

}  // namespace ryosen
