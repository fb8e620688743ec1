// Follows the links of a form's records one by one, and makes a step of each.
#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "ryosen/textbook/forms/reading/record_reader.h"
#include "ryosen/textbook/steps/sequence.h"

namespace ryosen::steps {

class LinkWalk {
 public:
  LinkWalk(const Mesh& mesh, const forms::FormRow& form, Source source);

  // A step of its own, or a further link of the last one.
  enum class Tell { own, more };
  // Where a link leads; `what` stands in front of the caption of a step of its own.
  Element follow(Element of, std::string_view key, Tell tell, const Text& what = {});
  // All that a field links to.
  std::vector<Element> follow_all(Element of, std::string_view key, Tell tell, const Text& what = {});

  // Those of a halfedge as the form has them: stored, by the parent edge, or by the numbers 3i+j, which cost no record.
  Element next(Element h, Tell tell, const Text& what = {}) { return turned(h, "next", 1, tell, what); }
  Element prev(Element h, Tell tell, const Text& what = {}) { return turned(h, "prev", 2, tell, what); }
  Element twin_of(Element h, Tell tell, const Text& what = {});
  // The first halfedge of a face: stored, or 3i.
  Element first_of(Element f, Tell tell, const Text& what = {});

  // The places of a face, of a form that stores nothing else; a step of its own. Returns how many there are.
  std::size_t read_places(Face f);

  void say(Text caption, const std::vector<Element>& answer);
  void add_to_last(const Text& more) { steps_.back().caption = steps_.back().caption + more; }
  void mark_last(Role role, Element element) { steps_.back().marks.push_back({role, element}); }

  const Mesh& mesh() const { return mesh_; }
  bool stores(Element::Kind kind, std::string_view key) const { return reader_.stores(kind, key); }
  std::size_t records() const { return reader_.read().size(); }
  std::unique_ptr<Sequence> done(Text remark) &&;

 private:
  Element turned(Element h, std::string_view key, std::uint32_t by, Tell tell, const Text& what);
  // Adds to the last step, or begins one about an element.
  Step& tell(Tell tell, Element about, const Text& what, const Text& said);
  void add_row(Step& step, Element of, std::string_view key, const std::string& value, bool is_none);

  const Mesh& mesh_;
  forms::RecordReader reader_;
  Source source_;
  bool is_numbered_;                      // 3i+j
  std::vector<Halfedge> corners_;         // then the halfedge of each number
  std::vector<std::uint32_t> corner_of_;  // and back
  std::vector<Step> steps_;
};

}  // namespace ryosen::steps
