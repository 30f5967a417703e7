#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""In every state of the console nothing is cut off, covered, elided or off the screen.

usage: layout_test.py SCRIPTS_FOLDER PLUGIN_FOLDER WIDTHxHEIGHT [SCALE]
"""
import os
import sys
import tempfile
import unittest

SCRIPTS, PLUGINS, SIZE = sys.argv[1:4]
os.environ["QT_SCALE_FACTOR"] = sys.argv[4] if len(sys.argv) > 4 else "1"
del sys.argv[1:]
sys.path.insert(0, SCRIPTS)
from console_operator import Teacher  # noqa: E402
from console_session import Session, end  # noqa: E402
from layout_report import LayoutReport  # noqa: E402

CAMERA = {"width": 640, "height": 480, "neighbours": 1, "leg_time": 0.5}
NAME = "bracket_for_the_left_side"
LONGEST = "x" * 64
BAD = 2


class LayoutTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        cls.report = LayoutReport(PLUGINS, folder.name)
        cls.session = Session(size=SIZE, camera=CAMERA)
        cls.session.__enter__()
        cls.addClassCleanup(cls.session.__exit__)
        cls.teacher = Teacher()
        cls.mouse = cls.teacher.mouse

    def fits(self, state):
        with self.subTest(state):
            self.assertEqual(self.report.complaints(), [])

    def accept(self):
        if self.mouse.sees("insist"):
            self.mouse.click("insist", at=(10, 10))
        self.teacher.press("Accept")

    def review(self):
        """The draft, once the console shows it."""
        draft = self.teacher.wait_for_question()
        self.mouse.window("Reject")
        return draft

    def teach(self, name):
        self.teacher.begin(name)
        self.teacher.take_away()
        self.review()
        self.accept()

    def test_1_lesson(self):
        from mbncc_vision.msg import LearnObjectFeedback
        self.fits("ready")
        self.teacher.begin(NAME)
        self.teacher.wait_for_stage(LearnObjectFeedback.WAIT_REMOVAL)
        self.fits("take the object away")
        self.teacher.order("take_away", lies=False, halfway=lambda: self.fits("the arm takes it"))
        draft = self.review()
        self.fits("review")
        # Without a window manager, a click alone does not give the window the keyboard focus.
        self.mouse.click("Cut")
        self.fits("review, a tool in hand")
        self.cut_until_bad(draft)
        self.mouse.window("insist")
        self.report.wait_until_says("Correct or reject the outline, or tick that you have checked it.")
        self.fits("review, verdict BAD")
        self.teacher.press("Reject")
        self.fits("rejected")

    def cut_until_bad(self, draft):
        reference = draft.object.reference
        for shift in range(-40, 41, 8):
            stroke = [(reference.x + shift, reference.y - 60 + 6 * i) for i in range(21)]
            draft = self.teacher.correct(
                lambda: self.mouse.drag(stroke, (CAMERA["width"], CAMERA["height"])))
            if draft.object.quality.verdict == BAD:
                return
        self.fail("the verdict never becomes BAD")

    def test_2_longest_name(self):
        self.teacher.order("put_next", lies=True)
        self.teach(LONGEST)
        self.mouse.window("Teach another view")
        self.fits("learned, another view is offered")
        self.mouse.write("name", LONGEST)
        self.mouse.click_until("Teach", lambda: self.mouse.sees("Replace it"), "it is asked")
        self.fits("the name is taken")
        self.teacher.order("put_next", lies=True)
        self.teacher.answer("Add view")
        self.teacher.take_away()
        self.review()
        self.accept()
        self.mouse.window("Next view .Space.")
        self.fits("the next view")
        self.mouse.click("library", at=(40, 40))
        self.mouse.click_until("Thresholds", lambda: self.mouse.sees("confirm_score"), "it shows them")
        self.fits("thresholds")
        self.mouse.click("one object", at=(8, 8))
        self.fits("thresholds of one object")
        self.mouse.press("Escape")
        self.mouse.click_until("Delete", lambda: LONGEST not in self.teacher.names(), "it is deleted")
        self.fits("deleted")
        self.mouse.choose_from_menu("More", "Up", "Return")
        self.mouse.window("Restore( .disabled.)?")
        self.fits("deleted objects")
        self.mouse.press("Escape")

    def test_3_library(self):
        self.teacher.order("put_next", lies=True)
        self.teach(NAME)
        self.teacher.order("put_next", lies=True)
        self.teacher.found.wait(lambda found: bool(found.objects), "it is found")
        self.fits("found")
        self.mouse.click("library", at=(40, 40))
        self.fits("library")
        self.mouse.open_menu("More")
        self.fits("menu")
        for key in ("Down", "Down", "Down", "Return"):
            self.mouse.press(key)
        self.mouse.window("Restore( .disabled.)?")
        self.fits("earlier revisions")
        self.mouse.press("Escape")
        self.mouse.focus_window()
        self.mouse.click("Rename")
        self.mouse.type("12")
        self.mouse.press("Return")
        self.report.wait_until_says("Not renamed")
        self.fits("a new name is refused")

    def test_4_explanations(self):
        self.mouse.click_until("Why not found here\\?", lambda: True, "it asks for the place")
        self.fits("the place is asked for")
        place = self.teacher.truth.get().objects[0].image_pose
        self.mouse.drag([(place.x, place.y)], (CAMERA["width"], CAMERA["height"]))
        self.mouse.window("Save this miss")
        self.fits("why not found")
        misses = self.session.folder / "library" / ".misses"
        self.mouse.click_until("Save this miss", lambda: any(misses.glob("*.miss")), "it is saved")
        self.fits("the miss is saved")
        self.mouse.press("Escape")

    def test_4b_search_region(self):
        self.mouse.click_until("Search region", lambda: self.report.says("Draw a box around"), "it asks for a box")
        self.fits("a search region is asked for")
        self.mouse.drag([(20, 20), (60, 60), (90, 80)], (CAMERA["width"], CAMERA["height"]))
        self.mouse.window("Search everywhere")
        self.fits("a search region")
        self.mouse.click("Search everywhere")
        self.mouse.window("Search region")

    def test_5_camera(self):
        self.mouse.click_until("Camera", lambda: self.mouse.sees("Compute"), "it helps with the camera")
        self.fits("camera")
        self.mouse.press("Escape")

    def test_6_gone(self):
        end(self.session.cell)
        self.mouse.window("Teach .disabled.")
        self.fits("the cell is gone")


class Report(unittest.TextTestResult):
    def addError(self, test, error):
        super().addError(test, error)
        if hasattr(LayoutTest, "session"):
            print(LayoutTest.session.logs())


unittest.main(testRunner=unittest.TextTestRunner(resultclass=Report, verbosity=2), failfast=False)
