#include "common/program.hpp"

#include <iostream>

namespace mbncc::bench {

int run_program(int argc, char** argv, const std::string& name, const std::string& options,
                const std::string& required,
                const std::function<void(const cv::CommandLineParser&)>& benchmark) {
  const cv::CommandLineParser given(argc, argv, options);
  if (given.has("help") || !given.has(required)) {
    given.printMessage();
    return given.has("help") ? 0 : 2;
  }
  cv::setNumThreads(1);
  cv::setRNGSeed(1);
  try {
    benchmark(given);
  } catch (const std::exception& error) {
    std::cerr << name << ": " << error.what() << '\n';
    return 1;
  }
  return 0;
}

}  // namespace mbncc::bench
