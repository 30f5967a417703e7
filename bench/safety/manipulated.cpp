// SPDX-License-Identifier: BSD-3-Clause
// Images in which something is wrong with the object: torn between two moments, mirrored, with
// another surface, half covered, glossy, or with another object on top. Every graspable detection
// in them must be correct. If a drawn object looks the same after part of a turn, the truth may
// state no symmetry; such poses are counted separately.
#include <algorithm>
#include <filesystem>
#include <iostream>
#include <map>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>
#include <set>
#include <stdexcept>
#include <string_view>
#include <vector>

#include "common/case_folder.hpp"
#include "common/program.hpp"
#include "common/table.hpp"
#include "mbncc/matching/matcher.hpp"

namespace mbncc::bench {
namespace {

namespace fs = std::filesystem;

constexpr const char* kOptions =
    "{@out   |   | folder for the images in which a wrong pose could be grasped }"
    "{@sets  |   | folders of sets (bench/README.md), with commas between them }"
    "{each   | 2 | images of each kind per instance }"
    "{kinds  |   | of what is done to the images, with commas between them; all if empty }"
    "{most   | 0 | cases per set; 0: all }"
    "{seed   | 1 | random seed of the manipulations }"
    "{help h |   | this text }";

/// A target with one instance of an object, and another object used for the manipulation.
struct Scene {
  const CaseFolder& object;
  const CaseFolder& other;
  const Instance& instance;
  cv::Mat image;
  bool has_mirror_image = false;  ///< a mirror image of the object lies beside it
};

/// A manipulated image, and the correct poses of the object in it.
struct Spoiled {
  cv::Mat image;
  std::vector<Pose2D> poses;  ///< poses between two of them are also correct; empty: none is
};

/// Transform [px] from the learning image of a case to a target.
cv::Matx23d placing(const CaseFolder& object, const Pose2D& pose) {
  const double c = std::cos(pose.theta), s = std::sin(pose.theta);
  const cv::Point2d r = object.reference;
  return {c, -s, pose.x - c * r.x + s * r.y, s, c, pose.y - s * r.x - c * r.y};
}

cv::Mat placed_map(const CaseFolder& object, const Pose2D& pose, cv::Size size) {
  cv::Mat map;
  cv::warpAffine(object.map, map, placing(object, pose), size, cv::INTER_LINEAR);
  return map > 127;
}

cv::Mat placed_image(const CaseFolder& object, const Pose2D& pose, cv::Size size) {
  cv::Mat image;
  cv::warpAffine(object.before, image, placing(object, pose), size, cv::INTER_LINEAR,
                 cv::BORDER_REFLECT);
  return image;
}

Spoiled untouched(const Scene& scene, cv::RNG&) {
  return {scene.image, {scene.instance.pose}};
}

/// From row `from` on, the image shows `moved`, which is displaced by `way` [px].
struct Tear {
  int from;
  double way;
  cv::Matx23d shift;
  cv::Mat moved;
};

/// A tear within the object, displaced by 4 to 10 px.
Tear tear_within(const cv::Rect& box, const cv::Mat& image, cv::RNG& random) {
  Tear tear;
  tear.way = random.uniform(4., 10.) * (random.uniform(0, 2) == 0 ? 1 : -1);
  tear.from = box.y + cvRound(random.uniform(0.3, 0.7) * box.height);
  tear.shift = {1, 0, tear.way, 0, 1, 0};
  cv::warpAffine(image, tear.moved, tear.shift, image.size(), cv::INTER_LINEAR,
                 cv::BORDER_REPLICATE);
  return tear;
}

/// The image above the tear, and `later` below it.
Spoiled torn_at(const Tear& tear, const Scene& scene, const cv::Mat& later) {
  Spoiled spoiled{scene.image.clone(), {scene.instance.pose, scene.instance.pose}};
  later.rowRange(tear.from, later.rows).copyTo(spoiled.image.rowRange(tear.from, later.rows));
  spoiled.poses.back().x += tear.way;
  return spoiled;
}

Spoiled torn(const Scene& scene, cv::RNG& random) {
  const cv::Mat map = placed_map(scene.object, scene.instance.pose, scene.image.size());
  const Tear tear = tear_within(cv::boundingRect(map), scene.image, random);
  return torn_at(tear, scene, tear.moved);
}

/// Only the object is torn; the background is at rest.
Spoiled torn_object(const Scene& scene, cv::RNG& random) {
  const cv::Size size = scene.image.size();
  const cv::Mat map = placed_map(scene.object, scene.instance.pose, size);
  const cv::Rect box = cv::boundingRect(map);
  const Tear tear = tear_within(box, scene.image, random);
  cv::Mat moved_map, whole, background, later = scene.image.clone();
  cv::warpAffine(map, moved_map, tear.shift, size, cv::INTER_NEAREST);
  cv::dilate(map, whole, cv::Mat::ones(5, 5, CV_8UC1));
  cv::warpAffine(scene.image, background, cv::Matx23d(1, 0, box.width + 8, 0, 1, 0), size,
                 cv::INTER_NEAREST, cv::BORDER_WRAP);
  background.copyTo(later, whole);
  tear.moved.copyTo(later, moved_map);
  return torn_at(tear, scene, later);
}

Spoiled mirrored(const Scene& scene, cv::RNG&) {
  Spoiled spoiled;
  cv::flip(scene.image, spoiled.image, 1);
  return spoiled;
}

/// The learning image of the other object within the outline.
Spoiled other_print(const Scene& scene, cv::RNG& random) {
  Spoiled spoiled{scene.image.clone(), {}};
  Pose2D pose = scene.instance.pose;
  pose.theta = random.uniform(-kPi, kPi);
  placed_image(scene.other, pose, scene.image.size())
      .copyTo(spoiled.image, placed_map(scene.object, scene.instance.pose, scene.image.size()));
  return spoiled;
}

/// Covers half of the object with another part of the image.
Spoiled half_covered(const Scene& scene, cv::RNG& random) {
  const cv::Size size = scene.image.size();
  const Pose2D& pose = scene.instance.pose;
  const double angle = random.uniform(-kPi, kPi), far = 4.0 * (size.width + size.height);
  const cv::Point2d along(std::cos(angle), std::sin(angle)), across(-along.y, along.x);
  const cv::Point2d at = pose.position();
  std::vector<cv::Point> half;
  for (const cv::Point2d& corner :
       {at - far * along, at + far * along, at + far * along + far * across,
        at - far * along + far * across})
    half.emplace_back(corner);
  cv::Mat side = cv::Mat::zeros(size, CV_8UC1), cover;
  cv::fillPoly(side, std::vector<std::vector<cv::Point>>{half}, cv::Scalar(255));
  const cv::Matx23d shift(1, 0, random.uniform(-0.5, 0.5) * size.width, 0, 1,
                          random.uniform(-0.5, 0.5) * size.height);
  cv::warpAffine(scene.image, cover, shift, size, cv::INTER_LINEAR, cv::BORDER_WRAP);
  Spoiled spoiled{scene.image.clone(), {pose}};
  cv::Mat covered;
  cv::dilate(placed_map(scene.object, pose, size), covered, cv::Mat::ones(9, 9, CV_8UC1));
  cover.copyTo(spoiled.image, covered & side);
  return spoiled;
}

/// White spots on about 15 % of the object.
Spoiled glossy(const Scene& scene, cv::RNG& random) {
  constexpr int kSpots = 3;
  const cv::Size size = scene.image.size();
  const cv::Mat map = placed_map(scene.object, scene.instance.pose, size);
  std::vector<cv::Point> inside;
  cv::findNonZero(map, inside);
  if (inside.empty()) return untouched(scene, random);
  const double radius = std::sqrt(0.15 * static_cast<double>(inside.size()) / kSpots / kPi);
  cv::Mat light = cv::Mat::zeros(size, CV_8UC1);
  for (int i = 0; i < kSpots; ++i)
    cv::circle(light, inside[random.next() % inside.size()], cvRound(radius), cv::Scalar(255),
               cv::FILLED);
  cv::GaussianBlur(light, light, {}, std::max(0.5, 0.3 * radius));
  light.setTo(0, ~map);
  cv::cvtColor(light, light, cv::COLOR_GRAY2BGR);
  return {scene.image + light, {scene.instance.pose}};
}

/// The other object on top, not centred.
Spoiled stacked(const Scene& scene, cv::RNG& random) {
  const double off = 0.3 * (scene.object.diameter + scene.other.diameter) * random.uniform(0.5, 1.);
  const double angle = random.uniform(-kPi, kPi);
  const Pose2D pose{scene.instance.pose.x + off * std::cos(angle),
                    scene.instance.pose.y + off * std::sin(angle), random.uniform(-kPi, kPi)};
  Spoiled spoiled{scene.image.clone(), {scene.instance.pose}};
  placed_image(scene.other, pose, scene.image.size())
      .copyTo(spoiled.image, placed_map(scene.other, pose, scene.image.size()));
  return spoiled;
}

cv::Point2d centroid(const cv::Mat& map) {
  const cv::Moments moments = cv::moments(map, true);
  return {moments.m10 / moments.m00, moments.m01 / moments.m00};
}

/// True if the outline differs from its mirror image at every rotation.
bool is_one_sided(const CaseFolder& object) {
  constexpr double kAlike = 0.85;  // fraction of the area
  CaseFolder mirror;
  cv::flip(object.map, mirror.map, 1);
  mirror.reference = centroid(mirror.map);
  const cv::Point2d own = centroid(object.map);
  for (int degrees = 0; degrees < 360; ++degrees) {
    const cv::Mat turned =
        placed_map(mirror, {own.x, own.y, to_radians(degrees)}, object.map.size());
    const double both = cv::countNonZero(turned & object.map);
    const double any = cv::countNonZero(turned | object.map);
    if (both > kAlike * any) return false;
  }
  return true;
}

double distance_to_way(cv::Point2d point, cv::Point2d from, cv::Point2d to) {
  const cv::Point2d way = to - from;
  const double length = way.dot(way);
  const double part = length > 0 ? std::clamp((point - from).dot(way) / length, 0., 1.) : 0;
  return cv::norm(point - from - part * way);
}

/// Compares modulo rotations by `symmetry`.
bool is_right(const Match& match, const Spoiled& spoiled, const Scene& scene, double symmetry) {
  if (spoiled.poses.empty()) return false;
  const double near = std::max(3.0, 0.03 * scene.object.diameter);
  const Pose2D &a = spoiled.poses.front(), &b = spoiled.poses.back();
  return distance_to_way(match.pose.position(), a.position(), b.position()) <= near &&
         angle_distance(match.pose.theta, a.theta, symmetry) <= to_radians(3);
}

struct Count {
  int images = 0, right = 0, wrong = 0, sure_wrong = 0;
  int turned = 0;  ///< correct except for a rotation that the match reports as a symmetry
};

/// A kind of manipulation.
struct Kind {
  std::string_view name;
  Spoiled (*spoil)(const Scene& scene, cv::RNG& random);
  bool varies = true;  ///< whether each repetition differs
};

constexpr std::string_view kMirrored = "mirrored";
constexpr Kind kKinds[] = {{"untouched", untouched, false},
                           {"torn", torn},
                           {"object torn", torn_object},
                           {kMirrored, mirrored, false},
                           {"other print", other_print},
                           {"half covered", half_covered},
                           {"glossy", glossy},
                           {"stacked", stacked}};

std::string known_kinds() {
  std::string names;
  for (const Kind& kind : kKinds) names.append(names.empty() ? "" : ", ").append(kind.name);
  return names;
}

class Trials {
 public:
  /// Runs only these `kinds`, or all if it is empty. Throws std::invalid_argument for an unknown
  /// kind.
  Trials(fs::path out, std::set<std::string> kinds, int seed)
      : out_(std::move(out)), kinds_(std::move(kinds)), random_(static_cast<std::uint64_t>(seed)) {
    for (const auto& name : kinds_)
      if (std::none_of(std::begin(kKinds), std::end(kKinds),
                       [&](const Kind& kind) { return kind.name == name; }))
        throw std::invalid_argument("unknown kind '" + name + "'; known are " + known_kinds());
  }

