// The options of `shot`: what the picture shows and what it is compared with.
#pragma once

#include <optional>
#include <set>
#include <string>
#include <vector>

#include "app/cli/edit_script.h"
#include "app/cli/subcommand_table.h"
#include "app/editor/preferences/view_switches.h"
#include "app/ui/headless.h"

namespace ryosen::cli {

struct ShotClick {
  glm::dvec2 pixel;
  std::string tool;  // empty: that of --tool, or a selection
};

struct ShotOptions {
  std::string file;
  std::optional<std::string> output, reference, difference;
  double tolerance_percent = 0.2;
  Headless::Options picture;
  std::vector<std::pair<ViewSwitch, std::size_t>> switches;  // and the numbers of their values
  std::optional<std::string> view, camera;                   // arguments of the script commands with these names
  std::optional<std::set<std::string>> shown;
  std::vector<std::string> selected;
  std::optional<std::string> preferences;  // a file of them
  bool has_language = false;               // a flag says it, whatever is preferred
  std::string tool;
  std::optional<glm::dvec2> hover;
  std::vector<ShotClick> clicks;
  EditScript script;
  RunFiles files{RunFiles::Policy::keep};  // what is read
  bool leaves_stdout = false;              // for a picture or a mesh
};

Result<ShotOptions> read_shot_options(const Arguments& arguments);

}  // namespace ryosen::cli
