// The only way to write to a mesh: a transaction that is committed as a whole or rolled back.
#pragma once

#include <cstring>
#include <span>
#include <utility>
#include <vector>

#include "ryosen/mesh/attribute.h"
#include "ryosen/mesh/descent.h"
#include "ryosen/mesh/journal.h"
#include "ryosen/mesh/mesh.h"
#include "ryosen/mesh/provenance.h"
#include "ryosen/mesh/value_rules.h"

namespace ryosen {

// While an Edit is open, old values go to the journal. commit() makes it one history entry; destroying it uncommitted
// restores the mesh byte for byte and keeps the redo list (so a preview is an Edit that is not committed). With a null
// Journal nothing is recorded and the writes are final: for batch work. At most one Edit may be open on a mesh.
class Edit {
 public:
  // A descent that records is told where elements come from, also by an edit that is rolled back.
  Edit(Mesh& mesh, Journal* journal, Descent* descent = nullptr)
      : mesh_(mesh),
        journal_(journal),
        descent_(descent && descent->is_recording() ? descent : nullptr),
        before_(journal ? mesh.lengths() : ColumnLengths()),
        attributes_before_(mesh.attributes().size()) {
    if (journal_) journal_->begin(mesh_);
  }
  ~Edit() {
    if (journal_ && open_) journal_->rollback(mesh_);
  }
  Edit(const Edit&) = delete;
  Edit& operator=(const Edit&) = delete;

  const Mesh& mesh() const { return mesh_; }
  // Ends the edit. In checked builds the invariants of small meshes are verified and a violation aborts with its name.
  // In test builds an edit aborts that created an element neither derived nor fresh, or removed one that was neither
  // united with another nor dropped.
  void commit();
#ifdef RYOSEN_PROVENANCE
  // Why it could not be committed now.
  std::optional<std::string> untold() const { return provenance_.untold(mesh_); }
#endif

  // Links. connect sets next and prev of both.
  void connect(Halfedge h, Halfedge next) {
    write<Column::next>(h.index, mesh_.columns_.halfedges[h.index].next, next);
    write<Column::prev>(next.index, mesh_.columns_.halfedges[next.index].prev, h);
  }
  void set_from(Halfedge h, Vertex v) { write<Column::from>(h.index, mesh_.columns_.halfedges[h.index].from, v); }
  void set_face(Halfedge h, Face f) {
    Face& face = mesh_.columns_.halfedges[h.index].face;
    if (!face && f) provenance_.creates(ElementKind::corner, h.index);
    if (face && !f) provenance_.removes(ElementKind::corner, h.index);
    write<Column::face>(h.index, face, f);
  }
  void set_halfedge(Vertex v, Halfedge h) {
    write<Column::vertex_halfedge>(v.index, mesh_.columns_.vertex_halfedge[v.index], h);
  }
  void set_halfedge(Face f, Halfedge h) {
    write<Column::face_halfedge>(f.index, mesh_.columns_.face_halfedge[f.index], h);
  }
  // Moves one vertex; use move_point (copies.h) to move all copies of a point.
  void set_position(Vertex v, const glm::dvec3& p) {
    write<Column::position>(v.index, mesh_.columns_.positions[v.index], p);
  }
  // The successor of v in its cyclic list of copies, and the smallest of the list. copies.h has what keeps lists whole.
  void set_copy_links(Vertex v, Vertex next, Vertex point);
  // Adds the loop of `h` to the face as a ring; the caller has already set the face of its halfedges. O(1), the mesh's
  // first ring O(faces).
  void add_ring(Face f, Halfedge h);
  // Removes a ring from the face's list; the caller updates its halfedges. Cost: the rings of the face.
  void remove_ring(Face f, std::uint32_t ring);
  void set_ring_halfedge(std::uint32_t ring, Halfedge h) {
    write<Column::ring>(ring, mesh_.columns_.rings[ring], Ring{h, mesh_.columns_.rings[ring].next});
  }

  // New elements are appended; their links are none until set. add_edge sets both origins.
  Vertex add_vertex(const glm::dvec3& position);
  Halfedge add_edge(Vertex from, Vertex to);
  Face add_face(Halfedge first);
  // Removes an element that was a source of what it is united with (see derive()). The slot stays, marked dead. The
  // caller must already have redirected the links of other elements to it.
  void remove(Vertex v);
  void remove(Edge e);
  void remove(Face f);
  // Removes an element and its values.
  template <class Handle>
  void drop(Handle gone) {
    tell_end(kind_of(gone), gone.index);
    remove(gone);
  }

