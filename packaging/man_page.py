#!/usr/bin/env python3
"""Writes a man page from what a program prints for --help: man_page.py PROGRAM VERSION [SUBCOMMAND...] > NAME.1"""

import os
import re
import subprocess
import sys


def roff(text):
    """Text in which roff finds no request: escaped backslashes, hyphens, and a leading dot or quote."""
    text = text.replace("\\", "\\\\").replace("-", "\\-")
    return "\\&" + text if text.startswith((".", "'")) else text


def help_of(program, *arguments):
    return subprocess.run([program, *arguments, "--help"], check=True, capture_output=True, text=True).stdout


def options(lines):
    """The entries of a help text's lists: (option, explanation), and (heading, None) before each list."""
    entries = []
    for line in lines:
        heading = re.fullmatch(r"(\w+):", line)
        entry = re.match(r"  (\S.*?)(?:\s{2,}(.*))?$", line)
        if heading:
            entries.append((heading[1], None))
        elif entry and line[2] != " ":
            entries.append((entry[1], entry[2] or ""))
        elif line.strip() and entries and entries[-1][1] is not None:
            entries[-1] = (entries[-1][0], (entries[-1][1] + " " + line.strip()).strip())
    return entries


def print_options(text):
    for name, explanation in options(text.splitlines()):
        if explanation is None:
            continue
        print(f".TP\n\\fB{roff(name)}\\fR\n{roff(explanation) or '.br'}")


def main(program, version, *subcommands):
    name = os.path.basename(program)
    text = help_of(program)
    summary = "a lab for Braitenberg vehicles" + (" without a window" if subcommands else "")
    print(f'.TH {name.upper()} 1 "" "Braitenlab {version}" "User Commands"')
    print(f".SH NAME\n{name} \\- {summary}")
    usage = "\\fICOMMAND\\fR [\\fIOPTION\\fR]..." if subcommands else "[\\fIOPTION\\fR]... [\\fIFILE\\fR]"
    print(f".SH SYNOPSIS\n.B {name}\n{usage}")
    print(".SH DESCRIPTION\nSmall wheeled robots in which a few wires between two eyes and two motors look like fear,")
    print("aggression or love. Scenes, exercises, lectures and brains are TOML files.")
    if not subcommands:
        print(".SH OPTIONS")
        print_options(text)
    for subcommand in subcommands:
        own = help_of(program, subcommand)
        print(f".SH {subcommand.upper()}\n{roff(own.splitlines()[0])}")
        print_options(own)
    if subcommands:
        print('.SH EXIT STATUS\n0 done or passed, 1 failed, 2 bad input, 130 interrupted.')
    print(".SH ENVIRONMENT\n.TP\n.B BRAITENLAB_DATA\nthe folder of exercises, shaders and words, if it is not beside the program")
    other = "braitenlab" if subcommands else "braitenctl"
    print(f".SH SEE ALSO\n.BR {other} (1)")


if __name__ == "__main__":
    main(*sys.argv[1:])
