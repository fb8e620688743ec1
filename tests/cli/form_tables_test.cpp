// The records of every element in every form, held to tables that were written from the faces of the mesh:
// tests/data/forms, laid out as the source texts do it.
//
//   mesh FILE                      in assets
//   form ID
//    none | SENTENCE               it cannot hold the mesh
//    KIND | -                      it stores nothing of such an element
//    KIND | KEY: WORD | ...        else the columns, KEY[] for a list; and a row for each element:
//     NAME | CELL | ...            a link and what is stored for it: f3 = 3; several with commas; a place: 0.0 1.0 2.0
//     NAME | -                     it has no record of this one
#include <gtest/gtest.h>

#include <fstream>
#include <map>
#include <set>
#include <sstream>

#include "tests/support/app/program.h"

namespace ryosen::test {
namespace {

std::vector<std::string> parts(std::string_view line, std::string_view between) {
  std::vector<std::string> found;
  for (std::size_t end; (end = line.find(between)) != line.npos; line.remove_prefix(end + between.size()))
    found.emplace_back(line.substr(0, end));
  found.emplace_back(line);
  return found;
}

std::string trimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(' ');
  return first == text.npos ? std::string() : std::string(text.substr(first));
}

struct Expected {
  Json fields, words = Json::object(), stored = Json::object();
};
using Records = std::map<std::pair<std::string, std::string>, Expected>;  // by form and element

Json number_or_null(const std::string& text) { return text == "none" ? Json() : Json::parse(text); }

// One value of a cell and what is stored for it.
std::pair<Json, Json> value_of(const std::string& text) {
  const std::vector<std::string> sides = parts(text, " = ");
  if (sides.size() == 2) return {sides[0] == "none" ? Json() : Json(sides[0]), number_or_null(sides[1])};
  Json place = Json::array();
  for (const std::string& number : parts(text, " ")) place.push_back(Json::parse(number));
  return {place, place};
}

void put_cell(Expected& record, const std::string& head, const std::string& cell) {
  const std::size_t colon = head.find(": ");
  std::string key = head.substr(0, colon);
  bool is_list = key == "positions";
  if (key.ends_with("[]")) {
    is_list = true;
    key.resize(key.size() - 2);
  }
  record.words[key] = head.substr(colon + 2);
  if (!is_list) {
    std::tie(record.fields[key], record.stored[key]) = value_of(cell);
    return;
  }
  record.fields[key] = record.stored[key] = Json::array();
  if (cell == "empty") return;
  for (const std::string& one : parts(cell, ", ")) {
    const auto [link, stored] = value_of(one);
    record.fields[key].push_back(link);
    record.stored[key].push_back(stored);
  }
}

class Table {
 public:
  explicit Table(const std::string& name) {
    std::ifstream in(asset("../tests/data/forms/" + name + ".txt"));
    for (std::string line; std::getline(in, line);) read(line);
  }
  std::string mesh;
  Records records;
  std::map<std::string, std::string> sentences;       // of forms that cannot hold the mesh
  std::set<std::pair<std::string, char>> nothing_of;  // form, first letter of the kind

 private:
  void read(const std::string& line) {
    const std::vector<std::string> cells = parts(trimmed(line), " | ");
    if (line.starts_with("mesh ")) {
      mesh = line.substr(5);
    } else if (line.starts_with("form ")) {
      form_ = line.substr(5);
    } else if (line.starts_with("  ")) {
      Expected record;
      if (cells[1] != "-") {
        ASSERT_EQ(cells.size(), heads_.size()) << line;
        for (std::size_t i = 1; i < cells.size(); ++i) put_cell(record, heads_[i], cells[i]);
      }
      records[{form_, cells[0]}] = record;
    } else if (cells[0] == "none") {
      sentences[form_] = cells[1];
    } else if (cells[1] == "-") {
      nothing_of.insert({form_, cells[0][0]});
    } else {
      heads_ = cells;
    }
  }

  std::string form_;
  std::vector<std::string> heads_;
};

class FormTables : public testing::TestWithParam<const char*> {};

TEST_P(FormTables, are_what_the_command_prints) {
  const Table table(GetParam());
  ASSERT_FALSE(table.mesh.empty());
  const ProgramRun run = run_program({"forms", asset(table.mesh), "--element", "all", "--json"});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  std::size_t found = 0;
  for (const Json& line : run.lines()) {
    const std::string form = line["form"], element = line["element"];
    const auto expected = table.records.find({form, element});
    found += expected != table.records.end() ? 1 : 0;
    if (expected != table.records.end() && !expected->second.fields.is_null()) {
      EXPECT_EQ(line["fields"], expected->second.fields) << form << ' ' << element;
      EXPECT_EQ(line["words"], expected->second.words) << form << ' ' << element;
      EXPECT_EQ(line["stored"], expected->second.stored) << form << ' ' << element;
      EXPECT_TRUE(line["none"].is_null()) << form << ' ' << element;
      continue;
    }
    EXPECT_TRUE(line["fields"].is_null()) << line;
    const std::string sentence = line["none"]["en"];
    if (const auto cannot = table.sentences.find(form); cannot != table.sentences.end()) {
      EXPECT_EQ(sentence, cannot->second);
    } else if (expected == table.records.end()) {
      EXPECT_TRUE(table.nothing_of.contains({form, element[0]})) << line;
      EXPECT_TRUE(sentence.starts_with("It stores nothing of a")) << line;
    } else {
      EXPECT_EQ(sentence, "It has no halfedge where there is no face.") << line;
    }
  }
  EXPECT_EQ(found, table.records.size()) << "every row of the table is printed";
}

INSTANTIATE_TEST_SUITE_P(meshes, FormTables, testing::Values("tetrahedron", "fan", "two_quads", "holed_cube"));

}  // namespace
}  // namespace ryosen::test
