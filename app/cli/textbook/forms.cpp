// `forms`: the representations of the source texts side by side for a mesh; with --element what each of them stores of
// an element.
#include "app/cli/columns.h"
#include "app/cli/console.h"
#include "app/cli/contract/json.h"
#include "app/cli/contract/textbook.h"
#include "app/cli/subcommand_table.h"
#include "app/cli/textbook/form_growth.h"
#include "app/editor/textbook/record_text.h"
#include "ryosen/base/rows.h"
#include "ryosen/indexed/from_indexed.h"
#include "ryosen/io/formats.h"
#include "ryosen/mesh/find_element.h"
#include "ryosen/mesh/names.h"
#include "ryosen/textbook/forms/all.h"
#include "ryosen/textbook/forms/comparison.h"
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
  const std::string known = joined_ids(forms::all_forms(), ", ");
  return usage_failure("bad_value", {"There is no form '" + std::string(id) + "'; the forms are " + known + ".",
                                     "形状表現「" + std::string(id) + "」はありません（" + known + "）。"});
}

// Prints what each form stores of the element that --element names, or of all, in every form or that of --form.
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

using forms::Comparison;
using forms::FormFigures;
using forms::PairingFigures;

std::optional<double> bytes_per_face(const FormFigures& figures, std::uint32_t faces) {
  if (figures.unsuitable || faces == 0) return {};
  return static_cast<double>(figures.bytes) / faces;
}

Json to_json(const FormFigures& figures, std::uint32_t faces) {
  const bool suits = !figures.unsuitable;
  Record<form_shape> json;
  json["form"] = figures.row->id;
  json.put(figures.row->en, figures.row->ja);
  json["source"] = cli::to_json(Text{std::string(figures.row->source_en), std::string(figures.row->source_ja)});
  json["suitable"] = suits;
  json["reason"] = suits ? Json() : cli::to_json(*figures.unsuitable);
  json["bytes"] = suits ? Json(figures.bytes) : Json();
  json["bytes_per_face"] = or_null(bytes_per_face(figures, faces));
  json["build_ms"] = suits ? Json(1e3 * figures.build_seconds) : Json();
  json["query_ns"] = Json::object();
  for (const forms::RelationRow& relation : forms::relations()) {
    const auto& seconds = figures.query_seconds[static_cast<std::size_t>(relation.relation)];
    json["query_ns"][std::string(relation.id)] = seconds ? Json(1e9 * *seconds) : Json();
  }
  return std::move(json).json();
}

Json to_json(const PairingFigures& figures) {
  Record<pairing_shape> json;
  json["method"] = figures.method->id;
  json.put(figures.method->en, figures.method->ja);
  json["faces"] = figures.faces;
  json["whole"] = figures.is_whole();
  json["ms"] = 1e3 * figures.seconds;
  return std::move(json).json();
}

Json to_json(const forms::SourceReport& report) {
  Record<source_shape> json;
  json["operation"] = report.operation;
  json["place"] = report.place;
  json["completed"] = report.outcome.completed;
  json.put(report.outcome.sentence);
  return std::move(json).json();
}

std::string json_line_of(const Comparison& comparison, const std::string& file) {
  Record<forms_shape> json;
  json["file"] = file;
  json["vertices"] = comparison.vertices;
  json["edges"] = comparison.edges;
  json["faces"] = comparison.faces;
  json["forms"] = array_of(comparison.forms, [&](const FormFigures& f) { return to_json(f, comparison.faces); });
  json["pairing"] = array_of(comparison.pairing, [](const PairingFigures& figures) { return to_json(figures); });
  json["texts"] = array_of(comparison.texts, [](const forms::SourceReport& report) { return to_json(report); });
  return line_of(json);
}

std::string short_or_dash(const std::optional<double>& value, double unit) {
  return value ? forms::figure_text(unit * *value) : "-";
}

std::string forms_text(const Comparison& comparison, const Console& console) {
  Columns table(Columns::Others::figures);
  std::vector<std::string> head{"", std::string(console.text("bytes/face", "バイト/面")),
                                std::string(console.text("build", "構築"))};
  for (const forms::RelationRow& relation : forms::relations())
    head.emplace_back(console.text(relation.en, relation.ja));
  table.add(head);
  std::string unsuitable;
  for (const FormFigures& figures : comparison.forms) {
    const std::string name(console.text(figures.row->en, figures.row->ja));
    if (figures.unsuitable) {
      unsuitable.append("  " + name).append(console.text(": ", "：")).append(console.text(*figures.unsuitable)) += "\n";
      continue;
    }
    std::vector<std::string> row{name, short_or_dash(bytes_per_face(figures, comparison.faces), 1),
                                 forms::duration_text(figures.build_seconds)};
    for (const auto& seconds : figures.query_seconds) row.push_back(short_or_dash(seconds, 1e9));
    table.add(row);
  }
  std::string text(console.text("Forms; nanoseconds per query, - where the form cannot tell:\n",
                                "形状表現（問い合わせはナノ秒、- は答えられないもの）：\n"));
  text += table.text();
  for (const forms::ComparedClaim& compared : forms::compare_claims(comparison)) {
    text.append("  * ").append(console.text(compared.sentence));
    if (!compared.holds)
      text.append(console.text(" ", "")).append(console.text(compared.claim->why_en, compared.claim->why_ja));
    text += "\n";
  }
  if (!unsuitable.empty())
    text.append(console.text("Forms that cannot hold this mesh:\n", "このメッシュを持てない形状表現：\n")) +=
        unsuitable;
  return text;
}

