#include "app/cli/textbook/form_records.h"

#include "app/cli/columns.h"
#include "app/cli/contract/json.h"
#include "app/cli/contract/textbook.h"
#include "app/editor/textbook/record_text.h"
#include "ryosen/mesh/find_element.h"
#include "ryosen/mesh/names.h"
#include "ryosen/textbook/forms/all.h"
#include "ryosen/textbook/forms/records.h"

namespace ryosen::cli {

namespace {

using forms::ElementRecord;
using forms::Field;
using forms::Records;

Json to_json(const glm::dvec3& place) { return Json::array({place.x, place.y, place.z}); }

Json to_json(Element link) { return link.index == no_index ? Json() : Json(slot_name(link)); }

Json to_json(const std::optional<std::int64_t>& stored) { return stored ? Json(*stored) : Json(); }

// One value, or an array of them where the field is a list.
template <class Value>
Json value_of(const Field& field, const std::vector<Value>& values) {
  if (!field.is_list) return to_json(values.front());
  Json list = Json::array();
  for (const Value& value : values) list.push_back(to_json(value));
  return list;
}

std::string json_line_of(const Records& records, Element element, const ElementRecord& record) {
  Record<form_record_shape> json;
  json["form"] = records.row().id;
  json["element"] = slot_name(element);
  json["fields"] = record.none ? Json() : Json::object();
  json["none"] = record.none ? cli::to_json(*record.none) : Json();
  json["words"] = Json::object();
  json["stored"] = Json::object();
  for (const Field& field : record.fields) {
    const std::string key(field.key);
    const bool is_place = !field.places.empty();
    json["fields"][key] = is_place ? value_of(field, field.places) : value_of(field, field.links);
    json["words"][key] = field.word;
    json["stored"][key] = is_place ? value_of(field, field.places) : value_of(field, field.stored);
  }
  return line_of(json);
}

std::string text_of(const Records& records, Element element, const ElementRecord& record, const Console& console) {
  const forms::FormRow& row = records.row();
  std::string text = slot_name(element) + console.text(" as ", "：").data() +
                     std::string(console.text(row.en, row.ja)) + " (" +
                     std::string(console.text(row.source_en, row.source_ja)) + ")\n";
  if (record.none) return text + "  " + console.text(*record.none) + "\n";
  Columns table;
  for (const RecordLine& line : record_lines(record.fields, console.language)) {
    std::string values;
    for (const std::string& value : line.values) values += (values.empty() ? "" : " ") + value;
    table.add({line.key, line.word, values, line.stored});
  }
  return text + table.text();
}

std::vector<Element> all_elements(const Mesh& mesh) {
  std::vector<Element> all;
  const auto add = [&]<class Handle>(Handle, std::uint32_t slots) {
    for (std::uint32_t i = 0; i < slots; ++i)
      if (mesh.is_alive(Handle(i))) all.push_back(Handle(i));
  };
  add(Vertex(), mesh.vertex_slots());
  add(Edge(), mesh.edge_slots());
  add(Face(), mesh.face_slots());
  add(Halfedge(), mesh.halfedge_slots());
  return all;
}

Failure unknown_form(std::string_view id) {
  std::string known;
  for (const forms::FormRow& row : forms::all_forms()) known.append(known.empty() ? "" : ", ").append(row.id);
  return usage_failure("bad_value", {"There is no form '" + std::string(id) + "'; the forms are " + known + ".",
                                     "形状表現「" + std::string(id) + "」はありません（" + known + "）。"});
}

}  // namespace

ExitCode print_form_records(const Mesh& mesh, const Arguments& arguments, const Console& console) {
  const std::string& path = arguments.operands()[0];
  const std::string& asked = *arguments.value("--element");
  std::vector<Element> elements;
  if (asked == "all") {
    elements = all_elements(mesh);
  } else {
    NamedElement named = find_element(mesh, asked);
    if (!named.element) return console.fail(failure_of_name(named.error, std::move(named.sentence)), path);
    elements.push_back(*named.element);
  }
  const std::string* const form = arguments.value("--form");
  if (form != nullptr && forms::find_form(*form) == nullptr) return console.fail(unknown_form(*form));
  for (const forms::FormRow& row : forms::all_forms()) {
    if (form != nullptr && row.id != *form) continue;
    const Records records(mesh, row);
    for (const Element element : elements) {
      const ElementRecord record = records.of(element);
      console.print(console.json ? json_line_of(records, element, record) : text_of(records, element, record, console));
    }
  }
  return console.end("");
}

}  // namespace ryosen::cli
