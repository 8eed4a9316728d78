# Stands for the module `thymio` of a Thymio 3: readings are lines of the file `rows`, speeds of motors are printed. Valid
# in MicroPython and in Python. A line: 7 proximity sensors, 2 ground sensors, 5 buttons. EOFError ends the program.
rows = open("rows")
row = []


class BUTTONS:
    def get_status(self):
        row[:] = [int(word) for word in rows.readline().split()]
        if not row:
            raise EOFError
        return row[9:]


class PROXIMITY:
    def __init__(self, i):
        self.i = range(7)[i]

    def value(self):
        return row[self.i]


class GROUND:
    def __init__(self, i):
        self.i = 7 + range(2)[i]

    def value(self):
        return row[self.i]


class MOTORS:
    def set_speed(self, left, right):
        for speed in (left, right):
            if type(speed) is not int:  # the robot's own module converts with mp_obj_get_int(), which takes no float
                raise TypeError("speed")
        print(left, right)