  void spoil(const Scene& scene, const Matcher& matcher, bool one_sided, int each) {
    for (const Kind& kind : kKinds) {
      if (!kinds_.empty() && kinds_.count(std::string(kind.name)) == 0) continue;
      if (kind.name == kMirrored && (!one_sided || scene.has_mirror_image)) continue;
      run(kind, scene, matcher, kind.varies ? each : 1);
    }
  }

  Table table() const {
    Table table{{"what was done", "images", "graspable right", "turned by a stated symmetry",
                 "wrong", "wrong above .99"},
                {}};
    for (const auto& [kind, count] : counts_)
      table.rows.push_back({kind, std::to_string(count.images), std::to_string(count.right),
                            std::to_string(count.turned), std::to_string(count.wrong),
                            std::to_string(count.sure_wrong)});
    return table;
  }

 private:
  void run(const Kind& kind, const Scene& scene, const Matcher& matcher, int draws) {
    for (int i = 0; i < draws; ++i) {
      const Spoiled spoiled = kind.spoil(scene, random_);
      Count& count = counts_[std::string(kind.name)];
      ++count.images;
      for (const auto& match : matcher.find(spoiled.image).matches) {
        if (!match.graspable) continue;
        if (is_right(match, spoiled, scene, scene.instance.symmetry)) {
          ++count.right;
        } else if (is_right(match, spoiled, scene, match.symmetry)) {
          ++count.turned;
          keep(std::string(kind.name) + " turned", scene, spoiled, match);
        } else {
          ++count.wrong;
          count.sure_wrong += match.score > 0.99 ? 1 : 0;
          keep(std::string(kind.name), scene, spoiled, match);
        }
      }
    }
  }

