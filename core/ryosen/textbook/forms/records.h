// What each form stores of an element of a mesh, with its links as elements of that mesh.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "ryosen/textbook/forms/form.h"
#include "ryosen/textbook/forms/polygons.h"

namespace ryosen::forms {

// Without a record `none` says why: the form cannot hold the mesh, or stores nothing of such an element.
struct ElementRecord {
  std::optional<Text> none;
  Fields fields;
};

// One form of a mesh, built at once, for looking into. Names of elements are slots of the mesh; a form that holds
// points links to the first copy. The mesh is not needed later. Cost: that of building the form.
class Records {
 public:
  Records(const Mesh& mesh, const FormRow& row);

  const FormRow& row() const { return *row_; }
  // Null where the mesh is unsuitable.
  const Form* form() const { return form_.get(); }
  // Of a live element of the mesh as it was.
  ElementRecord of(Element element) const;

 private:
  std::uint32_t number_of(Element element) const;
  Element element_of(Element own) const;

  const FormRow* row_;
  std::optional<Text> unsuitable_;
  std::unique_ptr<Form> form_;
  // By Element::Kind: the form's number of each slot, and the slot of each number; no_index for none.
  std::vector<std::uint32_t> numbers_[4], slots_[4];
};

}  // namespace ryosen::forms
