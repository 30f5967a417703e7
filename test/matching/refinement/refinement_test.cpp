// SPDX-License-Identifier: BSD-3-Clause
// Sub-pixel refinement: light must not displace the pose, and the covariance must be correct.
#include "matching/refinement/refinement.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <utility>
#include <vector>

#include "matching/images.hpp"
#include "matching/prepared/prepared_object.hpp"
#include "matching/refinement/gauss_newton.hpp"
#include "matching/refinement/illumination_bias.hpp"
#include "numeric/random_effects.hpp"

namespace mbncc::refinement {
namespace {

using test::LearningImage;

class RefinementTest : public ::testing::Test {
 protected:
  static constexpr double kDegree = kPi / 180;

  RefinementTest()
      : source_(41),
        object_(test::object_from(source_, {kReference.x, kReference.y, 0})),
        view_(object_->views.front(), prepared::Engine::kFast) {}

  /// The object at `truth` on another texture, with noise.
  cv::Mat scene_with(const Pose2D& truth, std::uint64_t seed = 42, double noise = 3) const {
    cv::Mat scene = test::texture({220, 180}, seed, 4);
    test::place(scene, source_, kReference, truth);
    return with_noise(scene, seed, noise);
  }

  static cv::Mat with_noise(const cv::Mat& image, std::uint64_t seed, double deviation) {
    cv::Mat noise(image.size(), CV_16SC3), noisy;
    cv::RNG random(seed + 7);
    random.fill(noise, cv::RNG::NORMAL, 0, deviation);
    cv::add(image, noise, noisy, {}, CV_8U);
    return noisy;
  }

  /// Imitates relief that follows the texture: the brightness is displaced by `aside` [px], the
  /// colours are not.
  cv::Mat scene_with_brightness_aside(const Pose2D& truth, double aside) const {
    cv::Mat scene = scene_with(truth, 42, 0);
    const cv::Mat moved = scene_with({truth.x + aside, truth.y, truth.theta}, 42, 0);
    for (int y = 0; y < scene.rows; ++y)
      for (int x = 0; x < scene.cols; ++x) {
        auto& own = scene.at<cv::Vec3b>(y, x);
        const cv::Vec3b other = moved.at<cv::Vec3b>(y, x);
        const double factor =
            (90.0 + other[0] + other[1] + other[2]) / (90 + own[0] + own[1] + own[2]);
        for (int c = 0; c < 3; ++c) own[c] = cv::saturate_cast<uchar>((own[c] + 30) * factor - 30);
      }
    return scene;
  }

  /// The anchor if the reference point lies at `truth` and the object is `scale` times as large.
  Pose2D anchor_at(const Pose2D& truth, double scale = 1) const {
    const cv::Point2d lever = scale * view_.reference_in_anchor.position();
    return compose(truth, inverse(Pose2D{lever.x, lever.y, 0}));
  }

  Refined refined(const cv::Mat& scene, const Pose2D& start, int iterations = 5,
                  double scale = 1) const {
    return refine(view_.dense, scene::SceneLevel(scene, 0), start, iterations, scale);
  }

  /// A scene with the object at `truth`, enlarged by `scale`, with noise.
  cv::Mat scene_in_size(double scale, const Pose2D& truth) const {
    cv::Mat scene;
    cv::resize(scene_with(truth, 42, 0), scene, {}, scale, scale,
               scale < 1 ? cv::INTER_AREA : cv::INTER_CUBIC);
    return with_noise(scene, 9, 3);
  }

  /// The anchor in that scene.
  Pose2D anchor_in_size(double scale, const Pose2D& truth) const {
    return anchor_at({(truth.x + 0.5) * scale - 0.5, (truth.y + 0.5) * scale - 0.5, truth.theta},
                     scale);
  }

