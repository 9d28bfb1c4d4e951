#!/usr/bin/python3
"""The command shapemap, beside the package that is installed with it."""
import os
import sys

prefix = os.path.dirname(os.path.dirname(os.path.realpath(__file__)))
sys.path.insert(0, os.path.join(prefix, 'lib', 'python3', 'dist-packages'))

from shapemap.__main__ import main

sys.exit(main())
