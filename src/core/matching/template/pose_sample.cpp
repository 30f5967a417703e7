// SPDX-License-Identifier: BSD-3-Clause
#include "matching/template/pose_sample.hpp"

namespace mbncc::templates {

void PoseSample::read(const PoseTemplate& object, const scene::SceneLevel& scene,
                      const Pose2D& pose, int reach, double scale) {
  const scene::PreparedPixels pixels = scene.around(pose, scale * object.reach());
  object.surface.sample(pixels, pose, surface, scale);
  read_contour(object.contour, pixels.edges, pose, reach, contour, scale);
  if (surface.suffices()) residual = object.surface.residual(surface);
}

}  // namespace mbncc::templates
