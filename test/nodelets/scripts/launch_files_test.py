#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Settings of the launch files, checked without a master: each image uses its own calibration."""
import glob
import os
import tempfile
import unittest
import xml.etree.ElementTree

import rospkg
from roslaunch.config import ROSLaunchConfig
from roslaunch.xmlloader import XmlLoader

LAUNCH = os.path.join(rospkg.RosPack().get_path("mbncc_vision"), "launch")


def load(name, *arguments):
    config = ROSLaunchConfig()
    XmlLoader().load(os.path.join(LAUNCH, name), config, argv=list(arguments), verbose=False)
    return config


def parameters(name, *arguments):
    return {key: parameter.value for key, parameter in load(name, *arguments).params.items()}


def calibrations(name, *arguments):
    """The names to which the nodes of the package remap camera_info."""
    return {dict(node.remap_args)["camera_info"] for node in load(name, *arguments).nodes
            if node.type == "nodelet" and node.args != "manager"}


class Rectified(unittest.TestCase):
    def expect(self, expected, name, *arguments, cell="/"):
        loaded = parameters(name, *arguments)
        for nodelet in ("learning", "matching"):
            self.assertIs(loaded[cell + nodelet + "/rectified"], expected, (nodelet, name, arguments))

    def test_a_camera_publishes_raw_images(self):
        self.expect(False, "cell.launch")
        self.expect(False, "cell.launch", "simulated:=true")
        self.expect(False, "demo.launch")
        self.expect(False, "vision.launch")

    def test_the_rectify_nodelet_publishes_rectified_images(self):
        self.expect(True, "cell.launch", "rectify:=true")
        self.expect(True, "cell.launch", "camera:=false", "rectify:=true", "image:=/front/image_raw")

    def test_raw_images_that_are_rectified_here_are_searched_as_rectified(self):
        for rectified in ("true", "false"):
            self.expect(True, "cell.launch", "rectify:=true", "rectified:=" + rectified)
        for expected, argument in ((True, "image:=/cam/image_rect"), (True, "rectified:=true"), (False, "image:=/cam/image_raw")):
            self.assertIs(parameters("cell.launch", "camera:=false", "rectify:=true", argument)["/rectify/rectified"], expected)

    def test_other_images_are_recognised_by_their_topic(self):
        self.expect(False, "cell.launch", "camera:=false", "image:=/front/image_color")
        self.expect(True, "cell.launch", "camera:=false", "image:=/front/image_rect")
        self.expect(True, "cell.launch", "camera:=false", "image:=/front/image_rect_color")
        self.expect(False, "replay.launch", "bag:=x.bag")
        self.expect(True, "replay.launch", "bag:=x.bag", "image:=/image_rect")

    def test_an_explicit_argument_takes_precedence(self):
        self.expect(True, "cell.launch", "camera:=false", "image:=/straight", "rectified:=true")
        self.expect(True, "replay.launch", "bag:=x.bag", "image:=/straight", "rectified:=true")
        self.expect(False, "cell.launch", "camera:=false", "image:=/image_rect", "rectified:=false")

    def test_both_of_two_cells_use_raw_images(self):
        loaded = parameters("cells.launch")
        for key in ("/left/learning", "/left/matching", "/right/matching"):
            self.assertIs(loaded[key + "/rectified"], False, key)


