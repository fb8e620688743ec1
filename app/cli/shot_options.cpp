#include "app/cli/shot_options.h"

#include <algorithm>

#include "app/cli/outputs.h"
#include "app/editor/camera/camera_text.h"
#include "app/editor/commands/text/script.h"
#include "app/editor/commands/text/words.h"
#include "ryosen/base/number_text.h"
#include "ryosen/scene/highlights/highlight_table.h"
#include "ryosen/scene/view/named_views.h"

namespace ryosen::cli {

namespace {

// Reads all flags and keeps the first failure.
class OptionsReader {
 public:
  explicit OptionsReader(const Arguments& arguments) : arguments_(arguments) {
    options_.file = arguments.operands()[0];
    options_.files = files_of_run(arguments, options_.file);
  }

  Result<ShotOptions> read() {
    options_.output = text("-o");
    options_.reference = text("--compare");
    options_.difference = text("--diff");
    options_.view = text("--view");
    options_.camera = text("--camera");
    options_.preferences = text("--preferences");
    options_.has_language = arguments_.has("--lang");
    options_.picture.panels = arguments_.has("--panels");
    options_.picture.transparent = arguments_.has("--transparent");
    read_size();
    read_supersample();
    read_tolerance();
    read_words();
    read_highlights();
    read_names();
    read_pointer();
    check_outputs();
    if (failure_) return *failure_;
    if (const std::string* const script_file = arguments_.value("--script")) {
      Result<EditScript> script = read_edit_script(script_file, {});
      if (!script) return script.failure();
      options_.script = std::move(script).value();
      options_.files.reads(*script_file, FileRole::script);
    }
    if (options_.reference) options_.files.reads(*options_.reference, FileRole::reference);
    options_.picture.bytes_per_triangle = bytes_of_switches();
    std::vector<PlannedOutput> outputs;
    if (options_.output) outputs.push_back({*options_.output, FileRole::picture});
    if (options_.difference) outputs.push_back({*options_.difference, FileRole::difference});
    RunFiles planned = options_.files;
    if (auto fault = find_fault(options_.script, options_.file, outputs, planned)) return *fault;
    options_.files.plans(planned);
    options_.leaves_stdout = planned.uses_stdout();
    return std::move(options_);
  }

 private:
  std::optional<std::string> text(std::string_view flag) const {
    const std::string* const value = arguments_.value(flag);
    return value ? std::optional(*value) : std::nullopt;
  }

  void fail(Failure failure) {
    if (!failure_) failure_ = std::move(failure);
  }
  void bad_value(const std::string& flag, const std::string& value, const std::string& en, const std::string& ja) {
    fail(usage_failure("bad_value", {flag + " is " + en + ", not '" + value + "'.",
                                     flag + " は" + ja + "です（「" + value + "」は使えません）。"}));
  }

  // The flag takes one of these words, which are separated by |.
  void bad_word(const std::string& flag, const std::string& value, const std::string& words) {
    std::string en, ja;
    std::size_t count = 0;
    for (std::size_t at = 0, end = 0; end < words.size(); at = end + 1, ++count) {
      end = std::min(words.find('|', at), words.size());
      const std::string word = words.substr(at, end - at);
      const bool is_last = end == words.size();
      en.append(count == 0 ? "" : is_last ? " or " : ", ").append(word);
      ja.append(count == 0 ? " " : count == 1 && is_last ? " か " : "、").append(word);
    }
    bad_value(flag, value, en, ja + (count > 2 ? " のいずれか" : " "));
  }

  void read_size() {
    const auto value = text("--size");
    if (!value) return;
    const std::size_t cross = value->find('x');
    const auto width = whole_number(std::string_view(*value).substr(0, cross), 1, largest_side);
    const auto height =
        cross == std::string::npos ? std::nullopt : whole_number(value->substr(cross + 1), 1, largest_side);
    if (!width || !height)
      return bad_value("--size", *value, "WIDTHxHEIGHT, each from 1 to 16384", "幅x高さ（1 から 16384）");
    options_.picture.size = {static_cast<int>(*width), static_cast<int>(*height)};
  }

  void read_supersample() {
    const auto value = text("--supersample");
    if (!value) return;
    const auto [width, height] = options_.picture.size;
    const auto n = whole_number(*value, 1, std::min(8, largest_side / std::max(width, height)));
    if (!n)
      return bad_value("--supersample", *value, "from 1 to 8, with at most 16384 rendered pixels a side",
                       " 1 から 8（描画は縦横 16384 画素まで）");
    options_.picture.supersample = static_cast<int>(*n);
  }

  void read_tolerance() {
    const auto value = text("--tolerance");
    if (!value) return;
    const auto percent = parse_double(*value);
    if (!percent || *percent < 0 || *percent > 100)
      return bad_value("--tolerance", *value, "a percentage from 0 to 100", " 0 から 100 の百分率");
    options_.tolerance_percent = *percent;
  }

