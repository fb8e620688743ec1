#include "ryosen/io/ply_attributes.h"

#include <algorithm>
#include <cstring>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>

#include "ryosen/base/column_memory.h"
#include "ryosen/mesh/attribute.h"
#include "ryosen/mesh/attribute_text.h"

namespace ryosen {
namespace {

Scalar scalar_in_ply(Scalar scalar) { return scalar == Scalar::boolean ? Scalar::uint8 : scalar; }

class AttributeTaker {
 public:
  AttributeTaker(MeshFile& file, std::vector<PlyAttribute> described)
      : file_(file), mesh_(file.mesh), described_(std::move(described)) {
    for (const PlyAttribute& each : described_) by_name_.insert_or_assign(each.column.name, &each);  // the last counts
  }

  void take() {
    for (PropertyTable& table : file_.properties.tables) {
      if (!table.is_further()) take_table(table);
      if (may_be_edges(table)) take_edges(table);
    }
    give_values_to_quarantine();
    for (PlyAttribute& each : described_)
      if (!used_.contains(&each)) file_.head_comments.push_back(std::move(each.comment));
  }

 private:
  struct Head {
    AttributeColumn column;                   // without values
    const PlyAttribute* described = nullptr;  // by this comment
  };

  // The attribute that a property is, or none. A property with the whole name comes before one with the short one.
  std::optional<Head> head_of(TableKind kind, const std::set<std::string_view>& names, const Property& property) const {
    if (property.role != PropertyRole::extra || taken_.size() >= most_attributes_of_a_file) return std::nullopt;
    AttributeColumn head;
    head.name = attribute_of_property(kind, property.name);
    const auto element = element_of_attribute(head.name);
    if (!element || is_reserved_name(head.name) || taken_.contains(head.name)) return std::nullopt;
    if (head.name != property.name && names.contains(head.name)) return std::nullopt;
    if (const auto found = by_name_.find(head.name); found != by_name_.end()) {
      const ValueType type = found->second->column.type;
      const bool is_list = type.count != 1 || found->second->column.element == ElementKind::corner;
      if (scalar_in_ply(type.scalar) == property.type && is_list == property.is_list &&
          (type.scalar != Scalar::boolean || are_booleans(property)))
        return Head{found->second->column, found->second};
    }
    if (property.is_list || *element == ElementKind::corner) return std::nullopt;
    head.element = *element;
    head.type = {property.type, 1};
    head.rule = usual_rule(head.type);
    head.fill.assign(head.words(), 0);
    return Head{std::move(head), nullptr};
  }

  static std::set<std::string_view> names_of(const PropertyTable& table) {
    std::set<std::string_view> names;
    for (const Property& property : table.properties) names.insert(property.name);
    return names;
  }

  static bool are_booleans(const Property& property) {
    return std::all_of(property.data.begin(), property.data.end(), [](std::byte b) { return b <= std::byte{1}; });
  }

  // Whether each row of a list has so many values as the attribute needs.
  bool fits(const AttributeColumn& head, const Property& property, std::size_t rows) const {
    if (!property.is_list) return true;
    for (std::size_t row = 0; row < rows; ++row) {
      const std::size_t values = head.element == ElementKind::corner ? corner_count(row) : 1;
      if (property.value_count(row) != values * head.type.count) return false;
    }
    return true;
  }

  std::size_t corner_count(std::size_t face) const {
    const QuarantinedFace* const aside = quarantined(face);
    return aside ? aside->corners.size() : mesh_.face(face).size();
  }
  const QuarantinedFace* quarantined(std::size_t face) const {
    const auto found = std::lower_bound(mesh_.quarantine.begin(), mesh_.quarantine.end(), face,
                                        [](const QuarantinedFace& aside, std::size_t f) { return aside.face < f; });
    return found != mesh_.quarantine.end() && found->face == face ? &*found : nullptr;
  }

  // Appends numbers of a property, from this one on, as values of an attribute.
  static void append(const Property& property, std::size_t first, std::size_t values, ValueType type,
                     std::vector<std::uint32_t>& data) {
    const std::size_t bytes = type.bytes(), words = type.words(), at = data.size();
    const std::byte* source = property.data.data() + first * bytes_of(property.type);
    data.resize(at + values * words);
    for (std::size_t i = 0; i < values; ++i, source += bytes) std::memcpy(data.data() + at + i * words, source, bytes);
  }

  void take_table(PropertyTable& table) {
    const std::set<std::string_view> names = names_of(table);
    for (Property& property : table.properties) {
      std::optional<Head> head = head_of(table.kind, names, property);
      if (!head || !fits(head->column, property, table.rows)) continue;
      if (head->column.element == ElementKind::corner)
        take_corners(property, head->column);
      else
        append(property, 0, table.rows, head->column.type, head->column.data);
      release(property.data);
      release(property.ends);
      property.role = PropertyRole::attribute;
      take_column(std::move(*head));
    }
  }

  void take_column(Head head) {
    taken_.insert(head.column.name);
    if (head.described) used_.insert(head.described);
    mesh_.attributes.push_back(std::move(head.column));
  }

