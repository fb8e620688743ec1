// The command that moves the plane at which the mesh is cut.
#include <cmath>
#include <optional>

#include "app/editor/camera/cutting.h"
#include "app/editor/camera/view_state.h"
#include "app/editor/commands/command_functions.h"
#include "ryosen/base/number_text.h"
#include "ryosen/mesh/mesh.h"

namespace ryosen {

namespace {

// A share, or a step with its sign; none for anything else.
std::optional<double> share_of(Words arguments) {
  if (arguments.size() != 1) return std::nullopt;
  std::string_view word = arguments[0];
  if (word.starts_with('+')) word.remove_prefix(1);
  const auto value = parse_double(word);
  return value && std::abs(*value) <= 1 ? value : std::nullopt;
}

}  // namespace

std::optional<Text> fault_of_clip_at(Words arguments, const std::string&) {
  if (share_of(arguments)) return std::nullopt;
  return wrong_arguments("clip_at").sentence;
}

Outcome run_clip_at(const Mesh& mesh, ViewState& view, Words arguments, std::string_view) {
  const auto share = share_of(arguments);
  if (!share) return wrong_arguments("clip_at");
  if (!view.cut)
    return failed(ExitCode::refused, {"there is no clipping plane to move; clip x, for one, begins with it",
                                      "動かす断面がありません。clip x などで断面を表示してください"});
  const bool is_step = arguments[0][0] == '+' || arguments[0][0] == '-';
  move_cut(mesh, view, is_step ? view.cut->share + *share : *share);
  return {};
}

}  // namespace ryosen