  // Gives an element the values that the rule of each attribute makes of its sources, which exist and have weights as
  // in value_rules.h. A corner is the halfedge that leaves its vertex along its face. Tells whether a value has
  // changed. O(attributes x sources).
  template <class Handle>
  bool derive(Handle to, std::span<const Handle> sources, std::span<const double> weights, Derivation derivation) {
    tell(to, sources, derivation);
    return !mesh_.columns_.attributes.empty() &&
           derive_all(kind_of(to), to.index, indices_of(sources), weights, derivation);
  }
  // One source.
  template <class Handle>
  bool derive(Handle to, Handle source, Derivation derivation) {
    constexpr double weight[] = {1};
    tell<Handle>(to, {&source, 1}, derivation);
    return !mesh_.columns_.attributes.empty() &&
           derive_all(kind_of(to), to.index, {&source.index, 1}, weight, derivation);
  }
  // Between two sources: t from the first to the second.
  template <class Handle>
  bool derive(Handle to, Handle first, Handle second, double t, Derivation derivation) {
    const Handle handles[] = {first, second};
    const std::uint32_t sources[] = {first.index, second.index};
    const double weights[] = {1 - t, t};
    tell<Handle>(to, handles, derivation);
    return !mesh_.columns_.attributes.empty() && derive_all(kind_of(to), to.index, sources, weights, derivation);
  }
  // The same for a value in a pool: the index of one of the sources where one alone has a weight or all are equal,
  // no_index where one with a weight is none, else that of a value that is appended.
  std::uint32_t derive_in_pool(std::size_t pool_attribute, std::span<const std::uint32_t> sources,
                               std::span<const double> weights);
  // The value that the rule of one attribute makes, for set_attribute(); where that has a pool, the index of one there.
  std::vector<std::uint32_t> derived(std::size_t attribute, std::span<const std::uint32_t> sources,
                                     std::span<const double> weights, Derivation derivation);
  // Gives a vertex the means of its sources; attributes that have no means stay.
  void blend(Vertex to, std::span<const Vertex> sources, std::span<const double> weights);
  // Divides an element into parts, of which it may be one itself (see divide_value). `shares()` is asked only where a
  // rule divides.
  template <class Handle, class Shares>
  void divide(Handle source, std::span<const Handle> parts, const Shares& shares) {
    for (const Handle part : parts) tell(kind_of(part), part.index, {&source.index, 1});
    if (mesh_.columns_.attributes.empty()) return;
    const ElementKind element = kind_of(source);
    divide_all(element, source.index, indices_of(parts),
               needs_shares_to_divide(element) ? shares() : std::vector<double>(parts.size(), 1));
  }
  // Unites elements, of which `to` may be one. Shares need not add up to 1; where they add up to nothing or are not
  // finite, all are equal. `shares()` is asked only where a rule has means.
  template <class Handle, class Shares>
  void unite(Handle to, std::span<const Handle> sources, const Shares& shares) {
    tell(to, sources, Derivation::unites);
    if (mesh_.columns_.attributes.empty()) return;
    const ElementKind element = kind_of(to);
    unite_all(element, to.index, indices_of(sources),
              needs_shares_to_unite(element) ? shares() : std::vector<double>(sources.size(), 1));
  }
  // Gives a new element, or a corner that lies outside now, the default of each attribute.
  template <class Handle>
  void fresh(Handle to) {
    tell(kind_of(to), to.index, {});
    if (!mesh_.columns_.attributes.empty()) reset(kind_of(to), to.index);
  }
  // The first corner of each pair gets what the second had. Corners that are only second get the defaults.
  void move_corners(std::span<const std::pair<Halfedge, Halfedge>> to_from);

  // Adds an attribute of vertices, edges, corners or faces, of which every element has the default value. Its name must
  // be free. Returns its index in Mesh::attributes(). O(elements).
  std::size_t add_attribute(AttributeColumn column);
  template <AttributeValue T>
  std::size_t add_attribute(std::string_view name, ElementKind element, ValueRule rule, const T& value = T{}) {
    return add_attribute(make_column(name, element, rule, value));
  }
  // With a rule of its own, which no file keeps.
  template <AttributeValue T>
  std::size_t add_attribute(std::string_view name, ElementKind element, OwnRule rule, const T& value = T{}) {
    AttributeColumn column = make_column(name, element, ValueRule::own, value);
    column.own_rule = rule;
    return add_attribute(std::move(column));
  }
  // Marks an attribute as removed, a corner attribute together with its pool: find_attribute() no longer finds it.
  // Other indices stay. O(1).
  void remove_attribute(std::size_t attribute);

