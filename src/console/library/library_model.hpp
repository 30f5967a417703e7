// SPDX-License-Identifier: BSD-3-Clause
// Model of the library strip: the known objects, and edits with undo.
#pragma once

#include <mbncc_vision/EditObject.h>
#include <mbncc_vision/LearnedObject.h>

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace mbncc::console {

class LibraryModel {
 public:
  using Request = mbncc_vision::EditObject::Request;

  void set_objects(std::vector<mbncc_vision::LearnedObject> objects);
  const std::vector<mbncc_vision::LearnedObject>& objects() const { return objects_; }

  static Request enable(const std::string& name, bool enabled);
  static Request rename(const std::string& name, const std::string& new_name);
  static Request remove(const std::string& name);
  /// `symmetry` is one of LearnObjectGoal's SYMMETRY_...; records the current one for undo().
  Request declare(const std::string& name, std::uint8_t symmetry);
  /// Restores a revision from the trash; records the object's current one for undo().
  Request restore(const std::string& name, std::uint32_t revision);
  /// Sets the object's own min_score; 0: the matcher's applies. Records the current one for undo().
  Request set_threshold(const std::string& name, double min_score);

  /// The object of that name; null: none.
  const mbncc_vision::LearnedObject* find(const std::string& name) const;
  std::vector<std::string> names() const;

  /// A lesson begins; if an object has that name, notes the revision that an undo restores. The
  /// list may contain the new revision before the lesson's result arrives.
  void begin_lesson(const std::string& name);
  /// The lesson has stored an object; if it replaced one or added a view, this can be undone.
  void retaught(const std::string& name);

  /// An edit was carried out; it can be undone from now on.
  void done(const Request& request);
  bool can_undo() const { return !undo_.empty(); }
  /// The edit that undoes the last one; call only if can_undo().
  Request undo() const { return undo_.back(); }
  std::string undo_text() const;
  /// The last edit was undone, or cannot be undone.
  void undone() { undo_.pop_back(); }

 private:
  void record(const std::string& name);

  std::vector<mbncc_vision::LearnedObject> objects_;
  std::map<std::string, mbncc_vision::LearnedObject> before_;  // a recorded edit; revision 0: none
  std::optional<Request> before_lesson_;  // restores the object that is being taught again
  std::vector<Request> undo_;
};

}  // namespace mbncc::console
