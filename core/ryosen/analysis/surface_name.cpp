#include "ryosen/analysis/surface_name.h"

#include <string>

namespace ryosen {

namespace {

struct NamedSurface {
  bool orientable;
  std::int64_t parts;  // handles or crosscaps
  std::uint64_t boundary_loops;
  const char *en, *ja;
};

constexpr NamedSurface named_surfaces[] = {
    {true, 0, 0, "sphere", "球面"},
    {true, 1, 0, "torus", "トーラス"},
    {true, 0, 1, "disc", "円板"},
    {true, 0, 2, "cylinder", "円筒"},
    {false, 1, 0, "projective plane", "射影平面"},
    {false, 2, 0, "Klein bottle", "クラインの壺"},
    {false, 1, 1, "Möbius strip", "メビウスの帯"},
};

std::string counted(std::uint64_t n, const std::string& one) {
  return std::to_string(n) + " " + one + (n == 1 ? "" : "s");
}

}  // namespace

std::optional<Text> surface_name(const Figures& f) {
  if (!f.manifold || f.components != 1 || f.edges == 0 || f[ProblemKind::isolated_vertex] > 0) return std::nullopt;
  const std::int64_t lost = 2 - f.euler_characteristic - static_cast<std::int64_t>(f.boundary_loops);
  if (lost < 0 || (f.orientable && lost % 2 != 0)) return std::nullopt;
  const std::int64_t parts = f.orientable ? lost / 2 : lost;
  for (const NamedSurface& s : named_surfaces)
    if (s.orientable == f.orientable && s.parts == parts && s.boundary_loops == f.boundary_loops)
      return Text{s.en, s.ja};
  const auto count = static_cast<std::uint64_t>(parts);
  Text name =
      f.orientable
          ? Text{"sphere with " + counted(count, "handle"), "ハンドル " + std::to_string(count) + " 個の球面"}
          : Text{"sphere with " + counted(count, "crosscap"), "クロスキャップ " + std::to_string(count) + " 個の球面"};
  if (f.boundary_loops > 0) {
    name.en += " and " + counted(f.boundary_loops, "hole");
    name.ja += "（穴 " + std::to_string(f.boundary_loops) + " 個）";
  }
  return name;
}

}  // namespace ryosen
