// `doctor`: what the program was built with and what this machine offers it.
#include <imgui.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <glm/glm.hpp>
#include <map>
#include <sstream>
#include <thread>

#include "app/cli/columns.h"
#include "app/cli/contract/json.h"
#include "app/cli/contract/lists.h"
#include "app/cli/subcommand_table.h"
#include "app/ui/fonts.h"
#include "render/context/context.h"

namespace ryosen::cli {

namespace {

struct Version {
  std::string of, version;
};

std::vector<Version> versions() {
  const auto three = [](int a, int b, int c) {
    return std::to_string(a) + "." + std::to_string(b) + "." + std::to_string(c);
  };
  return {
      {"ryosen", RYOSEN_VERSION},
      {"build", RYOSEN_BUILD_TYPE},
#ifdef __clang__
      {"compiler", __VERSION__},
#else
      {"compiler", "GCC " __VERSION__},
#endif
      {"dear imgui", IMGUI_VERSION},
      {"glm",
       three(GLM_VERSION_MAJOR, GLM_VERSION_MINOR, GLM_VERSION_PATCH) + "." + std::to_string(GLM_VERSION_REVISION)},
      {"nlohmann json", three(NLOHMANN_JSON_VERSION_MAJOR, NLOHMANN_JSON_VERSION_MINOR, NLOHMANN_JSON_VERSION_PATCH)}};
}

// Installed version by package, from dpkg; empty on other systems.
std::map<std::string, std::string> installed_packages() {
  std::map<std::string, std::string> installed;
  std::ifstream records("/var/lib/dpkg/status");
  std::string line, name;
  bool is_installed = false;
  while (std::getline(records, line)) {
    if (line.empty())
      is_installed = false;
    else if (line.starts_with("Package: "))
      name = line.substr(9);
    else if (line.starts_with("Status: "))
      is_installed = line.ends_with(" installed");
    else if (line.starts_with("Version: ") && is_installed)
      installed[name] = line.substr(9);
  }
  return installed;
}

// The packages required for building, in the order of the scripts; the version is empty if missing.
std::vector<Version> packages() {
  const std::map<std::string, std::string> installed = installed_packages();
  std::vector<Version> all;
  std::istringstream names(RYOSEN_BUILD_PACKAGES);
  for (std::string name; names >> name;) {
    const auto found = installed.find(name);
    all.push_back({name, found == installed.end() ? std::string() : found->second});
  }
  return all;
}

std::string display() {
  for (const char* name : {"WAYLAND_DISPLAY", "DISPLAY"}) {
    const char* const value = std::getenv(name);
    if (value && *value) return value;
  }
  return {};
}

struct Diagnosis {
  std::vector<BackendReport> backends = report_backends();
  std::vector<Version> packages = cli::packages();
  std::string display = cli::display();

  bool can_draw() const {
    return std::any_of(backends.begin(), backends.end(), [](const BackendReport& backend) { return backend.works(); });
  }
};

Json diagnosis_json(const Diagnosis& d) {
  Record<doctor_shape> json;
  for (const Version& v : versions()) json["versions"][v.of] = v.version;
  json["processors"] = std::thread::hardware_concurrency();
  json["display"] = d.display.empty() ? Json() : Json(d.display);
  json["backends"] = Json::array();
  for (const BackendReport& backend : d.backends) {
    Record<backend_shape> row;
    row["backend"] = backend.name;
    row["works"] = backend.works();
    row["library"] = backend.library.empty() ? Json() : Json(backend.library);
    row["version"] = backend.works() ? Json(backend.version) : Json();
    row["renderer"] = backend.works() ? Json(backend.renderer) : Json();
    if (!backend.works()) row["en"] = backend.problem.en;
    if (!backend.works()) row["ja"] = backend.problem.ja;
    json["backends"].push_back(std::move(row).json());
  }
  json["fonts"] = Json::array();
  for (const FontUse& font : font_uses()) {
    Record<font_shape> row;
    row["file"] = font.file;
    row["found"] = font.is_found;
    json["fonts"].push_back(std::move(row).json());
  }
  json["packages"] = Json::array();
  for (const Version& p : d.packages) {
    Record<package_shape> row;
    row["package"] = p.of;
    row["version"] = p.version.empty() ? Json() : Json(p.version);
    json["packages"].push_back(std::move(row).json());
  }
  return std::move(json).json();
}

std::string to_text(const Diagnosis& d, const Console& console) {
  const std::string missing(console.text("missing", "なし"));
  Columns columns;
  for (const Version& v : versions()) columns.add(v.of, v.version);
  columns.add("display", d.display.empty() ? missing : d.display);
  for (const BackendReport& backend : d.backends)
    columns.add("render: " + backend.name,
                backend.works() ? backend.renderer + ", OpenGL " + backend.version
                                : std::string(console.text("none: ", "使えません：")) + console.text(backend.problem));
  for (const FontUse& font : font_uses())
    columns.add("font", std::string(console.text(font.purpose_en, font.purpose_ja)) + ": " +
                            (font.is_found ? font.file : missing + " (" + font.file + ")"));
  for (const Version& p : d.packages)
    if (console.verbose || p.version.empty()) columns.add("package " + p.of, p.version.empty() ? missing : p.version);
  std::string text = columns.text();
  if (!d.can_draw())
    text += console.text("No render backend works: pictures and the editor are not available.\n",
                         "描画できるバックエンドがないため、画像とエディタは使えません。\n");
  return text;
}

}  // namespace

ExitCode doctor_command(const Arguments&, const Console& console) {
  const Diagnosis diagnosis;
  const ExitCode code = diagnosis.can_draw() ? ExitCode::done : ExitCode::found_problems;
  return console.end(console.json ? line_of(diagnosis_json(diagnosis)) : to_text(diagnosis, console), code);
}

}  // namespace ryosen::cli
