// `formats` and `keys`: print the tables of core and editor.
#include "app/cli/contract/lists.h"
#include "app/cli/columns.h"
#include "app/cli/contract/json.h"
#include "app/cli/subcommand_table.h"
#include "app/editor/preferences/keys.h"
#include "ryosen/io/formats.h"

namespace ryosen::cli {

ExitCode formats_command(const Arguments&, const Console& console) {
  Columns columns;
  for (const Format& format : formats()) {
    std::vector<std::string_view> variants;
    for (const FormatVariant& variant : format.variants) variants.push_back(variant.id);
    if (console.json) {
      Record<format_shape> json;
      json["format"] = format.id;
      json["extensions"] = format.extensions;
      json["variants"] = variants;
      json["read"] = format.read != nullptr;
      json["write"] = format.write != nullptr;
      json["gzip"] = true;
      json.put(format.name);
      console.print(line_of(json));
      continue;
    }
    std::string text = console.text(format.name) + " (";
    for (std::size_t i = 0; i < format.extensions.size(); ++i) text.append(i ? " " : "").append(format.extensions[i]);
    text.append(console.text("); read", "）読み込み"));
    if (format.write) text.append(console.text(", write", "・書き出し"));
    for (const std::string_view variant : variants) text.append(variant == variants[0] ? ": " : " ").append(variant);
    columns.add(std::string(format.id), text);
  }
  if (!console.json) {
    console.print(columns.text());
    console.print(console.text("Each of them also packed with gzip, by a name such as x.obj.gz.\n",
                               "どの形式も、x.obj.gz のような名前で gzip 圧縮したまま扱えます。\n"));
  }
  return ExitCode::done;
}

ExitCode keys_command(const Arguments&, const Console& console) {
  Columns columns;
  for (const KeyRow& key : key_table()) {
    columns.add(std::string(key.chord),
                std::string(console.text(key.help_en, key.help_ja)) + " [" + std::string(key.command) + "]");
    if (!console.json) continue;
    Record<chord_shape> json;
    json["key"] = key.chord;
    json["command"] = key.command;
    json.put(key.help_en, key.help_ja);
    console.print(line_of(json));
  }
  if (!console.json) console.print(columns.text());
  return ExitCode::done;
}

}  // namespace ryosen::cli