  void take_corners(const Property& property, AttributeColumn& column) {
    quarantined_values_.resize(mesh_.quarantine.size());
    std::size_t aside = 0;
    for (std::size_t face = 0; face < mesh_.face_count(); ++face) {
      const std::size_t first = property.first_value(face);
      if (aside < mesh_.quarantine.size() && mesh_.quarantine[aside].face == face) {
        append(property, first, mesh_.quarantine[aside].corners.size(), column.type, quarantined_values_[aside]);
        ++aside;
      } else {
        append(property, first, mesh_.face(face).size(), column.type, column.data);
      }
    }
  }

  void give_values_to_quarantine() {
    for (std::size_t i = 0; i < quarantined_values_.size(); ++i) mesh_.quarantine[i].values = quarantined_values_[i];
  }

  bool may_be_edges(const PropertyTable& table) const {
    if (table.kind != TableKind::other || table.name != "edge") return false;
    if (taken_.size() + table.properties.size() > most_attributes_of_a_file) return false;
    std::size_t ends = 0;
    const std::set<std::string_view> names = names_of(table);
    for (const Property& property : table.properties) {
      if (property.role == PropertyRole::vertex_number && !property.is_list) {
        ++ends;
        continue;
      }
      const std::optional<Head> head = head_of(TableKind::edges, names, property);
      if (!head || !fits(head->column, property, table.rows)) return false;
    }
    return ends == 2 && names.size() == table.properties.size() && table.rows < no_index / 2;
  }

  struct EdgeRow {
    std::pair<std::uint32_t, std::uint32_t> ends;
    std::uint32_t row;
    friend auto operator<=>(const EdgeRow&, const EdgeRow&) = default;
  };

  // Tells of each row whether it becomes an edge of the list.
  std::vector<bool> find_edges(const Property& from, const Property& to, std::size_t rows) const {
    std::vector<EdgeRow> sought;
    const auto end = static_cast<std::int64_t>(mesh_.positions.size());
    for (std::uint32_t row = 0; row < rows; ++row) {
      const std::int64_t a = from.integer(row), b = to.integer(row);
      if (a >= 0 && a < end && b >= 0 && b < end)
        sought.push_back({std::minmax({static_cast<std::uint32_t>(a), static_cast<std::uint32_t>(b)}), row});
    }
    std::sort(sought.begin(), sought.end());
    std::vector<bool> found(rows, false);
    const auto edges = edges_of_faces(mesh_);
    auto edge = edges.begin();
    for (std::size_t i = 0; i < sought.size(); ++i) {
      if (i != 0 && sought[i].ends == sought[i - 1].ends) continue;  // the second row of an edge
      while (edge != edges.end() && *edge < sought[i].ends) ++edge;
      found[sought[i].row] = edge != edges.end() && *edge == sought[i].ends;
    }
    return found;
  }

  void take_edges(PropertyTable& table) {
    std::vector<const Property*> ends;
    for (const Property& property : table.properties)
      if (property.role == PropertyRole::vertex_number) ends.push_back(&property);
    if (ends[0]->component != 0) std::swap(ends[0], ends[1]);
    const std::vector<bool> are_edges = find_edges(*ends[0], *ends[1], table.rows);
    std::vector<std::uint32_t> others;
    for (std::uint32_t row = 0; row < table.rows; ++row) {
      if (are_edges[row])
        mesh_.edges.push_back({static_cast<std::uint32_t>(ends[0]->integer(row)),
                               static_cast<std::uint32_t>(ends[1]->integer(row)), row});
      else
        others.push_back(row);
    }
    const std::set<std::string_view> names = names_of(table);
    for (const Property& property : table.properties) {
      if (property.role == PropertyRole::vertex_number) continue;
      Head head = *head_of(TableKind::edges, names, property);
      for (const ListedEdge& e : mesh_.edges)
        append(property, property.first_value(e.row), 1, head.column.type, head.column.data);
      take_column(std::move(head));
    }
    keep_rows_in_table(table, others);
  }

  static void keep_rows_in_table(PropertyTable& table, const std::vector<std::uint32_t>& rows) {
    table = rows_of(table, rows);
    table.kind = TableKind::edges;
    for (Property& property : table.properties)
      if (property.role == PropertyRole::extra) property.role = PropertyRole::attribute;
    Property numbers;
    numbers.type = Scalar::uint32;
    numbers.role = PropertyRole::row;
    for (const std::uint32_t row : rows) numbers.append(std::int64_t{row});
    table.properties.push_back(std::move(numbers));
  }

  MeshFile& file_;
  IndexedMesh& mesh_;
  std::vector<PlyAttribute> described_;
  std::map<std::string_view, const PlyAttribute*> by_name_;  // of described_
  std::set<const PlyAttribute*> used_;
  std::vector<std::vector<std::uint32_t>> quarantined_values_;  // by place in the quarantine
  std::set<std::string> taken_;
};

}  // namespace

void take_attributes(MeshFile& file, std::vector<PlyAttribute> described) {
  AttributeTaker(file, std::move(described)).take();
}

bool is_plain_in_ply(const AttributeColumn& column) {
  const ValueRule rule = usual_rule(column.type);
  return column.element != ElementKind::corner && column.type.count == 1 && column.type.scalar != Scalar::boolean &&
         (column.rule == rule || column.rule == ValueRule::own) &&
         std::all_of(column.fill.begin(), column.fill.end(), [](std::uint32_t word) { return word == 0; });
}

}  // namespace ryosen
