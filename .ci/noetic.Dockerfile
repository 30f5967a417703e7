# SPDX-License-Identifier: BSD-3-Clause
# The package on ROS Noetic (Ubuntu 20.04), built and tested in a catkin workspace.
#   docker build -f .ci/noetic.Dockerfile -t mbncc_vision_noetic .
#   docker run --rm mbncc_vision_noetic                      # its tests
#   docker run --rm -it --network host --device /dev/video0 mbncc_vision_noetic bash
FROM osrf/ros:noetic-desktop

SHELL ["/bin/bash", "-o", "pipefail", "-c"]
WORKDIR /workspace
COPY package.xml src/mbncc_vision/
# Noetic has reached its end of life, so rosdep has to be told that it is meant.
RUN apt-get update \
    && rosdep update --include-eol-distros --rosdistro noetic \
    && DEBIAN_FRONTEND=noninteractive rosdep install --from-paths src --ignore-src --rosdistro noetic -y \
    && rm -rf /var/lib/apt/lists/*
COPY . src/mbncc_vision
RUN source /opt/ros/noetic/setup.bash && catkin_make -DCMAKE_BUILD_TYPE=Release
CMD ["bash", "-c", "source devel/setup.bash && cd build && ctest --output-on-failure -j$(nproc)"]