class TopView(unittest.TestCase):
    def test_is_searched_with_its_own_calibration_and_frame(self):
        config = load("cell.launch", "top_view:=true", "platform_frame:=table", "image:=/usb_cam/image_raw")
        remaps = {node.name: dict(node.remap_args) for node in config.nodes}
        for nodelet in ("learning", "matching"):
            self.assertEqual(remaps[nodelet]["image_raw"], "top_view/image_rect", nodelet)
            self.assertEqual(remaps[nodelet]["camera_info"], "top_view/camera_info", nodelet)
            self.assertIs(config.params["/%s/rectified" % nodelet].value, True, nodelet)
            self.assertEqual(config.params["/%s/camera_frame" % nodelet].value, "", nodelet)
        self.assertEqual(remaps["rectify"]["image_raw"], "/usb_cam/image_raw")
        self.assertEqual(remaps["rectify"]["camera_info"], "/usb_cam/camera_info")
        self.assertIs(config.params["/rectify/top_view"].value, True)
        self.assertEqual(config.params["/rectify/platform_frame"].value, "table")

    def test_undistorts_only_raw_images(self):
        def rectified(*arguments):
            return parameters("cell.launch", "top_view:=true", *arguments)["/rectify/rectified"]
        self.assertIs(rectified(), False)
        self.assertIs(rectified("rectify:=true"), False)
        self.assertIs(rectified("image:=/usb_cam/image_rect"), True)
        self.assertIs(rectified("image:=/straight", "rectified:=true"), True)
        self.assertIs(rectified("image:=/image_rect", "rectified:=false"), False)

    def test_works_for_two_cells_and_for_bags(self):
        loaded = parameters("cells.launch", "top_view:=true")
        for key in ("/left/rectify", "/right/rectify"):
            self.assertIs(loaded[key + "/top_view"], True, key)
        loaded = parameters("replay.launch", "bag:=x.bag", "top_view:=true", "platform_frame:=table")
        self.assertIs(loaded["/rectify/top_view"], True)
        self.assertEqual(loaded["/searched_image"], "top_view/image_rect")
        self.assertEqual(parameters("replay.launch", "bag:=x.bag", "rectify:=true")["/searched_image"], "image_rect")

    def test_is_off_by_default(self):
        loaded = parameters("cell.launch", "rectify:=true", "platform_frame:=table")
        self.assertIs(loaded["/rectify/top_view"], False)
        self.assertIs(loaded["/rectify/rectified"], False)


class Calibration(unittest.TestCase):
    def test_of_two_cameras_does_not_go_to_one_file(self):
        loaded = parameters("cells.launch")
        self.assertEqual(loaded["/left/camera/camera_name"], "left_camera")
        self.assertEqual(loaded["/right/camera/camera_name"], "right_camera")


    def test_lies_beside_the_images(self):
        self.assertEqual(calibrations("cell.launch"), {"camera_info"})
        self.assertEqual(calibrations("cell.launch", "camera:=false", "image:=/usb_cam/image_raw"),
                         {"/usb_cam/camera_info"})
        self.assertEqual(calibrations("replay.launch", "bag:=x.bag", "image:=/front/image_raw"),
                         {"/front/camera_info"})

    def test_may_be_another_topic(self):
        self.assertEqual(calibrations("cell.launch", "image:=/a/image_raw", "camera_info:=/b/info"), {"/b/info"})


class Console(unittest.TestCase):
    def of(self, *arguments):
        return load("console.launch", *arguments).nodes[0]

    def test_shows_the_images_and_the_frame_of_the_cell(self):
        self.assertEqual(self.of().type, "console")
        for window in ("rviz:=false", "rviz:=true"):
            self.assertEqual(dict(self.of(window).remap_args), {"image_raw": "image_raw"})
            other = self.of(window, "image:=/usb_cam/image_raw")
            self.assertEqual(dict(other.remap_args), {"image_raw": "/usb_cam/image_raw"})
        self.assertIn("-f camera_optical_frame", self.of("rviz:=true").args)
        self.assertIn("-f usb_cam", self.of("rviz:=true", "frame:=usb_cam").args)

    def test_has_a_name_of_its_own_so_that_a_second_one_does_not_end_it(self):
        for window in ("rviz:=false", "rviz:=true"):
            self.assertNotEqual(self.of(window).name, self.of(window).name)

    def test_is_configured_with_the_images_that_the_cell_searches(self):
        def told(*arguments):
            loaded = parameters("cell.launch", *arguments)
            return loaded["/searched_image"], loaded["/camera_image"]
        self.assertEqual(told(), ("image_raw", "image_raw"))
        self.assertEqual(told("image:=/a/image_raw"), ("/a/image_raw", "/a/image_raw"))
        self.assertEqual(told("rectify:=true"), ("image_rect", "image_raw"))
        self.assertEqual(told("top_view:=true"), ("top_view/image_rect", "image_raw"))


