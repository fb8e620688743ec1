// Elements to ask the forms of a mesh about, the same for every form, and how long an answer takes.
#pragma once

#include <optional>
#include <vector>

#include "ryosen/textbook/forms/form.h"

namespace ryosen::forms {

// Up to 256 random vertices, edges by their ends, and faces, in the numbers of the forms. The same for the same mesh.
struct Questions {
  explicit Questions(const Mesh& mesh);

  std::vector<std::uint32_t> vertices, faces;
  std::vector<EdgeEnds> edges;
};

// A form's handles of these edges, as many as can be found within the time, but at least one where there is one.
std::vector<std::uint32_t> handles_of(const Form& form, const std::vector<EdgeEnds>& edges, double seconds);

// Seconds per query, of the fastest of several rounds; each takes at least an eighth of `seconds`. None where the form
// cannot answer, or nothing is asked.
std::optional<double> time_per_query(const Form& form, Relation relation, const std::vector<std::uint32_t>& elements,
                                     double seconds);

}  // namespace ryosen::forms
