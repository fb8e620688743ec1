// The panel of records: what it draws is what the command prints, its links select, and large meshes wait to be asked.
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <functional>
#include <mutex>
#include <optional>
#include <thread>

#include "app/editor/session/session.h"
#include "app/editor/textbook/record_book.h"
#include "ryosen/mesh/names.h"
#include "ryosen/textbook/forms/all.h"
#include "tests/support/app/drawn_text.h"
#include "tests/support/app/laid.h"

namespace ryosen {
namespace {

// Without blanks, and ? for each character that is not ASCII, as DrawnText has it.
std::string as_drawn(std::string_view line) {
  std::string drawn;
  for (const char c : line) {
    if (c == ' ' || (static_cast<unsigned char>(c) & 0xC0) == 0x80) continue;
    drawn += static_cast<unsigned char>(c) < 128 ? c : '?';
  }
  return drawn;
}

class RecordsPanel : public testing::Test, protected test::Laid {
 protected:
  RecordsPanel() : Laid("cube.obj", {1280, 4200}) {}

  void show(const std::string& asset_name) {
    open(asset_name);
    for (const char* const line : {"panel inspector off", "panel forms off", "panel history off", "panel problems off",
                                   "panel pointer off", "panel records on", "columns right 420"})
      ASSERT_TRUE(session.run(line).done()) << line;
    frames(3);
  }
  void select(const std::string& name) {
    ASSERT_TRUE(session.run("select " + name).done()) << name;
    frames(4);
  }
};

TEST_F(RecordsPanel, shows_what_the_command_prints) {
  for (const auto& [file, elements] : {std::pair{"tetrahedron.off", std::vector{"v3", "e2", "h3", "f1"}},
                                       {"two_quads.obj", {"v1", "e1", "h2", "h13", "f0"}},
                                       {"figures/000-4b.obj", {"f8", "h28"}}}) {
    show(file);
    for (const char* const element : elements) {
      select(element);
      const test::DrawnText text(gui);
      const std::string printed = test::run_program({"forms", test::asset(file), "--element", element}).out;
      std::size_t begin = 0, lines = 0;
      while (begin < printed.size()) {
        const std::size_t end = printed.find('\n', begin);
        const std::string line = printed.substr(begin, end - begin);
        begin = end + 1;
        // A heading has the form's name; sentences may be wrapped, which leaves the same letters.
        const std::size_t as = line.find(" as "), source = line.rfind(" (");
        const bool is_heading = !line.starts_with(' ') && as != line.npos;
        const std::string drawn = as_drawn(is_heading ? line.substr(as + 4, source - as - 4) : line);
        EXPECT_GT(text.count(drawn), 0u) << file << ' ' << element << ": " << line;
        ++lines;
      }
      EXPECT_GE(lines, 2 * forms::all_forms().size()) << file << ' ' << element;
    }
  }
}

TEST_F(RecordsPanel, selects_what_a_link_leads_to) {
  show("two_quads.obj");
  select("h2");
  const test::DrawnText text(gui);
  glm::dvec2 place = text.place("nextnexth");
  ASSERT_GT(place.x, 0);
  const Mesh& mesh = session.mesh();
  EXPECT_EQ(text.count(name_of(mesh, Halfedge(2)) + "(h2)"), 1u) << "the title";
  const std::string wanted = slot_name(mesh.next(Halfedge(2)));
  // The link stands behind the two words.
  for (double x = place.x; session.selecting.selection[0] == Element(Halfedge(2)) && x < 1280; x += 8)
    click({x, place.y});
  EXPECT_EQ(session.selecting.selection, (std::vector<Element>{mesh.next(Halfedge(2))})) << wanted;
}

TEST_F(RecordsPanel, follows_an_edit_and_waits_to_be_asked_on_large_meshes) {
  show("two_quads.obj");
  select("f0");
  EXPECT_GT(test::DrawnText(gui).count("v0v1v4v3=0143"), 0u);
  ASSERT_TRUE(session.run("split 0-1").done());
  select("f0");
  EXPECT_GT(test::DrawnText(gui).count("v0v6v1v4v3=06143"), 0u);
  ASSERT_TRUE(session.run("new").done());
  ASSERT_TRUE(session.run("grid columns=320 rows=320").done());
  ASSERT_GT(session.mesh().live().faces, 100'000u);
  select("f0");
  EXPECT_EQ(test::DrawnText(gui).count("v0v"), 0u);
  const glm::dvec2 button = test::DrawnText(gui).place("Buildtheforms");
  ASSERT_GT(button.x, 0);
  click(button);
  frames(3);
  EXPECT_GE(test::DrawnText(gui).count("=0"), 10u);
}

TEST(record_book, builds_beside_the_frames_once_for_a_revision) {
  auto document = Document::open(test::asset("torus.off"));
  ASSERT_TRUE(document);
  RecordBook book;
  EXPECT_FALSE(book.is_of(**document));
  book.ask(**document);
  EXPECT_TRUE(book.is_of(**document));
  book.wait_for(**document);
  ASSERT_TRUE(book.is_ready());
  ASSERT_EQ(book.records().size(), forms::all_forms().size());
  for (const forms::Records& records : book.records()) {
    const auto alone = forms::Records((*document)->mesh(), records.row()).of(Face(5));
    EXPECT_EQ(records.of(Face(5)).fields.size(), alone.fields.size());
  }
}

// Asking never waits, however often the mesh changes meanwhile; what is there in the end is that of the last one.
TEST(record_book, follows_edits_without_waiting) {
  Session session(Document::open(test::asset("stanford_bunny.obj")).value());
  Document* const document = &session.document();
  RecordBook book;
  const auto begin = std::chrono::steady_clock::now();
  book.wait_for(*document);
  const auto whole = std::chrono::steady_clock::now() - begin;
  auto shortest = whole;
  for (int i = 0; i < 5; ++i) {
    ASSERT_TRUE(session.run("split h0").done());
    const auto before = std::chrono::steady_clock::now();
    book.ask(*document);
    shortest = std::min(shortest, std::chrono::steady_clock::now() - before);
    EXPECT_FALSE(book.is_ready());
  }
  EXPECT_LT(shortest, whole / 2) << "it takes a copy of the mesh at most";
  book.wait_for(*document);
  EXPECT_FALSE(book.records()[0].of(Face(document->mesh().face_slots() - 1)).none);
  while (!book.rest()) std::this_thread::yield();
  EXPECT_FALSE(book.is_ready());
  EXPECT_FALSE(book.is_of(*document));
}

// What was built is given back while the next is already asked for.
// What the book does beside the frames stands still while the gate is shut, though not for ever.
struct Gate {
  std::mutex mutex;
  std::condition_variable opened;
  bool is_open = true;
  bool was_waited_for_in_vain = false;

  void set(bool open) {
    const std::lock_guard lock(mutex);
    is_open = open;
    opened.notify_all();
  }
  void pass() {
    std::unique_lock lock(mutex);
    if (!opened.wait_for(lock, std::chrono::seconds(20), [&] { return is_open; })) was_waited_for_in_vain = true;
  }
};

TEST(record_book, asks_without_waiting_for_what_rests) {
  Gate gate;
  Session session(Document::open(test::asset("cube.obj")).value());
  const Document& document = session.document();
  RecordBook book([&](std::function<void()> work) {
    return std::thread([&gate, work = std::move(work)] {
      gate.pass();
      work();
    });
  });
  book.wait_for(document);
  for (int i = 0; i < 2; ++i) {
    gate.set(false);
    ASSERT_TRUE(book.rest());  // what was built is not gone yet
    book.ask(document);
    EXPECT_FALSE(book.is_ready());
    EXPECT_FALSE(book.rest()) << "nor does it wait for what it has just begun";
    book.ask(document);
    gate.set(true);
    book.wait_for(document);
    EXPECT_EQ(book.records().size(), forms::all_forms().size());
  }
  EXPECT_FALSE(gate.was_waited_for_in_vain);
}

}  // namespace
}  // namespace ryosen
