// The fields of what the panel of values asks for: the values of an algorithm, or what an operator may be told besides
// the elements that it works on.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/editor/commands/text/command.h"
#include "app/editor/shown/values_preview.h"
#include "ryosen/algo/parameters.h"
#include "ryosen/base/message.h"

namespace ryosen {

class Document;
class Findings;
class Selecting;

struct ValueField {
  ParameterRow row;
  std::string text;
  bool is_shown = true;
};

class AskedValues {
 public:
  virtual ~AskedValues() = default;

  const RowWords& words() const { return words_; }
  std::vector<ValueField>& fields() { return fields_; }
  // Call when a field has changed: others may appear or go.
  virtual void follow() {}
  // The first field that must be filled in and is empty.
  virtual std::optional<std::size_t> lacking() const = 0;
  // Call while the view shows the document's mesh: what is selected may decide which fields there are, and whether it
  // can be run.
  virtual void look_at_selection(const Document&, const Findings&, const Selecting&) {}
  // Why it cannot be run with these values; none where it can.
  virtual std::optional<Text> fault() const = 0;
  // There must be no fault.
  virtual Command command() const = 0;
  // The same, to be shown before it is run.
  virtual ValuesTrial trial() const = 0;

 protected:
  explicit AskedValues(const RowWords& words) : words_(words) {}

  RowWords words_;
  std::vector<ValueField> fields_;
};

// Elements begin with what is selected, other fields with what fits the mesh.
std::unique_ptr<AskedValues> ask_values(const AlgorithmRow& row, const Mesh& mesh, const Selecting& selecting);
std::unique_ptr<AskedValues> ask_values(const OpInfo& op, const Document& document, const Findings& findings,
                                        const Selecting& selecting);

// Whether an operator may be told anything besides elements.
bool has_values(const OpInfo& op);
// Whether that may be a number or a position.
bool takes_numbers(const OpInfo& op);

}  // namespace ryosen
