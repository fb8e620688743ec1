// The edges of faces in the picture of a session: there, or not.
#include <gtest/gtest.h>

#include <set>

#include "app/ui/headless.h"
#include "tests/support/app/program.h"

namespace ryosen {
namespace {

// Three faces of a cube.
TEST(wire, goes_with_its_key_and_comes_back) {
  Session session(Document::open(test::asset("cube.obj")).value());
  const auto headless = Headless::make({.backend = Backend::osmesa, .size = {320, 240}}).value();
  headless->place_view(session);
  const auto picture = [&](const char* line) {
    EXPECT_TRUE(session.run(line).done()) << line;
    return headless->picture(session);
  };
  const auto colours_amid = [](const Image& image) {
    std::set<Rgba> all;
    for (int y = 90; y < 150; ++y)
      for (int x = 130; x < 190; ++x) all.insert(image.at(x, y));
    return all.size();
  };
  const Image with = picture("view iso"), without = picture("key W");
  EXPECT_GT(colours_amid(with), 20u);
  EXPECT_LE(colours_amid(without), 6u) << "one for each triangle";
  EXPECT_TRUE(picture("wire on") == with);
  EXPECT_TRUE(picture("wire toggle") == without);
  headless->forget();
  EXPECT_TRUE(picture("wire off") == without);
}

}  // namespace
}  // namespace ryosen
