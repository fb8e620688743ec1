// Problems that the file of a document has and the document has not, or the other way round.
#pragma once

#include <filesystem>
#include <optional>

#include "ryosen/document/document.h"

namespace ryosen {

// A sentence with the kinds of problems of which the file at this path will have another number than the document: one
// without a list of vertices makes one point of those at one place. None where the numbers are equal. Cost: that of
// writing and reading such a file; nothing for other formats.
std::optional<Text> file_findings_text(const Document& document, const std::filesystem::path& path);

}  // namespace ryosen
