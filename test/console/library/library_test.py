#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""The library beside the image: messages that disappear when outdated, new names, restored objects, own thresholds.

usage: library_test.py SCRIPTS_FOLDER PLUGIN_FOLDER
"""
import pathlib
import sys
import tempfile
import unittest

SCRIPTS, PLUGINS = sys.argv[1:3]
del sys.argv[1:]
sys.path[:0] = [SCRIPTS, str(pathlib.Path(__file__).parents[1] / "layout")]
from console_operator import Teacher  # noqa: E402
from console_session import Session, wait_for  # noqa: E402
from layout_report import LayoutReport  # noqa: E402

CAMERA = {"width": 400, "height": 300, "object_diameter": 70.0, "neighbours": 0, "leg_time": 0.5}
FIRST = (40, 40)  # [px] position of the first object in the list


class LibraryTest(unittest.TestCase):
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

    def teach(self, name):
        if not self.teacher.truth.get().objects:
            self.teacher.order("put_next", lies=True)
        self.teacher.begin(name)
        self.teacher.take_away()
        self.teacher.wait_for_question()
        self.teacher.press("Accept")
        wait_for(lambda: name in self.teacher.names(), "it is listed")

    def rename_to(self, name):
        self.mouse.click("Rename")
        self.mouse.type(name)
        self.mouse.press("Return")

    def delete(self, name):
        self.mouse.click("library", at=FIRST)
        self.mouse.click_until("Delete", lambda: name not in self.teacher.names(), "it is deleted")

    def wait_until_found(self):
        self.teacher.found.wait(lambda m: bool(m.objects), "it is found")

    def own_threshold(self):
        return self.teacher.library.get().objects[0].min_score

    def test_1_learned_is_shown_only_while_the_object_exists(self):
        self.teach("bracket")
        self.report.wait_until_says("Learned 'bracket'")
        self.delete("bracket")
        self.report.wait_until_silent("Learned")
        self.report.wait_until_says("Ready")
        self.mouse.click_until("Undo edit", lambda: "bracket" in self.teacher.names(), "it is back")

    def test_2_an_invalid_name_is_reported_below_the_list_until_it_is_corrected(self):
        self.teach("clamp")
        self.mouse.focus_window()
        self.mouse.click("library", at=FIRST)
        self.rename_to("clamp")
        self.report.wait_until_says("Not renamed: 'clamp' is in the library already.")
        self.rename_to("12")
        self.report.wait_until_says("Not renamed: a name begins with a letter")
        self.rename_to("angle iron")
        wait_for(lambda: "angle_iron" in self.teacher.names(), "it is renamed")
        self.report.wait_until_says("A name has no spaces")
        self.rename_to("angle")
        wait_for(lambda: "angle" in self.teacher.names(), "it is renamed")
        self.report.wait_until_silent("name has no spaces")
        self.assertEqual(set(self.teacher.names()), {"angle", "clamp"})

    def test_2b_an_explanation_names_the_objects_that_are_disabled(self):
        self.mouse.click("library", at=FIRST)
        self.mouse.click_until("Disable", lambda: not self.teacher.names()["angle"], "it is disabled")
        self.mouse.click(r"Why not found here\?")
        self.mouse.drag([(200, 150)], (CAMERA["width"], CAMERA["height"]))
        self.report.wait_until_says("Not searched, because disabled: 'angle'. Enable the one that lies here.")
        self.mouse.click("Back to live")
        self.mouse.click_until("Enable", lambda: self.teacher.names()["angle"], "it is enabled")

    def test_2c_the_question_about_a_taken_name_has_its_headline(self):
        self.mouse.write("name", "clamp")
        self.mouse.click_until("Teach", lambda: self.mouse.sees("Replace it"), "it is asked")
        self.report.wait_until_says("The name is taken")
        self.mouse.press("Escape")
        self.report.wait_until_silent("The name is taken")

    def test_3_an_object_that_was_deleted_in_an_earlier_session_is_restored_from_the_trash(self):
        self.delete("angle")
        self.session.reopen_console()
        self.mouse.window("library")
        self.mouse.choose_from_menu("More", "Up", "Return")
        self.mouse.click_until("Restore", lambda: "angle" in self.teacher.names(), "it is back")
        self.mouse.click_until("Undo edit", lambda: "angle" not in self.teacher.names(), "it is deleted again")
        self.assertIn("clamp", self.teacher.names())

    def show_own_threshold(self):
        self.mouse.click("library", at=FIRST)
        self.mouse.click_until("Thresholds", lambda: self.mouse.sees("confirm_score"), "it shows them")
        self.mouse.click("one object", at=(8, 8))
        self.report.wait_until_says("'clamp' in this image: reported 1 (now 1)")

    def set_least(self):
        self.mouse.focus_window()
        self.mouse.click("min_score", at=(8, 8))
        self.mouse.press("Home")
        self.report.wait_until_says("0.01 (min_score)")
        self.mouse.click("Apply")
        wait_for(lambda: 0 < self.own_threshold() < 0.02, "it has a threshold of its own")
        self.report.wait_until_says("'clamp' has its own min_score now, 0.01. Undo edit reverts it.")

    def test_4_an_own_threshold_is_previewed_for_its_object_and_undone(self):
        self.teacher.order("put_next", lies=True)
        self.wait_until_found()
        self.show_own_threshold()
        self.set_least()
        self.mouse.click_until("Undo edit", lambda: self.own_threshold() <= 0, "it has none any more")

    def test_5_an_object_gets_the_common_threshold_again(self):
        self.show_own_threshold()
        self.assertFalse(self.mouse.sees("as all"), "it has none of its own")
        self.set_least()
        self.mouse.click("library", at=FIRST)
        self.mouse.click_until("Thresholds", lambda: self.mouse.sees("confirm_score"), "it shows them")
        self.mouse.click("one object", at=(8, 8))
        self.report.wait_until_says("0.01 (min_score)")
        self.mouse.click("as all", at=(8, 8))
        self.report.wait_until_says("0.50 (min_score)")
        self.mouse.click("Apply")
        wait_for(lambda: self.own_threshold() <= 0, "it has none any more")
        self.report.wait_until_says("'clamp' no longer has its own min_score.")

    def test_6_a_replaced_object_is_restored(self):
        taught = self.teacher.revisions()["clamp"]
        self.mouse.write("name", "clamp")
        self.mouse.click_until("Teach", lambda: self.mouse.sees("Replace it"), "it is asked")
        self.teacher.answer("Replace it")
        self.teacher.take_away()
        self.teacher.wait_for_question()
        self.teacher.press("Accept")
        wait_for(lambda: self.teacher.revisions()["clamp"] == taught + 1, "it is replaced")
        self.mouse.click_until("Undo edit", lambda: self.teacher.revisions()["clamp"] == taught + 2, "the old one is back")


class Report(unittest.TextTestResult):
    def addError(self, test, error):
        super().addError(test, error)
        if hasattr(LibraryTest, "session"):
            print(LibraryTest.session.logs(), LibraryTest.report.newest())


unittest.main(testRunner=unittest.TextTestRunner(resultclass=Report, verbosity=2))