  // Attribute values as raw words. set_attribute() tells whether the value was another; append_value() appends to a
  // pool and returns the new index.
  bool set_attribute(std::size_t attribute, std::uint32_t index, std::span<const std::uint32_t> words);
  std::uint32_t append_value(std::size_t pool_attribute, std::span<const std::uint32_t> words);

  // A descent for what replaces this mesh: it records where that is asked for, and in test builds.
  Descent new_descent() const;
  // Replaces all columns at once: for batch algorithms that build new columns. Must be the only write of the edit.
  // `descent`: from new_descent(), told where the elements of these columns come from.
  void replace(MeshColumns columns, const Descent& descent);
  // The same by any mesh; where its elements come from is not told, and not recorded any more.
  void replace_by_other(MeshColumns columns);

 private:
  template <Column column, class Value>
  void write(std::uint32_t index, Value& cell, const Value& value) {
    if (std::memcmp(&cell, &value, sizeof(Value)) == 0) return;
    // Cells at or past the length before belong to elements created by this edit and have no old value.
    constexpr auto length = length_of_column[static_cast<std::size_t>(column)];
    if (journal_ && index < before_.*length) journal_->record(column, index, &cell, sizeof(Value));
    cell = value;
  }
  void extend_attributes(ElementKind element, std::uint32_t count);
  static constexpr ElementKind kind_of(Vertex) { return ElementKind::vertex; }
  static constexpr ElementKind kind_of(Edge) { return ElementKind::edge; }
  static constexpr ElementKind kind_of(Halfedge) { return ElementKind::corner; }
  static constexpr ElementKind kind_of(Face) { return ElementKind::face; }
  template <class Handle>
  static std::vector<std::uint32_t> indices_of(std::span<const Handle> handles) {
    std::vector<std::uint32_t> indices;
    for (const Handle handle : handles) indices.push_back(handle.index);
    return indices;
  }
  void swap_columns(MeshColumns columns);
  template <class Handle>
  void tell(Handle to, std::span<const Handle> sources, Derivation derivation) {
    provenance_.tells(kind_of(to), to.index);
    if (Descent::is_checked && derivation == Derivation::unites)
      for (const Handle source : sources)
        if (source != to) provenance_.ends(kind_of(source), source.index);
    if (descent_) [[unlikely]]
      record(kind_of(to), to.index, indices_of(sources), derivation);
  }
  void tell(ElementKind kind, std::uint32_t to, std::span<const std::uint32_t> sources) {
    provenance_.tells(kind, to);
    if (descent_) [[unlikely]]
      record(kind, to, sources, Derivation::copies);
  }
  void tell_end(ElementKind kind, std::uint32_t index) {
    provenance_.ends(kind, index);
    if (descent_) [[unlikely]]
      descent_->end(kind, index);
  }
  // Tells the descent; not inlined, since few edits have one.
  void record(ElementKind kind, std::uint32_t to, std::span<const std::uint32_t> sources, Derivation derivation);
  bool derive_all(ElementKind element, std::uint32_t to, std::span<const std::uint32_t> sources,
                  std::span<const double> weights, Derivation derivation);
  bool derive_column(std::size_t attribute, std::uint32_t to, std::span<const std::uint32_t> sources,
                     std::span<const double> weights, Derivation derivation);
  bool needs_shares_to_divide(ElementKind element) const;
  bool needs_shares_to_unite(ElementKind element) const;
  void unite_all(ElementKind element, std::uint32_t to, std::span<const std::uint32_t> sources,
                 std::vector<double> shares);
  void divide_all(ElementKind element, std::uint32_t source, std::span<const std::uint32_t> parts,
                  std::span<const double> shares);
  void reset(ElementKind element, std::uint32_t to);
  // The corner attributes with pools.
  std::span<const CornerAttribute> pooled();

  Mesh& mesh_;
  Journal* journal_;
  Descent* descent_;
  ColumnLengths before_;
  std::size_t attributes_before_;
  Provenance provenance_;
  std::vector<CornerAttribute> pooled_;
  bool knows_pooled_ = false;
  bool open_ = true;
};

}  // namespace ryosen
