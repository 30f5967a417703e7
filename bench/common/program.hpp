// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <functional>
#include <opencv2/core/utility.hpp>
#include <string>
#include <vector>

namespace mbncc::bench {

/// The main() of a benchmark: reads the options, runs `benchmark` on one thread with a fixed seed,
/// and prints an exception as one sentence. `required` names the mandatory argument. Returns the
/// exit code: 0 done, 1 failed, 2 wrong usage.
int run_program(int argc, char** argv, const std::string& name, const std::string& options,
                const std::string& required,
                const std::function<void(const cv::CommandLineParser&)>& benchmark);

/// Like run_program(), for programs whose arguments are the folders of one or more evaluation sets.
int run_on_sets(int argc, char** argv, const std::string& name,
                const std::function<void(const std::vector<std::string>&)>& benchmark);

/// The folder at `path`, which is created if necessary; call this before the benchmark, which may
/// take hours. An empty path stays empty. Throws std::runtime_error if the folder is not writable.
std::filesystem::path output_folder(const std::string& path);

}  // namespace mbncc::bench
