// SPDX-License-Identifier: BSD-3-Clause
// Runs the built tool, and draws images for it.
#pragma once

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <fstream>
#include <iterator>
#include <opencv2/imgcodecs.hpp>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "mbncc/sim/scene.hpp"
#include "support/temporary_folder.hpp"

namespace mbncc::test {

struct ToolRun {
  int code = -1;
  std::string out, err;

  bool says(const std::string& text) const { return err.find(text) != std::string::npos; }
  bool prints(const std::string& text) const { return out.find(text) != std::string::npos; }
};

inline std::string content_of_file(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

inline std::vector<std::string> split(const std::string& text, char separator) {
  std::vector<std::string> parts;
  std::istringstream stream(text);
  for (std::string part; std::getline(stream, part, separator);) parts.push_back(part);
  return parts;
}

/// Starts the tool with its output redirected to the files; the caller waits for it.
inline pid_t start_tool(const std::vector<std::string>& words, const std::string& out,
                        const std::string& err) {
  const pid_t child = ::fork();
  if (child != 0) return child;
  ::dup2(::open(out.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0644), STDOUT_FILENO);
  ::dup2(::open(err.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0644), STDERR_FILENO);
  std::vector<char*> arguments{const_cast<char*>("mbncc")};
  for (const auto& word : words) arguments.push_back(const_cast<char*>(word.c_str()));
  arguments.push_back(nullptr);
  ::execv(MBNCC_TOOL, arguments.data());
  ::_exit(127);
}

inline ToolRun run_tool(const std::vector<std::string>& words) {
  TemporaryFolder folder;
  int status = 0;
  ::waitpid(start_tool(words, folder / "out", folder / "err"), &status, 0);
  ToolRun run;
  run.code = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  run.out = content_of_file(folder / "out");
  run.err = content_of_file(folder / "err");
  return run;
}

/// A folder with images of a lesson and of later scenes.
class LessonFolder : public TemporaryFolder {
 public:
  static constexpr int kWidth = 320, kHeight = 240;

  LessonFolder() {
    write("before.png", scene().render({learned()}, 1));
    write("after.png", scene().render({}, 2));
    write("map.png", scene().true_map(learned()));
    write("target.png", scene().render({placed()}, 3));
    write("empty.png", scene().render({}, 4));
  }

  void write(const std::string& name, const cv::Mat& image) const {
    if (!cv::imwrite(*this / name, image)) throw std::runtime_error("cannot write " + name);
  }

  std::string library() const { return *this / "library"; }

  static sim::Placed learned() { return {object(), {130, 110, 0}}; }
  static sim::Placed placed() { return {object(), {195, 125, to_radians(70)}}; }
  static const sim::Scene& scene() {
    static const sim::Scene drawn = [] {
      sim::SceneConfig config;
      config.size = {kWidth, kHeight};
      return sim::Scene(config);
    }();
    return drawn;
  }

  /// Arguments of a lesson by map; more can be appended.
  std::vector<std::string> lesson(const std::string& name) const {
    return {"learn",    "--library",          library(), "--name",         name,
            "--before", *this / "before.png", "--map",   *this / "map.png"};
  }

 private:
  static sim::SceneObject object() {
    sim::SceneObject object;
    object.seed = 5;
    return object;
  }
};

inline std::vector<std::string> operator+(std::vector<std::string> words,
                                          const std::vector<std::string>& more) {
  words.insert(words.end(), more.begin(), more.end());
  return words;
}

}  // namespace mbncc::test
