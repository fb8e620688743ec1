#include "app/editor/shown/gesturing.h"

#include <gtest/gtest.h>

#include "app/editor/session/session.h"
#include "tests/support/app/program.h"

namespace ryosen {
namespace {

std::unique_ptr<Document> torus_document() { return std::move(Document::open(test::asset("torus.off"))).value(); }

// A gesture that ends without a movement does what its command does with what is selected.
void expect_as_command(const std::string& selected, const std::string& gesture, const std::string& command) {
  Session by_hand(torus_document()), by_line(torus_document());
  for (Session* session : {&by_hand, &by_line}) ASSERT_TRUE(session->run(selected).done()) << selected;
  ASSERT_TRUE(by_hand.run(gesture).done()) << selected;
  const Outcome ended = by_hand.gesturing.end(), run = by_line.run(command);
  ASSERT_TRUE(ended.done() && run.done()) << ended.sentence.en << run.sentence.en;
  EXPECT_EQ(ended.performed, run.performed) << selected;
  EXPECT_EQ(by_hand.mesh().hash(), by_line.mesh().hash()) << selected;
  EXPECT_EQ(by_hand.document().history().size(), 1u);
}

TEST(gesturing, extrudes_an_edge_to_the_side_of_its_line) {
  const std::uint32_t edges = torus_document()->mesh().edge_slots();
  for (std::uint32_t e = 0; e < edges; e += 7)
    expect_as_command("select e" + std::to_string(e), "gesture extrude", "extrude_edges selected 0");
}

TEST(gesturing, extrudes_splits_and_duplicates_as_the_commands_do) {
  expect_as_command("select f1 f2 f9", "gesture extrude", "extrude selected 0");
  expect_as_command("select e3", "gesture split", "split 0-1");
  expect_as_command("select f1 f2", "gesture duplicate", "duplicate elements=selected by=0,0,0");
}

}  // namespace
}  // namespace ryosen
