"""Runs an exported calibrate.py in MicroPython on an emulated micro:bit, and prints the file that it keeps.

    microbit_calibrate.py CALIBRATE.py

Pins, buttons and the display are a stand-in, for the emulated display stops at one row. All eyes read 100 after one
text and 900 after the next; both buttons are always pressed.
"""
import sys

import microbit_run
import thymio3_run

STAND_IN = """
texts = [0]
class Pin:
    def read_analog(self): return 100 if texts[0] % 2 else 900
    def write_analog(self, value): pass
    def write_digital(self, value): pass
    def set_analog_period(self, ms): pass
pin0 = pin1 = pin2 = pin8 = pin12 = pin13 = pin14 = pin15 = pin16 = Pin()
class Button:
    def was_pressed(self): return True
    def is_pressed(self): return True
button_a = button_b = Button()
class Display:
    def scroll(self, text, delay=150): texts[0] += 1
    def show(self, text): pass
    def clear(self): pass
display = Display()
def sleep(ms): pass
def reset(): raise EOFError
"""
DRIVER = """
try:
    import calibrate
except EOFError:
    print(open('calibration.txt').read())
"""


def main():
    with open(sys.argv[1]) as source:
        program = source.read().replace("from microbit import", "from board import")
    microbit = microbit_run.Microbit()
    try:
        thymio3_run.write_file(microbit, "board.py", STAND_IN)
        thymio3_run.write_file(microbit, "calibrate.py", program)
        print(microbit.execute(DRIVER).strip())
    finally:
        microbit.process.kill()


if __name__ == "__main__":
    main()