  void keep(std::string kind, const Scene& scene, const Spoiled& spoiled, const Match& match) {
    std::replace(kind.begin(), kind.end(), ' ', '_');
    const std::string name = std::to_string(kept_++) + '_' + kind + '_' + scene.object.name;
    std::cout << name << " at " << match.pose.x << ' ' << match.pose.y << ' '
              << to_degrees(match.pose.theta) << " for " << scene.instance.pose.x << ' '
              << scene.instance.pose.y << ' ' << to_degrees(scene.instance.pose.theta) << " score "
              << match.score << std::endl;
    cv::imwrite((out_ / (name + ".png")).string(), spoiled.image);
  }

  fs::path out_;
  std::set<std::string> kinds_;
  cv::RNG random_;
  std::map<std::string, Count> counts_;
  int kept_ = 0;
};

void spoil_set(const fs::path& set, std::size_t most, int each, Trials& trials) {
  std::vector<CaseFolder> cases;
  for (const auto& name : list_cases(set, most)) cases.push_back(read_case(set / name));
  for (std::size_t i = 0; i < cases.size(); ++i) {
    const CaseFolder& object = cases[i];
    auto model = std::make_shared<ObjectModel>();
    model->name = object.name;
    model->views.push_back(
        crop_view(object.before, object.map, {object.reference.x, object.reference.y, 0}));
    Matcher matcher;
    matcher.set_objects({model});
    const bool one_sided = is_one_sided(object);
    for (const auto& target : object.targets)
      if (target.instances.size() == 1)
        trials.spoil({object, cases[(i + 1) % cases.size()], target.instances.front(),
                      read_image(target.image),
                      std::count(target.tags.begin(), target.tags.end(), "mirror") > 0},
                     matcher, one_sided, each);
  }
}

/// Splits `list` at commas.
std::vector<std::string> parts_of(const std::string& list) {
  std::vector<std::string> parts;
  std::stringstream stream(list);
  for (std::string part; std::getline(stream, part, ',');) parts.push_back(part);
  return parts;
}

void benchmark(const cv::CommandLineParser& options) {
  const fs::path out = output_folder(options.get<std::string>("@out"));
  const auto kinds = parts_of(options.get<std::string>("kinds"));
  Trials trials(out, {kinds.begin(), kinds.end()}, options.get<int>("seed"));
  for (const auto& set : parts_of(options.get<std::string>("@sets")))
    spoil_set(set, static_cast<std::size_t>(options.get<int>("most")), options.get<int>("each"),
              trials);
  save_csv((out / "manipulated.csv").string(), trials.table());
  write_markdown(std::cout, trials.table());
}

}  // namespace
}  // namespace mbncc::bench

int main(int argc, char** argv) {
  return mbncc::bench::run_program(argc, argv, "manipulated_bench", mbncc::bench::kOptions, "@out",
                                   mbncc::bench::benchmark);
}
