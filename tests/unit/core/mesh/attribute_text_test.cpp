#include "ryosen/mesh/attribute_text.h"

#include <gtest/gtest.h>

#include <sstream>

#include "ryosen/base/enum_table.h"
#include "tests/support/core/random_meshes.h"

namespace ryosen {
namespace {

std::vector<std::string> split(const std::string& line) {
  std::istringstream in(line);
  std::vector<std::string> words;
  for (std::string word; in >> word;) words.push_back(word);
  return words;
}

ReadAttribute read(const std::vector<std::string>& words) {
  return read_attribute(std::vector<std::string_view>(words.begin(), words.end()));
}

TEST(attribute_text, the_usual_rule_and_zeros_stand_for_what_is_missing) {
  const ReadAttribute load = read({"vertex.load", "float"});
  ASSERT_FALSE(load.fault);
  EXPECT_EQ(words_of(load.column), "vertex.load float blend 0");
  EXPECT_EQ(words_of(read({"face.tag", "uint8x3"}).column), "face.tag ucharx3 first 0 0 0");
  EXPECT_EQ(words_of(read({"corner.fixed", "bool", "greatest", "true"}).column), "corner.fixed bool greatest true");
  EXPECT_EQ(words_of(read({"edge.a.b", "float64", "sum", "-0"}).column), "edge.a.b double sum -0");
  EXPECT_EQ(short_name(load.column), "load");
}

TEST(attribute_text, every_type_and_rule_reads_back) {
  for (std::size_t scalar = 0; scalar < enum_count<Scalar>; ++scalar)
    for (const std::uint32_t count : {1u, 2u, 7u, most_numbers_in_a_value})
      for (const ValueRule rule : {ValueRule::blend, ValueRule::first, ValueRule::greatest, ValueRule::sum}) {
        AttributeColumn column{"face.x", ElementKind::face, {static_cast<Scalar>(scalar), count}, rule, {}, {}};
        column.fill.assign(column.words(), 0);
        const ReadAttribute again = read(split(words_of(column)));
        ASSERT_FALSE(again.fault) << words_of(column);
        EXPECT_TRUE(again.column == column) << words_of(column);
      }
}

// Words that are almost right, and bytes that are not.
TEST(attribute_text, garbage_has_a_fault_or_reads_back) {
  Dice dice(11);
  const std::vector<std::string> pieces{"vertex.a",
                                        "edge.",
                                        ".x",
                                        "corner.c",
                                        "face.f",
                                        "pool.p",
                                        "float",
                                        "floatx",
                                        "x3",
                                        "floatx3",
                                        "floatx0",
                                        "floatx1024",
                                        "floatx1025",
                                        "boolx-1",
                                        "own",
                                        "blend",
                                        "sum",
                                        "true",
                                        "0",
                                        "-1",
                                        "1e999",
                                        "nan",
                                        "inf",
                                        "256",
                                        "1.5",
                                        "",
                                        "\xff",
                                        "99999999999999999999",
                                        "doublex18446744073709551617",
                                        "0x10",
                                        "+1",
                                        "1e3"};
  int readable = 0;
  for (int i = 0; i < 200000; ++i) {
    std::vector<std::string> words;
    for (int n = dice.below(7); n > 0; --n)
      words.push_back(pieces[static_cast<std::size_t>(dice.below(static_cast<int>(pieces.size())))]);
    if (dice.one_in(2)) words.insert(words.begin(), {"vertex.a", "float"});
    const ReadAttribute found = read(words);
    if (found.fault) {
      EXPECT_FALSE(found.fault->rest.en.empty() || found.fault->rest.ja.empty());
      continue;
    }
    ++readable;
    const ReadAttribute again = read(split(words_of(found.column)));
    ASSERT_FALSE(again.fault) << words_of(found.column);
    EXPECT_EQ(words_of(again.column), words_of(found.column));
  }
  EXPECT_GT(readable, 1000);
}

TEST(attribute_text, names_begin_with_their_element) {
  EXPECT_EQ(element_of_attribute("vertex.x"), ElementKind::vertex);
  EXPECT_EQ(element_of_attribute("corner.\xe8\x8d\xb7"), ElementKind::corner);
  for (const char* name : {"", "x", "vertex", "vertex.", "vertexx", "pool.x", "vertex.a b", "face.\n", "Vertex.x"})
    EXPECT_FALSE(element_of_attribute(name)) << name;
}

}  // namespace
}  // namespace ryosen
