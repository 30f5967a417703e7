// SPDX-License-Identifier: BSD-3-Clause
// The completion script is sourced by a real bash without start-up files.
#include <gtest/gtest.h>

#include <filesystem>

#include "cli/tool.hpp"

namespace mbncc::test {
namespace {

/// Completions that bash offers for the last word of `words`.
std::string completed(const TemporaryFolder& folder, const std::string& words) {
  const std::string script = folder / "ask.sh", out = folder / "offered";
  std::ofstream(script) << "source <(" << MBNCC_TOOL << " completion bash)\nCOMP_WORDS=(" << words
                        << ")\nCOMP_CWORD=$((${#COMP_WORDS[@]} - 1))\n_mbncc\n"
                        << "echo \" ${COMPREPLY[*]} \"\n";
  const std::string command = "env -i HOME='" + std::string(folder / "home") +
                              "' bash --norc --noprofile '" + script + "' > '" + out + "' 2>&1";
  EXPECT_EQ(std::system(command.c_str()), 0) << content_of_file(out);
  return content_of_file(out);
}

TEST(Completion, OffersCommandsOptionsChoicesNamesAndFiles) {
  const TemporaryFolder folder;
  std::filesystem::create_directories(folder / "library");
  std::filesystem::create_directories(folder / "home/.ros/mbncc_library");
  std::ofstream(folder / "library/wrench.png") << "";
  std::ofstream(folder / "home/.ros/mbncc_library/nut.png") << "";
  EXPECT_EQ(completed(folder, "mbncc fin"), " find \n");
  EXPECT_EQ(completed(folder, "mbncc help expl"), " explain \n");
  EXPECT_EQ(completed(folder, "mbncc find --over"), " --overlay \n");
  EXPECT_EQ(completed(folder, "mbncc find --engine po"), " polar \n");
  EXPECT_EQ(
      completed(folder, "mbncc find --library '" + std::string(folder / "library") + "' --name ''"),
      " wrench \n");
  EXPECT_EQ(completed(folder, "mbncc show --name n"), " nut \n");
  // bash passes the equals sign as a separate word, zsh does not.
  const std::string library = folder / "library";
  EXPECT_EQ(completed(folder, "mbncc show --library = '" + library + "' --name w"), " wrench \n");
  EXPECT_EQ(completed(folder, "mbncc show '--library=" + library + "' --name w"), " wrench \n");
  EXPECT_EQ(completed(folder, "mbncc find --library = '" + library + "/wr'"),
            " " + library + "/wrench.png \n");
  EXPECT_EQ(completed(folder, "mbncc find '--library=" + library + "/wr'"),
            " --library=" + library + "/wrench.png \n");
  EXPECT_EQ(completed(folder, "mbncc find --engine = po"), " polar \n");
  EXPECT_EQ(completed(folder, "mbncc find --engine ="), " fast polar \n");
  EXPECT_EQ(completed(folder, "mbncc learn --symmetry ro"), " round \n");
  EXPECT_EQ(completed(folder, "mbncc learn --method r"), " region_cut \n");
  EXPECT_EQ(completed(folder, "mbncc completion ''"), " bash zsh \n");
  const std::string file = folder / "library/wr";
  EXPECT_EQ(completed(folder, "mbncc find '" + file + "'"), " " + file + "ench.png \n");
}

TEST(Completion, TheZshScriptUsesTheSameWords) {
  const ToolRun bash = run_tool({"completion", "bash"}), zsh = run_tool({"completion", "zsh"});
  EXPECT_EQ(zsh.code, 0);
  EXPECT_TRUE(zsh.prints("bashcompinit"));
  EXPECT_TRUE(zsh.prints(bash.out.substr(bash.out.find("_mbncc_words"))));
}

}  // namespace
}  // namespace mbncc::test