std::string pairing_text(const Comparison& comparison, const Console& console) {
  Columns table(Columns::Others::figures);
  std::string parts;
  for (const PairingFigures& figures : comparison.pairing) {
    const std::string name(console.text(figures.method->en, figures.method->ja));
    table.add({name + (figures.is_whole() ? "" : " *"), forms::duration_text(figures.seconds)});
    if (figures.is_whole()) continue;
    const std::string part = std::to_string(figures.faces), all = std::to_string(figures.all_faces),
                      factor = forms::figure_text(figures.steps_of_all);
    parts += console.text(Text{"  * on the first " + part + " of " + all + " faces alone; all of them take " + factor +
                                   " times as many steps\n",
                               "  * 最初の " + part + " 面のみ（全 " + all + " 面では " + factor + " 倍の手数）\n"});
  }
  return std::string(console.text("Pairing the halfedges, by method:\n", "半稜線の対を見つける方法：\n")) +
         table.text() + parts;
}

std::string sources_text(const Comparison& comparison, const Console& console) {
  std::string text(console.text("The source texts' own code for collapse and swap is written for closed triangles:\n",
                                "テキストの稜線削除・稜線交換のコードは閉じた三角形メッシュ用です：\n"));
  for (const forms::SourceReport& report : comparison.texts)
    text += "  " + console.text(report.what + Text{": ", "："} + report.outcome.sentence) + "\n";
  return text;
}

std::string to_text(const Comparison& comparison, const std::string& file, const Console& console) {
  const std::string v = std::to_string(comparison.vertices), e = std::to_string(comparison.edges),
                    f = std::to_string(comparison.faces);
  return visible_line(file) +
         console.text(Text{": vertices " + v + ", edges " + e + ", faces " + f + "\n",
                           "：頂点 " + v + "、稜線 " + e + "、面 " + f + "\n"}) +
         forms_text(comparison, console) + pairing_text(comparison, console) + sources_text(comparison, console);
}

// Flags that go with one that is not given.
std::optional<Failure> fault_of_flags(const Arguments& arguments) {
  constexpr struct {
    const char *flag, *with;
  } pairs[] = {{"--form", "--element"},
               {"--plot", "--growth"},
               {"--relation", "--plot"},
               {"--theme", "--plot"},
               {"--overwrite", "--plot"}};
  for (const auto& [flag, with] : pairs)
    if (arguments.has(flag) && !arguments.has(with)) {
      const std::string a = flag, b = with;
      return usage_failure("flag_missing", {a + " goes with " + b + ".", a + " は " + b + " と共に使います。"});
    }
  if (arguments.has("--growth") && arguments.has("--element"))
    return usage_failure("flag_missing",
                         {"--growth and --element do not go together.", "--growth と --element は共に使えません。"});
  if (arguments.operands().empty() && !arguments.has("--growth"))
    return usage_failure("operand_missing",
                         {"Something is missing: ryosen forms FILE", "引数が足りません：ryosen forms FILE"});
  return {};
}

}  // namespace

ExitCode forms_command(const Arguments& arguments, const Console& console) {
  if (const auto fault = fault_of_flags(arguments)) return console.fail(*fault);
  if (arguments.operands().empty()) return print_form_growth(nullptr, arguments, console);
  const std::string& path = arguments.operands()[0];
  Result<MeshFile> file = read_mesh_file(path);
  if (!file) return console.fail(file.failure(), path);
  for (const Message& message : file->messages) console.show(message, path);
  const Mesh mesh = from_indexed(std::move(file->mesh));
  if (arguments.has("--growth")) return print_form_growth(&mesh, arguments, console);
  if (arguments.has("--element")) return print_form_records(mesh, arguments, console);
  const Comparison comparison = forms::compare_forms(mesh);
  return console.end(console.json ? json_line_of(comparison, path) : to_text(comparison, path, console));
}

}  // namespace ryosen::cli
