# SPDX-License-Identifier: BSD-3-Clause
"""Operates the console with xdotool as fast as the lesson allows."""
import subprocess
import threading
import time

from console_session import GLANCE, PATIENCE, SessionFailed, wait_for


def xdotool(*arguments):
    done = subprocess.run(["xdotool", *map(str, arguments)], stdout=subprocess.PIPE,
                          stderr=subprocess.DEVNULL, text=True)
    return done.stdout.split() if done.returncode == 0 else []


class Mouse:
    """Finds the console's parts by the names that MBNCC_CONSOLE_NATIVE gives their windows."""

    def __init__(self):
        self.actions = 0

    @staticmethod
    def window(name):
        """The window of a part that accepts clicks."""
        found = wait_for(lambda: xdotool("search", "--onlyvisible", "--name", "^mbncc:%s$" % name),
                         "the console shows '%s', enabled" % name)
        return found[-1]

    @staticmethod
    def place(window):
        """Position on the display and size [px]; None without such a window."""
        words = xdotool("getwindowgeometry", "--shell", window)
        values = dict(word.split("=") for word in words if "=" in word)
        names = ("X", "Y", "WIDTH", "HEIGHT")
        return tuple(int(values[name]) for name in names) if set(names) <= set(values) else None

    def resting_window(self, name):
        """The window and the size of a part that accepts clicks, once the layout no longer moves it."""
        before = None

        def look():
            nonlocal before
            window = self.window(name)
            earlier, before = before, (window, self.place(window))
            return before if before[1] and before == earlier else None
        window, place = wait_for(look, "the console leaves '%s' in its place" % name)
        return window, place[2:]

    def click(self, name, at=None, button=1):
        window, (width, height) = self.resting_window(name)
        x, y = at or (width // 2, height // 2)
        xdotool("mousemove", "--window", window, x, y, "click", button)
        self.actions += 1

    def press(self, key):
        """Presses a key in the focused part."""
        xdotool("key", key)
        self.actions += 1

    def type(self, text):
        """Replaces the text of the focused field."""
        xdotool("key", "ctrl+a")
        xdotool("type", "--delay", "20", text)
        self.actions += 1

    def choose_from_menu(self, name, *keys):
        """Opens a menu and presses keys in it, which reach it only once it is shown."""
        self.open_menu(name)
        for key in keys:
            self.press(key)

    def open_menu(self, name):
        # A further click on a slow console closes the menu again, so it has to stay.
        self.click_until(name, lambda: self.stays("menu of " + name), "its menu is shown")

    def stays(self, name):
        """Whether the console shows a part now and at the next look as well."""
        if not self.sees(name):
            return False
        time.sleep(GLANCE)
        return self.sees(name)

    @staticmethod
    def sees(name):
        """Whether the console shows a part of that name now."""
        return bool(xdotool("search", "--onlyvisible", "--name", r"^mbncc:%s( \(disabled\))?$" % name))

    def click_until(self, name, predicate, what, patience=PATIENCE):
        """Clicks again if the console was not ready for the click; counts as one action."""
        before, value = self.actions, None
        deadline = time.monotonic() + patience
        while not value and time.monotonic() < deadline:
            self.click(name)
            try:
                value = wait_for(predicate, what, 3)
            except SessionFailed:
                pass
        self.actions = before + 1
        if not value:
            raise SessionFailed("clicked '%s' in vain until %s" % (name, what))
        return value

    @staticmethod
    def focus_window():
        """Gives the console the keyboard focus, as a window manager does."""
        top = xdotool("search", "--onlyvisible", "--name", "RViz|mbncc console")
        if top:
            xdotool("windowfocus", "--sync", top[0])

    def write(self, name, text):
        """Replaces the text of a field."""
        self.click(name)
        self.focus_window()
        self.click(name)
        xdotool("key", "ctrl+a")
        xdotool("type", "--delay", "20", text)
        self.actions -= 1

    def drag(self, points, image):
        """A stroke over `points` [px] of an image of size `image` in the image view."""
        window, (width, height) = self.resting_window("image")
        scale = min(width / image[0], height / image[1])
        left, top = (width - scale * image[0]) / 2, (height - scale * image[1]) / 2
        spots = [(round(left + scale * (x + 0.5)), round(top + scale * (y + 0.5))) for x, y in points]
        xdotool("mousemove", "--window", window, *spots[0], "mousedown", 1)
        for spot in spots[1:]:
            xdotool("mousemove", "--window", window, *spot)
            time.sleep(0.02)
        xdotool("mouseup", 1)
        self.actions += 1


class Newest:
    """Keeps the last message of a topic."""

    def __init__(self, topic, kind):
        import rospy
        self._lock = threading.Lock()
        self._message, self._count, self._at = None, 0, time.monotonic()
        rospy.Subscriber(topic, kind, self._take, queue_size=10)

    def _take(self, message):
        with self._lock:
            self._message, self._count, self._at = message, self._count + 1, time.monotonic()

    def get(self):
        with self._lock:
            return self._message

    def count(self):
        with self._lock:
            return self._count

    def silent_for(self):
        """[s] since the last message."""
        with self._lock:
            return time.monotonic() - self._at

    def wait(self, fits, what, patience=PATIENCE):
        return wait_for(lambda: self.get() if self.get() is not None and fits(self.get()) else None, what,
                        patience)


class Teacher:
    """An ideal operator: does at once what the lesson asks, by mouse and arm."""

    def __init__(self):
        import rospy
        from mbncc_vision.msg import (DetectedObjectArray, LearnObjectActionFeedback, LearnObjectActionResult,
                                      LearnObjectResult, LearnedObjectArray)
        from std_srvs.srv import Trigger
        self.mouse = Mouse()
        self.feedback = Newest("/learn_object/feedback", LearnObjectActionFeedback)
        self.result = Newest("/learn_object/result", LearnObjectActionResult)
        self.draft = Newest("/learn_object/draft", LearnObjectResult)
        self.library = Newest("/object_library", LearnedObjectArray)
        self.found = Newest("/detected_objects", DetectedObjectArray)
        self.truth = Newest("/camera/truth", DetectedObjectArray)
        self._arm = {name: rospy.ServiceProxy("/camera/" + name, Trigger) for name in ("take_away", "put_next")}
        for arm in self._arm.values():
            arm.wait_for_service(PATIENCE)
        self._drafts = 0
        # The console itself, not only this program, must be connected to the server.
        self.mouse.window("Teach")
        self.truth.wait(lambda m: bool(m.objects), "the simulated camera works")

    def stage(self):
        feedback = self.feedback.get()
        return feedback.feedback.stage if feedback else None

    def wait_for_stage(self, *stages):
        wait_for(lambda: self.stage() in stages, "the lesson reaches a stage of %s" % (stages,))

    def order(self, name, lies, halfway=lambda: None):
        """Moves the arm and waits until it has left the image."""
        wait_for(lambda: self._arm[name]().success, "the arm obeys")
        self.truth.wait(lambda m: m.message == "carry", "the arm has the object")
        halfway()
        self.truth.wait(lambda m: m.message == "rest" and bool(m.objects) == lies, "the arm has gone")

    def begin(self, name=""):
        if name:
            self.mouse.write("name", name)
        self._drafts = self.draft.count()
        count = self.feedback.count()
        self.mouse.click_until("Teach", lambda: self.feedback.count() > count, "a lesson begins")

    def answer(self, name):
        """Clicks an answer that begins a lesson."""
        self._drafts = self.draft.count()
        count = self.feedback.count()
        self.mouse.click(name)
        wait_for(lambda: self.feedback.count() > count, "a lesson begins")

    def take_away(self):
        from mbncc_vision.msg import LearnObjectFeedback
        self.wait_for_stage(LearnObjectFeedback.WAIT_REMOVAL)
        self.order("take_away", lies=False)
        self.mouse.actions += 1

    def wait_for_question(self):
        from mbncc_vision.msg import LearnObjectFeedback
        self.wait_for_stage(LearnObjectFeedback.WAIT_CONFIRM)
        # Stage and draft are messages of different topics.
        wait_for(lambda: self.draft.count() > self._drafts, "the lesson shows its draft")
        self.mouse.window("Reject")
        return self.draft.get()

    def press(self, name):
        """Accept or Reject; the result of the lesson."""
        count = self.result.count()
        self.mouse.click_until(name, lambda: self.result.count() > count, "the lesson ends")
        return self.result.get().result

    def correct(self, act):
        """Carries out a correction and returns the new draft."""
        count = self.draft.count()
        act()
        wait_for(lambda: self.draft.count() > count, "the lesson has taken the correction")
        return self.draft.get()

    def revisions(self):
        library = self.library.get()
        return {known.name: known.revision for known in library.objects} if library else {}

    def names(self):
        library = self.library.get()
        return {known.name: known.enabled for known in library.objects} if library else {}
