# SPDX-License-Identifier: BSD-3-Clause
"""A simulated cell and its console on a separate display.

Shared by the console's test and by scripts/make_console_images; needs Xvfb.
"""
import os
import pathlib
import signal
import socket
import subprocess
import tempfile
import time

PATIENCE = 60  # [s] allowed for each step on a busy machine
GLANCE = 0.1   # [s] between two checks


class SessionFailed(Exception):
    """Ends the session with a message."""


def wait_for(predicate, what, patience=PATIENCE):
    """The first true value of predicate()."""
    deadline = time.monotonic() + patience
    while time.monotonic() < deadline:
        value = predicate()
        if value:
            return value
        time.sleep(GLANCE)
    raise SessionFailed("waited %d s in vain until %s" % (patience, what))


def free_port():
    with socket.socket() as probe:
        probe.bind(("", 0))
        return probe.getsockname()[1]


class Session:
    """Use as a context manager; ends the processes that it started."""

    def __init__(self, size="1280x900", camera=None):
        self._size = size
        self._camera = camera or {}
        self._programs = []
        self._folder = tempfile.TemporaryDirectory()
        self.folder = pathlib.Path(self._folder.name)

    def __enter__(self):
        try:
            self._open_display()
            self._start_ros()
        except BaseException:
            self.__exit__()
            raise
        return self

    def __exit__(self, *_):
        for program in reversed(self._programs):
            end(program)
        self._folder.cleanup()

    def _open_display(self):
        reader, writer = os.pipe()
        # Without -noreset the display resets after its last window and refuses clients meanwhile.
        self.start(["Xvfb", "-displayfd", str(writer), "-screen", "0", self._size + "x24",
                     "+extension", "GLX", "-nolisten", "tcp", "-noreset", "-fbdir", str(self.folder)],
                   pass_fds=[writer])
        os.close(writer)
        with os.fdopen(reader) as numbers:
            number = numbers.readline().strip()
        if not number:
            raise SessionFailed("Xvfb did not start")
        os.environ.update(DISPLAY=":" + number, LIBGL_ALWAYS_SOFTWARE="1", QT_X11_NO_MITSHM="1",
                          MBNCC_CONSOLE_NATIVE="1", XDG_RUNTIME_DIR=str(self.folder))

    def _start_ros(self):
        port = str(free_port())
        os.environ.update(ROS_MASTER_URI="http://localhost:" + port, ROS_HOSTNAME="localhost",
                          ROS_HOME=str(self.folder / "ros"), ROS_LOG_DIR=str(self.folder / "log"))
        self.start(["roscore", "-p", port])
        import rosgraph
        wait_for(rosgraph.is_master_online, "the ROS master answers")
        import rospy
        rospy.init_node("operator", disable_signals=True)
        self.cell = self.start(["roslaunch", "mbncc_vision", "cell.launch", "simulated:=true",
                                "simulated_camera_config:=%s" % self._camera_config(),
                                "library:=%s" % (self.folder / "library"), "platform_distance:=0.6"])
        self.console = self._open_console()

    def _open_console(self):
        return self.start(["roslaunch", "mbncc_vision", "console.launch"])

    def reopen_console(self):
        end(self.console)
        self.console = self._open_console()

    def _camera_config(self):
        """The shipped settings with this session's, the arm moving on request only."""
        import rospkg
        import yaml
        shipped = pathlib.Path(rospkg.RosPack().get_path("mbncc_vision")) / "config/simulated_camera.yaml"
        settings = dict(yaml.safe_load(shipped.read_text()), auto_play=False, **self._camera)
        path = self.folder / "simulated_camera.yaml"
        path.write_text(yaml.safe_dump(settings))
        return path

    def start(self, command, **options):
        log = open(self.folder / (pathlib.Path(command[0]).name + "_%d.log" % len(self._programs)), "w")
        program = subprocess.Popen(command, stdout=log, stderr=subprocess.STDOUT,
                                   start_new_session=True, **options)
        self._programs.append(program)
        return program

    def logs(self):
        """The last lines that every program wrote."""
        return "\n".join("%s:\n%s" % (log.name, "\n".join(log.read_text(errors="replace").splitlines()[-40:]))
                         for log in sorted(self.folder.glob("*.log")))


def end(program):
    """Interrupts the process, because roslaunch stops its nodes only then."""
    if program.poll() is None:
        os.killpg(program.pid, signal.SIGINT)
    try:
        program.wait(15)
    except subprocess.TimeoutExpired:
        os.killpg(program.pid, signal.SIGKILL)
        program.wait()
