// The answers of the practice questions, held to what the polygons alone say.
#include "app/editor/textbook/practice.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>

#include "app/editor/textbook/figures.h"
#include "ryosen/indexed/from_indexed.h"
#include "ryosen/io/formats.h"
#include "ryosen/mesh/circulate.h"
#include "ryosen/mesh/copies.h"
#include "ryosen/mesh/names.h"
#include "ryosen/textbook/forms/all.h"
#include "ryosen/textbook/forms/polygons.h"
#include "tests/support/app/program.h"
#include "tests/support/core/kernel_lists.h"
#include "tests/support/core/long_run.h"
#include "tests/support/core/random_meshes.h"
#include "tests/support/core/shapes.h"

namespace ryosen {
namespace {

int questions() { return test::is_long_run() ? 10'000 : 400; }

using Side = std::pair<std::uint32_t, std::uint32_t>;

// The sides of faces by their ends, from corner lists; what a halfedge is called is all that is taken from the mesh.
class Sides {
 public:
  explicit Sides(const Mesh& mesh) : mesh_(mesh) {
    for (std::uint32_t f = 0; f < mesh.face_slots(); ++f) {
      std::vector<Halfedge> starts{mesh.halfedge(Face(f))};
      for (const Halfedge ring : forms::inner_loops(mesh, Face(f))) starts.push_back(ring);
      for (const Halfedge start : starts) {
        std::vector<std::uint32_t> corners;
        for (const Halfedge h : loop(mesh, start)) corners.push_back(mesh.from(h).index);
        for (std::size_t i = 0; i < corners.size(); ++i) {
          const std::uint32_t a = corners[i], b = corners[(i + 1) % corners.size()];
          face_[{a, b}] = f;
          next_[{a, b}] = {b, corners[(i + 2) % corners.size()]};
          prev_[{b, corners[(i + 2) % corners.size()]}] = {a, b};
        }
      }
    }
    for (std::uint32_t h = 0; h < mesh.halfedge_slots(); ++h) slot_[side(Halfedge(h))] = h;
  }
  Side side(Halfedge h) const { return {mesh_.from(h).index, mesh_.to(h).index}; }
  std::uint32_t slot(Side s) const { return slot_.at(s); }
  std::int64_t face(Side s) const { return face_.contains(s) ? std::int64_t(face_.at(s)) : -1; }
  // Outside it turns about the end, over the faces there.
  Side next(Side s) const {
    if (face_.contains(s)) return next_.at(s);
    Side t{s.second, s.first};
    while (face_.contains(t)) t = {prev_.at(t).second, prev_.at(t).first};
    return t;
  }
  Side prev(Side s) const {
    if (face_.contains(s)) return prev_.at(s);
    for (const auto& [of, number] : slot_)
      if (!face_.contains(of) && next(of) == s) return of;
    return {};
  }
  std::size_t valence(std::uint32_t v) const {
    return static_cast<std::size_t>(
        std::count_if(slot_.begin(), slot_.end(), [&](const auto& s) { return s.first.first == v; }));
  }

 private:
  const Mesh& mesh_;
  std::map<Side, std::uint32_t> face_, slot_;
  std::map<Side, Side> next_, prev_;
};

std::string h_name(std::uint32_t slot) { return "h" + std::to_string(slot); }

std::vector<Mesh> meshes_of_figures() {
  std::vector<Mesh> meshes;
  for (const Figure& figure : figures()) {
    if (figure.id == "000-11") continue;  // the largest: as the others
    Mesh mesh = from_indexed(std::move(mesh_of_figure(figure)->mesh));
    if (!mesh.has_copies()) meshes.push_back(std::move(mesh));
  }
  return meshes;
}

TEST(practice, next_twin_and_valence_are_what_the_polygons_say) {
  int asked = 0;  // of each kind
  for (const Mesh& mesh : meshes_of_figures()) {
    const Sides sides(mesh);
    for (int seed = 0; seed < questions() / 10; ++seed) {
      const auto n = static_cast<std::uint64_t>(seed);
      const Question next = make_question(mesh, QuestionKind::next, n),
                     twin = make_question(mesh, QuestionKind::twin, n),
                     valence = make_question(mesh, QuestionKind::valence, n);
      const Side side = sides.side(next.about.halfedge());
      EXPECT_EQ(solve(mesh, next).answers[0], h_name(sides.slot(sides.next(side)))) << next.asks.en;
      const auto [a, b] = sides.side(twin.about.halfedge());
      EXPECT_EQ(solve(mesh, twin).answers[0], h_name(sides.slot({b, a}))) << twin.asks.en;
      EXPECT_EQ(solve(mesh, valence).answers, std::vector{std::to_string(sides.valence(valence.about.index))});
      ++asked;
    }
  }
  EXPECT_GE(asked, questions());
}

// At a point with copies the edges of all are counted, as every form counts them from the list of faces.
TEST(practice, valence_is_that_of_the_point) {
  const test::Polygons cones = [] {
    test::Polygons faces;
    for (std::uint32_t i = 0; i < 6; ++i) {
      faces.push_back({0, 1 + i, 1 + (i + 1) % 6});
      faces.push_back({0, 7 + i, 7 + (i + 1) % 6});
    }
    return faces;
  }();
  int at_copies = 0, at_sheets = 0, asked = 0;
  std::vector<test::Polygons> lists{cones, test::two_tetrahedra_on_an_edge(), test::fin(), test::bow_tie()};
  for (std::uint64_t seed = 1; static_cast<int>(lists.size()) < questions() / 100; ++seed) {
    test::SeededMesh random = test::seeded_mesh(seed);
    const Mesh mesh = test::make_mesh(random.faces, random.points);
    const bool holds_all = mesh.live().faces == random.faces.size() && !mesh.has_rings();
    if (!random.faces.empty() && holds_all) lists.push_back(std::move(random.faces));
  }
  for (const test::Polygons& faces : lists) {
    const Mesh mesh = test::make_mesh(faces);
    std::map<std::uint32_t, std::set<std::uint32_t>> ends;
    for (const std::vector<std::uint32_t>& face : faces)
      for (std::size_t i = 0; i < face.size(); ++i) {
        ends[face[i]].insert(face[(i + 1) % face.size()]);
        ends[face[(i + 1) % face.size()]].insert(face[i]);
      }
    for (std::uint64_t seed = 0; seed < 100; ++seed) {
      const Question question = make_question(mesh, QuestionKind::valence, seed);
      const Vertex v = question.about.vertex();
      const Solution solution = solve(mesh, question);
      EXPECT_EQ(solution.answers[0], std::to_string(ends[mesh.copy_point(v).index].size())) << question.asks.en;
      EXPECT_EQ(solution.witnesses.size(), ends[mesh.copy_point(v).index].size());
      EXPECT_EQ(question.asks.en.find("copies") != std::string::npos, has_copies(mesh, v));
      ++asked;
      at_copies += has_copies(mesh, v) ? 1 : 0;
      at_sheets += question.asks.en.find("count once") != std::string::npos ? 1 : 0;
    }
  }
  EXPECT_GE(asked, questions());
  EXPECT_GT(at_copies, 50);
  EXPECT_GT(at_sheets, 10);
}

// However many edges meet there, the right number is among those to choose from, and so is a wrong one past it.
TEST(practice, numbers_to_choose_from_reach_past_the_right_one) {
  for (const std::uint32_t spokes : {3u, 12u, 20u, 39u, 40u, 100u, 1009u}) {
    const Mesh mesh = test::make_mesh(test::closed_fan(spokes));
    Question question;
    question.kind = QuestionKind::valence;
    question.about = Vertex(0);
    const std::vector<AnswerChoice> choices = answer_choices(question, solve(mesh, question));
    EXPECT_LT(std::stoul(choices.front().word), spokes);
    EXPECT_GT(std::stoul(choices.back().word), spokes);
    EXPECT_LE(choices.size(), 43u);
    EXPECT_EQ(std::count_if(choices.begin(), choices.end(),
                            [&](const AnswerChoice& choice) { return choice.word == std::to_string(spokes); }),
              1)
        << spokes;
  }
}

// What a field must hold; nothing where any of several would do, which is then looked at.
std::optional<std::string> expected_link(const Mesh& mesh, const Sides& sides, const Question& question,
                                         const std::string& answer) {
  const bool winged = question.form == "winged_edge",
             inner_only = forms::find_form(question.form)->halfedges == forms::HalfedgesOf::faces;
  const std::string& key = question.field;
  const auto name = [&](char kind, std::int64_t slot) { return slot < 0 ? "none" : kind + std::to_string(slot); };
  const auto half = [&](Side s) {
    return inner_only && sides.face(s) < 0 ? std::string("none") : h_name(sides.slot(s));
  };
  const auto about_side = [&](Side s) -> std::optional<std::string> {
    const Side t{s.second, s.first};
    if (key == "from") return name('v', s.first);
    if (key == "to") return name('v', s.second);
    if (key == "next") return half(sides.next(s));
    if (key == "prev") return half(sides.prev(s));
    if (key == "twin") return half(t);
    if (key == "face") return name('f', sides.face(s));
    if (key == "edge") return name('e', sides.slot(s) / 2);
    if (key == "left") return winged ? name('f', sides.face(s)) : half(s);
    if (key == "right") return winged ? name('f', sides.face(t)) : half(t);
    const Side of = key.starts_with("left") ? s : t;
    if (sides.face(of) < 0) return "none";
    return name('e', sides.slot(key.ends_with("next") ? sides.next(of) : sides.prev(of)) / 2);
  };
  if (question.about.kind == Element::Kind::halfedge) return about_side(sides.side(question.about.halfedge()));
  if (question.about.kind == Element::Kind::edge) {
    // Which way the record runs is the form's choice: both ways are allowed, and the tables of forms_test fix one.
    const Side s = sides.side(halfedge(question.about.edge())), t{s.second, s.first};
    const auto one = about_side(s), other = about_side(t);
    return answer == *other ? other : one;
  }
  // One of several that begin there, or lie there.
  const std::uint32_t i = question.about.index, to = static_cast<std::uint32_t>(std::stoul("0" + answer.substr(1)));
  bool fits = answer == "none" && question.about.kind == Element::Kind::vertex && sides.valence(i) == 0;
  const auto at_vertex = [&](Side s) { return s.first == i; };
  const auto in_face = [&](Side s) { return sides.face(s) == std::int64_t(i); };
  const bool of_vertex = question.about.kind == Element::Kind::vertex;
  for (std::uint32_t h = 0; h < mesh.halfedge_slots(); ++h) {
    const Side s = sides.side(Halfedge(h));
    if (of_vertex ? !at_vertex(s) : !in_face(s)) continue;
    fits |= answer == h_name(h) || (answer[0] == 'e' && to == h / 2) ||
            (answer[0] == 'f' && sides.face(s) == std::int64_t(to));
  }
  return fits ? std::optional(answer) : std::nullopt;
}

TEST(practice, records_are_what_the_polygons_say) {
  std::set<std::string> forms_asked;
  int asked = 0;
  for (const Mesh& mesh : meshes_of_figures()) {
    const Sides sides(mesh);
    for (int seed = 0; seed < questions() / 10; ++seed) {
      const Question question = make_question(mesh, QuestionKind::record, static_cast<std::uint64_t>(seed));
      forms_asked.insert(question.form);
      const Solution solution = solve(mesh, question);
      EXPECT_EQ(solution.answers[0], expected_link(mesh, sides, question, solution.answers[0]).value_or("?"))
          << question.asks.en;
      EXPECT_TRUE(is_right(mesh, solution, solution.answers[0]));
      EXPECT_FALSE(is_right(mesh, solution, "h99999"));
      ++asked;
    }
  }
  EXPECT_GE(asked, questions());
  EXPECT_GE(forms_asked.size(), 9u);
}

// "swap 3-7@f2" as the oracle has it.
oracle::Operation operation_of(const std::string& line) {
  oracle::Operation operation;
  operation.kind = line.starts_with("swap") ? oracle::Kind::swap : oracle::Kind::collapse;
  const std::size_t blank = line.find(' '), dash = line.find('-', blank), at = line.find("@f");
  operation.from = std::stoi(line.substr(blank + 1));
  operation.to = std::stoi(line.substr(dash + 1));
  if (at != line.npos) operation.face = std::stoi(line.substr(at + 2));
  return operation;
}

TEST(practice, verdicts_are_those_of_doing_it_on_the_polygons) {
  int legal = 0, asked = 0;  // of those that the oracle can judge
  for (std::uint64_t seed = 1; asked < questions(); ++seed) {
    RandomMesh random = random_mesh(seed);
    const oracle::PolygonList list = oracle::polygon_list(random.points, std::move(random.faces));
    const Mesh mesh = test::kernel_mesh(list, seed);
    if (mesh.live().edges == 0) continue;
    const oracle::Judge judge(oracle::read_copies(list));
    for (std::uint64_t n = 0; n < 20; ++n) {
      const Question question = make_question(mesh, QuestionKind::legal, n);
      if (question.line.starts_with("collapse h") || question.line.find('~') != std::string::npos) continue;
      const Solution solution = solve(mesh, question);
      const bool may = judge.legal(operation_of(question.line));
      legal += may ? 1 : 0;
      ++asked;
      EXPECT_EQ(is_right(mesh, solution, "yes"), may) << "seed " << seed << ' ' << question.line;
      EXPECT_FALSE(solution.answers.empty());
      EXPECT_TRUE(may || !solution.witnesses.empty()) << question.line;
      // What may be chosen holds every right answer, and each of the others is called wrong.
      const std::vector<AnswerChoice> choices = answer_choices(question, solution);
      for (const std::string& answer : solution.answers)
        if (answer != "legal" && answer != "はい") {
          EXPECT_TRUE(std::any_of(choices.begin(), choices.end(), [&](const auto& c) { return c.word == answer; }))
              << question.line << ' ' << answer;
        }
      for (const AnswerChoice& choice : choices)
        EXPECT_EQ(is_right(mesh, solution, choice.word),
                  std::count(solution.answers.begin(), solution.answers.end(), choice.word) > 0);
    }
  }
  EXPECT_GT(legal, asked / 10);
  EXPECT_LT(legal, asked * 9 / 10);
}

TEST(practice, has_no_english_word_in_a_japanese_question_or_verdict) {
  const Mesh mesh = from_indexed(std::move(mesh_of_figure(*find_figure("003-image41"))->mesh));
  bool has_legal = false;
  for (std::uint64_t seed = 0; seed < 50; ++seed) {
    const Question question = make_question(mesh, QuestionKind::legal, seed);
    EXPECT_NE(question.asks.ja.find("「はい」か"), std::string::npos) << question.asks.ja;
    const Solution solution = solve(mesh, question);
    const Text verdict = verdict_on_wrong(solution);
    if (!is_right(mesh, solution, "yes")) continue;
    has_legal = true;
    EXPECT_EQ(verdict.ja, "違います。正解は「はい」です。");
    EXPECT_EQ(verdict.en, "No, the right answer is yes.");
    EXPECT_NE(why_no_answer(mesh, question, solution, "perhaps").ja.find("「はい」か"), std::string::npos);
  }
  EXPECT_TRUE(has_legal);
}

TEST(practice, takes_names_and_slots_and_never_a_wrong_one) {
  const Mesh mesh = from_indexed(std::move(mesh_of_figure(*find_figure("003-image41"))->mesh));
  for (std::uint64_t seed = 0; seed < 50; ++seed) {
    const Question question = make_question(mesh, QuestionKind::twin, seed);
    const Solution solution = solve(mesh, question);
    const Halfedge right = twin(question.about.halfedge());
    for (std::uint32_t i = 0; i < mesh.halfedge_slots(); ++i) {
      const Halfedge h(i);
      EXPECT_EQ(is_right(mesh, solution, slot_name(h)), h == right);
      const std::string name = std::to_string(mesh.from(h).index) + "-" + std::to_string(mesh.to(h).index);
      EXPECT_EQ(is_right(mesh, solution, name), h == right) << name;
    }
    for (const char* const nonsense : {"", "x", "-", "h", "e0", "yes", "0"})
      EXPECT_FALSE(is_right(mesh, solution, nonsense));
  }
}

// Three faces share the edge 0-1, so that its name alone means three edges.
TEST(practice, a_name_of_several_elements_is_in_doubt) {
  const Mesh mesh = from_indexed(read_mesh_file(test::asset("three_tri_edge.off"))->mesh);
  int doubted = 0;
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    const Solution solution = solve(mesh, make_question(mesh, QuestionKind::twin, seed));
    const Halfedge right = solution.element->halfedge();
    const std::string name =
        std::to_string(point(mesh, mesh.from(right)).index) + "-" + std::to_string(point(mesh, mesh.to(right)).index);
    EXPECT_TRUE(is_right(mesh, solution, slot_name(right)));
    EXPECT_TRUE(doubt_about(mesh, solution, slot_name(right)).en.empty());
    const bool is_doubted = !doubt_about(mesh, solution, name).en.empty();
    EXPECT_NE(is_right(mesh, solution, name), is_doubted) << name;
    doubted += is_doubted;
  }
  EXPECT_GT(doubted, 0);
  const test::ProgramRun run = test::run_program(
      {"practice", test::asset("three_tri_edge.off"), "--kind", "twin", "--count", "60", "--answer", "0-1", "--json"});
  EXPECT_EQ(run.exit_code, 2);
  EXPECT_EQ(run.lines().back()["messages"][0]["code"], "name_ambiguous");
}

TEST(practice, command_judges_answers) {
  const test::Json asked = test::run_program({"practice", "--seed", "5", "--kind", "next", "--json"}).line();
  EXPECT_EQ(asked["kind"], "next");
  EXPECT_TRUE(asked["right"].is_null());
  const std::string answer = asked["answers"][0];
  const auto run = [&](const std::string& word) {
    return test::run_program({"practice", "--seed", "5", "--kind", "next", "--json", "--answer", word});
  };
  EXPECT_EQ(run(answer).exit_code, 0);
  EXPECT_EQ(run(answer).line()["right"], true);
  EXPECT_EQ(run("h777").exit_code, 1);
  EXPECT_EQ(run("h777").line()["right"], false);
  const auto lines = test::run_program({"practice", test::asset("torus.off"), "--count", "50", "--json"}).lines();
  ASSERT_EQ(lines.size(), 50u);
  std::set<std::string> kinds;
  for (const test::Json& line : lines) kinds.insert(line["kind"]);
  EXPECT_EQ(kinds.size(), question_kinds().size());
  EXPECT_EQ(test::run_program({"practice", "--kind", "x"}).exit_code, 2);
  EXPECT_EQ(test::run_program({"practice", "--seed", "-1"}).exit_code, 2);
  const test::ProgramRun none = test::run_program({"practice", "--count", "0", "--json"});
  EXPECT_EQ(none.exit_code, 2);
  EXPECT_NE(none.err.find("1 to 100000"), std::string::npos) << none.err;
  EXPECT_EQ(test::run_program({"practice", test::asset("isolated_vertex.obj")}).exit_code, 0);
}

}  // namespace
}  // namespace ryosen
