// Narrow objects mix with their background; what is known of the mixture is taken out again.
#include "matching/mixture.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <opencv2/imgproc.hpp>

#include "matching/prepared_object.hpp"

namespace mbncc {
namespace {

const cv::Scalar kColour{40, 90, 170};
const cv::Size kSize{80, 60};

/// A bent strip, `width` px wide.
cv::Mat strip(int width) {
  cv::Mat map(kSize, CV_8UC1, cv::Scalar(0));
  map(cv::Rect(20, 20, 40, width)) = 255;
  map(cv::Rect(20, 20, width, 25)) = 255;
  return map;
}

/// The strip before a plain background, as a lens blurs it.
cv::Mat picture_of(const cv::Mat& map, const cv::Scalar& background) {
  cv::Mat picture(kSize, CV_8UC3, background);
  picture.setTo(kColour, map);
  cv::GaussianBlur(picture, picture, {}, 0.8);
  return picture;
}

TEST(Coverage, WideObjectsHideTheirBackground) {
  const MapGeometry map(strip(14));
  const Coverage coverage(map, 0);
  EXPECT_GT(coverage.at({27, 27}).share, 0.98f);
  EXPECT_NEAR(coverage.at({40, 20}).share, 0.6f, 0.15f);
}

TEST(Coverage, NarrowObjectsShowIt) {
  const cv::Mat map = strip(2);
  const Mixture mixture = Coverage(MapGeometry(map), 0).at({45, 20});
  EXPECT_GT(mixture.share, 0.4f);
  EXPECT_LT(mixture.share, 0.75f);
  for (const auto& place : mixture.beyond) EXPECT_EQ(map.at<uchar>(cv::Point(place)), 0);
  EXPECT_LT((mixture.beyond[0].y - 20.5) * (mixture.beyond[1].y - 20.5), 0) << "not on both sides";
}

TEST(Coverage, WithoutBackgroundThereIsNoMixture) {
  const MapGeometry map(cv::Mat(kSize, CV_8UC1, cv::Scalar(255)));
  EXPECT_EQ(Coverage(map, 0).at({40, 30}).share, 1.f);
}

/// Colours of the template and at the same place before other backgrounds.
class Unmixed : public ::testing::TestWithParam<int> {};

TEST_P(Unmixed, ColoursDoNotDependOnTheBackground) {
  constexpr double kLeft = 0.125;  // of the contrast to the background
  const cv::Mat map = strip(GetParam());
  const View view = crop_view(picture_of(map, {120, 120, 120}), map, {40, 30, 0});
  const PreparedView prepared(view, Engine::kFast);
  const SurfaceTemplate& surface = prepared.fine.surface;
  const cv::Point2d home = prepared.anchor + cv::Point2d(view.origin);
  for (const double grey : {30., 120., 230.}) {
    const SceneLevel scene(picture_of(map, cv::Scalar::all(grey)), 0);
    scene.prepare();
    SurfaceSample sample;
    surface.sample(scene, {home.x, home.y, 0}, sample);
    for (int c = 0; c < 3; ++c) {
      EXPECT_NEAR(sample.means[c], kColour[c], kLeft * std::abs(grey - kColour[c]) + 1)
          << "before " << grey;
      double learned = 0;
      for (std::size_t i = 0; i < surface.size(); ++i) learned += surface.planes[c][i];
      EXPECT_NEAR(learned / static_cast<double>(surface.size()), kColour[c],
                  kLeft * std::abs(120 - kColour[c]) + 1);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Widths, Unmixed, ::testing::Values(2, 3, 4, 6));

}  // namespace
}  // namespace mbncc
