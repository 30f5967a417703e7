# SPDX-License-Identifier: BSD-3-Clause
"""Reads the report of layout_check.cpp, which is loaded into the console, about the console's widgets."""
import json
import os
import pathlib

from console_session import PATIENCE, SessionFailed, wait_for


class LayoutReport:
    def __init__(self, plugin_folder, folder):
        self._path = pathlib.Path(folder) / "layout.json"
        os.environ.update(QT_PLUGIN_PATH=str(plugin_folder), QT_QPA_GENERIC_PLUGINS="layoutcheck",
                          MBNCC_LAYOUT_REPORT=str(self._path))

    def newest(self):
        try:
            return json.loads(self._path.read_text())
        except (OSError, ValueError):
            return {"looks": 0, "focus": "", "texts": [], "complaints": ["nothing was looked at"]}

    def focus(self):
        return self.newest()["focus"]

    def says(self, part):
        return any(part in text for text in self.newest()["texts"])

    def wait_until_says(self, part, patience=PATIENCE):
        wait_for(lambda: self.says(part), "the console says '%s'" % part, patience)

    def wait_until_silent(self, part, patience=PATIENCE):
        wait_for(lambda: not self.says(part), "the console no longer says '%s'" % part, patience)

    def complaints(self, patience=10):  # a layout that has not settled by then never does
        """Complaints of two checks from now on, or of later ones, until there are none or `patience` [s] is over."""
        first = self.newest()["looks"]
        wait_for(lambda: self.newest()["looks"] >= first + 2, "the widgets are looked at")
        try:
            wait_for(lambda: not self.newest()["complaints"], "there is nothing to complain about", patience)
        except SessionFailed:
            pass
        return self.newest()["complaints"]
