// `ryosen help json` and what the program prints: each holds the other. run_program holds every line of every test
// against it; here all that it lists is printed at least once.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <set>
#include <sstream>

#include "app/cli/id_lists.h"
#include "ryosen/algo/algorithm_table.h"
#include "ryosen/ops/all.h"
#include "tests/support/app/algorithm_call.h"
#include "tests/support/app/contract.h"

namespace {

using namespace ryosen::test;

// Runs the program with --json and notes what it shows.
class Sweep {
 public:
  SeenOfContract seen;

  void run(std::vector<std::string> arguments) {
    arguments.push_back("--json");
    const ProgramRun run = run_unchecked(arguments, folder_.path());
    EXPECT_EQ(fault_of_run(arguments, run, &seen), "");
  }
  // A file of that content, checked.
  void check(const std::string& name, const std::string& content) { run({"check", folder_.write(name, content)}); }
  // The same, converted.
  void convert(const std::string& name, const std::string& content, const std::string& format) {
    run({"convert", folder_.write(name, content), "-o", "converted", "--format", format});
  }
  void edit(const std::string& file, const std::string& commands) { run({"edit", file, "--do", commands}); }

  const TemporaryFolder& folder() const { return folder_; }

 private:
  TemporaryFolder folder_;
};

std::vector<std::string> files_below(const std::string& folder) {
  std::vector<std::string> files;
  for (const auto& entry :
       std::filesystem::directory_iterator(std::string(RYOSEN_SOURCE_DIR) + "/tests/data/" + folder))
    files.push_back(entry.path().string());
  std::sort(files.begin(), files.end());
  return files;
}

void sweep_command_lines(Sweep& sweep) {
  const std::string mesh = asset("tetrahedron.off"), three = asset("three_tri_edge.off");
  const std::vector<std::vector<std::string>> lines{
      {"check", mesh, "--jobs", "0"},
      {"check", mesh, "--jobs", "1", "--jobs", "2"},
      {"check", mesh, "--unordered=1"},
      {"check"},
      {"check", mesh, "--bogus"},
      {"keys", "x"},
      {"nonsense"},
      {"convert", mesh},
      {"why", mesh, "--op", "collapse", "--edge", "0-99"},
      {"why", mesh, "--op", "nonsense", "--all"},
      {"why", mesh, "--do", "collapse 0-1; swap 0-1"},
      {"why", mesh, "--op", "collapse", "--all"},
      {"why", mesh, "--op", "--all"},
      {"why", three, "--op", "collapse", "--edge", "0-1"},
      {"edit", mesh, "--do", "undo many"},
      {"shot", mesh},
      {"shot", mesh, "-o", mesh},
      {"shot", mesh, "-o", "p.png", "--diff", "d.png"},
      {"shot", mesh, "-o", "p.png", "--view", "front", "--camera", "{}"},
      {"shot", mesh, "-o", "p.png", "--show", "nonsense"},
      {"shot", mesh, "-o", "p.png", "--tool", "nonsense"},
      {"view"},
      {"formats"},
      {"keys"},
      {"doctor"},
      {"help"},
      {"help", "json"},
      {"help", "texts"},
      {"--version"},
      {"forms", mesh},
      {"forms", mesh, "--element", "0-1"},
      {"forms", mesh, "--growth"},
      {"forms"},
      {"steps", "script", "triangle"},
      {"steps", "script"},
      {"steps", "collapse 0-1", asset("cube.obj")},
      {"steps", "hull", mesh},
      {"steps", "hull", mesh, "--numbers", "x"},
      {"steps", "nonsense", mesh},
      {"practice", "--count", "10"},
      {"practice", mesh, "--seed", "3", "--answer", "h1"},
      {"measure", mesh, "--bars", "3"},
      {"measure", mesh, "f0"},
      {"measure", mesh, "v0"},
      {"simplify", asset("torus.off"), "--ratio", "0.5", "--distance"},
      {"distance", mesh, three},
      {"hull", mesh, "-v", "--measure"},
      {"hull", mesh, "-v", "--measure", "--per-component"},
      {"check", asset("stanford_bunny.obj"), "--self-intersections"},
  };
  for (const std::vector<std::string>& line : lines) sweep.run(line);
  sweep.run({"check", "value", "is", "missing", "--jobs"});
}

void sweep_inputs_and_outputs(Sweep& sweep) {
  const TemporaryFolder& folder = sweep.folder();
  const std::string mesh = folder.copy(asset("tetrahedron.off"), "mesh.off");
  std::filesystem::create_directories(folder.path() / "folder.obj");
  std::filesystem::create_symlink("circle.obj", folder.path() / "circle.obj");
  for (const char* const input : {"nosuch.obj", "circle.obj", "folder.obj", "/dev/null"}) sweep.run({"check", input});
  sweep.run({"why", "folder.obj", "--op", "swap", "--all"});
  for (const char* const output : {"mesh.off", "folder.obj", "nosuch/o.obj", "o.nonsense"})
    sweep.run({"convert", mesh, "-o", output});
  sweep.run({"convert", mesh, "-o", "o.stl", "--format", "txt"});
  sweep.run({"edit", mesh, "--do", "save o.off", "-o", "o.off"});
}

// Every command that reads a mesh, on one that is not there and on one that is malformed.
void sweep_refused_inputs(Sweep& sweep) {
  const std::string bad = sweep.folder().write("bad.obj", "v 0 0 x\n");
  for (const std::string& file : {std::string("nosuch.obj"), bad}) {
    sweep.run({"check", file});
    sweep.run({"why", file, "--op", "swap", "--all"});
    sweep.edit(file, "undo");
    sweep.run({"repair", file});
    sweep.run({"convert", file, "-o", "o.obj"});
    sweep.run({"shot", file, "-o", "o.png"});
    sweep.run({"forms", file});
    sweep.run({"steps", "script", "cube", file});
    sweep.run({"measure", file});
    sweep.run({"distance", file, file});
    sweep.run({"practice", file});
    sweep.run({"hull", file});
    for (const ryosen::AlgorithmRow& row : ryosen::algorithm_table()) sweep.run(words_for(row, file));
  }
  sweep.run({"check", asset("tetrahedron.off"), bad});
}

// Each algorithm on a mesh with more problems than one takes away.
void sweep_algorithms(Sweep& sweep) {
  const std::string points = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nv 0 -1 0\nv 9 9 9\nv 1e999 0 0\n";
  const std::string mesh = sweep.folder().write("problems.obj", points + "f 1 2 3\nf 1 2 4\nf 1 2 5\nf 1 1 2\n");
  const std::string empty = sweep.folder().write("empty.off", "OFF\n0 0 0\n");
  for (const ryosen::AlgorithmRow& row : ryosen::algorithm_table()) {
    sweep.run(words_for(row, mesh));
    if (row.has_goal) sweep.run(words_for(row, empty));
  }
  sweep.run({"distance", mesh, mesh});
  sweep.run({"hull", mesh});
  sweep.run({"practice", empty});
  sweep.run({"remesh", empty, "--length", "1"});
  sweep.run({"distance", mesh, sweep.folder().write("points.obj", points)});
}

void sweep_runs(Sweep& sweep) {
  const std::string mesh = asset("tetrahedron.off");
  sweep.edit(mesh, "expect V 9");
  sweep.run({"edit", mesh, "--do", "collapse 0-1; split 0-1", "--on-refuse", "skip", "-o", "o.off"});
  sweep.edit(mesh, "collapse 0-1");
  sweep.edit(mesh, "split 0-1; poke f0; delete f1; undo");
  sweep.edit(mesh, "shot o.png");
  sweep.run({"repair", mesh, "-o", "o.off"});
  sweep.run({"repair", asset("three_tri_edge.off"), "--kinds", "remove_isolated"});
  sweep.run({"convert", asset("cube.obj"), "-o", "o.txt", "--strict"});
  sweep.run({"shot", mesh, "-o", "o.png", "--size", "16x16", "--script",
             sweep.folder().write("refused.ryosen", "collapse 0-1\n")});
  sweep.run({"steps", "script", sweep.folder().write("unlike.ryosen", "expect V 9\n"), mesh});
  sweep.run({"forms", sweep.folder().write("no_faces.off", "OFF\n0 0 0\n"), "--growth"});
  sweep.run({"shot", mesh, "-o", "small.png", "--size", "16x16"});
  sweep.run({"shot", mesh, "--compare", "small.png", "--size", "16x16", "--view", "front"});
  sweep.run({"shot", mesh, "--compare", "small.png", "--size", "16x8"});
  sweep.folder().write("bad.png", "no picture");
  sweep.run({"shot", mesh, "--compare", "bad.png", "--size", "16x16"});
}

const std::string triangle_obj = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
const std::string triangle_off = "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";

void sweep_losses(Sweep& sweep) {
  for (const std::string& file : files_below("io"))
    for (const char* const format : {"obj", "ply-ascii", "off", "stl-binary", "txt"})
      sweep.run({"convert", file, "-o", "converted", "--format", format});
  sweep.convert("bright.obj", "v 0 0 0 1e308 1.5 0\nv 1 0 0 0 0 0\nv 0 1 0 1 1 1\nf 1 2 3\n", "off");
  sweep.convert("head.stl", "COLOR=\x10\x02" + std::string(72, '\1') + std::string(4, '\0'), "obj");
  sweep.convert("ring.obj",
                "v 0 0 0\nv 9 0 0\nv 9 9 0\nv 0 9 0\nv 3 3 0\nv 6 3 0\nv 6 6 0\nv 3 6 0\nf 1 2 3 4 1 5 8 7 6 5\n",
                "stl-binary");
  sweep.convert("large.obj", "v 1e300 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", "stl-binary");
  sweep.convert("lines.obj", triangle_obj + "vp 0 0\n", "obj");
  sweep.convert("values.obj", triangle_obj + "v 2 2 2 1 1\n", "obj");
  sweep.convert("rest.off", triangle_off + "3 0 1 2\n", "off");
  sweep.run({"edit", "lines.obj", "--do", "delete_loop f0", "-o", "wires.obj"});
  const std::string kept = triangle_obj + "v 5 5 5\nv 6 5 5\nf 4 4 5\n";
  sweep.run({"edit", sweep.folder().write("kept.obj", kept), "--do", "remove_vertex v4", "-o", "o.obj"});
}

// Heads of PLY, each wrong in one way.
void sweep_ply(Sweep& sweep) {
  const std::string place = "property float x\nproperty float y\nproperty float z\n";
  const std::string points = "element vertex 1\n" + place, row = "end_header\n0 0 0\n";
  const std::string head = "ply\nformat ascii 1.0\n";
  sweep.check("no.ply", "plyx\n");
  sweep.check("encoding.ply", "ply\nformat asci 1.0\n" + points + row);
  sweep.check("version.ply", "ply\nformat ascii 2.0\n" + points + row);
  sweep.check("element.ply", head + "end_header\n");
  sweep.check("twice.ply", head + points + "element vertex 1\n" + place + row);
  sweep.check("lost.ply", head + place + row);
  sweep.check("type.ply", head + "element vertex 1\nproperty flout x\n" + row);
  sweep.check("name.ply", head + "element vertex 1\nproperty float\n" + row);
  sweep.check("range.ply", head + points + "property char small\nend_header\n0 0 0 400\n");
  sweep.check("rounded.ply", head + "element vertex 1\nproperty int64 x\nproperty float y\nproperty float z\n" +
                                 "end_header\n9007199254740993 0 0\n");
  sweep.check("fans.ply", head + points + "element trifans 1\nproperty list uchar int vertex_indices\n" +
                              "end_header\n0 0 0\n3 0 0 0\n");
}

void sweep_gzip(Sweep& sweep) {
  sweep.run({"convert", asset("tetrahedron.off"), "-o", "mesh.off.gz"});
  const std::string packed = read_file(sweep.folder().at("mesh.off.gz"));
  std::string damaged = packed;
  for (std::size_t i = packed.size() / 2; i < packed.size(); ++i) damaged[i] = '\x55';
  sweep.check("cut.off.gz", packed.substr(0, packed.size() / 2));
  sweep.check("damaged.off.gz", damaged);
  sweep.check("longer.off.gz", packed + "x");
  const char twice[] =
      "\x1f\x8b\x08\x00\x00\x00\x00\x00\x02\x03\x93\xef\xe6\x50\x28\x48\x4c\xce"
      "\x4e\x4d\x51\x28\x29\xcf\x4c\x4e\x05\x00\x58\x39\x3e\xeb\x10\x00\x00\x00";
  sweep.check("twice.off.gz", std::string(twice, sizeof twice - 1));
}

void sweep_contents(Sweep& sweep) {
  std::vector<std::string> files = files_below("malformed");
  files.insert(files.begin(), "check");
  sweep.run(files);
  sweep.check("empty.obj", "");
  sweep.check("zeros.obj", std::string(4096, '\0'));
  sweep.check("binary.obj", "ab\1\2\3\xff");
  sweep.check("words.off", "words\n");
  sweep.check("mesh.fbx", triangle_obj);
  sweep.check("words.mesh.off", "OFF 3 1 0 0 0 0 1 0 0 0 1 0 3 0 1 2\n");
  sweep.check("libraries.obj",
              "mtllib\nmtllib folder.obj\nmtllib circle.obj\nmtllib nosuch.mtl\nmtllib ../x.mtl\n" + triangle_obj);
  sweep.check("counts.obj", triangle_obj + "l 1 2\np 3\n");
  sweep.check("nothing.off", "OFF\n0 0 0\n");
  sweep.check("square.stl",
              "solid\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 1 1 0\n"
              "vertex 0 1 0\nendloop\nendfacet\nendsolid\n");
  const std::string crossing = "OFF\n6 2 0\n0 0 0\n3 0 0\n0 3 0\n1 1 -1\n1 1 1\n2 2 1\n3 0 1 2\n3 3 4 5\n";
  sweep.run({"check", sweep.folder().write("crossing.off", crossing), "--self-intersections"});
}

// What the sweep cannot bring about, and why.
const std::map<std::string, std::string> out_of_reach{
    {"backend.en", "every way to draw is there where the tests run"},
    {"backend.ja", "the same"},
    {"codes.cancelled", "it takes a signal; signals_test sends some"},
    {"codes.folder_unreadable", "a test may run as a user who may read everything"},
    {"codes.gzip_too_large", "it takes a file of gigabytes"},
    {"codes.loses_rules", "only a program that links the library can make own rules"},
    {"codes.internal_error", "the program itself would have to be wrong"},
    {"codes.no_render_backend", "every way to draw is there where the tests run"},
    {"codes.out_of_memory", "it takes a limit of memory; little_memory_test sets some"},
    {"codes.output_not_durable", "the disk would have to fail late; failing_saves_test lets it"},
    {"codes.points_without_z", "a note on a whole file, which JSON leaves out"},
    {"codes.shader_refused", "the graphics driver would have to be broken"},
    {"codes.too_many_elements", "it takes a file of gigabytes"},
    {"codes.welded", "a note on a whole file, which JSON leaves out"},
    {"doctor 1", "every way to draw is there where the tests run"},
    {"failure.stopped", "it takes a signal; simplify_test sends one"},
    {"remesh 1", "it always reaches its goal"},
    {"smooth 1", "it always reaches its goal"},
    {"subdivide 1", "it always reaches its goal"},
    {"forms 7", "every way to draw is there where the tests run"},
    {"steps 7", "every way to draw is there where the tests run"},
    {"shot 7", "every way to draw is there where the tests run"},
    {"view 3", "it takes a display"},
    {"view 4", "it takes a display"},
};

void expect_all(const std::set<std::string>& all, const std::set<std::string>& seen) {
  for (const std::string& name : all) EXPECT_NE(seen.contains(name), out_of_reach.contains(name)) << name;
}

TEST(contract, all_that_it_lists_is_printed) {
  Sweep sweep;
  sweep_command_lines(sweep);
  sweep_inputs_and_outputs(sweep);
  sweep_refused_inputs(sweep);
  sweep_algorithms(sweep);
  sweep_runs(sweep);
  sweep_losses(sweep);
  sweep_ply(sweep);
  sweep_gzip(sweep);
  sweep_contents(sweep);
  const SeenOfContract all = all_of_contract();
  expect_all(all.keys, sweep.seen.keys);
  expect_all(all.exits, sweep.seen.exits);
  std::set<std::string> codes = all.ids;
  std::erase_if(codes, [](const std::string& id) { return !id.starts_with("codes."); });
  expect_all(codes, sweep.seen.ids);
}

TEST(contract, is_said_in_both_languages) {
  const auto expect_sentences = [](const Json& row) {
    EXPECT_TRUE(row["en"].get<std::string>().ends_with(".")) << row;
    EXPECT_TRUE(row["ja"].get<std::string>().ends_with("。")) << row;
  };
  const std::string english = run_program({"help", "json"}).out;
  const std::string japanese = run_program({"help", "json", "--lang", "ja"}).out;
  for (const Json& line : run_program({"help", "json", "--json"}).lines()) {
    if (line.contains("list")) continue;
    for (const Json& object : line["objects"]) {
      expect_sentences(object);
      for (const Json& key : object["keys"]) {
        expect_sentences(key);
        EXPECT_NE(english.find(key["en"]), std::string::npos) << key;
        EXPECT_NE(japanese.find(key["ja"]), std::string::npos) << key;
      }
    }
  }
}

TEST(contract, names_what_every_command_prints) {
  std::vector<std::string> commands;
  for (const Json& line : run_program({"help", "json", "--json"}).lines()) {
    if (!line.contains("command") || line["command"].is_null()) continue;
    commands.push_back(line["command"]);
    EXPECT_EQ(line["objects"].empty(), commands.back() == "view") << "a window prints nothing";
  }
  std::vector<std::string> known;
  for (const Json& line : run_program({"help", "--json"}).lines()) known.push_back(line["command"]);
  EXPECT_EQ(commands, known);
}

// The names in a syntax: "fN [fM ...] [DISTANCE|X,Y,Z]" has fN, fM, DISTANCE and X,Y,Z.
std::vector<std::string> names_in(std::string syntax) {
  std::vector<std::string> names;
  for (char& c : syntax)
    if (c == '[' || c == ']' || c == '|') c = ' ';
  std::istringstream words(syntax);
  for (std::string word; words >> word;)
    if (word != "...") names.push_back(word);
  return names;
}

TEST(contract, operators_tell_the_places_of_their_lines) {
  std::size_t operators = 0;
  for (const Json& line : run_program({"help", "json", "--json"}).lines()) {
    if (line.value("list", Json()) != "operators") continue;
    for (const Json& entry : line["entries"]) {
      const std::string syntax = entry["syntax"];
      std::vector<std::string> left = names_in(syntax);
      std::ranges::reverse(left);
      std::size_t list = 0, optional = 0;
      for (const Json& place : entry["places"]) {
        EXPECT_GE(place["list"], list) << syntax;
        list = place["list"];
        for (const char* key : {"id", "en", "ja"}) EXPECT_FALSE(place[key].get<std::string>().empty()) << syntax;
        for (const Json& value : place["values"]) {
          ASSERT_FALSE(left.empty()) << syntax << " lacks " << value;
          EXPECT_EQ(value["called"], left.back()) << syntax;
          EXPECT_EQ(value["called"] == "X,Y,Z", value["kind"] == "position") << syntax;
          EXPECT_EQ(value["called"] == "fN", value["kind"] == "face") << syntax;
          left.pop_back();
        }
        if (place["need"] == "list" && !left.empty() && (left.back() == "fM" || left.back() == "C-D")) left.pop_back();
        optional += place["need"] == "optional";
      }
      EXPECT_TRUE(left.empty()) << syntax << " has a name that no place has";
      const auto brackets = static_cast<std::size_t>(std::ranges::count(syntax, '['));
      EXPECT_EQ(optional, brackets - (syntax.find(" ...]") != std::string::npos)) << syntax;
      ++operators;
    }
  }
  EXPECT_EQ(operators, ryosen::all_ops().size());
}

TEST(contract, the_readme_names_every_exit_code) {
  const std::string readme = read_file(std::string(RYOSEN_SOURCE_DIR) + "/README.md");
  const std::size_t begin = readme.find("exit codes are "), end = readme.find('.', begin);
  std::set<int> named, known;
  std::istringstream words(readme.substr(begin, end - begin));
  for (std::string word; words >> word;)
    if (std::isdigit(static_cast<unsigned char>(word[0])) != 0) named.insert(std::stoi(word));
  const ryosen::cli::IdList& codes = ryosen::cli::list_of(ryosen::cli::Ids::exit_codes);
  for (const ryosen::cli::IdEntry& row : codes.entries()) known.insert(std::stoi(row.id));
  EXPECT_EQ(named, known);
}

// What a test is told of a run that does not fit.
TEST(contract, finds_what_does_not_fit) {
  const ProgramRun good = run_program({"check", asset("three_tri_edge.off"), "--json"});
  const std::vector<std::string> arguments{"check", "x", "--json"};
  const auto fault_with = [&](const std::string& from, const std::string& to) {
    ProgramRun run = good;
    const std::size_t at = run.out.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    run.out.replace(at, from.size(), to);
    const std::string fault = fault_of_run(arguments, run);
    return fault.substr(0, fault.find(": {"));
  };
  EXPECT_EQ(fault_of_run(arguments, good), "");
  EXPECT_EQ(fault_with("\"edges\":", "\"ends\":"), "check lacks edges");
  EXPECT_EQ(fault_with("\"edges\":", "\"further\":1,\"edges\":"), "check has no such key: further");
  EXPECT_EQ(fault_with("\"edges\":7", "\"edges\":7.5"), "check.edges: 7.5 is not integer");
  EXPECT_EQ(fault_with("\"genus\":null", "\"genus\":[1]"), "check.genus: [1] is not integer or null");
  EXPECT_EQ(fault_with("\"status\":\"warnings\"", "\"status\":\"bad\""), "check.status: bad is none of its words");
  EXPECT_EQ(fault_with("nonmanifold_edge\",", "nonsense\","),
            "check.problems: problem.kind: nonsense is not in the list problems");
  EXPECT_EQ(fault_with("\"severity\":\"problem\"", "\"severity\":\"info\""),
            "check.problems: problem.kind: nonmanifold_edge does not occur with the severity \"info\"");
  EXPECT_EQ(fault_with("{\"file\"", "\"file\"").substr(0, 21), "not an object of JSON");
  ProgramRun refused = good;
  refused.exit_code = 6;
  EXPECT_EQ(fault_of_run(arguments, refused), "check does not end with 6");
}

}  // namespace