  void read_words() {
    for (const ViewSwitch& row : view_switches()) {
      const auto word = row.has_flag() ? text(flag_of(row)) : std::nullopt;
      if (!word) continue;
      const auto value = find_value(row, *word);
      if (!value) bad_word(flag_of(row), *word, ids_of(row.values));
      options_.switches.emplace_back(row, value.value_or(0));
    }
    if (const auto backend = text("--backend")) {
      if (*backend == "osmesa")
        options_.picture.backend = Backend::osmesa;
      else if (*backend == "egl")
        options_.picture.backend = Backend::egl;
      else if (*backend != "auto")
        bad_word("--backend", *backend, "auto|osmesa|egl");
    }
    if (options_.view && !find_named_view(*options_.view)) bad_word("--view", *options_.view, named_view_ids());
    Text error;
    if (options_.camera && !camera_from_json(*options_.camera, {}, error))
      fail(usage_failure("bad_value", closed({"--camera: " + error.en, "--camera：" + error.ja})));
    if (options_.camera && options_.view)
      fail(usage_failure("flags_exclude",
                         {"--view and --camera exclude each other.", "--view と --camera は同時に指定できません。"}));
    options_.tool = read_tool(text("--tool").value_or(""));
  }

  // Those of the values that flags set, and those that the script may set.
  std::uint64_t bytes_of_switches() const {
    std::uint64_t bytes = 0;
    for (const ViewSwitch& row : view_switches()) {
      std::uint64_t most = row.values.front().bytes_per_triangle;
      for (const auto& [of_flag, value] : options_.switches)
        if (of_flag.id == row.id) most = of_flag.values[value].bytes_per_triangle;
      for (const ScriptLine& line : options_.script.lines)
        if (split_words(line.text).front() == row.id)
          for (const SwitchValue& value : row.values) most = std::max(most, value.bytes_per_triangle);
      bytes += most;
    }
    return bytes;
  }

  std::string read_tool(const std::string& id) {
    const OpInfo* const named = find_op(id);
    if (id.empty() || (named && is_tool(*named))) return id;
    std::vector<std::string> known;
    for (const OpInfo& op : all_ops())
      if (is_tool(op)) add_ids(op, known);
    fail(usage_failure("unknown_tool",
                       Text{"There is no tool '" + id + "'.", "「" + id + "」というツールはありません。"} +
                           did_you_mean(id, known, HintForm::sentence)));
    return id;
  }

  // Splits a list at commas and blanks.
  static std::vector<std::string> parts(std::string list) {
    std::replace(list.begin(), list.end(), ',', ' ');
    const std::vector<std::string_view> words = split_words(list);
    return {words.begin(), words.end()};
  }

  void read_highlights() {
    const auto value = text("--show");
    if (!value) return;
    std::vector<std::string> known;
    for (const HighlightRow& row : highlight_table()) known.emplace_back(row.id);
    std::set<std::string> shown;
    for (const std::string& id : parts(*value)) {
      if (id == "none") continue;
      if (id == "all") {
        shown.insert(known.begin(), known.end());
      } else if (std::find(known.begin(), known.end(), id) != known.end()) {
        shown.insert(id);
      } else {
        fail(usage_failure("unknown_highlight",
                           Text{"There is no highlight '" + id + "'.", "「" + id + "」という強調表示はありません。"} +
                               did_you_mean(id, known, HintForm::sentence)));
      }
    }
    options_.shown = std::move(shown);
  }

  void read_names() {
    if (const auto value = text("--select")) options_.selected = parts(*value);
  }

  void read_pointer() {
    if (const auto value = text("--hover")) {
      options_.hover = parse_pixel(*value);
      if (!options_.hover) bad_value("--hover", *value, "a pixel X,Y", "画素 X,Y ");
    }
    for (const std::string& value : arguments_.values("--click")) {
      const std::size_t comma = value.find(',');
      const std::size_t second = comma == std::string::npos ? comma : value.find(',', comma + 1);
      const auto pixel = parse_pixel(value.substr(0, second));
      if (!pixel) return bad_value("--click", value, "a pixel X,Y or X,Y,TOOL", "画素 X,Y または X,Y,TOOL ");
      options_.clicks.push_back(
          {*pixel, second == std::string::npos ? options_.tool : read_tool(value.substr(second + 1))});
    }
  }

  void check_outputs() {
    if (!options_.output && !options_.reference)
      fail(usage_failure("output_missing",
                         {"-o PNG or --compare REF.png is needed.", "-o PNG か --compare REF.png が必要です。"}));
    if (options_.difference && !options_.reference)
      fail(usage_failure("flag_missing", {"--diff goes with --compare.", "--diff は --compare と共に使います。"}));
  }

  static constexpr int largest_side = 16384;
  const Arguments& arguments_;
  ShotOptions options_;
  std::optional<Failure> failure_;
};

}  // namespace

Result<ShotOptions> read_shot_options(const Arguments& arguments) { return OptionsReader(arguments).read(); }

}  // namespace ryosen::cli
