#include "app/editor/camera/camera_text.h"

#include <gtest/gtest.h>

#include <chrono>

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

// The parser keeps its place in memory, but a fault prints what it found by calling itself, and keys are told apart one
// by one.
TEST(camera_text, deep_and_long_ones_are_refused_at_once) {
  const auto deep = [](const std::string& before, const std::string& open, const std::string& close,
                       std::size_t depth) {
    std::string json = before;
    for (std::size_t i = 0; i < depth; ++i) json += open;
    for (std::size_t i = 0; i < depth; ++i) json += close;
    return json + (before.empty() ? "" : "}");
  };
  const auto start = std::chrono::steady_clock::now();
  for (const std::size_t depth : {10000u, 1000000u}) {
    for (const std::string& json :
         {deep("", "[", "]", depth), deep("{\"up\":", "[", "]", depth), deep("{\"up\":", "{\"a\":", "}", depth),
          deep("{\"eye\":[", "[", "]", depth), std::string(depth, '[')})
      EXPECT_NE(fault(json).find("it is longer than 4096 characters"), std::string::npos) << fault(json);
  }
  std::string keys;
  for (int i = 0; i < 200000; ++i) keys += (i > 0 ? ",\"k" : "\"k") + std::to_string(i) + "\":1";
  EXPECT_NE(fault("{" + keys + "}").find("it is longer"), std::string::npos);
  EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(5));
  EXPECT_NE(fault(deep("", "[", "]", 2000)).find("it is [[[["), std::string::npos) << "short ones say what they are";
  EXPECT_EQ(fault("{\"fov_y_deg\":40" + std::string(3000, ' ') + "}"), "");
}

TEST(camera_text, very_large_and_very_small_cameras_look_somewhere) {
  EXPECT_EQ(fault(R"({"eye":[0,0,1e300],"target":[0,0,0]})"), "");
  EXPECT_EQ(fault(R"({"eye":[0,0,1e-300],"target":[0,0,0],"up":[0,1e-300,0]})"), "");
  EXPECT_EQ(fault(R"({"ortho_height":null,"fov_y_deg":1})"), "");
}

}  // namespace
}  // namespace ryosen
