"""Presses the abort button of ParaView's status bar, or Escape, as soon as the button is enabled:

    python3 abortbutton.py button|Escape RESULT

runs beside the window, which does nothing else while a filter runs. RESULT gets the time of the press and
the position of the button on the screen. The button is enabled when its cross is red (Qt draws it grey
otherwise); it is the lowest red thing of the window."""
import statistics
import subprocess
import sys
import time

RED = (0xec, 0x1c, 0x24)
ROWS = 40  # of pixels, from the screen's lower edge


def find():
    """The centre of the cross; None if there is none."""
    picture = subprocess.run(['import', '-window', 'root', '-depth', '8', 'ppm:-'], stdout=subprocess.PIPE,
                             check=True).stdout
    _, size, _, pixels = picture.split(b'\n', 3)
    width, height = map(int, size.split())
    strip = pixels[-3 * width * ROWS:]
    red = [divmod(i, width) for i in range(width * ROWS)
           if all(abs(strip[3 * i + k] - RED[k]) < 8 for k in range(3))]
    if len(red) < 10:
        return None
    return (int(statistics.median(column for _, column in red)),
            height - ROWS + int(statistics.median(row for row, _ in red)))


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
