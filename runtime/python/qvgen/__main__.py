# SPDX-License-Identifier: MIT
"""The command qvgen of an installed package: runs the tool that it has."""

import os
import sys

from ._tool import own_tool


def main():
    tool = own_tool()
    if tool is None:
        sys.exit("qvgen: this package was made without the tool: run ./qvgen generate in the source tree before pip install .")
    os.execv(tool, ["qvgen", *sys.argv[1:]])


if __name__ == "__main__":
    main()
