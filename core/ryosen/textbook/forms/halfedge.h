// The halfedge structure of the source texts: table 5, with and without boundary halfedges, with and without the edge
// records of table 6.
#pragma once

#include "ryosen/textbook/forms/form.h"
#include "ryosen/textbook/forms/halfedge_table.h"

namespace ryosen::forms {

// The handle of an edge is one of its halfedges, or with edge records the number of its record.
class HalfedgeForm : public Form {
 public:
  // With halfedges also where there is no face, and with edge records.
  HalfedgeForm(const Mesh& mesh, bool outside, bool edge_records);

  std::size_t bytes() const override;
  Mesh to_mesh() const override;
  std::uint32_t find_edge(std::uint32_t a, std::uint32_t b) const override;
  bool answer(Relation relation, std::uint32_t element, Answer& out) const override;
  Fields record(Element own) const override;

 private:
  struct EdgeRecord {
    std::uint32_t start, end;   // vertices
    std::uint32_t left, right;  // the halfedge from start to end, and its pair or none
  };
  bool outside_, edge_records_;
  HalfedgeTable table_;
  std::vector<std::uint32_t> halfedge_edge_;  // empty without edge records
  std::vector<EdgeRecord> edges_;
};

}  // namespace ryosen::forms
