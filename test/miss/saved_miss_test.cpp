// SPDX-License-Identifier: BSD-3-Clause
#include "mbncc/miss/saved_miss.hpp"

#include <fstream>
#include <iterator>

#include "matching/matcher_fixture.hpp"
#include "mbncc/error.hpp"
#include "support/temporary_folder.hpp"

namespace mbncc {
namespace {

class SavedMissTest : public test::MatcherTest {
 protected:
  SavedMissTest() {
    miss_.image = test::texture({320, 240}, 77, 5);
    test::place(miss_.image, source_, reference_.position(), {150, 110, 0.7});
    miss_.place = {150.25, 110};
    miss_.search.min_score = 0.875;
    miss_.objects = {test::object_from(source_, reference_, "part")};
    miss_.lines = lines_of(explain(miss_), 3);
  }

  std::string path() const { return folder_ / "a.miss"; }

  std::string text() const {
    std::ifstream file(path(), std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
  }

  void rewrite(const std::string& text) const { std::ofstream(path(), std::ios::binary) << text; }

  test::TemporaryFolder folder_;
  SavedMiss miss_;
};

TEST_F(SavedMissTest, IsReadBackWithTheSameExplanation) {
  write_miss(path(), miss_);
  const SavedMiss read = read_miss(path());
  EXPECT_EQ(cv::norm(read.image, miss_.image, cv::NORM_INF), 0);
  EXPECT_EQ(read.place, miss_.place);
  EXPECT_EQ(read.search.min_score, miss_.search.min_score);
  EXPECT_EQ(read.lines, miss_.lines);
  EXPECT_EQ(lines_of(explain(read), 3), miss_.lines);
}

TEST_F(SavedMissTest, AnImageMayBeLargerThanAnObjectFile) {
  miss_.image = cv::Mat(1000, 8400, CV_8UC3, cv::Scalar(90, 120, 130));
  write_miss(path(), miss_);
  EXPECT_EQ(read_miss(path()).image.size(), miss_.image.size());
}

TEST_F(SavedMissTest, BeginsWithTheReasonInWords) {
  write_miss(path(), miss_);
  EXPECT_LT(text().find("part"), text().find("settings:"));
  EXPECT_NE(text().find("mbncc replay"), std::string::npos);
}

TEST_F(SavedMissTest, OtherFilesAreRefusedWithTheirPath) {
  write_miss(path(), miss_);
  const std::string whole = text();
  for (const std::string& broken :
       {std::string(), std::string("image: 7\n"), std::string("%PNG\x01"), whole.substr(0, 3000),
        "mbncc_miss: 99" + whole.substr(whole.find('\n'))}) {
    rewrite(broken);
    try {
      read_miss(path());
      ADD_FAILURE() << broken.substr(0, 40);
    } catch (const FileError& error) {
      EXPECT_EQ(error.path(), path());
      const bool claims = broken.rfind("mbncc_miss", 0) == 0;
      EXPECT_EQ(error.reason().find("not a saved miss; give a file") == 0, !claims)
          << error.reason();
    }
  }
  EXPECT_THROW(read_miss(folder_ / "none"), FileError);
}

TEST_F(SavedMissTest, AnUnwritableFolderIsAFileError) {
  EXPECT_THROW(write_miss(folder_ / "none/a.miss", miss_), FileError);
}

}  // namespace
}  // namespace mbncc
