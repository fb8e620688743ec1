#include "tests/support/app/contract.h"

#include <algorithm>
#include <map>
#include <sstream>

namespace ryosen::test {

namespace {

std::vector<std::string> split(const std::string& text, const std::string& between) {
  std::vector<std::string> parts;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find(between, begin), text.size());
    parts.push_back(text.substr(begin, end - begin));
    begin = end + between.size();
  }
  return parts;
}

// A surrogate without its other half stands for a byte of a name; this parser knows no such.
Json parsed(std::string line) {
  Json json = Json::parse(line, nullptr, false);
  if (!json.is_discarded()) return json;
  for (std::size_t at = line.find("\\udc"); at != std::string::npos; at = line.find("\\udc", at))
    line[at + 2] = line[at + 3] = '0';
  return Json::parse(line, nullptr, false);
}

bool has_type(const Json& value, const std::string& type) {
  const std::string array = "array of ";
  if (type.rfind(array, 0) == 0) {
    const std::string each = type.substr(array.size());
    return value.is_array() &&
           std::all_of(value.begin(), value.end(), [&](const Json& v) { return has_type(v, each); });
  }
  return (type == "string" && value.is_string()) || (type == "integer" && value.is_number_integer()) ||
         (type == "number" && value.is_number()) || (type == "boolean" && value.is_boolean()) ||
         (type == "object" && value.is_object()) || (type == "null" && value.is_null());
}

class PrintedContract {
 public:
  // As the program prints it; asked once.
  static const PrintedContract& get() {
    static const PrintedContract contract;
    return contract;
  }

  std::string command_of(const std::vector<std::string>& arguments) const {
    for (const std::string& argument : arguments)
      if (argument == "--help" || argument == "-h") return "help";
    for (const std::string& argument : arguments)
      if (argument != shared && commands_.contains(argument)) return argument;
    return "view";
  }

  std::string fault_of_exit(const std::string& command, int code, SeenOfContract* seen) const {
    if (!ends_with(command, code)) return command + " does not end with " + std::to_string(code);
    if (seen && !ends_with(shared, code)) seen->exits.insert(command + " " + std::to_string(code));
    return {};
  }

  // A line may be any of the command's; the fault is that of the one which fits best.
  std::string fault_of_line(const std::string& command, const Json& line, SeenOfContract* seen) const {
    std::string best;
    std::size_t most = 0;
    for (const std::string& owner : {command, shared}) {
      for (const Json& object : commands_.at(owner)["objects"]) {
        if (!object["is_line"]) continue;
        SeenOfContract found;
        const std::string fault = fault_of_object(command, object, line, found);
        if (fault.empty()) {
          if (seen) seen->keys.merge(found.keys);
          if (seen) seen->ids.merge(found.ids);
          return {};
        }
        if (best.empty() || found.keys.size() > most) best = fault;
        most = std::max(most, found.keys.size());
      }
    }
    return best.empty() ? command + " prints no lines" : best;
  }

  SeenOfContract all() const {
    SeenOfContract all;
    for (const auto& [command, row] : commands_)
      for (const Json& object : row["objects"])
        for (const Json& key : object["keys"]) all.keys.insert(name_of(object, key));
    for (const auto& [list, rows] : lists_)
      for (const auto& [id, row] : rows) all.ids.insert(list + "." + id);
    for (const auto& [command, row] : commands_)
      for (const int code : row["exit_codes"])
        if (!ends_with(shared, code)) all.exits.insert(command + " " + std::to_string(code));
    return all;
  }

 private:
  PrintedContract() {
    std::istringstream text(run_unchecked({"help", "json", "--json"}).out);
    for (std::string line; std::getline(text, line);) {
      const Json json = Json::parse(line);
      if (json.contains("list"))
        for (const Json& entry : json["entries"]) lists_[json["list"]][entry["id"]] = entry;
      else
        commands_[json["command"].is_null() ? shared : json["command"].get<std::string>()] = json;
    }
  }

  bool ends_with(const std::string& command, int code) const {
    const Json& codes = commands_.at(command)["exit_codes"];
    return std::find(codes.begin(), codes.end(), code) != codes.end();
  }

  static std::string name_of(const Json& object, const Json& key) {
    return object["object"].get<std::string>() + "." + key["key"].get<std::string>();
  }

  const Json* object_named(const std::string& command, const Json& name) const {
    for (const std::string& owner : {command, shared})
      for (const Json& object : commands_.at(owner)["objects"])
        if (object["object"] == name) return &object;
    return nullptr;
  }

