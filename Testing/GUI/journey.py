"""A user's way through the window, with a picture of the screen, the clicks and the seconds at each step."""
import os
import shutil

import shapetesting
import window


class Journey(window.Window):
    def __init__(self, name):
        super().__init__()
        self.pictures = os.path.join(shapetesting.BUILD, 'Testing', 'Temporary', 'Journeys', name)
        shutil.rmtree(self.pictures, ignore_errors=True)
        os.makedirs(self.pictures)
        self.report = os.path.join(self.pictures, 'steps.txt')
        self.count = 0
        self.fill_screen()
        self.python('''
            import time
            begin = time.monotonic()''')

    def step(self, name):
        """The user has reached something: writes a picture, the clicks and keys since the last step, and
        the seconds that the window took for them."""
        self.count += 1
        self.wait(300)
        self.python('''
            import subprocess, time
            subprocess.check_call(['import', '-window', 'root', %r])
            with open(%r, 'a') as file:
                print('%%-40s %%3d clicks and keys %%6.1f s' %% (%r, %d, time.monotonic() - begin), file=file)
            begin = time.monotonic()''' % (
            os.path.join(self.pictures, '%02d-%s.png' % (self.count, name.replace(' ', '-'))),
            self.report, name, self.clicks))
        self.clicks = 0

    def run(self, seconds=200):
        printed = super().run(seconds)
        print(open(self.report).read())
        return printed
