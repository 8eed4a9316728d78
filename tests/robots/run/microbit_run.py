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


class Microbit:
    def __init__(self):
        command = ["qemu-system-arm", "-M", "microbit", "-display", "none", "-monitor", "none", "-serial", "stdio",
                   "-device", "loader,file=" + FIRMWARE]
        self.process = subprocess.Popen(command, stdin=subprocess.PIPE, stdout=subprocess.PIPE)
        os.set_blocking(self.process.stdout.fileno(), False)
        self.pending = b""
        self.read_until(b">>> ")
        self.write(b"\x01")  # raw mode
        self.read_until(b"raw REPL; CTRL-B to exit\r\n>")

    def write(self, data):
        for at in range(0, len(data), 32):  # the receive buffer is small
            self.process.stdin.write(data[at:at + 32])
            self.process.stdin.flush()
            time.sleep(0.003)

    def read_until(self, mark, seconds=60):
        end = time.time() + seconds
        while mark not in self.pending:
            self.pending += self.process.stdout.read() or b""
            if time.time() > end:
                sys.exit("no answer from the micro:bit: %r" % self.pending)
            time.sleep(0.002)
        found, self.pending = self.pending.split(mark, 1)
        return found

    def execute(self, code):
        self.write(code.encode() + b"\x04")
        self.read_until(b"OK")
        out = self.read_until(b"\x04")
        error = self.read_until(b"\x04>")
        if error:
            sys.exit(error.decode())
        return out.decode().replace("\r", "")


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


main()