  std::string fault_of_object(const std::string& command, const Json& object, const Json& value,
                              SeenOfContract& seen) const {
    std::size_t known = 0;
    const std::string name = object["object"];
    for (const Json& key : object["keys"]) {
      const std::string id = key["key"];
      if (!value.contains(id)) {
        if (key["optional"]) continue;
        return name + " lacks " + id;
      }
      ++known;
      seen.keys.insert(name_of(object, key));
      if (std::string fault = fault_of_value(command, key, value, seen); !fault.empty())
        return name_of(object, key) + ": " + fault;
    }
    if (known == value.size()) return {};
    std::string unknown = name + " has no such key:";
    for (const auto& [id, ignored] : value.items())
      if (!seen.keys.contains(name + "." + id)) unknown += " " + id;
    return unknown;
  }

  std::string fault_of_value(const std::string& command, const Json& key, const Json& object,
                             SeenOfContract& seen) const {
    const Json& value = object[key["key"].get<std::string>()];
    const std::vector<std::string> types = split(key["type"], " or ");
    if (std::none_of(types.begin(), types.end(), [&](const std::string& type) { return has_type(value, type); }))
      return value.dump() + " is not " + key["type"].get<std::string>();
    if (!key["object"].is_null()) {
      const Json* const shape = object_named(command, key["object"]);
      if (!shape) return key["object"].dump() + " is no object of " + command;
      for (const Json& part : value.is_array() ? value : Json::array({value})) {
        if (part.is_null()) continue;
        if (std::string fault = fault_of_object(command, *shape, part, seen); !fault.empty()) return fault;
      }
    }
    // Where a text stands beside a list of texts, the limits are those of the text.
    const bool is_limited = !value.is_array() || std::find(types.begin(), types.end(), "string") == types.end();
    if (!is_limited) return {};
    for (const std::string& text : texts_of(value)) {
      if (!key["words"].is_null() && std::find(key["words"].begin(), key["words"].end(), text) == key["words"].end())
        return text + " is none of its words";
      if (std::string fault = fault_of_id(key["list"], text, object, seen); !fault.empty()) return fault;
    }
    return {};
  }

  // Of an object its keys.
  static std::vector<std::string> texts_of(const Json& value) {
    std::vector<std::string> texts;
    if (value.is_object()) {
      for (const auto& [id, ignored] : value.items()) texts.push_back(id);
    } else {
      for (const Json& part : value.is_array() ? value : Json::array({value})) {
        if (part.is_string()) texts.push_back(part);
        if (part.is_number_integer()) texts.push_back(part.dump());
      }
    }
    return texts;
  }

  std::string fault_of_id(const Json& list, const std::string& id, const Json& object, SeenOfContract& seen) const {
    if (list.is_null()) return {};
    const auto& rows = lists_.at(list);
    const auto row = rows.find(id);
    if (row == rows.end()) return id + " is not in the list " + list.get<std::string>();
    seen.ids.insert(list.get<std::string>() + "." + id);
    if (!row->second.contains("severities") || !object.contains("severity")) return {};
    const Json& severities = row->second["severities"];
    const bool occurs = std::find(severities.begin(), severities.end(), object["severity"]) != severities.end();
    return occurs ? "" : id + " does not occur with the severity " + object["severity"].dump();
  }

  inline static const std::string shared = "";
  std::map<std::string, Json> commands_;
  std::map<std::string, std::map<std::string, Json>> lists_;
};

}  // namespace

std::string fault_of_run(const std::vector<std::string>& arguments, const ProgramRun& run, SeenOfContract* seen) {
  constexpr int killed = 128;
  if (run.exit_code < 0 || run.exit_code > killed) return {};
  const PrintedContract& contract = PrintedContract::get();
  const std::string command = contract.command_of(arguments);
  std::string faults = contract.fault_of_exit(command, run.exit_code, seen);
  if (std::find(arguments.begin(), arguments.end(), "--json") == arguments.end()) return faults;
  std::istringstream text(run.out);
  for (std::string line; std::getline(text, line);) {
    const Json json = parsed(line);
    const std::string fault = json.is_object() ? contract.fault_of_line(command, json, seen) : "not an object of JSON";
    if (!fault.empty()) faults += (faults.empty() ? "" : "\n") + fault + ": " + line.substr(0, 2000);
  }
  return faults;
}

std::vector<std::string> required_keys(const std::vector<Json>& contract, const std::string& object) {
  std::vector<std::string> keys;
  for (const Json& line : contract) {
    if (!line.contains("objects")) continue;
    for (const Json& row : line["objects"]) {
      if (row["object"] != object || !keys.empty()) continue;
      for (const Json& key : row["keys"])
        if (!key["optional"]) keys.push_back(key["key"]);
    }
  }
  return keys;
}

SeenOfContract all_of_contract() { return PrintedContract::get().all(); }

}  // namespace ryosen::test
