// SPDX-License-Identifier: BSD-3-Clause
#include "console/library/library_model.hpp"

#include <utility>

namespace mbncc::console {

void LibraryModel::set_objects(std::vector<mbncc_vision::LearnedObject> objects) {
  objects_ = std::move(objects);
}

const mbncc_vision::LearnedObject* LibraryModel::find(const std::string& name) const {
  for (const auto& object : objects_)
    if (object.name == name) return &object;
  return nullptr;
}

std::vector<std::string> LibraryModel::names() const {
  std::vector<std::string> names;
  for (const auto& object : objects_) names.push_back(object.name);
  return names;
}

void LibraryModel::begin_lesson(const std::string& name) {
  before_lesson_.reset();
  const auto* before = find(name);
  if (before == nullptr) return;
  before_lesson_.emplace();
  before_lesson_->name = name;
  before_lesson_->command = Request::RESTORE;
  before_lesson_->revision = before->revision;
}

void LibraryModel::retaught(const std::string& name) {
  if (before_lesson_ && before_lesson_->name == name) undo_.push_back(*before_lesson_);
  before_lesson_.reset();
}

LibraryModel::Request LibraryModel::enable(const std::string& name, bool enabled) {
  Request request;
  request.name = name;
  request.command = enabled ? Request::ENABLE : Request::DISABLE;
  return request;
}

LibraryModel::Request LibraryModel::rename(const std::string& name, const std::string& new_name) {
  Request request;
  request.name = name;
  request.command = Request::RENAME;
  request.new_name = new_name;
  return request;
}

LibraryModel::Request LibraryModel::remove(const std::string& name) {
  Request request;
  request.name = name;
  request.command = Request::DELETE;
  return request;
}

LibraryModel::Request LibraryModel::declare(const std::string& name, std::uint8_t symmetry) {
  record(name);
  Request request;
  request.name = name;
  request.command = Request::SET_SYMMETRY;
  request.symmetry = symmetry;
  return request;
}

LibraryModel::Request LibraryModel::restore(const std::string& name, std::uint32_t revision) {
  record(name);
  Request request;
  request.name = name;
  request.command = Request::RESTORE;
  request.revision = revision;
  return request;
}

LibraryModel::Request LibraryModel::set_threshold(const std::string& name, double min_score) {
  record(name);
  Request request;
  request.name = name;
  request.command = Request::SET_THRESHOLD;
  request.min_score = static_cast<float>(min_score);
  request.clear = min_score <= 0;
  return request;
}

void LibraryModel::record(const std::string& name) {
  const auto* object = find(name);
  before_[name] = object != nullptr ? *object : mbncc_vision::LearnedObject();
}

void LibraryModel::done(const Request& request) {
  Request inverse = request;
  const auto& before = before_[request.name];
  switch (request.command) {
    case Request::ENABLE:
      inverse.command = Request::DISABLE;
      break;
    case Request::DISABLE:
      inverse.command = Request::ENABLE;
      break;
    case Request::RENAME:
      std::swap(inverse.name, inverse.new_name);
      break;
    case Request::DELETE:
      inverse.command = Request::RESTORE;
      break;
    case Request::RESTORE:
      if (before.revision == 0) inverse.command = Request::DELETE;
      inverse.revision = before.revision;
      break;
    case Request::SET_THRESHOLD:
      inverse.min_score = before.min_score;
      inverse.clear = !(before.min_score > 0);
      break;
    case Request::SET_SYMMETRY:
      inverse.symmetry = before.symmetry;
      break;
    default:
      return;
  }
  undo_.push_back(inverse);
}

std::string LibraryModel::undo_text() const {
  if (undo_.empty()) return "Undo";
  const Request& last = undo_.back();
  switch (last.command) {
    case Request::DISABLE:
      return "Undo: disable '" + last.name + "'";
    case Request::ENABLE:
      return "Undo: enable '" + last.name + "'";
    case Request::RENAME:
      return "Undo: rename to '" + last.new_name + "'";
    case Request::SET_SYMMETRY:
      return "Undo: symmetry of '" + last.name + "'";
    case Request::SET_THRESHOLD:
      return "Undo: min_score of '" + last.name + "'";
    case Request::DELETE:
      return "Undo: delete '" + last.name + "' again";
    default:
      return last.revision == 0 ? "Undo: restore '" + last.name + "'"
                                : "Undo: restore revision " + std::to_string(last.revision) +
                                      " of '" + last.name + "'";
  }
}

}  // namespace mbncc::console
