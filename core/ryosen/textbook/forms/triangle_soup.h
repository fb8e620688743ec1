// Table 1 of the source texts: three corners with coordinates per triangle, and nothing else.
#pragma once

#include <array>

#include "ryosen/textbook/forms/form.h"

namespace ryosen::forms {

// It stores neither vertices nor edges, so it answers no relation. In the conversion back equal coordinates are one
// point, numbered by its first corner; +0 and -0 are equal.
class TriangleSoup : public Form {
 public:
  explicit TriangleSoup(const Mesh& mesh);

  std::size_t bytes() const override;
  Mesh to_mesh() const override;
  Fields record(Element own) const override;

 private:
  std::vector<std::array<glm::dvec3, 3>> triangles_;
};

}  // namespace ryosen::forms
