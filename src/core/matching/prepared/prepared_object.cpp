// SPDX-License-Identifier: BSD-3-Clause
#include "matching/prepared/prepared_object.hpp"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

#include "imaging/pyramid.hpp"
#include "matching/scene/grey_image.hpp"
#include "matching/template/colours_beside.hpp"
#include "mbncc/matching/symmetry.hpp"

namespace mbncc::prepared {
namespace {

/// Largest numbers of points of a template.
struct PointCounts {
  std::size_t surface, contour;
};
constexpr PointCounts kRoughPoints{48, 32};     // ranks proposals
constexpr PointCounts kTrackedPoints{112, 64};  // alignment at each level
constexpr PointCounts kVerifiedPoints{640, 200};
constexpr PointCounts kRefinedPoints{2500, 200};

constexpr double kNearSize = 0.05;  // relative change of size that heights and tilts cause

cv::Mat grey_of(const View& view) {
  cv::Mat grey;
  cv::cvtColor(view.template_image, grey, cv::COLOR_BGR2GRAY);
  return grey;
}

bool shows_colour(const ObjectModel& model) {
  return std::none_of(model.views.begin(), model.views.end(),
                      [](const View& view) { return scene::is_grey(view.template_image); });
}

View as_grey(const View& view) {
  View result = view;
  result.template_image = cv::Mat();  // the model's own pixels stay as they are
  cv::cvtColor(grey_of(view), result.template_image, cv::COLOR_GRAY2BGR);
  return result;
}

/// The map without its rim, where template pixels mix with the background; the whole map if little
/// would remain.
cv::Mat without_rim(const cv::Mat& map) {
  cv::Mat padded, inner;
  cv::copyMakeBorder(map, padded, 1, 1, 1, 1, cv::BORDER_CONSTANT, cv::Scalar(0));
  cv::erode(padded, inner, cv::getStructuringElement(cv::MORPH_ELLIPSE, {3, 3}));
  inner = inner(cv::Rect({1, 1}, map.size())).clone();
  return 2 * cv::countNonZero(inner) > cv::countNonZero(map) ? inner : map;
}

Pose2D reference_in_crop(const View& view, cv::Point2d anchor) {
  return {view.reference.x - view.origin.x - anchor.x, view.reference.y - view.origin.y - anchor.y,
          view.reference.theta};
}

/// The view scaled as from another distance.
View rescaled(const View& view, double scale) {
  if (scale == 1) return view;
  View result = view;
  const int method = scale < 1 ? cv::INTER_AREA : cv::INTER_CUBIC;
  cv::resize(view.template_image, result.template_image, {}, scale, scale, method);
  cv::resize(view.map, result.map, result.template_image.size(), 0, 0, cv::INTER_LINEAR);
  double most = 0;  // less than 255 if only a pixel of the map remains
  cv::minMaxLoc(result.map, nullptr, &most);
  result.map = result.map > std::min(127.0, most / 2);
  const cv::Point2d in_crop = view.reference.position() - cv::Point2d(view.origin);
  result.origin = {0, 0};
  result.reference.x = (in_crop.x + 0.5) * scale - 0.5;
  result.reference.y = (in_crop.y + 0.5) * scale - 0.5;
  return result;
}

/// Pyramid with all levels up to `top`, also for maps only a few pixels wide, for which
/// build_pyramid() returns fewer.
std::vector<cv::Mat> whole_pyramid(const cv::Mat& image, int top) {
  const int least = imaging::kSmallestLevel << top;
  cv::Mat wide;
  cv::copyMakeBorder(image, wide, 0, std::max(0, least - image.rows), 0,
                     std::max(0, least - image.cols), cv::BORDER_REPLICATE);
  return imaging::build_pyramid(wide, top);
}

templates::PoseTemplate resized_by(double factor, templates::PoseTemplate object) {
  object.surface.resize(factor);
  object.contour.resize(factor);
  return object;
}

ResizedTemplates resized_templates(double change, const templates::PoseTemplate& object) {
  return {1 + change, resized_by(1 + change, object), resized_by(1 + 2 * change, object)};
}

/// The scales to search within 1 +- `range`, the learned one first. A search tolerates 3 % in
/// either direction.
std::vector<double> scales_within(double range) {
  constexpr double kStep = 0.06, kBorne = 0.03;
  std::vector<double> scales{1};
  for (double off = kStep; off - kBorne < range; off += kStep) {
    scales.push_back(1 - std::min(off, range));
    scales.push_back(1 + std::min(off, range));
  }
  return scales;
}

/// The declared symmetry, otherwise the one measured with certainty.
int symmetry_of(const ObjectModel& model, const View& view) {
  return model.symmetry ? *model.symmetry : measure_symmetry(view).certain;
}

/// The centre [px, from the anchor] of the view's symmetry, in a `lesson` that shows it, where a
/// refinement from the turned pose finds the same object again.
cv::Point2d symmetry_centre(const PreparedView& view, const View& learned) {
  constexpr int kSteps = 6;
  if (view.symmetry == 1) return {};
  // The multiple that is nearest to half a turn fixes the centre best; a round object has them all.
  const double turn = view.symmetry == 0 ? kPi : 2 * kPi / view.symmetry * (view.symmetry / 2);
  const cv::Point2d middle = centroid(learned.map) - view.anchor;
  const cv::Point2d start = view.anchor + middle - rotate(middle, turn);
  const scene::SceneLevel lesson(learned.template_image, 0);
  const Pose2D again =
      refinement::refine(view.dense, lesson, {start.x, start.y, turn}, kSteps).pose;
  // The fixed point c of that motion: c = t + R c.
  const double c = std::cos(again.theta), s = std::sin(again.theta);
  const cv::Matx22d remaining(1 - c, s, -s, 1 - c);
  const cv::Point2d way = again.position() - view.anchor;
  return cv::Point2d(remaining.inv() * cv::Vec2d(way.x, way.y));
}

}  // namespace

/// Images from which all members are computed.
struct PreparedView::Source {
  explicit Source(const View& learned)
      : view(learned),
        grey(grey_of(learned)),
        inner(without_rim(learned.map)),
        anchor(excircle(learned.map).centre),
        surface(templates::continued_outwards(learned.template_image, learned.map)) {}

