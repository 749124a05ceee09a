"""The program judge_pictures, which this one asks about pictures."""
import contextlib
import json
import os
import struct
import subprocess
import zlib

from results import GradeError


def png(columns, rows, data):
    """A PNG file of RGB or RGBA bytes, quickly made."""
    def chunk(kind, data):
        checked = kind + data
        return struct.pack('>I', len(data)) + checked + struct.pack('>I', zlib.crc32(checked))

    line = len(data) // rows
    head = struct.pack('>2I5B', columns, rows, 8, 6 if line == 4 * columns else 2, 0, 0, 0)
    lines = b''.join(b'\0' + data[line * row:line * (row + 1)] for row in range(rows))
    return (b'\x89PNG\r\n\x1a\n' + chunk(b'IHDR', head)
            + chunk(b'IDAT', zlib.compress(lines, 1)) + chunk(b'IEND', b''))


class Pictures:
    def __init__(self, programs, stopping):
        self.stopping = stopping
        try:
            self.process = subprocess.Popen([programs / 'judge_pictures'], stdin=subprocess.PIPE,
                                            stdout=subprocess.PIPE, start_new_session=True)
        except OSError as error:
            raise GradeError(
                f'{programs / "judge_pictures"} cannot be started: {error.strerror}') from error
        self.pages = self.answer()

    def answer(self):
        line = self.process.stdout.readline()
        if not line and self.stopping.is_set():
            self.process.wait()
            raise KeyboardInterrupt
        if not line:
            raise GradeError('the program that compares pictures, judge_pictures, has ended')
        return json.loads(line.decode('utf-8', 'replace'))

    def compare(self, picture, golden):
        """What there is to say of a chapter's picture."""
        words = b''.join(os.fsencode(word) + b'\0' for word in (picture, golden))
        with contextlib.suppress(BrokenPipeError):  # that there is no answer says why
            self.process.stdin.raw.write(words)
        return self.answer()
