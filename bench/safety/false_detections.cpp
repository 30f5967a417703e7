// SPDX-License-Identifier: BSD-3-Clause
// Images without the object: how many detections are reported nevertheless, and how many of them
// are graspable, with the shipped thresholds.
#include <filesystem>
#include <iostream>
#include <map>
#include <opencv2/imgcodecs.hpp>

#include "common/case_folder.hpp"
#include "common/program.hpp"
#include "common/table.hpp"
#include "mbncc/matching/matcher.hpp"
#include "safety/decoys.hpp"

namespace mbncc::bench {
namespace {

namespace fs = std::filesystem;

constexpr const char* kOptions =
    "{@out        |      | folder for the images in which something could be grasped }"
    "{photographs |      | set of photographed cases (bench/README.md); none: drawn images alone "
    "}"
    "{scenes      | 2000 | drawn images of other scenes }"
    "{parts       | 1500 | parts of photographs }"
    "{likes       | 1000 | images with a look-alike }"
    "{empty       | 1000 | black, plain and noisy images }"
    "{objects     | 40   | taught objects; every image is searched for four of them }"
    "{seed        | 1    | random seed }"
    "{help h      |      | this text }";

constexpr int kPerImage = 4;       // objects searched per image, one at a time
constexpr double kColourful = 30;  // [grey levels] least value to be distinguished by colour

using Object = std::shared_ptr<const ObjectModel>;

struct Count {
  int images = 0, searches = 0, found = 0, graspable = 0;
};

class Trials {
 public:
  explicit Trials(fs::path out) : out_(std::move(out)) {}

  void search(const std::string& kind, const cv::Mat& image, const std::vector<Object>& objects) {
    Count& count = counts_[kind];
    ++count.images;
    for (const auto& object : objects) {
      Matcher matcher;
      matcher.set_objects({object});
      ++count.searches;
      int graspable = 0;
      for (const auto& match : matcher.find(image).matches) {
        ++count.found;
        graspable += match.graspable;
        if (match.graspable) describe(kind, count.images, match);
      }
      count.graspable += graspable;
      if (graspable > 0) keep(kind + "_" + std::to_string(count.images), image, *object);
    }
  }

  Table table() const {
    Table table{{"images of", "images", "searches", "detections", "graspable"}, {}};
    for (const auto& [kind, count] : counts_)
      table.rows.push_back({kind, std::to_string(count.images), std::to_string(count.searches),
                            std::to_string(count.found), std::to_string(count.graspable)});
    return table;
  }

 private:
  void describe(const std::string& kind, int image, const Match& match) {
    std::cout << kind << '_' << image << ' ' << match.name << " at " << match.pose.x << ' '
              << match.pose.y << ' ' << to_degrees(match.pose.theta) << " score " << match.score
              << " similarity " << match.similarity << " margins " << match.margin_place << ' '
              << match.margin_angle << std::endl;
  }

  void keep(const std::string& name, const cv::Mat& image, const ObjectModel& object) const {
    const std::string start = (out_ / (name + "_" + object.name)).string();
    cv::imwrite(start + "_image.png", image);
    cv::imwrite(start + "_template.png", object.views[0].template_image);
    cv::imwrite(start + "_map.png", object.views[0].map);
  }

  fs::path out_;
  std::map<std::string, Count> counts_;
};

/// Returns the next few objects in turn.
class Turns {
 public:
  explicit Turns(const std::vector<Taught>& taught) : taught_(taught) {}

  std::vector<Object> next() {
    std::vector<Object> objects;
    for (int i = 0; i < kPerImage; ++i) objects.push_back(taught_[next_++ % taught_.size()].model);
    return objects;
  }

 private:
  const std::vector<Taught>& taught_;
  std::size_t next_ = 0;
};

std::vector<CaseFolder> read_cases(const fs::path& set) {
  std::vector<CaseFolder> cases;
  if (!set.empty())
    for (const auto& name : list_cases(set)) cases.push_back(read_case(set / name));
  return cases;
}

Object object_of(const CaseFolder& one) {
  auto object = std::make_shared<ObjectModel>();
  object->name = one.name;
  object->views.push_back(crop_view(one.before, one.map, {one.reference.x, one.reference.y, 0}));
  return object;
}

/// Simulated objects do not occur in photographs.
void search_parts(const std::vector<CaseFolder>& cases, int images, Turns& turns, Trials& trials,
                  cv::RNG& random) {
  std::vector<cv::Mat> photographs;
  for (const auto& one : cases) {
    photographs.push_back(one.before);
    for (const auto& target : one.targets) photographs.push_back(read_image(target.image));
  }
  for (int i = 0; i < images && !photographs.empty(); ++i)
    trials.search("photographs, objects drawn",
                  part_of(photographs[static_cast<std::size_t>(i) % photographs.size()], random),
                  turns.next());
}

/// The photographed objects: searched in images that lack them, and in their own images with
/// exchanged colour channels.
void search_photographed(const std::vector<CaseFolder>& cases, int images, Trials& trials,
                         cv::RNG& random) {
  for (const auto& one : cases) {
    const Object object = object_of(one);
    const bool colourful = colourfulness(object->views[0]) > kColourful;
    for (const auto& target : one.targets) {
      const cv::Mat photograph = read_image(target.image);
      for (int i = 0; i < images; ++i) {
        const cv::Mat part = part_of(photograph, random);
        if (target.instances.empty())
          trials.search("photographs that lack the object", part, {object});
        else if (colourful)
          trials.search("photographs, other colours", recoloured(part), {object});
      }
    }
  }
}

void search_likes(const std::vector<Taught>& taught, int images, Trials& trials, cv::RNG& random) {
  constexpr Likeness kAll[] = {Likeness::kMirrored, Likeness::kRecoloured, Likeness::kResurfaced,
                               Likeness::kResized};
  for (int i = 0, drawn = 0; i < images; ++drawn) {
    const Taught& object = taught[static_cast<std::size_t>(drawn / 4) % taught.size()];
    const Likeness likeness = kAll[drawn % 4];
    if (likeness == Likeness::kRecoloured && colourfulness(object.model->views[0]) < kColourful)
      continue;
    ++i;
    trials.search(std::string("look-alikes, ") + to_string(likeness),
                  scene_with_likeness(object, likeness, random), {object.model});
  }
}

void benchmark(const cv::CommandLineParser& options) {
  const int seed = options.get<int>("seed");
  cv::RNG random(static_cast<std::uint64_t>(seed) + 1);
  const std::vector<Taught> taught = teach(options.get<int>("objects"), seed);
  if (taught.empty()) throw std::runtime_error("no object could be taught");
  Trials trials(output_folder(options.get<std::string>("@out")));
  Turns turns(taught);
  for (int i = 0; i < options.get<int>("empty"); ++i)
    trials.search("nothing", empty_image(random), turns.next());
  for (int i = 0; i < options.get<int>("scenes"); ++i)
    trials.search("other scenes", other_scene(random), turns.next());
  search_likes(taught, options.get<int>("likes"), trials, random);
  const auto cases = read_cases(options.get<std::string>("photographs"));
  search_parts(cases, options.get<int>("parts"), turns, trials, random);
  search_photographed(cases, 40, trials, random);
  std::cout << taught.size() << " objects taught\n";
  write_markdown(std::cout, trials.table());
}

}  // namespace
}  // namespace mbncc::bench

int main(int argc, char** argv) {
  return mbncc::bench::run_program(argc, argv, "false_detections_bench", mbncc::bench::kOptions,
                                   "@out", mbncc::bench::benchmark);
}
