// SPDX-License-Identifier: BSD-3-Clause
#include <benchmark/benchmark.h>

#include <opencv2/core/utility.hpp>

int main(int argc, char** argv) {
  cv::setNumThreads(1);
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}
