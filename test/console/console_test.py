#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Clicks through lessons in the simulated cell: taught, found, rejected, corrected, deleted and brought back.

usage: console_test.py SCRIPTS_FOLDER
"""
import math
import subprocess
import sys
import unittest

sys.path.insert(0, sys.argv.pop(1))
from console_operator import Teacher  # noqa: E402
from console_session import PATIENCE, Session, wait_for  # noqa: E402

CAMERA = {"width": 400, "height": 300, "object_diameter": 70.0, "neighbours": 1, "leg_time": 0.5}
PLACE = 5  # [px] largest distance between the learned and the true reference point


class ConsoleTest(unittest.TestCase):
    """All tests share one session, because starting RViz takes longer than teaching."""

    @classmethod
    def setUpClass(cls):
        cls.session = Session(camera=CAMERA)
        cls.session.__enter__()
        cls.addClassCleanup(cls.session.__exit__)
        cls.teacher = Teacher()

    def setUp(self):
        if not self.lies():
            self.teacher.order("put_next", lies=True)

    def lies(self):
        return bool(self.teacher.truth.get().objects)

    def teach(self, name):
        self.teacher.begin(name)
        self.teacher.take_away()
        return self.teacher.wait_for_question()

    def test_1_three_actions_teach_an_object_that_is_then_found(self):
        from mbncc_vision.msg import LearnObjectResult
        self.teacher.mouse.actions = 0
        self.teach("bracket")
        result = self.teacher.press("Accept")
        self.assertEqual(result.error_code, LearnObjectResult.SUCCESS, result.message)
        # The fourth action was typing the name.
        self.assertEqual(self.teacher.mouse.actions, 4)
        self.teacher.order("put_next", lies=True)
        self.teacher.found.wait(self.is_at_its_true_place, "the object is found")

    def is_at_its_true_place(self, detections):
        # Whether it is also confirmed depends on the load of the machine, because old images confirm nothing.
        true = self.teacher.truth.get().objects
        return bool(true) and any(
            o.name == "bracket" and math.hypot(o.image_pose.x - true[0].image_pose.x,
                                               o.image_pose.y - true[0].image_pose.y) < PLACE
            for o in detections.objects)

    def test_1_the_images_are_those_that_the_cell_searches(self):
        import rosgraph
        import rospy

        def listeners(topic):
            return dict(rosgraph.Master("/test").getSystemState()[1]).get(topic, [])
        searched = rospy.get_param("/searched_image")
        rospy.set_param("/searched_image", "top_view/image_rect")
        wait_for(lambda: listeners("/top_view/image_rect"), "the console follows")
        rospy.set_param("/searched_image", searched)
        wait_for(lambda: not listeners("/top_view/image_rect"), "the console returns")

    def test_2_a_rejected_lesson_stores_nothing(self):
        from mbncc_vision.msg import LearnObjectResult
        known = self.teacher.names()
        self.teach("unwanted")
        result = self.teacher.press("Reject")
        self.assertEqual(result.error_code, LearnObjectResult.REJECTED_BY_OPERATOR)
        self.assertEqual(self.teacher.names(), known)

    def test_3_a_stroke_corrects_the_outline_and_undo_takes_it_back(self):
        first = self.teach("corrected")
        reference = first.object.reference
        image = (first.preview.width, first.preview.height)
        self.teacher.mouse.click("Cut")
        stroke = [(reference.x - 12 + 2 * i, reference.y - 30 + 5 * i) for i in range(13)]
        cut = self.teacher.correct(lambda: self.teacher.mouse.drag(stroke, image))
        self.assertLess(cut.object.quality.area, first.object.quality.area - 50)
        back = self.teacher.correct(lambda: self.teacher.mouse.click("Undo mark"))
        self.assertEqual(back.map.data, first.map.data)
        self.teacher.press("Reject")

    def test_3b_a_double_click_draws_nothing_and_escape_deselects_the_tool(self):
        first = self.teach("untouched")
        reference = first.object.reference
        image = (first.preview.width, first.preview.height)
        self.assertTrue(self.teacher.feedback.get().feedback.remaining.is_zero(), "a review has no deadline")
        self.teacher.mouse.click("Cut")
        self.teacher.mouse.click("image")
        self.teacher.mouse.click("image")
        drafts = self.teacher.draft.count()
        self.teacher.mouse.press("Escape")
        stroke = [(reference.x - 12 + 2 * i, reference.y - 30 + 5 * i) for i in range(13)]
        self.teacher.mouse.drag(stroke, image)
        self.teacher.mouse.press("c")  # the tool's key
        cut = self.teacher.correct(lambda: self.teacher.mouse.drag(stroke, image))
        self.assertEqual(self.teacher.draft.count(), drafts + 1, "nothing but the last stroke")
        self.assertLess(cut.object.quality.area, first.object.quality.area - 50)
        self.teacher.mouse.press("space")
        self.teacher.press("Reject")
        self.assertNotIn("untouched", self.teacher.names(), "Space stores nothing")

    def test_3c_strokes_drawn_while_one_is_computed_are_all_carried_out(self):
        first = self.teach("hurried")
        reference = first.object.reference
        image = (first.preview.width, first.preview.height)
        self.teacher.mouse.click("Cut")
        count = self.teacher.draft.count()
        for shift in (-14, 0, 14):
            self.teacher.mouse.drag([(reference.x + shift, reference.y - 20 + 10 * i) for i in range(5)], image)
        wait_for(lambda: self.teacher.draft.count() >= count + 3, "three corrections are carried out")
        self.teacher.press("Reject")

    def test_3d_a_taken_name_asks_what_to_do(self):
        from mbncc_vision.msg import LearnObjectResult
        self.teacher.mouse.write("name", "bracket")
        self.teacher.mouse.click_until("Teach", lambda: self.teacher.mouse.sees("Replace it"), "it is asked")
        revisions = self.teacher.revisions()
        self.teacher.answer("Replace it")
        self.teacher.take_away()
        self.teacher.wait_for_question()
        result = self.teacher.press("Accept")
        self.assertEqual(result.error_code, LearnObjectResult.SUCCESS, result.message)
        wait_for(lambda: self.teacher.revisions()["bracket"] > revisions["bracket"], "it is replaced")

    def test_3e_explains_a_detection_and_saves_it(self):
        truth = self.teacher.truth.get().objects[0].image_pose
        self.teacher.mouse.click_until("Why not found here\\?", lambda: True, "it asks for the place")
        self.teacher.mouse.drag([(truth.x, truth.y)], (CAMERA["width"], CAMERA["height"]))
        self.teacher.mouse.window("Back to live")
        misses = self.session.folder / "library" / ".misses"
        self.teacher.mouse.click_until("Save this miss", lambda: any(misses.glob("*.miss")), "it is saved")
        self.teacher.mouse.press("Escape")
        wait_for(lambda: not self.teacher.mouse.sees("Back to live"), "the live image is back")

    def test_3f_other_thresholds_are_tried_and_applied(self):
        import rospy
        self.teacher.mouse.click_until("Thresholds", lambda: self.teacher.mouse.sees("confirm_score"), "it shows them")
        self.teacher.mouse.click("min_score", at=(60, 8))
        self.teacher.mouse.click_until("Apply", lambda: rospy.get_param("/matching/min_score", 0.5) < 0.5,
                                       "the matcher has it")

    def test_4_delete_and_undo(self):
        self.assertIn("bracket", self.teacher.names())
        self.teacher.mouse.click("library", at=(40, 40))
        self.teacher.mouse.click_until("Delete", lambda: "bracket" not in self.teacher.names(), "it is deleted")
        self.teacher.mouse.click_until("Undo edit", lambda: "bracket" in self.teacher.names(), "it is back")

    def test_5_a_console_opened_during_a_review_takes_the_decision(self):
        from mbncc_vision.msg import LearnObjectResult
        self.teach("handed_over")
        self.session.reopen_console()
        result = self.teacher.press("Accept")
        self.assertEqual(result.error_code, LearnObjectResult.SUCCESS, result.message)
        wait_for(lambda: "handed_over" in self.teacher.names(), "it is known")

    def test_6_continues_after_the_nodelets_were_away(self):
        subprocess.run(["rosnode", "kill", "/mbncc_manager"], stdout=subprocess.DEVNULL, check=True)
        silent = self.teacher.feedback.count()
        # roslaunch restarts the nodelets; the button is enabled once the console has heard from them.
        self.teacher.mouse.click_until("Teach", lambda: self.teacher.feedback.count() > silent,
                                       "a lesson begins", patience=2 * PATIENCE)
        self.assertIsNone(self.session.console.poll())
        count = self.teacher.result.count()
        self.teacher.mouse.click_until("Cancel", lambda: self.teacher.result.count() > count, "it is cancelled")


class Report(unittest.TextTestResult):
    def addFailure(self, test, error):
        super().addFailure(test, error)
        print(ConsoleTest.session.logs())

    def addError(self, test, error):
        super().addError(test, error)
        if hasattr(ConsoleTest, "session"):
            print(ConsoleTest.session.logs())


unittest.main(testRunner=unittest.TextTestRunner(resultclass=Report, verbosity=2))
