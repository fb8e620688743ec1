#include "ryosen/algo/seams/seam_mode.h"

#include "ryosen/algo/preparation.h"
#include "ryosen/algo/seams/flat_normals.h"
#include "ryosen/mesh/attribute.h"

namespace ryosen {

namespace {

void drop_corner_values(Mesh& mesh) {
  using namespace attribute_names;
  MeshColumns columns = mesh.columns();
  std::erase_if(columns.attributes, [](const AttributeColumn& column) {
    return column.name == texcoord || column.name == texcoord_pool || column.name == normal ||
           column.name == normal_pool;
  });
  mesh = Mesh(std::move(columns));
}

}  // namespace

ParameterRow seams_row(std::string_view help_en, std::string_view help_ja) {
  return parameter_row(
      {"seams", "Seams", "シーム", help_en, help_ja},
      {.kind = ParameterKind::choice,
       .initial = "weigh",
       .choices = {{"weigh", "Weigh", "重み付き"}, {"keep", "Keep", "保つ"}, {"drop", "Drop", "捨てる"}}});
}

SeamMode seam_mode_of(const ParameterValues& values) {
  const std::string_view seams = values.choice("seams");
  return seams == "keep" ? SeamMode::kept : seams == "drop" ? SeamMode::dropped : SeamMode::weighed;
}

std::vector<std::uint8_t> prepare_seams(Mesh& mesh, SeamMode seams) {
  if (seams == SeamMode::dropped) drop_corner_values(mesh);
  if (seams != SeamMode::weighed || !find_column(mesh, attribute_names::normal)) return {};
  Edit batch(mesh, nullptr);
  share_equal_values(batch);
  batch.commit();
  return take_flat_normals(mesh);
}

Text dropped_text(const Mesh& before, SeamMode seams) {
  const bool has_texture = find_column(before, attribute_names::texcoord),
             has_normals = find_column(before, attribute_names::normal);
  if (seams != SeamMode::dropped || (!has_texture && !has_normals)) return {};
  const Text what = has_texture && has_normals ? Text{"Texture and normals were", "テクスチャと法線"}
                    : has_texture              ? Text{"Texture was", "テクスチャ"}
                                               : Text{"Normals were", "法線"};
  return {" " + what.en + " dropped.", what.ja + "は捨てました。"};
}

}  // namespace ryosen
