// The history of a document, and what is on trial beside it.
#include <algorithm>
#include <cassert>
#include <new>
#include <utility>

#include "ryosen/document/document.h"

namespace ryosen {

void Document::make_room_in_history() {
  if (history_.size() == history_.capacity()) history_.reserve(2 * history_.size() + 1);
}

void Document::committed(HistoryEntry entry, OtherQuarantine other) {
  const std::size_t transaction = journal_.position() - 1;
  history_.resize(transaction);
  other_quarantine_.erase(other_quarantine_.lower_bound(transaction), other_quarantine_.end());
  history_.push_back(std::move(entry));
  if (!other.empty()) {
    other_quarantine_.merge(other);
    exchange_quarantine(transaction);
  }
  if (saved_position_ >= journal_.position()) saved_position_ = no_index;  // that position can no longer be reached
  held_.in_history = std::min(held_.in_history, transaction);
  notify(journal_, transaction, Change::made);
}

void Document::mark_unsaved() {
  saved_position_ = no_index;
  held_ = {};
}

Document::Unsaved Document::unsaved() const {
  const std::size_t common = std::min(held_.in_history, position());
  return {position() - common, held_.entries - common};
}

void Document::exchange_quarantine(std::size_t transaction) {
  const auto other = other_quarantine_.find(transaction);
  if (other != other_quarantine_.end()) std::swap(tables_.quarantine, other->second);
}

void Document::notify(const Journal& journal, std::size_t transaction, Change change) {
  ++revision_;
  for (const Listener& listener : listeners_) listener(journal, transaction, change);
}

Outcome Document::try_out(const AnyOp& op) {
  Verdict verdict = check(mesh_, op);
  if (!verdict.legal()) return refuse(command_of(mesh_, op), std::move(verdict.reasons));
  {
    Edit edit(writable(), &trial_);
    ryosen::apply(edit, op);
    edit.commit();
  }
  notify(trial_, 0, Change::tried);
  return {};
}

std::optional<EachResult> Document::try_out(const OpInfo& op, std::span<const Element> elements,
                                            std::span<const std::string_view> arguments, Progress::Report report) {
  end_trial();
  EachResult result;
  {
    Progress progress(std::move(report));
    Edit edit(writable(), &trial_);
    result = ryosen::apply_to_each(edit, op, elements, arguments, false, progress);
    if (progress.is_cancelled()) return std::nullopt;
    if (result.done == 0 || result.error != NameError::none) return result;
    edit.commit();
  }
  notify(trial_, 0, Change::tried);
  return result;
}

std::optional<AlgorithmResult> Document::try_out(const AlgorithmRow& row, const ParameterValues& values,
                                                 Progress::Report report) {
  end_trial();
  AlgorithmResult result;
  {
    Progress progress(std::move(report));
    Edit edit(writable(), &trial_);
    result = run_in(edit, row, values, {}, progress);
    if (progress.is_cancelled()) return std::nullopt;
    if (result.changed == 0) return result;
    edit.commit();
  }
  notify(trial_, 0, Change::tried);
  return result;
}

void Document::show_on_trial(MeshColumns columns) {
  {
    Edit edit(writable(), &trial_);
    edit.replace_by_other(std::move(columns));
    edit.commit();
  }
  notify(trial_, 0, Change::tried);
}

void Document::end_trial() {
  if (!is_on_trial()) return;
  if (before_writing) before_writing();
  trial_.undo(mesh_);
  notify(trial_, 0, Change::trial_ended);
  trial_.clear();
}

std::optional<std::size_t> Document::unsaved_edits() const {
  if (saved_position_ == no_index) return std::nullopt;
  return std::max(saved_position_, position()) - std::min(saved_position_, position());
}

bool Document::undo() {
  if (!journal_.can_undo()) return false;
  journal_.undo(writable());
  exchange_quarantine(journal_.position());
  notify(journal_, journal_.position(), Change::undone);
  return true;
}

bool Document::redo() {
  if (!journal_.can_redo()) return false;
  journal_.redo(writable());
  exchange_quarantine(journal_.position() - 1);
  notify(journal_, journal_.position() - 1, Change::redone);
  return true;
}

void Document::go_to(std::size_t position) {
  while (journal_.position() > position && undo()) {
  }
  while (journal_.position() < position && redo()) {
  }
}

void Document::take_back(std::size_t position) {
  if (is_on_trial()) {
    if (before_writing) before_writing();
    trial_.withdraw(mesh_);
    ++revision_;
  }
  while (journal_.position() > position && !journal_.is_last_redone()) {
    const std::size_t transaction = journal_.position() - 1;
    if (before_writing) before_writing();
    journal_.withdraw(mesh_);
    exchange_quarantine(transaction);
    other_quarantine_.erase(other_quarantine_.lower_bound(transaction), other_quarantine_.end());
    history_.resize(transaction);
    ++revision_;
  }
  go_to(position);
}

Mesh Document::without_trial() const {
  Mesh mesh = mesh_;
  if (is_on_trial()) Journal(trial_).undo(mesh);
  return mesh;
}

// The way back needs no memory. Nobody is told: it is as it was.
Mesh Document::before_last_entry() {
  if (!journal_.can_undo()) return mesh_;
  journal_.undo(writable());
  Mesh before;
  try {
    before = mesh_;
  } catch (const std::bad_alloc&) {
    journal_.redo(mesh_);
    throw;
  }
  journal_.redo(mesh_);
  return before;
}

}  // namespace ryosen
