// Colours and texture coordinates in the error of a collapse. A value is linear over a face, where it has a gradient;
// the new vertex gets the value that fits all faces around it best, and the squares that remain are added to those of
// distances [Hoppe99].
#pragma once

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <optional>
#include <utility>
#include <vector>

#include "ryosen/algo/simplify/quadric.h"
#include "ryosen/mesh/attribute.h"
#include "ryosen/mesh/edit.h"

namespace ryosen {

class CollapseSurface;

// Sums over faces of an attribute in one chart: of weights, and of weighted gradients and offsets by channel.
struct ValueSums {
  static constexpr std::size_t most_channels = 4;
  double weight = 0;
  std::array<glm::dvec3, most_channels> gradients{};
  std::array<double, most_channels> offsets{};

  ValueSums& operator+=(const ValueSums& other);
};

class AttributeError {
 public:
  // Returns none where no value that takes part differs anywhere, or the weight is 0. A change of a colour from 0 to 1
  // counts with a weight of 1 as a distance of 2 % of the mesh's longest side, and a shift of the texture as a distance
  // as long. O(corners), on several threads.
  static std::optional<AttributeError> of(const CollapseSurface& surface, double weight);

  // The weight that was asked for.
  double weight() const { return weight_; }

  // The squares that remain at the new vertex of an edge, as a function of its place. Its weight is the sum of squares
  // that they are the rest of, of which rounding is a share.
  Quadric of_edge(Halfedge h) const;

  // The charts at the corners around both ends of an edge, before values are written to these corners.
  using Charts = std::vector<std::pair<Halfedge, std::uint32_t>>;
  Charts charts_around(Halfedge h) const;
  // Before the edge collapses: its corners have new values.
  void follow(const Charts& before, Halfedge h);
  // Gives both ends of an edge the colours that fit best at a place, scaled.
  void write_colours(Edit& edit, Halfedge h, const glm::dvec3& place) const;
  // The same for a vertex alone.
  void write_colours(Edit& edit, Vertex v, const glm::dvec3& place) const;

  // `kept` now stands for `gone` too.
  void merge(Vertex gone, Vertex kept);
  // A new vertex, the next one by its number, stands for what another one stands for.
  void add_copy(Vertex of);

 private:
  // An attribute whose channels are compared after scaling.
  struct Attribute {
    std::size_t column = 0;               // of the values
    std::vector<std::uint32_t> channels;  // that differ anywhere, by their place in a value
    std::array<double, ValueSums::most_channels> lowest{}, highest{};
    double factor = 1;
  };
  // A vertex stands for these sums in one chart of the texture, which is known by the value of its corners there.
  struct Wedge {
    std::uint32_t chart = no_index, next = no_index;
    ValueSums sums;
  };

  AttributeError(const Mesh& mesh, double weight) : mesh_(mesh), weight_(weight) {}
  void find_colours(const CollapseSurface& surface);
  void find_texture(const CollapseSurface& surface);
  std::optional<Attribute> varying(std::string_view column, std::uint32_t rows, double factor) const;
  void sum_gradients(const CollapseSurface& surface);
  // Adds the wedges of the texture to a list.
  void sum_gradients_at(const CollapseSurface& surface, Vertex v, std::vector<Wedge>& wedges);
  // The sums of the triangle of a corner and the two beside it, where the values of an attribute are at these indices;
  // without weight where one is missing.
  ValueSums sums_of(const std::array<glm::dvec3, 3>& corners, const Attribute& attribute,
                    const std::array<std::uint32_t, 3>& values) const;
  std::uint32_t chart(Halfedge corner) const {
    return mesh_.is_outside(corner) ? no_index : mesh_.attributes()[chart_column_].data[corner.index];
  }
  // Adds it to the one of the same chart, or gives it to the vertex.
  void give(Vertex v, std::uint32_t wedge);
  void subtract_charts(Quadric& sum, Halfedge h) const;
  void write(Edit& edit, Vertex v, const ValueSums& sums, const glm::dvec3& place) const;

  const Mesh& mesh_;
  double weight_;
  std::optional<Attribute> colour_, texture_;
  std::size_t chart_column_ = 0;             // of the corners
  std::vector<Quadric> quadrics_;            // by vertex, of values as they are
  std::vector<ValueSums> colours_;           // by vertex
  std::vector<std::uint32_t> first_wedges_;  // by vertex
  std::vector<Wedge> wedges_;
};

}  // namespace ryosen
