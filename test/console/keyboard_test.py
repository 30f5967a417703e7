#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""A whole lesson with the keyboard only: name, Teach, a stroke, Accept, Replace, Add view and the next view.

usage: keyboard_test.py SCRIPTS_FOLDER PLUGIN_FOLDER
"""
import pathlib
import sys
import tempfile
import unittest

SCRIPTS, PLUGINS = sys.argv[1:3]
del sys.argv[1:]
sys.path[:0] = [SCRIPTS, str(pathlib.Path(__file__).parent / "layout")]
from console_operator import Teacher  # noqa: E402
from console_session import Session, wait_for  # noqa: E402
from layout_report import LayoutReport  # noqa: E402

CAMERA = {"width": 400, "height": 300, "object_diameter": 70.0, "neighbours": 0, "leg_time": 0.5}


class KeyboardTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        cls.report = LayoutReport(PLUGINS, folder.name)
        cls.session = Session(size="1280x720", camera=CAMERA)
        cls.session.__enter__()
        cls.addClassCleanup(cls.session.__exit__)
        cls.teacher = Teacher()
        cls.teacher.mouse.focus_window()

    def setUp(self):
        if not self.teacher.truth.get().objects:
            self.teacher.order("put_next", lies=True)

    def keys(self, *keys):
        for key in keys:
            self.teacher.mouse.press(key)

    def has_keyboard(self, name):
        wait_for(lambda: self.report.focus() == name, "'%s' has the keyboard" % name)

    def begins_by(self, *keys):
        count = self.teacher.feedback.count()
        self.keys(*keys)
        wait_for(lambda: self.teacher.feedback.count() > count, "a lesson begins")
        self.has_keyboard("image")

    def ends_by(self, *keys):
        count = self.teacher.result.count()
        self.keys(*keys)
        wait_for(lambda: self.teacher.result.count() > count, "the lesson ends")
        return self.teacher.result.get().result

    def show(self):
        self.teacher.take_away()
        draft = self.teacher.wait_for_question()
        self.teacher.mouse.window("Accept")
        return draft

    def name(self, name):
        self.keys("ctrl+n")
        self.has_keyboard("name")
        self.teacher.mouse.type(name)

    def ask_about(self, name):
        wait_for(lambda: not self.teacher.mouse.sees("Teach .disabled."), "a lesson may begin")
        self.name(name)
        self.keys("Return")
        self.has_keyboard("New name")

    def test_1_a_new_object_with_a_stroke(self):
        from mbncc_vision.msg import LearnObjectResult
        self.has_keyboard("name")
        self.teacher.mouse.type("bracket")
        self.begins_by("Return")
        first = self.show()
        results = self.teacher.result.count()
        self.keys("space", "Return")
        self.keys("c", "Left", "Left", "space")
        cut = self.teacher.correct(lambda: self.keys("Right", "Right", "Right", "Right", "space"))
        self.assertLess(cut.object.quality.area, first.object.quality.area - 30)
        back = self.teacher.correct(lambda: self.keys("ctrl+z"))
        self.assertEqual(back.map.data, first.map.data)
        self.assertEqual(self.teacher.result.count(), results, "neither Space nor Enter stores")
        self.keys("Escape")
        wait_for(lambda: not self.teacher.mouse.sees("Accept .disabled."), "it may be accepted")
        result = self.ends_by("ctrl+Return")
        self.assertEqual(result.error_code, LearnObjectResult.SUCCESS, result.message)
        self.has_keyboard("image")

    def test_2_accept_is_reached_by_tab(self):
        from mbncc_vision.msg import LearnObjectResult
        self.name("clamp")
        self.begins_by("Return")
        self.show()
        for name in ("Hide marks", "Show all", "advice", "Add", "stroke width", "Accept"):
            self.keys("Tab")
            self.has_keyboard(name)
        result = self.ends_by("space")
        self.assertEqual(result.error_code, LearnObjectResult.SUCCESS, result.message)
        self.has_keyboard("image")
        count = self.teacher.feedback.count()
        self.keys("space", "Return")
        self.name("other")
        self.assertEqual(self.teacher.feedback.count(), count, "nothing begins by itself")

    def test_3_replace(self):
        revision = self.teacher.revisions()["bracket"]
        self.ask_about("bracket")
        self.begins_by("alt+p")
        self.show()
        self.ends_by("alt+a")
        wait_for(lambda: self.teacher.revisions()["bracket"] > revision, "it is replaced")

    def test_4_views_in_a_row(self):
        from mbncc_vision.msg import LearnObjectResult
        self.ask_about("bracket")
        self.begins_by("alt+a")
        self.show()
        result = self.ends_by("ctrl+Return")
        self.assertEqual(result.error_code, LearnObjectResult.SUCCESS, result.message)
        self.teacher.order("put_next", lies=True)
        self.has_keyboard("image")
        self.teacher.mouse.window("Next view .Space.")
        self.begins_by("space")
        result = self.ends_by("alt+c")
        self.assertEqual(result.error_code, LearnObjectResult.CANCELLED)
        self.keys("Escape")
        wait_for(lambda: not self.teacher.mouse.sees("Next view .Space."), "no further view is wanted")

    def test_5_a_place_is_asked_about(self):
        self.keys("w", "Right", "space")
        self.teacher.mouse.window("Save this miss")
        self.keys("Escape")
        wait_for(lambda: not self.teacher.mouse.sees("Back to live"), "the live image is back")

    def test_6_a_search_region_is_drawn(self):
        self.keys("g", "space", *["Right"] * 8, *["Down"] * 8, "space")
        self.teacher.mouse.window("Search everywhere")
        self.keys("g")
        self.teacher.mouse.window("Search region")


class Report(unittest.TextTestResult):
    def addError(self, test, error):
        super().addError(test, error)
        if hasattr(KeyboardTest, "session"):
            print(KeyboardTest.session.logs(), KeyboardTest.report.newest())


unittest.main(testRunner=unittest.TextTestRunner(resultclass=Report, verbosity=2))
