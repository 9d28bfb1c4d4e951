"""Presses the abort button of ParaView's status bar, or Escape, as soon as the button is enabled:

    python3 abortbutton.py button|Escape RESULT

runs beside the window, which does nothing else while a filter runs. RESULT gets the time of the press and
the position of the button on the screen. The button is enabled when its cross is red (Qt draws it grey
otherwise); it is the lowest red thing of the window."""
import subprocess
import sys
import time

import numpy

RED = (0xec, 0x1c, 0x24)


def find():
    """The centre of the cross; nothing if there is no red of its colour near the screen's lower edge."""
    picture = subprocess.run(['import', '-window', 'root', 'ppm:-'], stdout=subprocess.PIPE, check=True).stdout
    _, size, _, pixels = picture.split(b'\n', 3)
    width, height = map(int, size.split())
    image = numpy.frombuffer(pixels, numpy.uint8).reshape(height, width, 3)[-40:].astype(int)
    rows, columns = numpy.nonzero((abs(image - RED) < 8).all(axis=2))
    if len(rows) < 10:
        return None
    return int(numpy.median(columns)), height - 40 + int(numpy.median(rows))


def press(what, place):
    if what == 'button':
        subprocess.check_call(['xdotool', 'mousemove', *map(str, place)])
        actions = 'mousedown', 'mouseup'
        what = '1'
    else:
        window = subprocess.check_output(
            ['xdotool', 'search', '--onlyvisible', '--name', 'ParaView'], text=True).split()[0]
        subprocess.check_call(['xdotool', 'windowfocus', window])
        actions = 'keydown', 'keyup'
    now = time.time()
    for action in actions:
        subprocess.check_call(['xdotool', action, what])
        time.sleep(0.1)
    return now


def main():
    what, result = sys.argv[1:]
    place = None
    while place is None:
        time.sleep(0.1)
        place = find()
    time.sleep(2.0)  # the filter has done something
    now = press(what, place)
    with open(result, 'w') as file:
        file.write('%r %d %d' % (now, *place))


if __name__ == '__main__':
    main()
