// The `expect` command: assertions of a script about the mesh.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "ryosen/document/outcome.h"
#include "ryosen/mesh/mesh.h"

namespace ryosen {

class Document;
class Findings;

// A term of the Euler–Poincaré sum (analysis/euler_poincare.h), the verdict on a command, or the hash. A false
// assertion fails with exit code 1 and reports the actual value.
Outcome run_expect(Document& document, Findings& findings, std::span<const std::string_view> arguments,
                   std::string_view whole);
// What stands behind the word in its syntax.
std::string expect_syntax();

// The hash as in reports: 16 hexadecimal digits.
std::string hash_text(const Mesh& mesh);

}  // namespace ryosen
