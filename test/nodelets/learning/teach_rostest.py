#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Tests scripts/teach in the simulated cell, as an operator uses it."""
import argparse
import importlib.machinery
import importlib.util
import os
import signal
import subprocess
import sys
import tempfile
import unittest
import xmlrpc.client

import actionlib
import rosgraph
import rospy
import rostest
from actionlib_msgs.msg import GoalID, GoalStatus, GoalStatusArray
from std_srvs.srv import Trigger

from mbncc_vision.msg import (LearnObjectAction, LearnObjectActionFeedback, LearnObjectActionGoal,
                              LearnObjectActionResult, LearnObjectFeedback, LearnObjectGoal, LearnObjectResult)
from mbncc_vision.srv import ConfirmLearning, ConfirmLearningRequest, ConfirmLearningResponse, ListObjects

TEACH = os.path.join(os.path.dirname(os.path.realpath(__file__)), "..", "..", "..", "scripts", "teach")
PATIENCE = 60  # [s]


def known_names():
    rospy.wait_for_service("list_objects", PATIENCE)
    return [known.name for known in rospy.ServiceProxy("list_objects", ListObjects)().objects]


def order(command):
    """Repeats the command until the arm of the simulated cell accepts it."""
    rospy.wait_for_service("camera/" + command, PATIENCE)
    deadline = rospy.Time.now() + rospy.Duration(PATIENCE)
    while not rospy.ServiceProxy("camera/" + command, Trigger)().success:
        if rospy.Time.now() > deadline:
            raise AssertionError("the arm does not " + command)
        rospy.sleep(0.1)


def kill_learning(namespace):
    uri = rosgraph.Master("/teach_rostest").lookupNode(namespace + "/learning")
    os.kill(xmlrpc.client.ServerProxy(uri).getPid("/teach_rostest")[2], signal.SIGKILL)


class LostResult:
    """A server of the action that ends each goal with `status`; its result does not arrive."""

    def __init__(self, namespace, status, text):
        topic = namespace + "/learn_object/"
        self._ended = GoalStatus(status=status, text=text)
        self._goals = GoalStatusArray()
        self._status = rospy.Publisher(topic + "status", GoalStatusArray, queue_size=1)
        self._topics = [self._status,
                        rospy.Publisher(topic + "feedback", LearnObjectActionFeedback, queue_size=1),
                        rospy.Publisher(topic + "result", LearnObjectActionResult, queue_size=1),
                        rospy.Subscriber(topic + "cancel", GoalID, lambda _: None),
                        rospy.Subscriber(topic + "goal", LearnObjectActionGoal, self._end)]
        self._timer = rospy.Timer(rospy.Duration(0.2), lambda _: self._status.publish(self._goals))

    def _end(self, goal):
        self._ended.goal_id = goal.goal_id
        self._goals = GoalStatusArray(status_list=[self._ended])

    def stop(self):
        self._timer.shutdown()
        self._timer.join()
        for topic in self._topics:
            topic.unregister()


class AskingLesson:
    """A server of the action whose lessons only ask whether to store an object with this error code."""

    def __init__(self, namespace, error_code, refusals=()):
        self.goals, self.requests = [], []
        self._refusals = list(refusals)  # messages of the first answers to ACCEPT
        self._goal = None
        self._draft = rospy.Publisher(namespace + "/learn_object/draft", LearnObjectResult, queue_size=1, latch=True)
        self._draft.publish(LearnObjectResult(error_code=error_code))
        self._service = rospy.Service(namespace + "/confirm_learning", ConfirmLearning, self._confirm)
        self._server = actionlib.ActionServer(namespace + "/learn_object", LearnObjectAction, self._begin,
                                              lambda _: None, auto_start=False)
        self._server.start()
        self._timer = rospy.Timer(rospy.Duration(0.2), self._ask)

    def _begin(self, goal):
        self.goals.append(goal.get_goal())
        goal.set_accepted()
        self._goal = goal

    def _ask(self, _):
        if self._goal:
            self._goal.publish_feedback(LearnObjectFeedback(stage=LearnObjectFeedback.WAIT_CONFIRM))

    def _confirm(self, request):
        self.requests.append(request)
        if request.goal_id != self._goal.get_goal_id().id:
            return ConfirmLearningResponse(success=False, message="another lesson")
        if request.command == ConfirmLearningRequest.ACCEPT and self._refusals:
            return ConfirmLearningResponse(success=False, message=self._refusals.pop(0))
        goal, self._goal = self._goal, None
        if request.command == ConfirmLearningRequest.ACCEPT:
            goal.set_succeeded(LearnObjectResult(message="Learned."))
        else:
            goal.set_aborted(LearnObjectResult(error_code=LearnObjectResult.REJECTED_BY_OPERATOR))
        return ConfirmLearningResponse(success=True)

    def commands(self):
        return [request.command for request in self.requests]


