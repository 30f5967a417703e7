#include "matching/motion_pull.hpp"

namespace mbncc {

MotionPull& MotionPull::operator+=(const MotionPull& other) {
  information += other.information;
  vector += other.vector;
  return *this;
}

MotionPull loosened(const MotionPull& pull, double deviation) {
  const double prior = 1 / (deviation * deviation);
  const cv::Matx<double, kMotionParts, 2> cross = pull.information.get_minor<kMotionParts, 2>(0, 0);
  const cv::Matx22d own = pull.information.get_minor<2, 2>(0, 0) + cv::Matx22d::eye() * prior;
  const cv::Matx<double, kMotionParts, 2> share = cross * own.inv();
  MotionPull loose = pull;
  loose.information -= share * cross.t();
  loose.vector -= share * cv::Vec2d(pull.vector[0], pull.vector[1]);
  return loose;
}

}  // namespace mbncc