class Images(unittest.TestCase):
    WANTED = {"image_transport": "compressed", "white_level": 4095, "max_info_age": 1e9, "tf_wait": 0.05}
    ARGUMENTS = ["image_transport:=compressed", "white_level:=4095", "max_info_age:=1e9", "tf_wait:=0.05"]

    def of(self, nodelet, name, *arguments):
        loaded = parameters(name, *arguments)
        return {key: loaded[nodelet + "/" + key] for key in self.WANTED if nodelet + "/" + key in loaded}

    def test_are_read_with_the_arguments(self):
        learning = {key: value for key, value in self.WANTED.items() if key != "tf_wait"}
        for name, cell in (("cell.launch", ""), ("cells.launch", "/left"), ("vision.launch", "")):
            self.assertEqual(self.of(cell + "/learning", name, *self.ARGUMENTS), learning)
            self.assertEqual(self.of(cell + "/matching", name, *self.ARGUMENTS), self.WANTED)
        self.assertEqual(self.of("/right/matching", "cells.launch", *self.ARGUMENTS), self.WANTED)
        self.assertEqual(self.of("/learning", "replay.launch", "bag:=x.bag", *self.ARGUMENTS), learning)
        self.assertEqual(self.of("/matching", "replay.launch", "bag:=x.bag", *self.ARGUMENTS), self.WANTED)

    def test_of_the_rectify_nodelet_are_plain(self):
        arguments = ["cell.launch", "rectify:=true"] + self.ARGUMENTS
        rectify = {key: value for key, value in self.WANTED.items() if key != "tf_wait"}
        self.assertEqual(self.of("/rectify", *arguments), rectify)
        for nodelet in ("/learning", "/matching"):
            read = self.of(nodelet, *arguments)
            self.assertEqual((read["image_transport"], read["white_level"], read["max_info_age"]), ("raw", 0, 1e9))

    def test_are_read_as_configured_in_the_files_by_default(self):
        self.assertEqual(self.of("/matching", "cell.launch"),
                         {"image_transport": "raw", "white_level": 0, "max_info_age": 60, "tf_wait": 0})


class Recording(unittest.TestCase):
    def test_is_played_again_if_wanted(self):
        self.assertIs(parameters("cell.launch")["/camera/loop"], False)
        self.assertIs(parameters("cell.launch", "source:=images", "loop:=true")["/camera/loop"], True)


class Frames(unittest.TestCase):
    def test_are_those_of_the_arguments(self):
        for name in (["cell.launch"], ["replay.launch", "bag:=x.bag"]):
            loaded = parameters(*name, "target_frame:=base_link", "gripper_frame:=tool0", "tf_prefix:=left_")
            self.assertEqual(loaded["/matching/target_frame"], "base_link")
            self.assertEqual(loaded["/matching/tf_prefix"], "left_")
            self.assertEqual(loaded["/learning/gripper_frame"], "tool0")

    def test_of_poses_do_not_depend_on_the_image_source(self):
        for arguments, matching in ((["cells.launch"], "/left/matching"), (["cells.launch"], "/right/matching"),
                                    (["replay.launch", "bag:=x.bag"], "/matching")):
            loaded = parameters(*arguments, "target_frame:=base_link")
            self.assertEqual(loaded[matching + "/target_frame"], "base_link", arguments)

    def test_are_those_of_the_files_by_default(self):
        loaded = parameters("cell.launch")
        self.assertEqual((loaded["/matching/target_frame"], loaded["/learning/gripper_frame"]), ("", ""))