def program():
    """The program as a module."""
    loader = importlib.machinery.SourceFileLoader("teach", TEACH)
    module = importlib.util.module_from_spec(importlib.util.spec_from_loader(loader.name, loader))
    sys.dont_write_bytecode = True
    loader.exec_module(module)
    return module


class Teach(unittest.TestCase):
    def start(self, *arguments, namespace="/"):
        return subprocess.Popen([sys.executable, TEACH] + list(arguments), stdin=subprocess.PIPE,
                                stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                                universal_newlines=True, env=dict(os.environ, ROS_NAMESPACE=namespace))

    def lesson(self, answer, *arguments):
        """Takes the object away when the program asks for it; returns its exit code and output."""
        program = self.start(*arguments)
        said = ""
        for line in program.stdout:
            said += line
            if "ake the object away" in line:
                break
        order("take_away")
        rest, _ = program.communicate(answer)
        order("put_next")
        return program.returncode, said + rest

    def test_an_accepted_lesson_is_stored_and_a_rejected_one_is_not(self):
        with tempfile.TemporaryDirectory() as folder:
            preview = os.path.join(folder, "outline.png")
            code, said = self.lesson("y\n", "agreed", "--preview", preview, "--symmetry", "round")
            self.assertEqual(code, 0, said)
            self.assertGreater(os.path.getsize(preview), 0)
        code, said = self.lesson("perhaps\nn\n", "declined")
        self.assertEqual(code, 1, said)
        self.assertIn("y/n", said)
        code, said = self.lesson("", "unanswered")
        self.assertEqual(code, 1, said)
        self.assertTrue(said.endswith("Nothing was stored, because nobody answered on the standard input; "
                                      "--yes stores without asking.\n"), said)
        self.assertEqual(known_names(), ["agreed"])
        self.assertEqual(rospy.ServiceProxy("list_objects", ListObjects)().objects[0].symmetry,
                         LearnObjectGoal.SYMMETRY_ROUND)
        again, _ = self.start("agreed").communicate()
        self.assertIn("(--overwrite), add a view to it (--add-view)", again)  # the remedy names this program's options

    def lost_lesson(self, namespace):
        """Kills the nodelet during a lesson; returns what the program then prints."""
        rospy.wait_for_service(namespace + "/list_objects", PATIENCE)
        program = self.start("lost", namespace=namespace)
        program.stdout.readline()
        kill_learning(namespace)
        said, _ = program.communicate()
        self.assertEqual(program.returncode, 1, said)
        self.assertNotIn("Traceback", said)
        return said

    def test_a_server_that_dies_is_detected(self):
        self.assertIn("the learning nodelet has stopped", self.lost_lesson("/doomed"))

    def test_a_restarted_server_has_lost_the_lesson(self):
        self.assertIn("teach again", self.lost_lesson("/reborn"))

    def without_result(self, status, text):
        """Exit code and output of a lesson whose result is lost."""
        server = LostResult("/mute", status, text)
        self.addCleanup(server.stop)
        program = self.start("part", namespace="/mute")
        self.addCleanup(program.kill)
        said, _ = program.communicate(timeout=PATIENCE)
        return program.returncode, said

    def test_a_lost_refusal_is_told_by_the_status_of_the_goal(self):
        code, said = self.without_result(GoalStatus.REJECTED, "Set overwrite.")
        self.assertEqual(code, 1, said)
        self.assertIn("error: Set --overwrite.", said)

    def test_a_lost_verdict_is_no_failure(self):
        code, said = self.without_result(GoalStatus.SUCCEEDED, "")
        self.assertEqual(code, 0, said)
        self.assertIn("Stored", said)

    def answered(self, answers, namespace, error_code, *arguments, refusals=()):
        """Exit code, output and server of a lesson that only asks; these are the operator's answers."""
        server = AskingLesson(namespace, error_code, refusals)
        program = self.start("part", *arguments, namespace=namespace)
        self.addCleanup(program.kill)
        said, _ = program.communicate(answers, timeout=PATIENCE)
        return program.returncode, said, server

    def test_a_bad_object_is_stored_only_if_the_operator_confirms_it(self):
        code, said, server = self.answered("y\nn\n", "/declined", LearnObjectResult.QUALITY_BAD)
        self.assertEqual((code, server.commands()), (1, [ConfirmLearningRequest.REJECT]), said)
        self.assertIn("The verdict is BAD", said)
        code, said, server = self.answered("y\ny\n", "/insisted", LearnObjectResult.QUALITY_BAD)
        self.assertEqual((code, server.commands()), (0, [ConfirmLearningRequest.ACCEPT]), said)
        self.assertTrue(server.goals[0].allow_bad)
        code, said, server = self.answered("y\n", "/allowed", LearnObjectResult.QUALITY_BAD, "--allow-bad")
        self.assertEqual((code, server.commands()), (0, [ConfirmLearningRequest.ACCEPT]), said)

    def test_a_refused_answer_keeps_the_lesson(self):
        code, said, server = self.answered("y\ny\n", "/full_disk", LearnObjectResult.SUCCESS,
                                           refusals=["Not stored: no space left."])
        self.assertEqual((code, server.commands()), (0, [ConfirmLearningRequest.ACCEPT] * 2), said)
        self.assertIn("Not stored: no space left.", said)

    def test_a_preview_that_does_not_arrive_does_not_end_the_lesson(self):
        with tempfile.TemporaryDirectory() as folder:
            code, said, _ = self.answered("y\n", "/blind", LearnObjectResult.SUCCESS, "--preview",
                                          os.path.join(folder, "outline.png"))
        self.assertEqual(code, 0, said)
        self.assertIn("The outline was not written", said)

    def test_a_preview_that_cannot_be_written_is_refused_before_the_lesson(self):
        server = AskingLesson("/unwritable", LearnObjectResult.SUCCESS)
        for path in ("/no/such/folder/outline.png", "/tmp/outline.unknown"):
            program = self.start("part", "--preview", path, namespace="/unwritable")
            said, _ = program.communicate(timeout=PATIENCE)
            self.assertEqual(program.returncode, 1, said)
            self.assertIn("cannot write " + path, said)
        self.assertEqual(server.goals, [])

    def test_a_lesson_that_ended_while_the_operator_was_asked_gets_no_answer(self):
        module = program()
        teacher = module.Teacher(argparse.Namespace(preview=None, allow_bad=False))
        sent = []
        teacher._send = sent.append

        def answer(_):
            teacher._end()
            return False
        module.answer_to = answer
        teacher._confirm()
        self.assertEqual(sent, [])

    def test_a_bad_name_ends_at_once_with_a_reason(self):
        known_names()
        program = self.start("7up")
        said, _ = program.communicate()
        self.assertEqual(program.returncode, 1)
        self.assertIn("letter", said)

    def test_a_symmetry_that_does_not_exist_is_wrong_usage(self):
        program = self.start("part", "--symmetry", "13")
        said, _ = program.communicate()
        self.assertEqual(program.returncode, 2)
        self.assertIn("round", said)

    def test_without_a_name_the_usage_is_shown(self):
        program = self.start()
        said, _ = program.communicate()
        self.assertEqual(program.returncode, 2)
        self.assertIn("usage", said)


if __name__ == "__main__":
    rospy.init_node("teach_rostest")
    rostest.rosrun("mbncc_vision", "teach", Teach)
