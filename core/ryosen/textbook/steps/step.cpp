#include "ryosen/textbook/steps/step.h"

#include <array>
#include <string>

namespace ryosen::steps {

namespace {

constexpr std::array role_rows{
    RoleRow{Role::asked, "asked", RoleLook::main, false, "what the step is about", "対象"},
    RoleRow{Role::read, "read", RoleLook::quiet, false, "whose record is read", "データを読む要素"},
    RoleRow{Role::compared, "compared", RoleLook::quiet, false, "what it is compared with", "比べる相手"},
    RoleRow{Role::answer, "answer", RoleLook::good, false, "what is found", "見つかった要素"},
    RoleRow{Role::created, "created", RoleLook::good, false, "what is new", "新しい要素"},
    RoleRow{Role::changed, "changed", RoleLook::other, false, "whose links change", "リンクが変わる要素"},
    RoleRow{Role::deleted, "deleted", RoleLook::bad, false, "what is gone", "消えた要素"},
    RoleRow{Role::missing, "missing", RoleLook::bad, false, "where a link is missing", "リンクのない所"},
    RoleRow{Role::visible, "visible", RoleLook::bad, false, "what the point sees", "点から見えるもの"},
    RoleRow{Role::horizon, "horizon", RoleLook::other, false, "the border of what the point sees",
            "見える面の境界（ホライゾン）"},
    RoleRow{Role::united, "united", RoleLook::quiet, false, "what lies in one plane, or on one line",
            "同じ平面（直線）上にあるもの"},
    RoleRow{Role::l1, "(1)", RoleLook::main, true, "halfedge (1) of the figure", "図の半稜線 (1)"},
    RoleRow{Role::l2, "(2)", RoleLook::other, true, "halfedge (2) of the figure", "図の半稜線 (2)"},
    RoleRow{Role::l3, "(3)", RoleLook::other, true, "halfedge (3) of the figure", "図の半稜線 (3)"},
    RoleRow{Role::l4, "(4)", RoleLook::main, true, "halfedge (4) of the figure", "図の半稜線 (4)"},
    RoleRow{Role::l5, "(5)", RoleLook::other, true, "halfedge (5) of the figure", "図の半稜線 (5)"},
    RoleRow{Role::l6, "(6)", RoleLook::other, true, "halfedge (6) of the figure", "図の半稜線 (6)"},
    RoleRow{Role::l7, "(7)", RoleLook::quiet, true, "halfedge (7) of the figure", "図の半稜線 (7)"},
    RoleRow{Role::l8, "(8)", RoleLook::quiet, true, "halfedge (8) of the figure", "図の半稜線 (8)"},
    RoleRow{Role::l9, "(9)", RoleLook::quiet, true, "halfedge (9) of the figure", "図の半稜線 (9)"},
    RoleRow{Role::l10, "(10)", RoleLook::quiet, true, "halfedge (10) of the figure", "図の半稜線 (10)"},
};
static_assert(rows_are_in_order(role_rows, &RoleRow::role));

}  // namespace

std::span<const RoleRow> roles() { return role_rows; }

Text text_of(const Delta& delta) {
  std::string changes;
  const auto add = [&](char letter, std::int64_t by) {
    if (by == 0) return;
    changes += changes.empty() ? "" : ", ";
    changes += letter;
    changes += (by > 0 ? " + " : " - ") + std::to_string(by > 0 ? by : -by);
  };
  add('V', delta.v);
  add('E', delta.e);
  add('F', delta.f);
  add('B', delta.b.value_or(0));
  add('W', delta.w);
  add('I', delta.i);
  add('H', delta.h);
  add('S', delta.s);
  add('G', delta.g.value_or(0));
  if (changes.empty()) return {"no term changes", "どの項も変わらない"};
  return {changes, changes};
}

}  // namespace ryosen::steps
