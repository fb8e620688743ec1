#include "ryosen/io/xyz.h"

#include "tests/unit/core/io/io_helpers.h"

namespace ryosen {
namespace {

using io_test::read_refused;
using io_test::read_sound;

TEST(xyz_read, numbers_stand_apart_by_blanks_commas_or_semicolons) {
  const std::vector<glm::dvec3> points = {{1, 2.5, -3}, {4, 5, 6e-2}};
  for (const char* text :
       {"1 2.5 -3\n4 5 6e-2\n", "1,2.5,-3\n4,5,6e-2\n", "1;2.5;-3\n4;5;6e-2\n", "1, 2.5, -3\n4 ,5 ,\t6e-2\n",
        "1;2.5;-3;\n4; 5; 6e-2 ;\n", " 1,2.5,-3,\r\n\r\n 4,5,6e-2 # c, d; e\r\n", "1 2.5 -3\n4;5;6e-2\n",
        "+1,2.5,-3\n4,5,6e-2"}) {
    const MeshFile file = read_sound("xyz", text);
    EXPECT_EQ(file.mesh.positions, points) << text;
    EXPECT_TRUE(file.messages.empty()) << text;
    EXPECT_EQ(looks_like_xyz(text, std::string_view(text).size()), Likeness::maybe) << text;
  }
}

TEST(xyz_read, further_numbers_are_left_out_with_a_warning) {
  for (const char* text : {"1 2 3 255 0 0\n", "1,2,3,255,0,0\n", "1;2;3;255\n", "1, 2, 3, name\n"}) {
    const MeshFile file = read_sound("xyz", text);
    EXPECT_EQ(file.mesh.positions, (std::vector<glm::dvec3>{{1, 2, 3}})) << text;
    ASSERT_EQ(file.messages.size(), 1u) << text;
    EXPECT_EQ(file.messages[0].code, "extra_values");
    EXPECT_EQ(file.messages[0].line, 1u);
  }
}

TEST(xyz_read, decimal_commas_are_refused_with_their_place) {
  struct Case {
    const char* text;
    std::uint64_t line, column;
  };
  for (const Case& c : {Case{"1;2;3\n1,5;2,5;3,5\n", 2, 1},
                        {"1;2,5;3\n", 1, 3},
                        {"1,5 2,5 3,5\n", 1, 3},
                        {"0;0;1,25\n", 1, 5},
                        {"1;2;3;4,5\n", 1, 7},
                        {"-1,5;2;3\n", 1, 1}}) {
    const Message message = read_refused("xyz", c.text).message;
    EXPECT_EQ(message.code, "unreadable_number") << c.text;
    EXPECT_EQ(message.line, c.line) << c.text;
    EXPECT_EQ(message.column, c.column) << c.text;
    EXPECT_NE(message.text.en.find("decimal comma"), std::string::npos) << message.text.en;
    EXPECT_NE(message.text.ja.find("小数点"), std::string::npos) << message.text.ja;
  }
}

TEST(xyz_read, too_few_numbers_and_other_words_are_errors) {
  for (const auto& [text, code] : {std::pair{"1,2\n", "missing_number"},
                                   {"1;2;\n", "missing_number"},
                                   {"1,,3\n", "missing_number"},
                                   {"1 2\n", "missing_number"},
                                   {",1,2,3\n", "missing_number"},
                                   {"x,y,z\n", "unreadable_number"},
                                   {"1,2,x\n", "unreadable_number"},
                                   {"1,2 3\n", "unreadable_number"},
                                   {"1:2:3\n", "unreadable_number"},
                                   {";\n", "missing_number"},
                                   {",,,\n", "missing_number"}}) {
    const Failure failure = read_refused("xyz", text);
    EXPECT_EQ(failure.message.code, code) << text;
    EXPECT_EQ(failure.message.line, 1u) << text;
    EXPECT_EQ(looks_like_xyz(text, std::string_view(text).size()), Likeness::no) << text;
  }
  EXPECT_EQ(read_sound("xyz", "").mesh.positions.size(), 0u);
}

}  // namespace
}  // namespace ryosen
