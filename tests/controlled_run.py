# SPDX-License-Identifier: LGPL-2.1-or-later
"""Controllers for tests, which serve in a thread of the test while a run goes on."""
import contextlib
import pathlib
import shutil
import sys
import tempfile
import threading

from lumbricus_run import SOURCE

sys.path.insert(0, str(SOURCE / "python" / "src"))
from lumbricus.controller import Controller as Controller  # noqa: E402


def controlled(muscles, address, quantity="Active stretch"):
    """The settings that give these muscles to the controller at an address."""
    return [setting for muscle in muscles for setting in (
        f"Muscles/{muscle}/{quantity}=server",
        f"Muscles/{muscle}/server/Address={address}")]


@contextlib.contextmanager
def serving(controller, name=None):
    """The address at which a controller serves one run, in this file if it is
    given. Else its path is short."""
    folder = pathlib.Path(tempfile.mkdtemp())
    address = name or folder / "s"
    thread = threading.Thread(target=controller.serve, args=(address,),
                              daemon=True)
    thread.start()
    while not address.exists():
        assert thread.is_alive()
        thread.join(0.01)
    yield address
    thread.join(30)
    assert not thread.is_alive()
    shutil.rmtree(folder)