  static const cv::Point2d kReference;
  LearningImage source_;
  std::shared_ptr<ObjectModel> object_;
  prepared::PreparedView view_;
};

const cv::Point2d RefinementTest::kReference{58, 60};

TEST_F(RefinementTest, FindsAFractionOfAPixelFromAnySide) {
  const Pose2D truth{103.7, 82.6, -1.9};
  const Pose2D anchor = anchor_at(truth);
  const cv::Mat scene = scene_with(truth);
  for (int k = 0; k < 8; ++k) {
    const double side = k * kPi / 4;
    const Refined found =
        refined(scene, {anchor.x + 0.8 * std::cos(side), anchor.y + 0.8 * std::sin(side),
                        anchor.theta + (k % 2 ? 0.8 : -0.8) * kDegree});
    EXPECT_LT(cv::norm(found.pose.position() - anchor.position()), 0.1) << "side " << k;
    EXPECT_LT(angle_distance(found.pose.theta, anchor.theta), 0.1 * kDegree) << "side " << k;
    EXPECT_EQ(found.scale, 1) << "side " << k;
  }
}

TEST_F(RefinementTest, ErrorsMatchTheCovariance) {
  double squares = 0;
  constexpr int kPoses = 20;
  for (int k = 0; k < kPoses; ++k) {
    const Pose2D truth{100 + 0.37 * k, 85 + 0.53 * k, 0.31 * k};
    const Pose2D anchor = anchor_at(truth);
    const Refined found = refined(scene_with(truth, 60 + k, 6), anchor);
    const cv::Vec3d error(found.pose.x - anchor.x, found.pose.y - anchor.y,
                          wrap_angle(found.pose.theta - anchor.theta));
    squares += error.dot(found.covariance.inv() * error) / 3;
  }
  EXPECT_LT(std::sqrt(squares / kPoses), 1.5);
  EXPECT_GT(std::sqrt(squares / kPoses), 0.3);
}

TEST_F(RefinementTest, NoiseIncreasesTheCovariance) {
  const Pose2D truth{103.7, 82.6, 0.9};
  const cv::Matx33d calm = refined(scene_with(truth, 42, 1), anchor_at(truth)).covariance;
  const cv::Matx33d noisy = refined(scene_with(truth, 42, 14), anchor_at(truth)).covariance;
  for (int k = 0; k < 3; ++k) EXPECT_GT(noisy(k, k), 1.5 * calm(k, k));
}

TEST_F(RefinementTest, DisplacedBrightnessHardlyBiasesThePose) {
  const Pose2D truth{103.7, 82.6, 0.5};
  const Pose2D anchor = anchor_at(truth);
  const cv::Mat scene = scene_with_brightness_aside(truth, 0.5);
  const double found = cv::norm(refined(scene, anchor).pose.position() - anchor.position());
  EXPECT_LT(found, 0.15);
}

TEST_F(RefinementTest, DisplacedColourHardlyBiasesThePose) {
  constexpr double kAside = 2.5;
  const Pose2D truth{103.7, 82.6, 0.5}, colour{truth.x - kAside, truth.y, truth.theta};
  const cv::Mat scene = with_noise(scene_with_brightness_aside(colour, kAside), 5, 3);
  const Pose2D anchor = anchor_at(truth);
  const Refined found = refined(scene, anchor);
  EXPECT_LT(cv::norm(found.pose.position() - anchor.position()), 0.1 * kAside);
  EXPECT_GT(std::sqrt(found.covariance(0, 0)), 0.1 * kAside);
}

TEST_F(RefinementTest, DisagreementIncreasesTheCovariance) {
  const Pose2D truth{103.7, 82.6, 0.5};
  const auto claim = [&](double aside) {
    const cv::Mat scene = with_noise(scene_with_brightness_aside(truth, aside), 5, 3);
    return refined(scene, anchor_at(truth)).covariance;
  };
  const cv::Matx33d agreed = claim(0), disagreed = claim(1);
  for (int k = 0; k < 3; ++k) EXPECT_GT(disagreed(k, k), 2 * agreed(k, k)) << k;
}

TEST_F(RefinementTest, ShadingIncreasesTheCovariance) {
  const Pose2D truth{103.7, 82.6, 0.5};
  const cv::Mat even = scene_with(truth);
  cv::Mat shaded = even.clone();
  for (int x = 0; x < shaded.cols; ++x) shaded.col(x) *= 0.4 + 1.2 * x / shaded.cols;
  const Refined found = refined(shaded, anchor_at(truth));
  const scene::SceneLevel scene(shaded, 0);
  const templates::SurfaceTemplate& surface = view_.dense.object.surface;
  templates::SurfaceSample sample;
  surface.sample(scene.whole(), found.pose, sample);
  const IlluminationBias light(surface, sample, 1);
  const double place = light.of_pose(surface.radius())(0, 0);
  EXPECT_GT(place, refined(even, anchor_at(truth)).covariance(0, 0));
  EXPECT_GT(found.covariance(0, 0), place);
  EXPECT_GT(found.covariance(1, 1), place);
}

TEST_F(RefinementTest, TheCovarianceRotatesWithTheObject) {
  // Along a long strip, the position is known less well than across it.
  cv::Mat map = cv::Mat::zeros(120, 120, CV_8UC1);
  map(cv::Rect(15, 52, 90, 12)) = 255;
  LearningImage strip(5, map);
  strip.surface.setTo(cv::Scalar(60, 80, 160));
  strip.surface.copyTo(strip.image, map);
  const prepared::PreparedView view(test::object_from(strip, {60, 58, 0})->views.front(),
                                    prepared::Engine::kFast);
  const auto claim = [&](double theta) {
    cv::Mat scene = test::texture({220, 180}, 42, 4);
    test::place(scene, strip, {60, 58}, {110, 90, theta});
    const Pose2D anchor = compose({110, 90, theta}, inverse(view.reference_in_anchor));
    return refine(view.dense, scene::SceneLevel(with_noise(scene, 3, 3), 0), anchor, 5).covariance;
  };
  const cv::Matx33d along_x = claim(0), along_y = claim(kPi / 2);
  EXPECT_GT(along_x(0, 0), 1.3 * along_x(1, 1));
  EXPECT_GT(along_y(1, 1), 1.3 * along_y(0, 0));
}

TEST_F(RefinementTest, ScaleIsKeptIfItDiffersByMoreThanEightPercent) {
  const Pose2D truth{103.7, 82.6, 0.7};
  for (const double scale : {0.9, 1.1})
    EXPECT_EQ(refined(scene_in_size(scale, truth), anchor_in_size(scale, truth), 12).scale, 1)
        << scale;
}

TEST_F(RefinementTest, RefinesAPartlyCoveredObject) {
  const Pose2D truth{103.7, 82.6, 0};
  const Pose2D anchor = anchor_at(truth);
  cv::Mat scene = scene_with(truth);
  test::texture({40, 30}, 77, 3).copyTo(scene(cv::Rect(78, 50, 40, 30)));
  const Refined found = refined(scene, {anchor.x + 0.4, anchor.y - 0.4, anchor.theta});
  EXPECT_LT(cv::norm(found.pose.position() - anchor.position()), 0.35);
  EXPECT_LT(angle_distance(found.pose.theta, anchor.theta), 0.4 * kDegree);
}

TEST_F(RefinementTest, MeasuresTheScale) {
  const Pose2D truth{103.7, 82.6, 0.7};
  for (const double scale : {0.97, 0.985, 1.02, 1.03}) {
    const Pose2D anchor = anchor_in_size(scale, truth);
    const Refined found =
        refined(scene_in_size(scale, truth), {anchor.x + 0.4, anchor.y, anchor.theta});
    EXPECT_NEAR(found.scale, scale, 0.004);
    EXPECT_LT(cv::norm(found.pose.position() - anchor.position()), 0.12) << "scale " << scale;
  }
}

TEST_F(RefinementTest, StartsFromAnotherScale) {
  const Pose2D truth{103.7, 82.6, 0.7};
  const std::vector<std::pair<double, double>> sizes_and_starts{
      {0.95, 0.95}, {1, 0.95}, {1, 1.05}, {1.05, 1.05}};
  for (const auto& [scale, from] : sizes_and_starts) {
    const Pose2D anchor = anchor_in_size(scale, truth);
    const Refined found =
        refined(scene_in_size(scale, truth), {anchor.x + 0.4, anchor.y, anchor.theta}, 12, from);
    EXPECT_NEAR(found.scale, scale, scale == 1 ? 0 : 0.004) << from;
    EXPECT_LT(cv::norm(found.pose.position() - anchor.position()), 0.12) << scale << ' ' << from;
  }
}

// At the learned size, the edges are 3 to 5 px away.
TEST_F(RefinementTest, ALargePlainObjectNeedsAStartAtItsScale) {
  cv::Mat map = cv::Mat::zeros(240, 240, CV_8UC1);
  map(cv::Rect(30, 60, 180, 120)) = 255;
  LearningImage plate(3, map);
  plate.surface.convertTo(plate.surface, -1, 0.02, 120);
  plate.surface.copyTo(plate.image, map);
  const auto object = test::object_from(plate, {120, 120, 0});
  const prepared::PreparedView view(object->views.front(), prepared::Engine::kFast);
  cv::Mat image = test::texture({400, 400}, 77, 5), scene;
  test::place(image, plate, {120, 120}, {200, 200, 0.8});
  cv::resize(image, scene, {}, 0.95, 0.95, cv::INTER_AREA);
  const cv::Point2d lever = 0.95 * view.reference_in_anchor.position();
  const Pose2D anchor =
      compose({200.5 * 0.95 - 0.5, 200.5 * 0.95 - 0.5, 0.8}, inverse(Pose2D{lever.x, lever.y, 0}));
  const scene::SceneLevel level(scene, 0);
  EXPECT_EQ(refine(view.dense, level, anchor, 12).scale, 1);
  EXPECT_NEAR(refine(view.dense, level, anchor, 12, 0.94).scale, 0.95, 0.004);
}

TEST_F(RefinementTest, StaysAtTheStartWithoutSteps) {
  const Pose2D truth{103.7, 82.6, 0.7};
  const Pose2D start{104.1, 82.2, 0.71};
  const Refined found = refined(scene_with(truth), start, 0);
  EXPECT_EQ(found.pose.x, start.x);
  EXPECT_EQ(found.pose.y, start.y);
  EXPECT_EQ(found.pose.theta, start.theta);
  EXPECT_EQ(found.scale, 1);
  EXPECT_GT(found.covariance(0, 0), 0);
}

TEST_F(RefinementTest, CovarianceIsLargeOutsideTheImage) {
  const Refined found = refined(scene_with({103.7, 82.6, 0.7}), {-500, 40, 0});
  EXPECT_GT(found.covariance(0, 0), 1000);
  EXPECT_GT(found.covariance(2, 2), 1);
}

TEST(RandomEffects, MeasureTheDisagreementBeyondTheCovariances) {
  const auto pull_to = [](const numeric::Motion& motion, double information) {
    numeric::NormalEquations pull;
    pull.information = information * cv::Matx44d::diag({1, 1, 400, 400});
    pull.vector = pull.information * motion;
    return pull;
  };
  const numeric::Motion there(0.3, -0.2, 0.01, 0);
  std::vector<numeric::NormalEquations> agreed, apart, ignorant;
  for (const double information : {100.0, 400.0, 900.0}) {
    const numeric::Motion moved = there + numeric::Motion(0.5, 0, 0, 0) * (information == 900);
    agreed.push_back(pull_to(there, information));
    apart.push_back(pull_to(moved, information));
    ignorant.push_back(pull_to(moved, information == 900 ? information : 1e-6));
  }
  const auto variance = [](const auto& estimates) {
    return numeric::random_effects_variance(estimates, 20);
  };
  EXPECT_DOUBLE_EQ(variance(agreed), 0);
  EXPECT_DOUBLE_EQ(variance(ignorant), 0) << "who knows nothing cannot disagree";
  // Half a pixel along one of three directions.
  EXPECT_NEAR(variance(apart), 0.25 / 2 / 3, 0.02);
}

TEST(MarginalisationTest, AFreeShiftLowersTheInformationOnThePosition) {
  numeric::NormalEquations pull;
  pull.information = cv::Matx44d(50, 3, 8, 2, 3, 40, -5, 1, 8, -5, 900, 4, 2, 1, 4, 700);
  const numeric::Motion motion(0.2, -0.1, 0.01, 0.02);
  pull.vector = pull.information * motion;
  EXPECT_LT(cv::norm(numeric::marginalised_over_shift(pull, 1e-6).information - pull.information),
            1e-6);
  const numeric::NormalEquations loose = numeric::marginalised_over_shift(pull, 0.5);
  EXPECT_LT(loose.information(0, 0), 1 / (0.5 * 0.5));
  EXPECT_LT(loose.information(1, 1), 1 / (0.5 * 0.5));
  // The rotation is known only up to the correlated shift.
  EXPECT_LT(loose.information(2, 2), pull.information(2, 2));
  EXPECT_GT(loose.information(2, 2), 0.9 * pull.information(2, 2));
  EXPECT_LT(cv::norm(loose.information * motion - loose.vector), 1e-9);
}

TEST(MarginalisationTest, AFreeShiftAndTurnLowerAllInformation) {
  numeric::NormalEquations pull;
  pull.information = cv::Matx44d(50, 3, 8, 2, 3, 40, -5, 1, 8, -5, 90000, 4, 2, 1, 4, 70000);
  const numeric::Motion motion(0.2, -0.1, 0.01, 0.02);
  pull.vector = pull.information * motion;
  const numeric::NormalEquations loose = numeric::marginalised_over_shift_and_turn(pull, 0.5, 20);
  for (int k = 0; k < 4; ++k)
    EXPECT_LT(loose.information(k, k), (k < 2 ? 1.0 : 20.0 * 20.0) / (0.5 * 0.5)) << k;
  EXPECT_LT(cv::norm(loose.information * motion - loose.vector), 1e-9);
}

}  // namespace
}  // namespace mbncc::refinement
