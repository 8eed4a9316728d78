"""Runs an exported brain.py in MicroPython on an emulated micro:bit.

    microbit_run.py BRAIN.py < lines

Each line: the readings of the sensors in whole thousandths. Prints per line both commands in millionths.
With --here, the same in the Python that runs this script.
"""
import os
import subprocess
import sys
import time

FIRMWARE = "/usr/share/firmware-microbit-micropython/firmware.hex"
# Prints thousandths in, millionths out. Commands are rounded away from floats, whose printing has few digits.
DRIVER = """
def show(rows):
    for row in rows:
        for c in think(*[x / 1000 for x in row]):
            print(int(c * 1000000 + (0.5 if c > 0 else -0.5)), end=' ')
        print()
"""


CHUNK = 16  # bytes; fewer than the firmware's receive buffer holds


class Microbit:
    """The prompt of MicroPython in paste mode, which echoes what it has read: the next bytes wait for the echo of the last
    ones. Without that, bytes are lost when the computer is busy and the emulator gets many of them at once."""

    def __init__(self):
        command = ["qemu-system-arm", "-M", "microbit", "-display", "none", "-monitor", "none", "-serial", "stdio",
                   "-device", "loader,file=" + FIRMWARE]
        self.process = subprocess.Popen(command, stdin=subprocess.PIPE, stdout=subprocess.PIPE)
        os.set_blocking(self.process.stdout.fileno(), False)
        self.pending = b""
        self.read_until(b">>> ")

    def write(self, data):
        self.process.stdin.write(data)
        self.process.stdin.flush()

    def wait(self, is_there, seconds):
        end = time.time() + seconds
        while not is_there():
            self.pending += self.process.stdout.read() or b""
            if time.time() > end:
                sys.exit("no answer from the micro:bit: %r" % self.pending)
            time.sleep(0.001)

    def read_until(self, mark, seconds=300):
        self.wait(lambda: mark in self.pending, seconds)
        found, self.pending = self.pending.split(mark, 1)
        return found

    def execute(self, code):
        self.write(b"\x05")
        self.read_until(b"=== ")
        code = code.strip().encode()
        for at in range(0, len(code), CHUNK):
            self.write(code[at:at + CHUNK])
            self.read_until(code[at:at + CHUNK])
        self.write(b"\x04")
        self.read_until(b"\r\n")
        out = self.read_until(b">>> ").decode().replace("\r", "")
        if "Traceback" in out or "Error" in out:
            sys.exit(out)
        return out


def main():
    here = "--here" in sys.argv
    with open(sys.argv[1]) as source:
        brain = source.read()
    rows = [tuple(int(x) for x in line.split()) for line in sys.stdin]
    if here:
        names = {}
        exec(brain + DRIVER, names)
        names["show"](rows)
        return
    microbit = Microbit()
    try:
        microbit.execute(brain)
        microbit.execute(DRIVER)
        for at in range(0, len(rows), 10):
            sys.stdout.write(microbit.execute("show(%r)" % (rows[at:at + 10],)))
    finally:
        microbit.process.kill()


if __name__ == "__main__":
    main()
