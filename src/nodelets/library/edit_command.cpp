// SPDX-License-Identifier: BSD-3-Clause
#include "nodelets/library/edit_command.hpp"

#include <stdexcept>

#include "mbncc/symmetry.hpp"
#include "nodelets/conversion/messages.hpp"

namespace mbncc::nodelets {
namespace {

using Request = mbncc_vision::EditObject::Request;

[[noreturn]] void refuse(const std::string& sentence) {
  throw std::invalid_argument(sentence);
}

ObjectModel set_reference(ObjectLibrary& library, const Request& request) {
  const auto reference = from_msg(request.reference);
  if (!reference)
    refuse("the reference must be finite and within 32768 px; give x, y [px] and theta [rad]");
  return library.edit(request.name, [&](ObjectModel& model) { move_reference(model, *reference); });
}

ObjectModel set_grasp(ObjectLibrary& library, const Request& request) {
  const auto grasp = from_msg(request.grasp);
  if (!request.clear && !grasp)
    refuse("the grasp needs a position within 10 m and a quaternion of unit length");
  return library.edit(request.name, [&](ObjectModel& model) {
    model.grasp = request.clear ? std::nullopt : grasp;
  });
}

ObjectModel set_threshold(ObjectLibrary& library, const Request& request) {
  if (!request.clear && !(request.min_score > 0 && request.min_score <= 1))
    refuse("min_score must lie above 0 and not above 1; set clear to use the matcher's");
  return library.edit(request.name, [&](ObjectModel& model) {
    model.min_score = request.clear ? std::nullopt : std::optional<double>(request.min_score);
  });
}

ObjectModel set_symmetry(ObjectLibrary& library, const Request& request) {
  const auto symmetry = symmetry_from_msg(request.symmetry);
  return library.edit(request.name,
                      [symmetry](ObjectModel& model) { declare_symmetry(model, symmetry); });
}

ObjectModel rename(ObjectLibrary& library, const Request& request) {
  if (request.new_name.empty() && request.label.empty())
    refuse("nothing to rename; give new_name, label or both");
  return library.rename(request.name, request.new_name, request.label);
}

ObjectModel set_enabled(ObjectLibrary& library, const std::string& name, bool enabled) {
  return library.edit(name, [enabled](ObjectModel& model) { model.enabled = enabled; });
}

}  // namespace

ObjectModel edit_object(ObjectLibrary& library, const Request& request) {
  switch (request.command) {
    case Request::ENABLE:
      return set_enabled(library, request.name, true);
    case Request::DISABLE:
      return set_enabled(library, request.name, false);
    case Request::RENAME:
      return rename(library, request);
    case Request::DELETE:
      return library.remove(request.name);
    case Request::RESTORE:
      return library.restore(request.name, request.revision);
    case Request::SET_REFERENCE:
      return set_reference(library, request);
    case Request::SET_GRASP:
      return set_grasp(library, request);
    case Request::SET_THRESHOLD:
      return set_threshold(library, request);
    case Request::SET_SYMMETRY:
      return set_symmetry(library, request);
    default:
      refuse("command " + std::to_string(request.command) +
             " does not exist; see srv/EditObject.srv");
  }
}

}  // namespace mbncc::nodelets
