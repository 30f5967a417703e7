// SPDX-License-Identifier: BSD-3-Clause
#include "mbncc/library/object_file.hpp"

#include <stdexcept>

#include "library/file_io.hpp"
#include "library/object_yaml.hpp"
#include "library/png_codec.hpp"

namespace mbncc {
namespace {

constexpr int kBgrAndMapToRgba[] = {2, 0, 1, 1, 0, 2, 3, 3};

std::vector<cv::Rect> stack(const std::vector<View>& views) {
  std::vector<cv::Rect> rectangles;
  int top = 0;
  for (const auto& view : views) {
    rectangles.emplace_back(cv::Point(0, top), view.map.size());
    top += view.map.rows;
  }
  return rectangles;
}

cv::Size canvas_of(const std::vector<cv::Rect>& rectangles) {
  cv::Rect all;
  for (const auto& rectangle : rectangles) all |= rectangle;
  return all.size();
}

cv::Mat draw_rgba(const std::vector<View>& views, const std::vector<cv::Rect>& rectangles) {
  cv::Mat rgba = cv::Mat::zeros(canvas_of(rectangles), CV_8UC4);
  for (std::size_t i = 0; i < views.size(); ++i) {
    cv::Mat target = rgba(rectangles[i]);
    const cv::Mat sources[] = {views[i].template_image, views[i].map};
    cv::mixChannels(sources, 2, &target, 1, kBgrAndMapToRgba, 4);
  }
  return rgba;
}

std::string checked_description(const ObjectModel& model, const std::vector<cv::Rect>& rectangles) {
  const std::string text = library::write_description(model, rectangles);
  try {
    library::read_description(text);
  } catch (const std::exception& error) {
    throw std::invalid_argument(std::string("the object cannot be stored: ") + error.what());
  }
  return text;
}

// The file's name up to its first dot, so that "wrench.3.png" in the trash belongs to "wrench".
std::string name_of(const std::string& path) {
  const std::string file = path.substr(path.find_last_of('/') + 1);
  return file.substr(0, file.find('.'));
}

void check_stacked(const std::vector<cv::Rect>& rectangles, cv::Size canvas) {
  int top = 0;
  for (const auto& rectangle : rectangles) {
    if (rectangle.x != 0 || rectangle.y != top || rectangle.empty() ||
        rectangle.height > canvas.height - top || rectangle.width > canvas.width)
      throw std::runtime_error("its views are not stacked from top to bottom");
    top += rectangle.height;
  }
  if (top != canvas.height) throw std::runtime_error("its views do not fill the image");
}

void read_view_row(const std::vector<std::uint8_t>& rgba, View& view, int row) {
  auto* colour = view.template_image.ptr<cv::Vec3b>(row);
  auto* map = view.map.ptr<std::uint8_t>(row);
  for (int x = 0; x < view.map.cols; ++x) {
    const std::uint8_t* pixel = &rgba[4 * static_cast<std::size_t>(x)];
    colour[x] = {pixel[2], pixel[1], pixel[0]};
    map[x] = pixel[3];
  }
}

void read_views(library::PngReader& reader, library::ObjectDescription& description) {
  check_stacked(description.rectangles, reader.size());
  std::vector<std::uint8_t> row(4 * static_cast<std::size_t>(reader.size().width));
  for (auto& view : description.model.views) {
    const auto& rectangle =
        description.rectangles[static_cast<std::size_t>(&view - description.model.views.data())];
    view.template_image.create(rectangle.size(), CV_8UC3);
    view.map.create(rectangle.size(), CV_8UC1);
    for (int y = 0; y < rectangle.height; ++y) {
      reader.read_row(row.data());
      read_view_row(row, view, y);
    }
  }
  reader.finish();
}

ObjectModel decode(const std::vector<std::uint8_t>& bytes, const std::string& name) {
  if (!is_valid_name(name)) throw std::runtime_error("the file's name is not a valid object name");
  library::PngReader reader(bytes, library::kTextKey);
  library::ObjectDescription description = library::read_description(reader.text());
  description.model.name = name;
  read_views(reader, description);
  validate(description.model);
  return std::move(description.model);
}

}  // namespace

std::vector<std::uint8_t> encode_object(const ObjectModel& model) {
  validate(model);
  const auto rectangles = stack(model.views);
  if (!library::PngLimits::hold(canvas_of(rectangles)))
    throw std::invalid_argument("the object's views are too large to be stored in one file");
  return library::encode_png(draw_rgba(model.views, rectangles), library::kTextKey,
                             checked_description(model, rectangles));
}

ObjectModel decode_object(const std::vector<std::uint8_t>& bytes, const std::string& path) {
  try {
    return decode(bytes, name_of(path));
  } catch (const std::bad_alloc&) {
    throw FileError(path, "not enough memory to read it");
  } catch (const cv::Exception& error) {
    throw FileError(path, error.what());
  } catch (const library::NewerFormat& error) {
    throw library::NewerFileError(path, error.what());
  } catch (const std::exception& error) {
    throw library::ContentError(path, error.what());
  }
}

bool is_object_file(const std::string& path) {
  try {
    const auto content = library::read_regular_file(path, library::PngLimits::kMaxBytes);
    return !library::PngReader(content.bytes, library::kTextKey).text().empty();
  } catch (const std::exception&) {
    return false;
  }
}

ObjectModel read_object_file(const std::string& path) {
  return decode_object(library::read_regular_file(path, library::PngLimits::kMaxBytes).bytes, path);
}

}  // namespace mbncc