class OwnCamera(unittest.TestCase):
    """The example of a cell with its own driver and frames."""

    def test_passes_topics_and_frames_to_the_cell(self):
        arguments = ["../examples/launch/own_camera.launch", "image:=/cell7/cam/image_raw",
                     "camera_frame:=cell7_cam_optical", "base_frame:=robot_base", "camera_pose:=0.5 0 1.2 1 0 0 0",
                     "platform_distance:=0.8"]
        nodes = {node.name: node for node in load(*arguments).nodes}
        self.assertNotIn("camera", nodes)
        self.assertEqual(nodes["camera_in_base"].args, "0.5 0 1.2 1 0 0 0 robot_base cell7_cam_optical")
        for name in ("learning", "matching"):
            self.assertEqual(dict(nodes[name].remap_args), {"image_raw": "/cell7/cam/image_raw",
                                                            "camera_info": "/cell7/cam/camera_info"})
        loaded = parameters(*arguments)
        self.assertEqual((loaded["/matching/target_frame"], loaded["/matching/platform_distance"]), ("robot_base", 0.8))


class Settings(unittest.TestCase):
    def test_of_a_file_are_read_for_a_replay_as_for_a_cell(self):
        with tempfile.NamedTemporaryFile("w", suffix=".yaml") as file:
            file.write("{min_score: 0.625, still_time: 0.75}")
            file.flush()
            for name in (["cell.launch"], ["replay.launch", "bag:=x.bag"]):
                loaded = parameters(*name, "matching_config:=" + file.name, "learning_config:=" + file.name)
                self.assertEqual((loaded["/matching/min_score"], loaded["/learning/still_time"]), (0.625, 0.75))


class Manager(unittest.TestCase):
    """Nodelets in a driver's manager receive its images without copying."""

    def nodes(self, *arguments):
        return {node.name: node.args.split() for node in load(*arguments).nodes if node.type == "nodelet"}

    def test_is_the_cells_own_or_none(self):
        for name in ("cell.launch", "demo.launch"):
            nodes = self.nodes(name)
            self.assertEqual(nodes["mbncc_manager"], ["manager"])
            self.assertEqual(nodes["matching"], ["load", "mbncc_vision/MatchingNodelet", "mbncc_manager"])
            apart = self.nodes(name, "one_manager:=false")
            self.assertNotIn("mbncc_manager", apart)
            self.assertEqual(apart["matching"], ["standalone", "mbncc_vision/MatchingNodelet"])

    def test_has_no_remappings_that_override_those_of_its_nodelets(self):
        for name, arguments in (("cell.launch", ()), ("demo.launch", ()), ("cells.launch", ()),
                                ("replay.launch", ("bag:=x.bag",))):
            for more in ((), ("image:=/usb_cam/image_raw",)) if name in ("cell.launch", "replay.launch") else ((),):
                managers = [node for node in load(name, *arguments, *more).nodes if node.args == "manager"]
                self.assertTrue(managers)
                for manager in managers:
                    self.assertFalse({"image_raw", "camera_info"} & set(dict(manager.remap_args)), (name, more))

    def test_may_be_that_of_the_driver(self):
        for arguments in (["cell.launch", "camera:=false"], ["demo.launch"], ["replay.launch", "bag:=x.bag"],
                          ["vision.launch"], ["cell.launch", "one_manager:=false"],
                          ["cells.launch", "left_manager:=/driver", "right_manager:=/driver"]):
            if arguments[0] != "cells.launch":
                arguments.append("manager:=/driver")
            nodes = self.nodes(*arguments)
            self.assertNotIn("mbncc_manager", nodes, arguments)
            for node, words in nodes.items():
                self.assertEqual((words[0], words[2]), ("load", "/driver"), (node, arguments))


