// SPDX-License-Identifier: BSD-3-Clause
// Runs mutated libraries through `mbncc check`, `mbncc find` and the live matcher, each in a
// separate process with bounded memory: nothing crashes, accepted objects are searched, deleted or
// disabled ones are not. usage: mutated_libraries COUNT [FIRST]
#include <malloc.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>
#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <map>
#include <opencv2/core/utility.hpp>
#include <sstream>

#include "cli/command.hpp"
#include "cli/images.hpp"
#include "cli/settings.hpp"
#include "fuzz/mutated_library.hpp"
#include "nodelets/matching/live_matcher.hpp"
#include "support/sanitizers.hpp"
#include "support/searched_map.hpp"
#include "support/temporary_folder.hpp"

using namespace mbncc;

namespace {

constexpr rlim_t kMostMemory = rlim_t{512} << 20;  // [bytes] limit per library
constexpr unsigned kPatience = 120;                // [s] of processor time per library
using Names = std::vector<std::string>;

/// Result for one library; the counts are summed over all libraries.
struct Outcome {
  std::array<int, 5> counts{};
  std::string fault;  // "": none

  static constexpr const char* kCounts[] = {"accepted", "refused", "searched live",
                                            "of another image size", "disabled"};
  int& accepted() { return counts[0]; }
  int& refused() { return counts[1]; }
  int& searched_live() { return counts[2]; }
  int& other_size() { return counts[3]; }
  int& disabled() { return counts[4]; }
};

[[noreturn]] void fail(const std::string& sentence) {
  throw std::runtime_error(sentence);
}

bool holds(const Names& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

/// Runs a command of the tool and returns its output. `mbncc check` may fail, because a quarantine
/// that is not a folder cannot be listed.
std::string printed_by(const cli::Command& command, const Names& words) {
  std::ostringstream out, err;
  auto* const out_before = std::cout.rdbuf(out.rdbuf());
  auto* const err_before = std::cerr.rdbuf(err.rdbuf());
  std::string fault;
  int code = cli::kFailed;
  try {
    std::vector<cli::Option> options = command.options;
    for (const auto& option : cli::settings_options()) options.push_back(option);
    code = command.run(cli::Arguments(options, command.operand, words));
  } catch (const std::exception& error) {
    const bool refuses = dynamic_cast<const FileError*>(&error) != nullptr;
    if (!refuses || command.name != "check") fault = error.what();
  }
  std::cout.rdbuf(out_before);
  std::cerr.rdbuf(err_before);
  if (!fault.empty()) fail("mbncc " + command.name + " ends with: " + fault);
  if (code != cli::kDone && command.name == "find") fail("mbncc find fails: " + err.str());
  return out.str();
}

/// Every enabled object of the library must be searched, regardless of the image it was learned in.
void check_find(const LibrarySnapshot& library, const std::string& folder, const std::string& image,
                const Names& settings) {
  Names words{"--library", folder, "--json", image};
  words.insert(words.end(), settings.begin(), settings.end());
  const YAML::Node report = YAML::Load(printed_by(cli::find_command(), words));
  const auto searched = report["searched"].as<Names>();
  const auto skipped = report["skipped"].as<Names>();
  for (const auto& object : library.objects)
    if (object->enabled && !holds(searched, object->name))
      fail("find does not search for " + object->name + ": " +
           (skipped.empty() ? "no reason" : skipped.front()));
}

/// Names of the objects that were searched and found, in a single image or in the next two of a
/// video.
struct Looks {
  Names searched, found;

  void add(const SearchResult& result) {
    searched = result.searched;
    for (const auto& match : result.matches) found.push_back(match.name);
  }
};

class Watcher {
 public:
  Watcher(const nodelets::LiveMatcher& matcher, const cv::Mat& image, bool as_video)
      : matcher_(matcher), image_(image), as_video_(as_video) {}

  Looks look() {
    Looks looks;
    if (!as_video_) looks.add(matcher_.find(image_, {}).result);
    for (int k = 0; as_video_ && k < 2; ++k)
      looks.add(matcher_.watch(video_, stamp_ += 0.1, image_, {}).result);
    return looks;
  }

 private:
  const nodelets::LiveMatcher& matcher_;
  const cv::Mat& image_;
  bool as_video_;
  VideoSearch video_{VideoConfig()};
  double stamp_ = 1;
};

void check_searched(const LibrarySnapshot& library, const Looks& looks, cv::Size image,
                    Outcome& outcome) {
  for (const auto& object : library.objects) {
    const bool fits = object->views.front().image_size == image;
    if (!object->enabled)
      ++outcome.disabled();
    else if (!fits)
      ++outcome.other_size();
    else if (!holds(looks.searched, object->name))
      fail("the live matcher does not search for " + object->name);
    else
      ++outcome.searched_live();
  }
}

/// Deletes or disables the valid object while a matcher is running, as another process would:
/// through the library, or by deleting the file if the library refuses.
void take_away(const std::string& folder, bool disable) {
  try {
    ObjectLibrary library(folder);
    if (disable)
      library.edit(fuzz::kSound, [](ObjectModel& model) { model.enabled = false; });
    else
      library.remove(fuzz::kSound);
  } catch (const FileError&) {
    ::unlink((folder + "/" + fuzz::kSound + ".png").c_str());
  }
}

void check_live(const LibrarySnapshot& library, const std::string& folder, const cv::Mat& image,
                unsigned seed, Outcome& outcome) {
  SearchConfig config;
  config.threads = 1 + static_cast<int>(seed % 8 / 7);
  nodelets::LiveMatcher matcher(config, folder);
  Watcher watcher(matcher, image, seed % 4 < 2);
  const Looks before = watcher.look();
  check_searched(library, before, image.size(), outcome);
  if (!holds(before.found, fuzz::kSound)) fail("the sound object is not found");
  if (seed % 16 == 0) matcher.score_map(image);
  take_away(folder, seed % 2 == 0);
  // Also adds a mutant that did not exist when the search began.
  fuzz::make_mutants(folder, seed + 1);
  try {
    matcher.refresh(false);
  } catch (const FileError&) {  // then nothing may be found at all
    if (matcher.fault().empty()) fail("the library cannot be read, and no fault is told");
  }
  const Looks after = watcher.look();
  if (holds(after.searched, fuzz::kSound) || holds(after.found, fuzz::kSound))
    fail("stale: an object is searched for after it was deleted or disabled");
}

void bound_memory_and_time() {
  if (test::kSanitized) return;
  long pages = 0;
  std::ifstream("/proc/self/statm") >> pages;
  const rlim_t most =
      static_cast<rlim_t>(pages) * static_cast<rlim_t>(::getpagesize()) + kMostMemory;
  const rlimit memory{most, most}, time{kPatience, kPatience};
  ::setrlimit(RLIMIT_AS, &memory);
  ::setrlimit(RLIMIT_CPU, &time);
  ::alarm(10 * kPatience);  // ends a process that waits forever
}

Outcome outcome_of(const std::string& folder, const std::string& image_path, unsigned seed) {
  Outcome outcome;
  try {
    bound_memory_and_time();
    fuzz::make_mutated_library(folder, seed);
    printed_by(cli::check_command(), {"--library", folder});
    ObjectLibrary library(folder);
    const auto snapshot = library.load();
    outcome.accepted() = static_cast<int>(snapshot->objects.size());
    outcome.refused() = static_cast<int>(snapshot->quarantined.size());
    try {
      outcome.refused() += static_cast<int>(library.quarantine().size());
    } catch (const FileError&) {  // the quarantine is not a folder
    }
    if (snapshot->find(fuzz::kSound) == nullptr) fail("the sound object is lost");
    check_find(*snapshot, folder, image_path,
               seed % 8 == 0 ? Names{"--set", "scale_range=0.05"} : Names{});
    check_live(*snapshot, folder, cli::read_image(image_path), seed, outcome);
  } catch (const std::exception& error) {
    outcome.fault = error.what();
  }
  return outcome;
}

/// Runs in a child process, which writes its outcome to a pipe: the counts, then the fault.
Outcome run(const std::string& image_path, unsigned seed) {
  const test::TemporaryFolder folder;
  int ends[2];
  if (::pipe(ends) != 0) fail("no pipe");
  const pid_t child = ::fork();
  if (child == 0) {
    const Outcome outcome = outcome_of(folder.path(), image_path, seed);
    std::ostringstream text;
    for (const int count : outcome.counts) text << count << ' ';
    text << outcome.fault.substr(0, 2000);
    const std::string bytes = text.str();
    const bool told = ::write(ends[1], bytes.data(), bytes.size()) >= 0;
    ::_exit(told ? 0 : 1);
  }
  ::close(ends[1]);
  std::string told;
  std::array<char, 4096> part;
  for (ssize_t read = 0; (read = ::read(ends[0], part.data(), part.size())) > 0;)
    told.append(part.data(), static_cast<std::size_t>(read));
  ::close(ends[0]);
  int status = 0;
  ::waitpid(child, &status, 0);
  Outcome outcome;
  if (!WIFEXITED(status) || WEXITSTATUS(status) != 0) {
    outcome.fault = "the process dies by " +
                    (WIFSIGNALED(status) ? "signal " + std::to_string(WTERMSIG(status))
                                         : "exit code " + std::to_string(WEXITSTATUS(status)));
    return outcome;
  }
  std::istringstream text(told);
  for (int& count : outcome.counts) text >> count;
  text.get();
  std::getline(text, outcome.fault, '\0');
  return outcome;
}

/// The valid object on a plain background.
cv::Mat image_of_sound(const std::string& folder) {
  fuzz::make_mutated_library(folder, 0);
  const auto sound = ObjectLibrary(folder).load()->find(fuzz::kSound);
  const View& view = sound->views.front();
  cv::Mat image(fuzz::kImageHeight, fuzz::kImageWidth, CV_8UC3, cv::Scalar(90, 100, 110));
  view.template_image.copyTo(image(cv::Rect({30, 20}, view.map.size())));
  return image;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 2 || argc > 3 || std::atoi(argv[1]) < 1) {
    std::cerr << "usage: mutated_libraries COUNT [FIRST]\n";
    return 2;
  }
  const int count = std::atoi(argv[1]), first = argc > 2 ? std::atoi(argv[2]) : 1;
  // The heaps of threads reserve address space without using it.
  ::mallopt(M_ARENA_MAX, 1);
  cv::setNumThreads(1);
  const test::TemporaryFolder sound;
  const test::TemporaryFolder images;
  cli::write_image(images / "image.png", image_of_sound(sound.path()), {});
  Outcome total;
  std::map<std::string, int> faults;
  for (int seed = first; seed < first + count; ++seed) {
    const Outcome outcome = run(images / "image.png", static_cast<unsigned>(seed));
    for (std::size_t i = 0; i < total.counts.size(); ++i) total.counts[i] += outcome.counts[i];
    if ((seed - first + 1) % 1000 == 0) std::cout << seed - first + 1 << " done" << std::endl;
    if (outcome.fault.empty()) continue;
    if (++faults[outcome.fault.substr(0, 60)] <= 5)
      std::cout << "library " << seed << ": " << outcome.fault << std::endl;
  }
  std::cout << count << " libraries; files";
  for (std::size_t i = 0; i < total.counts.size(); ++i)
    std::cout << (i == 0 ? " " : ", ") << total.counts[i] << ' ' << Outcome::kCounts[i];
  std::cout << "; " << faults.size() << " kinds of faults\n";
  for (const auto& [fault, times] : faults) std::cout << times << " times: " << fault << '\n';
  return faults.empty() ? 0 : 1;
}
