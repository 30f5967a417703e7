#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Message packages that Debian 12 lacks, generated for tests: C++ headers and Python modules.

usage: generate.py OUT GEN_CPP TEMPLATES GEN_PY SHARE

Names, types and order of the fields are those of vision_msgs 0.0.2 and moveit_msgs 0.11 (Noetic), so the checksums are, too.
OUT gets share/PACKAGE/msg, include and lib/python3/dist-packages; SHARE holds the message packages that are installed.
"""
import pathlib
import subprocess
import sys

DEFINITIONS = {
    "object_recognition_msgs": {"ObjectType": ["string key", "string db"]},
    "vision_msgs": {
        "BoundingBox2D": ["geometry_msgs/Pose2D center", "float64 size_x", "float64 size_y"],
        "BoundingBox3D": ["geometry_msgs/Pose center", "geometry_msgs/Vector3 size"],
        "ObjectHypothesisWithPose": ["int64 id", "float64 score", "geometry_msgs/PoseWithCovariance pose"],
        "Detection2D": ["Header header", "ObjectHypothesisWithPose[] results", "BoundingBox2D bbox",
                        "sensor_msgs/Image source_img"],
        "Detection2DArray": ["Header header", "Detection2D[] detections"],
        "Detection3D": ["Header header", "ObjectHypothesisWithPose[] results", "BoundingBox3D bbox",
                        "sensor_msgs/PointCloud2 source_cloud"],
        "Detection3DArray": ["Header header", "Detection3D[] detections"],
        "VisionInfo": ["Header header", "string method", "string database_location", "int32 database_version"],
    },
    "moveit_msgs": {
        "CollisionObject": ["Header header", "geometry_msgs/Pose pose", "string id",
                            "object_recognition_msgs/ObjectType type", "shape_msgs/SolidPrimitive[] primitives",
                            "geometry_msgs/Pose[] primitive_poses", "shape_msgs/Mesh[] meshes",
                            "geometry_msgs/Pose[] mesh_poses", "shape_msgs/Plane[] planes",
                            "geometry_msgs/Pose[] plane_poses", "string[] subframe_names",
                            "geometry_msgs/Pose[] subframe_poses", "byte ADD=0", "byte REMOVE=1", "byte APPEND=2",
                            "byte MOVE=3", "byte operation"],
    },
}
INSTALLED = ("geometry_msgs", "sensor_msgs", "shape_msgs", "std_msgs")


def write_definitions(out):
    for package, messages in DEFINITIONS.items():
        folder = out / "share" / package / "msg"
        folder.mkdir(parents=True, exist_ok=True)
        for name, fields in messages.items():
            (folder / (name + ".msg")).write_text("\n".join(fields) + "\n")


def main():
    out, gen_cpp, templates, gen_py, share = (pathlib.Path(argument) for argument in sys.argv[1:])
    write_definitions(out)
    found = ["-I%s:%s" % (package, out / "share" / package / "msg") for package in DEFINITIONS]
    found += ["-I%s:%s" % (package, share / package / "msg") for package in INSTALLED]
    for package, messages in DEFINITIONS.items():
        headers = out / "include" / package
        modules = out / "lib/python3/dist-packages" / package
        (modules / "msg").mkdir(parents=True, exist_ok=True)
        headers.mkdir(parents=True, exist_ok=True)
        (modules / "__init__.py").write_text("")
        for name in messages:
            definition = out / "share" / package / "msg" / (name + ".msg")
            subprocess.run([sys.executable, gen_cpp, definition, *found, "-p", package, "-o", headers, "-e", templates],
                           check=True)
            subprocess.run([sys.executable, gen_py, definition, *found, "-p", package, "-o", modules / "msg"], check=True)
        subprocess.run([sys.executable, gen_py, "-o", modules / "msg", "--initpy"], check=True)


if __name__ == "__main__":
    main()
