// SPDX-License-Identifier: BSD-3-Clause
// Wrong usage: exit code 2 and a message that names the fault.
#include <gtest/gtest.h>

#include "cli/tool.hpp"

namespace mbncc::test {
namespace {

struct Wrong {
  std::vector<std::string> words;
  std::string sentence;
};

TEST(Usage, WrongUsageIsExplainedWithExitCode2) {
  const std::vector<std::string> learn = {"learn", "--library", "L",    "--name",
                                          "n",     "--before",  "b.png"};
  const std::vector<std::string> find = {"find", "--library", "L"};
  const std::vector<Wrong> table = {
      {{}, "no command"},
      {{"lern"}, "did you mean 'learn'?\nTry 'mbncc --help'"},
      {{"--versoin"}, "unknown command"},
      {{"help", "lern"}, "did you mean 'learn'?"},
      {{"frobnicate"}, "unknown command 'frobnicate'\nTry"},
      {{"explain", "--library", "L", "i.png"}, "--at x,y is missing"},
      {{"explain", "--library", "L", "--at", "1", "i.png"}, "--at needs x,y: two numbers"},
      {{"explain", "--library", "L", "--at", "1,2,3,4", "i.png"}, "--at needs x,y: two numbers"},
      {{"explain", "--library", "L", "--at", "1,2", "i.png", "j.png"}, "one image, not 2"},
      {{"replay"}, "an argument is missing; give FILE.miss\n"},
      {{"evaluate", "--library", "L", "i.png"}, "--truth TRUTH.csv is missing"},
      {{"completion"}, "an argument is missing; give bash or zsh\n"},
      {{"completion", "fish"}, "bash or zsh, not 'fish'"},
      {{"list", "--libary", "L"}, "did you mean '--library'?"},
      {{"list", "--colour", "red"}, "unknown option '--colour'\nTry"},
      {{"list", "--library"}, "--library needs a value"},
      {{"list", "--library", "--json"}, "--library needs a value"},
      {{"list", "--library="}, "--library needs a value"},
      {{"list", "--library", "L", "--library", "M"}, "given twice"},
      {{"list", "--library", "L", "extra"}, "'extra' is not expected"},
      {{"list", "--library", "L", "--json=yes"}, "--json takes no value"},
      {{"show", "--library", "L"}, "--name NAME is missing"},
      {{"map", "--library", "L", "--name", "n"}, "--out map.png is missing"},
      {{"restore", "--library", "L", "--name", "n", "--revision", "x"}, "--revision needs"},
      {find, "an argument is missing; give IMAGE\n"},
      {find + std::vector<std::string>{"--csv", "--json", "i.png"}, "cannot be combined"},
      {find + std::vector<std::string>{"--min-score", "2", "i.png"}, "0 .. 1"},
      {find + std::vector<std::string>{"--min-score", "nan", "i.png"}, "0 .. 1"},
      {find + std::vector<std::string>{"--max-instances", "0", "i.png"}, "max_instances"},
      {find + std::vector<std::string>{"--threads", "-1", "i.png"}, "threads"},
      {find + std::vector<std::string>{"--engine", "slow", "i.png"}, "fast | polar"},
      {find + std::vector<std::string>{"--set", "min_score", "i.png"}, "key=value"},
      {find + std::vector<std::string>{"--set", "min_scor=.5", "i.png"}, "'min_score'"},
      {find + std::vector<std::string>{"--set", "zork=1", "i.png"}, "is unknown; `mbncc params`"},
      {find + std::vector<std::string>{"--set", "min_score=high", "i.png"}, "'high'"},
      {learn, "add --after, --roi, --click or --map"},
      {learn + std::vector<std::string>{"--roi", "1,2,3,4", "--map", "m.png"},
       "cannot be combined"},
      {learn + std::vector<std::string>{"--map", "m.png", "--method", "sb_grabcut"},
       "cannot be combined"},
      {learn + std::vector<std::string>{"--roi", "1,2,3,4", "--overwrite", "--add-view"},
       "cannot be combined"},
      {learn + std::vector<std::string>{"--roi", "1,2,3,4", "--method", "change_cut"},
       "needs --after"},
      {learn + std::vector<std::string>{"--roi", "1,2,3,4", "--symmetry", "13"},
       "give auto, none, 2 to 12, or round"},
      {{"edit", "--library", "L", "--name", "n"}, "give --symmetry, --min-score or both"},
      {{"edit", "--library", "L", "--name", "n", "--symmetry", "twice"},
       "give auto, none, 2 to 12, or round"},
      {learn + std::vector<std::string>{"--roi", "1,2,3"}, "--roi needs x,y,w,h"},
      {learn + std::vector<std::string>{"--roi", "1,2,3,4,"}, "--roi needs x,y,w,h"},
      {learn + std::vector<std::string>{"--roi", "1,2,3,x"}, "--roi needs x,y,w,h"},
      {learn + std::vector<std::string>{"--roi", "1,2,0,4"}, "--roi needs x,y,w,h"},
      {learn + std::vector<std::string>{"--roi", "1,2,99999999999,4"}, "--roi needs x,y,w,h"},
  };
  for (const auto& wrong : table) {
    const ToolRun run = run_tool(wrong.words);
    std::string line = "mbncc";
    for (const auto& word : wrong.words) line += " " + word;
    EXPECT_EQ(run.code, 2) << line;
    EXPECT_TRUE(run.says(wrong.sentence)) << line << "\n" << run.err;
    EXPECT_TRUE(run.says("--help'")) << line << "\n" << run.err;
    EXPECT_EQ(run.out, "") << line;
  }
}

TEST(Usage, EveryCommandExplainsItself) {
  const ToolRun all = run_tool({"--help"});
  EXPECT_EQ(all.code, 0);
  for (const char* command : {"learn", "find", "explain", "replay", "evaluate", "map", "list",
                              "show", "forget", "restore", "check", "params", "simulate"}) {
    EXPECT_TRUE(all.prints(command));
    const ToolRun one = run_tool({command, "--help"});
    EXPECT_EQ(one.code, 0);
    EXPECT_TRUE(one.prints(std::string("usage: mbncc ") + command));
    EXPECT_TRUE(one.prints("--config FILE.yaml"));
    EXPECT_TRUE(one.prints("--set key=value"));
  }
  // The column is as wide as the longest name.
  EXPECT_TRUE(all.prints("\n  completion  print a script")) << all.out;
  EXPECT_TRUE(all.prints("\n  learn       learn an object")) << all.out;
  EXPECT_EQ(run_tool({"help", "learn"}).out, run_tool({"learn", "--help"}).out);
  EXPECT_EQ(run_tool({"help"}).out, all.out);
  EXPECT_EQ(run_tool({"--version"}).out.rfind("mbncc ", 0), 0u);
}

TEST(Usage, AcceptsTheConfigFilesOfTheNodelets) {
  for (const char* file : {"camera", "learning", "matching", "rectify", "simulated_camera"}) {
    const ToolRun run =
        run_tool({"params", "--config", std::string(MBNCC_CONFIG_FOLDER) + "/" + file + ".yaml"});
    EXPECT_EQ(run.code, 0) << file << ": " << run.err;
  }
}

TEST(Usage, SharedParametersNeedAPartThatAcceptsThem) {
  EXPECT_EQ(run_tool({"params", "--set", "width=1"}).code,
            0);  // the parameter of the camera nodelet, not of the simulated camera
  EXPECT_EQ(run_tool({"params", "--set", "width=-1"}).code, 2);
  EXPECT_EQ(run_tool({"simulate", "--out", "/nowhere", "--set", "width=1"}).code, 2);
}

TEST(Usage, OutputThatCannotBeWrittenIsAFailure) {
  int status = 0;
  ::waitpid(start_tool({"params"}, "/dev/full", "/dev/null"), &status, 0);
  EXPECT_EQ(WEXITSTATUS(status), 1);
}

}  // namespace
}  // namespace mbncc::test
