#include "matching/contour_template.hpp"

#include <algorithm>
#include <cmath>

#include "matching/edge_picture.hpp"
#include "mbncc/matching/pyramid.hpp"

namespace mbncc {
namespace {

/// Reads edge responses along the normals of a contour at a pose.
class NormalReader {
 public:
  NormalReader(const ContourTemplate& contour, const cv::Mat& edges, const Pose2D& pose)
      : contour_(contour),
        edges_(edges),
        cos_(static_cast<float>(std::cos(pose.theta))),
        sin_(static_cast<float>(std::sin(pose.theta))),
        x0_(static_cast<float>(pose.x)),
        y0_(static_cast<float>(pose.y)) {}

  void move_to(std::size_t k) {
    x_ = cos_ * contour_.x[k] - sin_ * contour_.y[k] + x0_;
    y_ = sin_ * contour_.x[k] + cos_ * contour_.y[k] + y0_;
    normal_x_ = cos_ * contour_.normal_x[k] - sin_ * contour_.normal_y[k];
    normal_y_ = sin_ * contour_.normal_x[k] + cos_ * contour_.normal_y[k];
    double_x_ = (normal_x_ * normal_x_ - normal_y_ * normal_y_) / kEdgeScale;
    double_y_ = 2 * normal_x_ * normal_y_ / kEdgeScale;
  }

  /// Response at the pixel nearest to `steps` pixels along the normal. False: outside the picture.
  bool read(int steps, float& response, float& offset) const {
    const float x = x_ + steps * normal_x_, y = y_ + steps * normal_y_;
    const int column = static_cast<int>(std::floor(x + 0.5f));
    const int row = static_cast<int>(std::floor(y + 0.5f));
    if (column < 1 || row < 1 || column >= edges_.cols - 1 || row >= edges_.rows - 1) return false;
    const auto* edge = edges_.ptr<std::int8_t>(row) + 2 * column;
    response = double_x_ * edge[0] + double_y_ * edge[1];
    offset = (column - x_) * normal_x_ + (row - y_) * normal_y_;
    return true;
  }

 private:
  const ContourTemplate& contour_;
  const cv::Mat& edges_;
  float cos_, sin_, x0_, y0_;
  float x_ = 0, y_ = 0, normal_x_ = 0, normal_y_ = 0, double_x_ = 0, double_y_ = 0;
};

}  // namespace

ContourTemplate::ContourTemplate(const MapGeometry& map, cv::Point2d anchor, int level,
                                 std::size_t most) {
  const double side = 1 << level;
  const auto edge = map.edge(std::max(1.5, 0.8 * side));
  const auto wanted = static_cast<std::size_t>(static_cast<double>(edge.size()) / side);
  const std::size_t count = std::min({most, std::max<std::size_t>(8, wanted), edge.size()});
  for (std::size_t i = 0; i < count; ++i) {
    const EdgePoint& point = edge[i * edge.size() / count];
    x.push_back(static_cast<float>((point.position.x - anchor.x) / side));
    y.push_back(static_cast<float>((point.position.y - anchor.y) / side));
    normal_x.push_back(point.normal.x);
    normal_y.push_back(point.normal.y);
  }
}

double contour_agreement(const ContourTemplate& contour, const cv::Mat& edges, const Pose2D& pose) {
  NormalReader reader(contour, edges, pose);
  double sum = 0;
  std::size_t visible = 0;
  for (std::size_t k = 0; k < contour.size(); ++k) {
    reader.move_to(k);
    float best = -2, response = 0, offset = 0;
    for (int steps = -1; steps <= 1; ++steps)
      if (reader.read(steps, response, offset)) best = std::max(best, response);
    if (best < -1.5f) continue;
    sum += best;
    ++visible;
  }
  if (visible < 4 || 4 * visible < contour.size()) return -1;
  return sum / static_cast<double>(visible);
}

ContourPull contour_pull(const ContourTemplate& contour, const cv::Mat& edges, const Pose2D& pose,
                         int reach) {
  // How fast a response falls with the square of the distance from its edge: the edge's blur of
  // about one pixel.
  constexpr double kCurvature = 0.15;
  NormalReader reader(contour, edges, pose);
  ContourPull pull;
  for (std::size_t k = 0; k < contour.size(); ++k) {
    reader.move_to(k);
    float weights = 0, moments = 0, strongest = 0, response = 0, offset = 0;
    for (int steps = -reach; steps <= reach; ++steps) {
      if (!reader.read(steps, response, offset) || response <= 0) continue;
      weights += response * response;
      moments += response * response * offset;
      strongest = std::max(strongest, response);
    }
    if (weights <= 0) continue;
    const double nx = contour.normal_x[k], ny = contour.normal_y[k];
    const cv::Vec3d row(nx, ny, ny * contour.x[k] - nx * contour.y[k]);
    const double weight = 2 * kCurvature * strongest / static_cast<double>(contour.size());
    pull.hessian += weight * (row * row.t());
    pull.gradient -= weight * (moments / weights) * row;
  }
  return pull;
}

}  // namespace mbncc
