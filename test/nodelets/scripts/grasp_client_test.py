#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Tests which objects the example consumer accepts and refuses.

usage: grasp_client_test.py PATH/TO/grasp_client.py FOLDER/OF/PYTHON/MESSAGES
"""
import importlib.util
import sys
import unittest

sys.path.insert(0, sys.argv.pop(2))

import genpy  # noqa: E402

from mbncc_vision.msg import DetectedObject, DetectedObjectArray  # noqa: E402

spec = importlib.util.spec_from_file_location("grasp_client", sys.argv.pop(1))
grasp_client = importlib.util.module_from_spec(spec)
spec.loader.exec_module(grasp_client)

NOW = genpy.Time(100)


def confirmed(**changes):
    found = DetectedObject(name="part", instance_id=1, state=DetectedObject.CONFIRMED, pose_valid=True,
                           valid_until=genpy.Time(100, 400000000))
    for key, value in changes.items():
        setattr(found, key, value)
    return found


def choice(objects, name="", status=DetectedObjectArray.OK, now=NOW):
    return grasp_client.choose(DetectedObjectArray(objects=objects, status=status), name, now)


class GraspClientTest(unittest.TestCase):
    def test_takes_a_confirmed_valid_object(self):
        self.assertEqual(choice([confirmed()])[0].instance_id, 1)
        self.assertEqual(choice([confirmed()], name="part")[0].instance_id, 1)

    def test_refuses_with_a_reason(self):
        for found in (confirmed(state=DetectedObject.NEW), confirmed(state=DetectedObject.AMBIGUOUS),
                      confirmed(state=DetectedObject.HELD), confirmed(pose_valid=False),
                      confirmed(valid_until=genpy.Time(99))):
            chosen, reasons = choice([found])
            self.assertIsNone(chosen)
            self.assertEqual(len(reasons), 1)

    def test_refuses_arrays_whose_status_forbids_motion(self):
        for status in (DetectedObjectArray.STALE, DetectedObjectArray.UNCALIBRATED,
                       DetectedObjectArray.TF_UNAVAILABLE, DetectedObjectArray.LIBRARY_EMPTY,
                       DetectedObjectArray.SEARCH_FAILED, 255):
            self.assertIsNone(choice([confirmed()], status=status)[0])

    def test_ignores_other_objects_and_empty_arrays(self):
        self.assertIsNone(choice([confirmed()], name="other")[0])
        self.assertIsNone(choice([])[0])
        self.assertEqual(choice([confirmed(state=DetectedObject.NEW), confirmed(instance_id=2)])[0]
                         .instance_id, 2)

    def test_an_ambiguous_object_of_another_name_is_reported(self):
        self.assertEqual(choice([confirmed()], name="other")[1], ["no other in view"])
        self.assertEqual(choice([confirmed(state=DetectedObject.AMBIGUOUS)], name="other")[1],
                         ["no other in view; ambiguous, may be it: part #1"])

    def test_a_mistyped_name_is_reported_with_the_known_names(self):
        self.assertIn("it has part, plate", grasp_client.unknown("prat", {"plate": 1, "part": 1})[0])
        self.assertEqual(grasp_client.unknown("part", {"part": 1}), [])
        self.assertEqual(grasp_client.unknown("", {"part": 1}), [])
        self.assertEqual(grasp_client.unknown("part", {}), [])

    def test_names_the_grasp_frame_if_there_is_one(self):
        header = DetectedObjectArray().header
        sent = confirmed(child_frame_id="object_part_0")
        self.assertIn("grasp frame object_part_0_grasp", grasp_client.describe(sent, header, grasp=True, now=NOW))
        self.assertNotIn("grasp frame", grasp_client.describe(sent, header, grasp=False, now=NOW))
        self.assertNotIn("grasp frame", grasp_client.describe(confirmed(), header, grasp=True, now=NOW))


unittest.main()
