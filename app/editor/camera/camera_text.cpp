#include "app/editor/camera/camera_text.h"

#include <algorithm>
#include <glm/geometric.hpp>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "app/editor/commands/text/script.h"
#include "ryosen/base/number_text.h"
#include "ryosen/geometry/unit_vector.h"

namespace ryosen {

namespace {

using Json = nlohmann::ordered_json;

const std::vector<std::string> keys{"eye", "target", "up", "fov_y_deg", "ortho_height"};

// Many times what a camera needs. Longer JSON could be nested deeper than the stack is, or have keys without end.
constexpr std::size_t most_bytes = 4096;

constexpr std::string_view form = R"({"eye":[x,y,z],"target":[x,y,z],"up":[x,y,z],"fov_y_deg":35,"ortho_height":null})";

std::string shown(const Json& json) {
  const std::string text = json.dump(-1, ' ', true, Json::error_handler_t::replace);
  return text.size() <= 40 ? text : text.substr(0, 40) + "...";
}

// Reads the keys into a camera and keeps the first fault.
class CameraReader {
 public:
  explicit CameraReader(const Camera& base) : camera_(base) {}

  std::optional<Text> read(const Json& json) {
    for (const auto& [key, value] : json.items())
      if (std::find(keys.begin(), keys.end(), key) == keys.end()) unknown(key);
    for (const auto& [key, vector] : {std::pair("eye", &camera_.eye), {"target", &camera_.target}, {"up", &camera_.up}})
      if (json.contains(key)) read_vector(json[key], key, *vector);
    if (json.contains("fov_y_deg")) read_angle(json["fov_y_deg"]);
    if (json.contains("ortho_height")) read_height(json["ortho_height"]);
    if (!fault_) check_directions();
    return fault_;
  }

  const Camera& camera() const { return camera_; }

 private:
  void fail(std::string en, std::string ja) {
    if (!fault_) fault_ = Text{std::move(en), std::move(ja)};
  }

  void unknown(const std::string& key) {
    const std::string name = shown(Json(key));
    const Text hint = did_you_mean(key, keys);
    fail("there is no key " + name + hint.en, name + " というキーはありません" + hint.ja);
  }

  void read_vector(const Json& json, const std::string& key, glm::dvec3& value) {
    if (!json.is_array())
      return fail(key + " is three numbers [x,y,z], not " + shown(json),
                  key + " は 3 つの数 [x,y,z] です（" + shown(json) + " は使えません）");
    if (json.size() != 3) {
      const std::string count = std::to_string(json.size());
      return fail(key + " is three numbers [x,y,z], not " + count,
                  key + " は 3 つの数 [x,y,z] です（" + count + " 個あります）");
    }
    for (std::size_t axis = 0; axis < 3; ++axis) {
      if (!json[axis].is_number())
        return fail("in " + key + ", " + shown(json[axis]) + " is not a number",
                    key + " の " + shown(json[axis]) + " は数ではありません");
      value[static_cast<int>(axis)] = json[axis].get<double>();
    }
  }

  void read_angle(const Json& json) {
    if (json.is_number()) camera_.fov_y_deg = json.get<double>();
    if (!json.is_number() || !(camera_.fov_y_deg > 0 && camera_.fov_y_deg < 180))
      fail("fov_y_deg is an angle between 0 and 180, not " + shown(json),
           "fov_y_deg は 0 より大きく 180 より小さい角度です（" + shown(json) + " は使えません）");
  }

  void read_height(const Json& json) {
    camera_.ortho_height = json.is_number() ? std::optional(json.get<double>()) : std::nullopt;
    if (!json.is_null() && !(camera_.ortho_height > 0.0))
      fail("ortho_height is a positive number, or null for a perspective, not " + shown(json),
           "ortho_height は正の数、または null（透視投影）です（" + shown(json) + " は使えません）");
  }

  void check_directions() {
    if (camera_.eye == camera_.target)
      return fail("eye and target are the same point, so it looks nowhere",
                  "eye と target が同じ点なので、視線の向きが決まりません");
    if (camera_.up == glm::dvec3(0)) return fail("up has no length", "up の長さが 0 です");
    constexpr double least_sine = 1e-12;
    if (!(glm::length(glm::cross(unit_vector(camera_.target - camera_.eye), unit_vector(camera_.up))) > least_sine))
      fail("up points along the line from eye to target, so no side is up",
           "up が eye から target への向きと平行なので、上の向きが決まりません");
  }

  Camera camera_;
  std::optional<Text> fault_;
};

Text not_json(const Json::exception& error) {
  const std::string en = ", expected " + std::string(form), ja = "。" + std::string(form) + " の形で指定してください";
  const auto* const place = dynamic_cast<const Json::parse_error*>(&error);
  if (!place) return {"a number in it is larger than any this program knows" + en, "大きすぎる数があります" + ja};
  const std::string byte = std::to_string(place->byte);
  return {"it is not JSON from character " + byte + " on" + en, byte + " 文字目から JSON として読めません" + ja};
}

}  // namespace

std::optional<Camera> camera_from_json(std::string_view text, const Camera& base, Text& error) {
  if (text.size() > most_bytes) {
    const std::string most = std::to_string(most_bytes);
    error = {"it is longer than " + most + " characters, expected " + std::string(form),
             most + " 文字を超えています。" + std::string(form) + " の形で指定してください"};
    return std::nullopt;
  }
  CameraReader reader(base);
  try {
    const Json json = Json::parse(text);
    if (json.is_object()) {
      const std::optional<Text> fault = reader.read(json);
      if (!fault) return reader.camera();
      error = *fault;
    } else {
      error = {"it is " + shown(json) + ", expected " + std::string(form),
               shown(json) + " は使えません。" + std::string(form) + " の形で指定してください"};
    }
  } catch (const Json::exception& wrong) {
    error = not_json(wrong);
  }
  return std::nullopt;
}

std::optional<glm::dvec2> parse_pixel(std::string_view text) {
  const std::size_t comma = text.find(',');
  if (comma == std::string_view::npos) return std::nullopt;
  const auto x = parse_double(text.substr(0, comma)), y = parse_double(text.substr(comma + 1));
  if (!x || !y) return std::nullopt;
  return glm::dvec2(*x, *y);
}

std::string format_pixel(glm::dvec2 pixel) { return format_double(pixel.x) + "," + format_double(pixel.y); }

}  // namespace ryosen