  const View& view;
  cv::Mat grey, inner;
  cv::Point2d anchor;
  cv::Mat surface;  // CV_8UC3, without the background
};

PreparedView::PreparedView(const View& view, Engine engine, double scale)
    : PreparedView(Source(rescaled(view, scale)), engine) {
  this->scale = scale;
}

PreparedView::PreparedView(const Source& source, Engine engine)
    : ViewFrame{1,
                reference_in_crop(source.view, source.anchor),
                templates::MapFootprint(source.view.map, source.anchor),
                1,
                {},
                {}},
      anchor(source.anchor),
      geometry(source.view.map),
      colour_prefilter(source.surface, source.view.map, anchor, geometry.mean_width()),
      template_bank(proposal::rotated_kernels(source.grey, source.view.map, anchor)),
      contour_bank(geometry, anchor),
      points(masked_template(source.grey, source.view.map, anchor)) {
  const int top = std::max(template_bank.level, contour_bank.level());
  const auto surfaces = whole_pyramid(source.surface, top);
  const auto images = whole_pyramid(source.view.template_image, top);
  for (int level = 0; level < static_cast<int>(surfaces.size()); ++level) {
    const scene::SceneLevel continued(surfaces[level], level), image(images[level], level);
    const templates::SurfaceTemplate::Source from{continued.whole(), geometry,
                                                  source.view.map.size(), level};
    const auto edge = templates::ContourTemplate::edge_of(geometry, level);
    const auto prepare = [&](const PointCounts& most) {
      return templates::PoseTemplate{templates::SurfaceTemplate(from, anchor, most.surface),
                                     templates::ContourTemplate(edge, anchor, level, most.contour)};
    };
    rough.push_back(prepare(kRoughPoints));
    tracked.push_back(prepare(kTrackedPoints));
    if (level > 0) continue;
    fine = prepare(kVerifiedPoints);
    dense = refinement::RefinementTemplate(prepare(kRefinedPoints), continued.whole());
    prepare_verification(source.view.map, image);
  }
  resized = {resized_templates(-kNearSize, fine), resized_templates(kNearSize, fine)};
  if (engine == Engine::kPolar) polar.emplace(source.view);
  const auto all = outlines(source.view);
  if (!all.empty()) outline = all.front();
}

/// Prepares what is compared beside `fine`. `lesson` is the learning image at full resolution.
void PreparedView::prepare_verification(const cv::Mat& map, const scene::SceneLevel& lesson) {
  const Pose2D learned{anchor.x, anchor.y, 0};
  parts = evidence::ColourParts(fine.surface, fine.contour,
                                templates::background_colour(fine.contour, lesson, learned));
  ratios = evidence::RatioResidual(fine.surface, shape.area());
  outline_contrast = evidence::OutlineContrast(fine.contour, lesson, learned, shape.area());
  interior_edges = evidence::InteriorEdges(lesson, map, anchor);
  print = evidence::PrintComparison(lesson, map, anchor);
  mirrored_contour = evidence::MirroredContour(fine.contour, lesson, learned);
}

PreparedObject::PreparedObject(std::shared_ptr<const ObjectModel> object, Engine engine,
                               double scale_range)
    : PreparedObject(object, engine, scale_range, shows_colour(*object)) {
  if (coloured)
    in_grey = numeric::Lazy<std::shared_ptr<const PreparedObject>>([object, engine, scale_range] {
      return std::shared_ptr<const PreparedObject>(
          new PreparedObject(object, engine, scale_range, false));
    });
}

PreparedObject::PreparedObject(std::shared_ptr<const ObjectModel> object, Engine engine,
                               double scale_range, bool in_colour)
    : model(std::move(object)), coloured(in_colour) {
  validate(*model);
  std::vector<int> symmetries;
  for (const auto& view : model->views) symmetries.push_back(symmetry_of(*model, view));
  for (const double scale : scales_within(scale_range))
    for (std::size_t i = 0; i < model->views.size(); ++i) {
      const View learned = coloured ? model->views[i] : as_grey(model->views[i]);
      views.emplace_back(learned, engine, scale);
      views.back().symmetry = symmetries[i];
      views.back().symmetry_centre = symmetry_centre(views.back(), rescaled(learned, scale));
    }
}

int PreparedObject::top_level() const {
  int top = 0;
  for (const auto& view : views)
    top = std::max({top, view.top_level(), view.colour_prefilter.level(),
                    view.polar ? view.polar->top_level() : 0});
  return top;
}

int PreparedObject::least_image() const {
  int level = 0;
  for (const auto& view : views)
    level = std::max(level, view.polar ? view.polar->top_level() : view.top_level());
  return imaging::kSmallestLevel << level;
}

void PreparedObject::make_rotations() const {
  for (const auto& view : views) {
    if (view.template_bank.searched()) view.template_bank.kernels.make();
    view.colour_prefilter.make_rotations();
  }
}

}  // namespace mbncc::prepared
