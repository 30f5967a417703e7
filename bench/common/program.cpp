// SPDX-License-Identifier: BSD-3-Clause
#include "common/program.hpp"

#include <unistd.h>

#include <iostream>
#include <stdexcept>
#include <system_error>

namespace mbncc::bench {

namespace {

/// Runs the work on one thread with a fixed seed; an exception is printed as one sentence.
int run(const std::string& name, const std::function<void()>& work) {
  cv::setNumThreads(1);
  cv::setRNGSeed(1);
  try {
    work();
  } catch (const std::exception& error) {
    std::cerr << name << ": " << error.what() << '\n';
    return 1;
  }
  return 0;
}

}  // namespace

int run_program(int argc, char** argv, const std::string& name, const std::string& options,
                const std::string& required,
                const std::function<void(const cv::CommandLineParser&)>& benchmark) {
  const cv::CommandLineParser given(argc, argv, options);
  if (given.has("help") || !given.has(required)) {
    given.printMessage();
    return given.has("help") ? 0 : 2;
  }
  return run(name, [&] { benchmark(given); });
}

int run_on_sets(int argc, char** argv, const std::string& name,
                const std::function<void(const std::vector<std::string>&)>& benchmark) {
  if (argc < 2 || argv[1][0] == '-') {
    std::cerr << "usage: " << name << " SET...\n";
    return 2;
  }
  return run(name, [&] { benchmark({argv + 1, argv + argc}); });
}

std::filesystem::path output_folder(const std::string& path) {
  std::error_code failure;
  if (!path.empty()) std::filesystem::create_directories(path, failure);
  if (!path.empty() && (failure || ::access(path.c_str(), W_OK) != 0))
    throw std::runtime_error("cannot write into '" + path + "'; give a folder that can be made");
  return path;
}

}  // namespace mbncc::bench
