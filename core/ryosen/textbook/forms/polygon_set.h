// The polygon set of the source texts: per polygon the coordinates of its corners, of any number, and nothing else.
#pragma once

#include "ryosen/textbook/forms/form.h"

namespace ryosen::forms {

// It stores neither vertices nor edges, so it answers no relation. In the conversion back equal coordinates are one
// point, numbered by its first corner; +0 and -0 are equal.
class PolygonSet : public Form {
 public:
  explicit PolygonSet(const Mesh& mesh);

  std::size_t bytes() const override;
  Mesh to_mesh() const override;
  Fields record(Element own) const override;

 private:
  std::vector<std::vector<glm::dvec3>> polygons_;
};

}  // namespace ryosen::forms
