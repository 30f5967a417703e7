#include "matching/pose_sample.hpp"

namespace mbncc {

void PoseSample::read(const PoseTemplate& object, const SceneLevel& scene, const Pose2D& pose,
                      int reach) {
  scene.prepare_around(pose, object.reach());
  object.surface.sample(scene, pose, surface);
  read_contour(object.contour, scene.edges, pose, reach, contour);
  if (surface.suffices()) remainder = object.surface.remainder(surface);
}

}  // namespace mbncc
