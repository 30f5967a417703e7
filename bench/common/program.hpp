// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <functional>
#include <opencv2/core/utility.hpp>
#include <string>
#include <vector>

namespace mbncc::bench {

/// What main() of a benchmark does: reads the options, runs `benchmark` in one thread with a fixed
/// seed, and turns an exception into a sentence. `required` names the argument that must be there.
/// Returns the exit code: 0 done, 1 failed, 2 wrong usage.
int run_program(int argc, char** argv, const std::string& name, const std::string& options,
                const std::string& required,
                const std::function<void(const cv::CommandLineParser&)>& benchmark);

/// The same for programs whose arguments are the folders of one or more evaluation sets.
int run_on_sets(int argc, char** argv, const std::string& name,
                const std::function<void(const std::vector<std::string>&)>& benchmark);

/// The folder at `path`, made if need be; to be called before the work, which may take hours. An
/// empty path stays empty. Throws std::runtime_error when nothing can be written there.
std::filesystem::path output_folder(const std::string& path);

}  // namespace mbncc::bench