class Platform(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = folder.name
        for name, text in (("platform.launch", "<launch><param name='published' value='1'/></launch>"),
                           ("platform.yaml", "{platform_frame: table, platform_intrinsics: stated}")):
            with open(os.path.join(self.folder, name), "w", encoding="utf-8") as file:
                file.write(text)

    def test_of_a_cell_comes_from_the_calibrations_folder(self):
        for arguments in (["cell.launch"], ["replay.launch", "bag:=x.bag"]):
            loaded = parameters(*arguments, "platform:=" + self.folder)
            self.assertEqual(loaded["/published"], 1)
            for nodelet in ("learning", "matching"):
                self.assertEqual(loaded["/" + nodelet + "/platform_frame"], "table")

    def intrinsics(self, *arguments):
        loaded = parameters("cell.launch", "platform:=" + self.folder, *arguments)
        return [loaded.get("/" + nodelet + "/platform_intrinsics") for nodelet in ("learning", "matching", "rectify")]

    def test_is_compared_with_the_camera_that_it_was_calibrated_with(self):
        self.assertEqual(self.intrinsics(), ["stated", "stated", None])
        self.assertEqual(self.intrinsics("rectify:=true"), ["stated", "stated", ""])
        self.assertEqual(self.intrinsics("top_view:=true"), ["", "", "stated"], "by the nodelet that sees the camera")
        self.assertEqual(self.intrinsics("platform_frame:=other"), ["", "", None], "which is of another frame")
        self.assertEqual(self.intrinsics("platform_frame:=other", "top_view:=true"), ["", "", ""])

    def test_of_each_of_two_cells(self):
        loaded = parameters("cells.launch", "left_platform:=" + self.folder)
        self.assertEqual(loaded["/left/published"], 1)
        self.assertEqual(loaded["/left/matching/platform_frame"], "table")
        self.assertEqual(loaded["/right/matching/platform_frame"], "")


class Searching(unittest.TestCase):
    """A lesson is judged with the settings of the search that will later find its object."""

    def of(self, nodelet, *arguments, file="cell.launch"):
        start = nodelet + "/"
        return {key[len(start):]: value for key, value in parameters(file, *arguments).items()
                if key.startswith(start)}

    def test_learning_reads_the_settings_of_matching(self):
        with tempfile.NamedTemporaryFile("w", suffix=".yaml") as file:
            file.write("{confirm_score: 0.9, scale_range: 0.1}")
            file.flush()
            own = "matching_config:=" + file.name
            judged = self.of("/learning/matching", own)
            self.assertEqual(judged, {"confirm_score": 0.9, "scale_range": 0.1})
            self.assertLessEqual(judged.items(), self.of("/matching", own).items())

    def test_learning_reads_the_shipped_settings_of_matching(self):
        for file, cell in (("cell.launch", ""), ("cells.launch", "/left"), ("demo.launch", "")):
            judged = self.of(cell + "/learning/matching", file=file)
            self.assertIn("min_score", judged)
            for key in ("min_score", "confirm_score", "engine", "threads"):
                self.assertEqual(judged[key], self.of(cell + "/matching", file=file)[key], (file, key))


class StaleParameters(unittest.TestCase):
    """The master may outlive a launch; the parameters of that launch must not affect the next one."""

    def test_every_node_of_every_file_clears_its_parameters(self):
        files = glob.glob(os.path.join(LAUNCH, "*.launch"))
        self.assertGreaterEqual(len(files), 6)
        for path in files:
            for node in xml.etree.ElementTree.parse(path).getroot().iter("node"):
                self.assertEqual(node.get("clear_params"), "true", (path, node.get("name")))

    def test_all_namespaces_that_nodes_read_are_cleared(self):
        for arguments in (["cell.launch"], ["cell.launch", "simulated:=true", "rectify:=true", "one_manager:=false"],
                          ["cells.launch"], ["demo.launch"], ["replay.launch", "bag:=x.bag"], ["console.launch"],
                          ["vision.launch"]):
            config = load(*arguments)
            cleared = {namespace.rstrip("/") for namespace in config.clear_params}
            for node in config.nodes:
                self.assertIn(node.namespace + node.name, cleared, arguments)

    def test_settings_for_nodes_of_an_included_file_are_applied_last(self):
        self.assertIs(parameters("demo.launch", "auto_play:=false")["/camera/auto_play"], False)


unittest.main()
