// A command that the program does not have: what a row says must be all that anybody needs to know of it.
#pragma once

#include "app/editor/commands/commands.h"
#include "app/editor/session/session.h"
#include "ryosen/base/number_text.h"

namespace ryosen::test {

// "probe N" puts a free vertex at N,0,0, tells how far it is, and takes long.
inline CommandRow probe_row() {
  return {.id = "probe",
          .syntax = "N",
          .help_en = "puts a vertex on the first axis",
          .help_ja = "第一軸の上に頂点を置く",
          .effect = Effect::edits,
          .run =
              [](Session& session, Words arguments, std::string_view) {
                const auto x = arguments.size() == 1 ? parse_double(arguments[0]) : std::nullopt;
                if (!x) return usage_error("probe needs a number", "probe には数が必要です");
                if (session.frontend.on_progress) session.frontend.on_progress(0.5);
                return session.document().apply(MakeVertex{{*x, 0, 0}});
              },
          .is_long = true};
}

}  // namespace ryosen::test
