"""The program judge_pictures, which this one asks about pictures, and draw_mistakes, which draws
what known mistakes draw."""
import json
import os
import struct
import subprocess
import sys
import zlib

from results import GradeError


def png(columns, rows, data):
    """A PNG file of RGB or RGBA bytes, quickly made."""
    def chunk(kind, data):
        return struct.pack('>I',
                           len(data)) + kind + data + struct.pack('>I', zlib.crc32(kind + data))

    line = len(data) // rows
    head = struct.pack('>2I5B', columns, rows, 8, 6 if line == 4 * columns else 2, 0, 0, 0)
    lines = b''.join(b'\0' + data[line * row:line * (row + 1)] for row in range(rows))
    return b'\x89PNG\r\n\x1a\n' + chunk(b'IHDR',
                                        head) + chunk(b'IDAT',
                                                      zlib.compress(lines, 1)) + chunk(b'IEND', b'')


def run_to_end(command, stopping, **streams):
    """Runs a program that Ctrl-C does not reach, and ends it when this one is to stop. Its
    status."""
    with subprocess.Popen(command, stdin=subprocess.DEVNULL, start_new_session=True,
                          **streams) as process:
        while not stopping.is_set():
            try:
                return process.wait(0.05)
            except subprocess.TimeoutExpired:
                pass
        if hasattr(os, 'killpg'):
            os.killpg(process.pid, 15)
        else:
            process.terminate()
    raise KeyboardInterrupt


class Pictures:
    def __init__(self, programs, stopping):
        self.programs, self.stopping = programs, stopping
        self.looked_for = set()  # chapters whose known mistakes are drawn, if they can be
        try:
            self.process = subprocess.Popen([programs / 'judge_pictures'], stdin=subprocess.PIPE,
                                            stdout=subprocess.PIPE, start_new_session=True)
        except OSError as error:
            raise GradeError(
                f'{programs / "judge_pictures"} cannot be started: {error.strerror}') from error
        self.pages = self.answer()

    def answer(self):
        line = self.process.stdout.readline()
        if not line:
            raise GradeError('the program that compares pictures, judge_pictures, has ended')
        return json.loads(line.decode('utf-8', 'replace'))

    def ask(self, picture, golden, mistakes=''):
        self.process.stdin.write(b''.join(os.fsencode(word) + b'\0'
                                          for word in (picture, golden, mistakes)))
        self.process.stdin.flush()
        return self.answer()

    def compare(self, picture, golden, item):
        """What there is to say of a chapter's picture. The first wrong one has the known mistakes
        drawn, which are kept."""
        folder = self.programs.parent / 'mistakes' / item.name
        known = item in self.looked_for
        answer = self.ask(picture, golden, folder if known else '')
        if known or not answer['shown']:
            return answer
        self.looked_for.add(item)
        drawn = folder / 'mistakes.txt'
        program = self.programs / 'draw_mistakes'
        if program.exists() and not (drawn.exists()
                                     and drawn.stat().st_mtime >= os.stat(item.golden).st_mtime):
            print(f'drawing the known mistakes of chapter {item.number}, once; this takes a minute',
                  file=sys.stderr, flush=True)
            run_to_end([program, item.number, '--out', folder], self.stopping)
        return self.ask(picture, golden, folder)
