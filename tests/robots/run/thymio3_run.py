"""Runs an exported program of a Thymio 3 as it is, in MicroPython on an emulated micro:bit.

    thymio3_run.py BRAIN.py < lines

Lines as thymio3_module.py reads them. Prints the speeds of both motors per line, and once more when the lines end.
With --here, the same in the Python that runs this script; the module `time` is a stand-in then.
"""
import os
import shutil
import sys
import tempfile
import types

import microbit_run

MODULE = os.path.join(os.path.dirname(os.path.abspath(__file__)), "thymio3_module.py")
# The program is compiled before the stand-in is: a micro:bit has little memory.
DRIVER = """
try:
    import brain
except EOFError:
    pass
"""


def run_here(program, lines):
    time = types.ModuleType("time")
    time.ticks_ms = lambda: 0
    time.ticks_diff = lambda a, b: a - b
    time.sleep_ms = lambda ms: None
    sys.modules["time"] = time
    with tempfile.TemporaryDirectory() as folder:
        shutil.copy(MODULE, os.path.join(folder, "thymio.py"))
        shutil.copy(program, os.path.join(folder, "brain.py"))
        with open(os.path.join(folder, "rows"), "w") as rows:
            rows.write(lines)
        sys.path.insert(0, folder)
        os.chdir(folder)
        exec(DRIVER, {})


def write_file(microbit, name, text):
    microbit.execute("f = open(%r, 'w')" % name)
    for at in range(0, len(text), 200):
        microbit.execute("_ = f.write(%r)" % text[at:at + 200])
    microbit.execute("f.close()")


def run_on_microbit(program, lines):
    microbit = microbit_run.Microbit()
    try:
        for name, path in (("thymio.py", MODULE), ("brain.py", program)):
            with open(path) as source:
                write_file(microbit, name, source.read())
        write_file(microbit, "rows", lines)
        sys.stdout.write(microbit.execute(DRIVER))
    finally:
        microbit.process.kill()


if __name__ == "__main__":
    (run_here if "--here" in sys.argv else run_on_microbit)(sys.argv[1], sys.stdin.read())
