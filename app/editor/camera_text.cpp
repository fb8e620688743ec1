#include "app/editor/camera_text.h"

#include <glm/geometric.hpp>
#include <nlohmann/json.hpp>

#include "core/ops/op.h"

namespace ryosen {

namespace {

using Json = nlohmann::ordered_json;

bool read_vector(const Json& json, const char* key, glm::dvec3& value) {
  if (!json.contains(key)) return true;
  const Json& array = json[key];
  if (!array.is_array() || array.size() != 3) return false;
  for (int axis = 0; axis < 3; ++axis) {
    if (!array[static_cast<std::size_t>(axis)].is_number()) return false;
    value[axis] = array[static_cast<std::size_t>(axis)].get<double>();
  }
  return true;
}

bool looks_somewhere(const Camera& c) {
  const glm::dvec3 side = glm::cross(c.target - c.eye, c.up);
  return glm::dot(side, side) > 0 && c.fov_y_deg > 0 && c.fov_y_deg < 180 && (!c.ortho_height || *c.ortho_height > 0);
}

bool read_camera(const Json& json, Camera& camera) {
  for (const auto& [key, value] : json.items())
    if (key != "eye" && key != "target" && key != "up" && key != "fov_y_deg" && key != "ortho_height") return false;
  if (!read_vector(json, "eye", camera.eye) || !read_vector(json, "target", camera.target) ||
      !read_vector(json, "up", camera.up))
    return false;
  if (json.contains("fov_y_deg")) {
    if (!json["fov_y_deg"].is_number()) return false;
    camera.fov_y_deg = json["fov_y_deg"].get<double>();
  }
  if (json.contains("ortho_height")) {
    const Json& height = json["ortho_height"];
    if (!height.is_null() && !height.is_number()) return false;
    camera.ortho_height = height.is_null() ? std::nullopt : std::optional(height.get<double>());
  }
  return looks_somewhere(camera);
}

Json to_array(const glm::dvec3& v) { return Json::array({v.x, v.y, v.z}); }

}  // namespace

std::optional<Camera> camera_from_json(std::string_view text, const Camera& base, Text& error) {
  const Json json = Json::parse(text, nullptr, false);
  Camera camera = base;
  if (json.is_object() && read_camera(json, camera)) return camera;
  error = {
      R"(expected {"eye":[x,y,z],"target":[x,y,z],"up":[x,y,z],"fov_y_deg":35,"ortho_height":null})",
      R"({"eye":[x,y,z],"target":[x,y,z],"up":[x,y,z],"fov_y_deg":35,"ortho_height":null} の形で指定してください)"};
  return std::nullopt;
}

std::string camera_to_json(const Camera& camera) {
  Json json;
  json["eye"] = to_array(camera.eye);
  json["target"] = to_array(camera.target);
  json["up"] = to_array(camera.up);
  json["fov_y_deg"] = camera.fov_y_deg;
  json["ortho_height"] = camera.ortho_height ? Json(*camera.ortho_height) : Json(nullptr);
  return json.dump();
}

std::optional<glm::dvec2> parse_pixel(std::string_view text) {
  const std::size_t comma = text.find(',');
  if (comma == std::string_view::npos) return std::nullopt;
  const auto x = parse_double(text.substr(0, comma)), y = parse_double(text.substr(comma + 1));
  if (!x || !y) return std::nullopt;
  return glm::dvec2(*x, *y);
}

}  // namespace ryosen
