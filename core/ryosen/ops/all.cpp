#include "ryosen/ops/all.h"

#include <algorithm>
#include <cassert>

#include "ryosen/base/enum_table.h"

namespace ryosen {

namespace {

bool is_called(const OpInfo& info, std::string_view id) {
  if (info.id == id) return true;
  const std::vector<std::string_view> aliases = split_words(info.aliases);
  return std::find(aliases.begin(), aliases.end(), id) != aliases.end();
}

// Calls visit(std::type_identity<Op>) for the operator with this id; false if there is none.
template <class Visit, std::size_t... I>
bool visit_op(std::string_view id, Visit visit, std::index_sequence<I...>) {
  return ((is_called(std::variant_alternative_t<I, AnyOp>::info, id)
               ? (visit(std::type_identity<std::variant_alternative_t<I, AnyOp>>()), true)
               : false) ||
          ...);
}

constexpr auto indices = std::make_index_sequence<std::variant_size_v<AnyOp>>();

template <std::size_t... I>
std::vector<OpInfo> collect(std::index_sequence<I...>) {
  return {std::variant_alternative_t<I, AnyOp>::info...};
}

constexpr OpGroupRow group_rows[] = {
    {OpGroup::refine, "Refine", "細分", "Put in vertices and edges.", "頂点や稜線を加えます。"},
    {OpGroup::join, "Join and cut", "結合と切断", "Make one of several elements, or several of one.",
     "いくつかの要素を一つにしたり、一つを分けたりします。"},
    {OpGroup::fill, "Delete and fill", "削除と穴埋め", "Take elements away, or put faces into holes.",
     "要素を取り除いたり、穴に面を張ったりします。"},
    {OpGroup::orient, "Orient and reconnect", "向きと接続", "Turn faces over, weld and detach.",
     "面を裏返したり、頂点をつないだり離したりします。"},
    {OpGroup::euler, "Euler operators", "オイラー操作",
     "Single steps that keep V − E + F + B − H = 2(S − G), by which any mesh can be built.",
     "V − E + F + B − H = 2(S − G) を保つ一歩ずつの操作で、どんなメッシュも作れます。", true},
};
static_assert(rows_are_in_order(group_rows, &OpGroupRow::group));

}  // namespace

std::span<const OpGroupRow> op_groups() { return group_rows; }

const std::vector<OpInfo>& all_ops() {
  static const std::vector<OpInfo> ops = collect(indices);
  return ops;
}

void add_ids(const OpInfo& info, std::vector<std::string>& ids) {
  ids.emplace_back(info.id);
  for (std::string_view alias : split_words(info.aliases)) ids.emplace_back(alias);
}

const OpInfo* find_op(std::string_view id) {
  for (const OpInfo& info : all_ops())
    if (is_called(info, id)) return &info;
  return nullptr;
}

ParsedOp parse_op(const Mesh& mesh, std::string_view id, std::span<const OpArgument> arguments) {
  ParsedOp out;
  [[maybe_unused]] const bool known = visit_op(
      id,
      [&]<class Op>(std::type_identity<Op>) {
        // The values of a line are read into an operator, or into its base, through a pointer to void.
        static_assert(std::is_standard_layout_v<Op>);
        ArgumentReader in(mesh, arguments, Op::info.line);
        Op op{};
        read_line(Op::info.line, mesh, in, &op);
        if (!in.failed()) out.op = std::move(op);
        out.error = in.error();
        out.sentence = in.sentence();
      },
      indices);
  assert(known);
  return out;
}

std::vector<std::string_view> split_words(std::string_view line) {
  constexpr std::string_view blanks = " \t\r\n";
  std::vector<std::string_view> words;
  for (std::size_t begin = line.find_first_not_of(blanks); begin != std::string_view::npos;) {
    const std::size_t end = std::min(line.find_first_of(blanks, begin), line.size());
    words.push_back(line.substr(begin, end - begin));
    begin = line.find_first_not_of(blanks, end);
  }
  return words;
}

const OpInfo& info_of(const AnyOp& op) {
  return std::visit([](const auto& o) -> const OpInfo& { return o.info; }, op);
}

Verdict check(const Mesh& mesh, const AnyOp& op) {
  return std::visit([&](const auto& o) { return o.check(mesh); }, op);
}

Verdict check(const Mesh& mesh, const AnyOp& op, LocalFacts& known) {
  return std::visit(
      [&](const auto& o) {
        if constexpr (requires { o.check(mesh, known); })
          return o.check(mesh, known);
        else
          return o.check(mesh);
      },
      op);
}

std::vector<Reason> warnings(const Mesh& mesh, const AnyOp& op) {
  return std::visit([&](const auto& o) { return o.warnings(mesh); }, op);
}

OpEffect apply(Edit& edit, const AnyOp& op) {
  return std::visit([&](const auto& o) { return o.apply(edit); }, op);
}

AnyOp dragged(AnyOp op, const glm::dvec3& position) {
  std::visit([&](auto& o) { set_dragged(o.info.line, &o, position); }, op);
  return op;
}

Halfedge halfedge_of(const AnyOp& op) {
  return std::visit([](const auto& o) { return halfedge_of(o.info.line, &o); }, op);
}

std::string command_of(const Mesh& mesh, const AnyOp& op) {
  return std::visit([&](const auto& o) { return std::string(o.info.id) + print_line(o.info.line, mesh, &o); }, op);
}

std::optional<Text> fault_of_values(const Mesh& mesh, const AnyOp& op) {
  const OpLine& line = info_of(op).line;
  if (!line.fault) return std::nullopt;
  const auto expected = std::visit([&](const auto& o) { return line.fault(mesh, &o); }, op);
  if (!expected) return std::nullopt;
  const std::string printed = command_of(mesh, op);
  return not_understood(split_words(printed).back(), *expected);
}

ParsedOp parse_line(const Mesh& mesh, std::string_view line) {
  const std::vector<std::string_view> words = split_words(line);
  if (words.empty() || !find_op(words[0]))
    return {std::nullopt, NameError::malformed, not_understood(line, {"an operator", "演算子を"})};
  return parse_op(mesh, words[0], op_arguments(std::span(words).subspan(1)));
}

std::optional<Text> fault_of_arguments(std::string_view id, std::span<const OpArgument> arguments) {
  // Reading may say more precisely what is wrong, if it gets that far without elements.
  ParsedOp parsed = parse_op(Mesh(), id, arguments);
  if (parsed.error == NameError::malformed) return std::move(parsed.sentence);
  const OpLine& line = find_op(id)->line;
  const std::optional<std::size_t> place = first_misfit(line, arguments);
  if (!place) return std::nullopt;
  const std::string syntax = syntax_of(line);
  if (*place == arguments.size()) return argument_missing(syntax);
  return not_of_syntax(print_argument(Mesh(), arguments[*place]), syntax);
}

AnyOp op_at(const Mesh& mesh, std::string_view id, const OpTarget& target) {
  AnyOp op;
  [[maybe_unused]] const bool known = visit_op(
      id, [&]<class Op>(std::type_identity<Op>) { op = Op::at(mesh, target); }, indices);
  assert(known);
  return op;
}

}  // namespace ryosen
