#include "app/cli/remedies.h"

namespace ryosen::cli {

// The mesh with its faces turned, and the questions to it.
struct Remedies::Oriented {
  Mesh mesh;
  Remedies remedies{mesh};
};

Remedies::Oriented* Remedies::oriented() {
  if (!orient_was_tried_ && check(mesh_, Orient()).legal()) {
    oriented_ = std::make_shared<Oriented>();
    oriented_->mesh = mesh_;
    Edit edit(oriented_->mesh, nullptr);
    apply(edit, Orient());
    edit.commit();
  }
  orient_was_tried_ = true;
  return oriented_.get();
}

std::vector<std::string> Remedies::find(const AnyOp& op, const Verdict& verdict) {
  if (verdict.has(Rule::deleted)) return {};
  if (!verdict.has(Rule::copies)) return find_remedy(mesh_, op);
  // Nothing but turned faces takes a copy away.
  Oriented* const turned = oriented();
  if (!turned) return {};
  const Parsed<AnyOp> same = parse_line(turned->mesh, command_of(mesh_, op));
  if (!same.op) return {};
  const Verdict after = check(turned->mesh, *same.op);
  std::vector<std::string> lines{"orient"};
  if (after.legal()) return lines;
  const std::vector<std::string> rest = turned->remedies.find(*same.op, after);
  if (rest.empty()) return {};
  lines.insert(lines.end(), rest.begin(), rest.end());
  return lines;
}

}  // namespace ryosen::cli
