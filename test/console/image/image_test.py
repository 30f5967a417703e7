#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""The image view: whether the image is live, the searched part of it, and the positions of boards.

usage: image_test.py SCRIPTS_FOLDER PLUGIN_FOLDER
"""
import pathlib
import sys
import tempfile
import unittest

SCRIPTS, PLUGINS = sys.argv[1:3]
del sys.argv[1:]
sys.path[:0] = [SCRIPTS, str(pathlib.Path(__file__).parents[1] / "layout")]
from console_boards import Boards  # noqa: E402
from console_operator import Teacher  # noqa: E402
from console_session import Session, end  # noqa: E402
from layout_report import LayoutReport  # noqa: E402

WIDTH, HEIGHT = 400, 300
# Without noise, images of a still scene are identical, like those of a frozen camera.
CAMERA = {"width": WIDTH, "height": HEIGHT, "object_diameter": 70.0, "neighbours": 0, "leg_time": 0.5,
          "noise_sigma": 0.0}


class ImageTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        cls.report = LayoutReport(PLUGINS, folder.name)
        cls.session = Session(size="1280x720", camera=CAMERA)
        cls.session.__enter__()
        cls.addClassCleanup(cls.session.__exit__)
        cls.teacher = Teacher()
        cls.mouse = cls.teacher.mouse

    def wait_until_found(self, found=True):
        self.teacher.found.wait(lambda m: bool(m.objects) == found, "it is found" if found else "nothing is found")

    def test_1_a_repeated_image_is_reported_until_it_changes(self):
        self.report.wait_until_says("THE SAME IMAGE")
        self.teacher.order("take_away", lies=False, halfway=lambda: self.report.wait_until_says("Live"))
        self.teacher.order("put_next", lies=True)

    def test_2_nothing_is_searched_outside_the_search_region(self):
        self.teacher.begin("bracket")
        self.teacher.take_away()
        self.teacher.wait_for_question()
        self.report.wait_until_says("Still image: before the object left")
        self.teacher.press("Accept")
        self.teacher.order("put_next", lies=True)
        self.wait_until_found()
        # The quarter of the image that is diagonally opposite the object.
        place = self.teacher.truth.get().objects[0].image_pose
        x = 5 if place.x > WIDTH / 2 else WIDTH - 105
        y = 5 if place.y > HEIGHT / 2 else HEIGHT - 80
        self.mouse.click_until("Search region", lambda: self.report.says("Draw a box around"), "it asks for a box")
        self.mouse.drag([(x, y), (x + 50, y + 40), (x + 100, y + 75)], (WIDTH, HEIGHT))
        self.mouse.window("Search everywhere")
        self.report.wait_until_says("Only the region is searched.")
        self.wait_until_found(False)
        self.mouse.click("Search everywhere")
        self.mouse.window("Search region")
        self.wait_until_found()

    def test_3_escape_and_a_click_set_no_region(self):
        self.mouse.click_until("Search region", lambda: self.report.says("Draw a box around"), "it asks for a box")
        self.mouse.drag([(20, 20)], (WIDTH, HEIGHT))
        self.mouse.press("Escape")
        self.mouse.drag([(20, 20), (60, 60), (90, 80)], (WIDTH, HEIGHT))
        self.mouse.window("Search region")

    def test_4_the_image_of_an_explanation_is_marked_as_still(self):
        self.mouse.click(r"Why not found here\?")
        self.mouse.drag([(30, 30)], (WIDTH, HEIGHT))
        self.mouse.window("Save this miss")
        self.report.wait_until_says("Still image of")
        self.mouse.press("Escape")
        self.report.wait_until_silent("Still image of")

    def test_5_the_boards_of_a_calibration_and_their_fields_are_drawn(self):
        end(self.session.cell)
        self.mouse.click("Camera")
        self.report.wait_until_says("OLD IMAGE: nothing has arrived for")
        Boards().show_all()
        self.report.wait_until_says("15 of 16 fields, 12 boards")
        self.mouse.click("Start over")
        self.report.wait_until_silent("15 of 16 fields, 12 boards")


class Report(unittest.TextTestResult):
    def addError(self, test, error):
        super().addError(test, error)
        if hasattr(ImageTest, "session"):
            print(ImageTest.session.logs(), ImageTest.report.newest())


unittest.main(testRunner=unittest.TextTestRunner(resultclass=Report, verbosity=2))
