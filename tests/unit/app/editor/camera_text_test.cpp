#include "app/editor/camera_text.h"

#include <gtest/gtest.h>

namespace ryosen {
namespace {

std::string fault(const std::string& json, Language language = Language::english) {
  Text error;
  return camera_from_json(json, {}, error) ? "" : error.in(language);
}

TEST(camera_text, each_fault_has_its_own_sentence) {
  const auto says = [](const std::string& json, const std::string& words) {
    EXPECT_NE(fault(json).find(words), std::string::npos) << json << ": " << fault(json);
    EXPECT_NE(fault(json, Language::japanese), "") << json;
    EXPECT_NE(fault(json, Language::japanese), fault(json)) << json;
  };
  says(R"({"eye":[1,2,3)", "it is not JSON from character 14 on");
  says("", "it is not JSON from character 1 on");
  says("7", "it is 7, expected {");
  says(R"({"eye":[1e999,0,0]})", "a number in it is larger than any");
  says(R"({"eyes":[1,2,3]})", R"(there is no key "eyes"; did you mean eye?)");
  says(R"({"zzzzzzzzz":1})", R"(there is no key "zzzzzzzzz")");
  says(R"({"eye":"front"})", R"(eye is three numbers [x,y,z], not "front")");
  says(R"({"target":[1,2]})", "target is three numbers [x,y,z], not 2");
  says(R"({"up":[0,null,1]})", "in up, null is not a number");
  says(R"({"fov_y_deg":180})", "fov_y_deg is an angle between 0 and 180, not 180");
  says(R"({"fov_y_deg":"wide"})", R"(not "wide")");
  says(R"({"ortho_height":0})", "ortho_height is a positive number, or null for a perspective, not 0");
  says(R"({"eye":[1,2,3],"target":[1,2,3]})", "eye and target are the same point");
  says(R"({"up":[0,0,0]})", "up has no length");
  says(R"({"eye":[0,5,0],"target":[0,0,0],"up":[0,-2,0]})", "up points along the line from eye to target");
}

TEST(camera_text, very_large_and_very_small_cameras_look_somewhere) {
  EXPECT_EQ(fault(R"({"eye":[0,0,1e300],"target":[0,0,0]})"), "");
  EXPECT_EQ(fault(R"({"eye":[0,0,1e-300],"target":[0,0,0],"up":[0,1e-300,0]})"), "");
  EXPECT_EQ(fault(R"({"ortho_height":null,"fov_y_deg":1})"), "");
}

}  // namespace
}  // namespace ryosen
