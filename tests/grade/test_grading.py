#!/usr/bin/env python3
"""Grading from the command line on: folders of pictures, a small course, tables, pages and files
for learning systems.

usage: test_grading.py PROGRAMS [TEST...]    PROGRAMS: the folder of judge_pictures
"""
import csv
import fcntl
import gzip
import io
import json
import os
import random
import re
import shutil
import signal
import subprocess
import sys
import tarfile
import tempfile
import threading
import time
import unicodedata
import unittest
import xml.dom.minidom
import zipfile
from pathlib import Path
from unittest import mock

sys.dont_write_bytecode = True
TESTS = Path(__file__).resolve().parents[1]
GRADE = TESTS.parent / 'common/tools/grade'
sys.path.insert(0, str(GRADE))
import class_pages  # noqa: E402
import pictures  # noqa: E402
from results import (  # noqa: E402
    NOT_CONTAINED, GradeError, Item, Row, Student, classroom_json, classroom_notices, clean,
    csv_cell, first_word, gradescope_json, grades_csv, junit_xml, padded, page_names, points_csv,
    shown_name, with_word)
from submissions import find_submissions, unpacked  # noqa: E402

GLOBE, SHEET = Item('03_image_texture', '03', 'golden'), Item('04_uv_conventions', '04', 'golden')
EVIL = '<script>alert(1)</script>\x1b"\'& =1+1'


def ramps(width, height):
    return [[[x * 255 // (width - 1), y * 255 // (height - 1), (x + y) % 256] for x in range(width)]
            for y in range(height)]


def noise(width, height, seed):
    rng = random.Random(seed)
    return [[[rng.randrange(256) for _ in range(3)] for _ in range(width)] for _ in range(height)]


def changed(rows, pixels, by):
    """The picture with these pixels (column, row) changed."""
    rows = [[list(pixel) for pixel in row] for row in rows]
    for column, row in pixels:
        rows[row][column][1] ^= by
    return rows


def png(rows, alpha=False):
    """A picture's file, with the filters and the compression that the course's own files do not
    have."""
    return pictures.png(len(rows[0]), len(rows),
                        b''.join(bytes(pixel) + (b'\x80' if alpha else b'') for row in rows
                                 for pixel in row))


def zip_of(files):
    packing = io.BytesIO()
    with zipfile.ZipFile(packing, 'w') as packed:
        for name, content in files.items():
            packed.writestr(name, content)
    return packing.getvalue()


GOLDEN, LARGE = ramps(250, 40), ramps(800, 600)  # of 10000 pixels, two may be off
RIGHT = png(GOLDEN)


class Course(unittest.TestCase):
    """A course with two chapters and an exercise, and folders of students."""

    def setUp(self):
        place = tempfile.TemporaryDirectory()
        self.addCleanup(place.cleanup)
        self.at = Path(place.name)
        self.put({'tree/chapters/03_image_texture/lesson.hpp': '',
                  'tree/chapters/04_uv_conventions/lesson.hpp': '',
                  'tree/chapters/04_uv_conventions/exercises/1_a.hpp': '',
                  'tree/tests/chapters/test_03_image_texture.cpp': '',
                  'tree/tests/golden/03_image_texture.png': RIGHT,
                  'tree/tests/golden/04_uv_conventions.png': png(LARGE)})
        (self.at / 'bin').mkdir()
        os.symlink(PROGRAMS / 'judge_pictures', self.at / 'bin/judge_pictures')

    def put(self, files):
        for name, content in files.items():
            path = self.at / name
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_bytes(content if isinstance(content, bytes) else content.encode())

    def command(self, *words):
        return [sys.executable, GRADE / 'grade.py', '--tree', self.at / 'tree', '--programs',
                self.at / 'bin', '--out', self.at / 'out', '--work', self.at / 'work', *words]

    def grade(self, *words, status=0):
        """Grades the folders that are named, from where the students' are."""
        self.ended = subprocess.run(self.command(*words), cwd=self.at, capture_output=True,
                                    text=True, check=False)
        self.assertEqual(self.ended.returncode, status, self.ended.stderr)
        return None if status == 2 or '--dry-run' in words else self.rows()

    def rows(self):
        """The rows of grades.csv, by student and chapter."""
        return {(row['student'], row['chapter'].partition('_')[0]): row
                for row in self.table('grades.csv')}

    def text(self, name):
        return (self.at / 'out' / name).read_bytes().decode()

    def table(self, name):
        return csv.DictReader(io.StringIO(self.text(name).removeprefix('\ufeff')))


class Pictures(Course):
    def test_verdicts(self):
        mirrored = [row[::-1] for row in GOLDEN]
        off = [(column, 3) for column in range(250)]
        self.put({'tree/chapters/05_y_rotation/README.md': '',
                  'tree/tests/golden/05_y_rotation.png': png(noise(250, 40, 3))})
        for name, (file, word, note) in (cases := {
                'right': (png(GOLDEN, alpha=True), 'ok', 'the file has an alpha channel, which is '
                                                         'not looked at'),
                'last bits': (png(changed(GOLDEN, off, 1)), 'ok', ''),
                'allowed': (png(changed(GOLDEN, off[1:3], 64)), 'ok',
                            'as few as the rule allows: 2 pixels are off by more than one level'),
                'not one more': (png(changed(GOLDEN, off[1:4], 64)), 'differs 0.03 %',
                                 '3 pixels are off by more than one level'),
                'mirrored': (png(mirrored), 'the whole picture is mirrored',
                             'the whole picture is mirrored: columns run the other way; '),
                'unknown': (png(noise(250, 40, 2)), 'differs 100 %',
                            ' pixels are off by more than one level'),
                'another': (png(LARGE), 'a picture of chapter 04',
                            '250 x 40; it is a picture of chapter 04'),
                'half': (png([row[::2] for row in GOLDEN[::2]]), 'wrong size',
                         'it is the right picture, drawn or scaled to 1/2'),
                'size': (png(ramps(30, 40)), 'wrong size', 'the picture has 30 x 40 pixels and '
                                                           'should have 250 x 40'),
                **{bad: ((TESTS / f'corpus/bad_{bad}.png').read_bytes(), 'unreadable',
                         'the picture cannot be read: ')
                   for bad in ('bomb_100000x100000', 'one_byte', 'trunc_idat')}}).items():
            self.put({f'class/{name}/03.png': file})
        rows = self.grade('--chapters', '3', 'class')
        for name, (_, word, note) in cases.items():
            row = rows[name, '03']
            self.assertEqual((row['verdict'], row['points'], row['picture_ok']),
                             (word, *(('1', 'yes') if word == 'ok' else ('0', 'no'))), name)
            self.assertTrue(note in row['note'] if note else row['note'] == '', row['note'])
        self.assertEqual([rows['not one more', '03'][name] for name in ('pixels_off', 'share_off')],
                         ['3', '0.00030000'])
        self.assertEqual([rows['size', '03'][name] for name in ('pixels_off', 'ssim')], ['', ''])
        self.assertIn('1 of 1    allowed                  all right\n', self.ended.stdout)
        self.assertIn(f'Look at {self.at}/out/index.html\n', self.ended.stdout)
        jpeg = (TESTS / 'corpus/jpg_420.jpg').read_bytes()
        right = png(ramps(49, 35))
        self.put({'tree/tests/golden/04_uv_conventions.png': right, 'jpegs/named_png/04.png': jpeg,
                  'jpegs/alone/04.jpg': jpeg,
                  'jpegs/both/4.jpeg': jpeg, 'jpegs/both/below/uv-04.png': right,
                  'jpegs/photo/me_4.jpg': jpeg})
        rows = self.grade('--chapters', '4', 'jpegs')
        self.assertEqual({name: row['verdict'] for (name, _), row in rows.items()},
                         {'named_png': 'a JPEG', 'alone': 'a JPEG', 'both': 'ok',
                          'photo': 'missing'})
        self.assertIn('the file is a JPEG, which has other colors than the picture: hand in a PNG',
                      rows['alone', '04']['note'])

    def test_page_shows_the_part_that_is_wrong_and_a_single_pixel_of_it(self):
        corners = [(0, 0), (799, 599)]
        for name, pixels in {'near': [(x, 599) for x in range(700, 800)],
                             'nearer': [(x, 599) for x in range(700, 799)],
                             'far': corners * 65 + [(x, 0) for x in range(99)],
                             'farther': corners + [(x, 0) for x in range(99)]}.items():
            pixels = set(pixels) | ({(400, 300)} if name == 'far' else set())
            self.put({f'class/{name}/04.png': png(changed(LARGE, pixels, 128))})
        self.put({'class/right/03.png': RIGHT, 'class/right/04.png': png(LARGE)})
        self.grade('--chapters', '04', 'class')
        pages = {name: self.text(f'{name}.html') for name in ('near', 'nearer', 'far', 'farther')}
        maps = {name: re.findall('<img [^>]*>', page) for name, page in pages.items()}
        self.assertEqual({len(images) for images in maps.values()}, {3})
        self.assertIn('is: columns 544 to 799, rows 408 to 599', pages['near'])
        self.assertIn('width="200" height="150"', maps['far'][0])
        self.assertNotEqual(maps['near'][2], maps['nearer'][2])
        self.assertNotEqual(maps['far'][2], maps['farther'][2])
        self.assertFalse((self.at / 'out/right.html').exists())  # nothing is to be seen there
        for name in pages:
            self.assertLess(len(pages[name]), 300000)


class Folders(Course):
    def test_pictures_are_found_under_many_names(self):
        found = ['03_image_texture.png', '03.png', '3.PNG', 'out/03_image_texture.png',
                 'OUT/03_IMAGE_TEXTURE.PNG',
                 'homework-main/out/03-globe.png', 'Chapter 3.png', 'ch03.png', 'Kap. 03.png',
                 'Chapter 3 final.png', 'picture_03.png',
                 'screenshot 03.png', '03 (1).png', '03_image_texture/03.png', '09_another/03.png',
                 'a/b/c/03.png']
        others = {'033.png': '033.png', 'image_texture.png': 'image_texture.png',
                  '03.1.png': '03.1.png', '03.txt': '',
                  '2 of 03 b.png': '2 of 03 b.png', 'IMG_0034.png': 'IMG_0034.png',
                  'x003.png': 'x003.png', 'a/b/c/d/03.png': '',
                  'tests/golden/03_image_texture.png': '', '.git/03.png': '',
                  'lesson.hpp': "lesson.hpp, but not in a chapter's folder"}
        self.put({f'class/{i:02}/{name}': RIGHT for i, name in enumerate([*found, *others])})
        self.put({f'class/many/{name}.png': 'x' for name in 'abcdef'})
        # The best name counts, then the place nearest to the top; two of a kind are a question;
        # links are not followed.
        self.put({'class/best/03.png': 'x', 'class/best/old/03_image_texture.png': RIGHT,
                  'class/top/out/03.png': 'x', 'class/top/03.png': RIGHT,
                  'class/two/03_a.png': RIGHT, 'class/two/03_b.png': RIGHT,
                  'class/exercise/04.1.png': RIGHT, 'class/link/a.txt': 'x'})
        os.symlink(self.at / 'tree/tests/golden/03_image_texture.png',
                   self.at / 'class/link/03.png')
        os.symlink(self.at / 'class/best', self.at / 'class/other')
        os.symlink(self.at / 'class/best', self.at / 'class/many/best')
        rows = self.grade('--chapters', '03,4.1', 'class')
        for i, name in enumerate([*found, *others]):
            note = ('there is no picture 03_image_texture.png'
                    f'{"; found " if others.get(name) else ""}{others.get(name)}')
            row = rows[f'{i:02}', '03']
            self.assertEqual((row['verdict'], row['note']),
                             ('missing', note) if name in others else ('ok', ''), name)
        self.assertEqual(rows['many', '03']['verdict'], 'missing')
        self.assertIn('; found a.png, b.png, c.png, d.png and 2 pictures more',
                      rows['many', '03']['note'])
        self.assertEqual([rows[name, '03']['verdict'] for name in ('best', 'top')], ['ok', 'ok'])
        self.assertEqual(rows['two', '03']['note'],
                         '03_a.png or 03_b.png? Name the picture 03_image_texture.png')
        self.assertEqual(rows['link', '03']['note'], '03.png is a link; links are not followed')
        # a picture is none of an exercise
        self.assertEqual(rows['exercise', '04.1']['verdict'], 'missing')
        self.assertIn('other                    the folder is a link; links are not followed\n',
                      self.ended.stdout)

    def test_whose_they_are(self):
        one = ("{} is graded as one student's folder; --class grades each folder in it as a "
               "student's\n")
        nobodys = "03_expected.png is nobody's: it lies next to students' folders\n"
        for files, words, names, remark in [
                ('ada/03.png bob/out/03.png none/a.txt a.txt', 'class', 'ada bob none', ''),
                ('ada/05.png bob/notes.txt', 'class', 'ada bob', ''),
                ('ada/x.txt bob/notes.txt', 'class', 'ada bob', ''),
                ('ada/03.png bob/03.png 03_expected.png', 'class', 'ada bob', nobodys),
                ('ada/03.png bob/03.png 03_expected.png', '--one class', 'class', ''),
                ('ada/03.png', 'class', 'ada', ''), ('ada/03.png', '--class class', 'ada', ''),
                ('ada/03.png ada.zip bob/03.png', 'class/ada/ class/ada.zip class/bob', 'ada bob',
                 ''),
                # a file in a student's own folder that names somebody else
                ('ada/03.png bob/dan_4074_90500_03.png', 'class', 'ada bob', ''),
                ('ada/03.png bob/dan_4074_90500_03.png', '--class class', 'ada bob', ''),
                ('ada/03.png bob/dan_4074_90500_03.png bob/eve_4075_90501_03.png',
                 'class/ada class/bob', 'ada bob', ''),
                # sections of a course, and what is none
                (sections := 'A/ada/03.png A/bob/03.png B/eve/03.png B/jo/03.png C/li/03.png',
                 'class', 'ada bob eve jo li', 'class is graded as a folder of classes; --class '
                 "grades each folder in it as a student's\n"),
                (sections, '--class class', 'A B C', ''),
                (sections.replace('A/', 'A/1/').replace('B/', 'B/2/'), 'class/A class/B class/C',
                 'ada bob eve jo li', ''),
                ('A/a/03.png A/b/03.png B/a/03.png B/b/03.png', 'class', 'A B', ''),
                ('A/a/03.png A/a_v2/03.png B/b/03.png B/b_v2/03.png', 'class', 'A B', ''),
                ('A/a/03.png A/b/05.png B/c/03.png B/d/05.png', 'class', 'A B', ''),
                ('A/work_v1/03.png A/work_v2/03.png B/old/03.png B/new/03.png', 'class/A class/B',
                 'A B', ''),
                ('ada/texmap-main/out/03.png', 'class/ada', 'ada', ''),
                ('ada/out/03.png', 'class/ada', 'ada', ''),
                ('03.png old/03.png', 'class', 'class', one.format('class')),
                ('03.png old/03.png', '--class class', 'old', nobodys.replace('_expected', '')),
                ('03.png notes/a.txt more/b.txt', 'class', 'class', ''),
                ('ada/03.png eve/03.png bob/a.txt', 'class/ada class/bob', 'ada bob', ''),
                ('a/ada/03.png a/bob/03.png b/eve/03.png b/cyd/03.png', 'class/a class/b',
                 'ada bob eve cyd', '')]:
            with self.subTest(files, words=words):
                shutil.rmtree(self.at / 'class', ignore_errors=True)
                self.put({f'class/{file}': RIGHT for file in files.split()})
                rows = self.grade('--chapters', '3', *words.split(),
                                  status=0 if '03' in files else 3)
                self.assertEqual({name for name, _ in rows}, set(names.split()))
                self.assertEqual(self.ended.stderr, remark)

    def test_learning_systems_say_in_a_name_whose_a_file_is(self):
        # The folder; what lies in it; and of each student the name, the id, and the picture that
        # counts for 03.
        for folder, files, students in [
                ('canvas', ['doejane_4071_90500_03_image_texture-1.png',
                            'doejane_4071_90499_03_image_texture.png',
                            'müller-lüdenscheidtjörg_LATE_4072_90501_03.png',
                            'de_la_cruzana_4073_90502_screenshot 03-2.png',
                            "o'brienann_4074_90503_03.txt"],
                 [('doejane', '4071', '03_image_texture-1.png'),
                  ('müller-lüdenscheidtjörg', '4072', '03.png'),
                  ('de_la_cruzana', '4073', 'screenshot 03-2.png'), ("o'brienann", '4074', '')]),
                ('flat', ['Jane Doe_12_assignsubmission_file_03.png',
                          "Zoë O'Brien_13_assignsubmission_file_03.png",
                          'Jane Doe_14_assignsubmission_file_Chapter 3.png',
                          'Max_15_assignsubmission_onlinetext_onlinetext.html',
                          'Jane Doe_12_assignfeedback_file_03_image_texture.png'],
                 [('Jane Doe', '12', '03.png'), ("Zoë O'Brien", '13', '03.png'),
                  ('Jane Doe', '14', 'Chapter 3.png'), ('Max', '15', '')]),
                ('week 3/moodle', ['Jo_e_12_assignsubmission_file_/out/03.png',
                                   'Jo_e_12_assignsubmission_onlinetext_/onlinetext.html'],
                 [('Jo_e', '12', '03.png')]),
                ('board', ['A_3_jdoe_attempt_2026-11-20-13-45-07_03.png',
                           'A_3_jdoe_attempt_2026-11-21-13-45-07_03.png',
                           'A_3_jdoe_attempt_2026-11-20-13-45-07.txt',
                           'A_3_max_m_attempt_2026-11-20-13-45-07_03.png'],
                 [('Jane Doe', 'jdoe', '21-13-45-07_03.png'), ('max_m', 'max_m', '07_03.png')]),
                ('alone', ['A_3_max_attempt_2026-11-20-13-45-07_03.png'],
                 [('max', 'max', '03.png')]),
                ('nobody', ['800_600_03.png', '03_image_800_600_a.png'],
                 [('nobody', '', '03_image_800_600_a.png')])]:
            for file in files:  # Apple's systems write names apart
                self.put({unicodedata.normalize('NFD', f'{folder}/{file}'):
                          'Name: Jane Doe (jdoe)\nAssignment: A_3\n'})
            ways = [[f'{self.at}/{folder.partition("/")[0]}'],
                    sorted(map(str, (self.at / folder).iterdir()))]
            for paths in ways[:1] if folder == 'nobody' else ways:
                found, remarks = find_submissions(paths, [GLOBE])
                self.assertEqual((sorted((one.person, one.id) for one in found), remarks),
                                 (sorted(one[:2] for one in students), []))
                pictures = {(one.person, one.id): one.pictures.get(GLOBE.name, ('none',))[0]
                            for one in found}
                for name, id, picture in students:
                    self.assertTrue(pictures[name, id].endswith(picture or 'none'), pictures)

    def test_layouts_of_systems_drives_and_forms(self):
        # The paths; and for each student the name, the id, and the files that count, with the
        # number of versions where there are several.
        chapters = [GLOBE, SHEET, Item('10_ray_footprints', '10', 'golden')]
        for paths, students in [
                # one folder, or two, between the class and the students; the newest by its number
                ('Work/Submitted files/王小明/HW 3/Version 1/03.png|'
                 'Work/Submitted files/王小明/HW 3/Version 2/03.png|'
                 'Work/Submitted files/A. B. Müller/HW 3/Version 9/03_image_texture.png|'
                 'Work/Submitted files/A. B. Müller/HW 3/Version 10/mine/out/03.png|'
                 'Work/Working files/王小明/HW 3/03.png',
                 '王小明||Version 2/03.png 2; A. B. Müller||Version 10/mine/out/03.png 2'),
                ('homework/ada/03.png|homework/eve/2026-11-9/03.png|'
                 'homework/eve/2026-11-10 b/03.png|homework/bob/v2/03.png|'
                 'homework/bob/v10/chapters/03_image_texture/lesson.hpp',
                 'ada||ada/03.png; bob||v10; eve||10 b/03.png 2'),
                ('submission_1_export/12/03.png|submission_1_export/13/03.png',
                 '12||12/03.png; 13||13/03.png'),
                # files that are there again
                ('ada/03.png|ada/03 (2).png|ada/03 (10).png|bob/03_image_texture_v2.png|'
                 'bob/03_image_texture.png|eve/04 (1).png|eve/uv (2).png',
                 'ada||03 (10).png 3; bob||03_image_texture_v2.png 2; eve||04 (1).png'),
                # Canvas's anonymous students, and those who typed a text
                ('anon_Ab3dE_90510_03_image_texture.png|anon_Ab3dE_90511_10_ray_footprints.png|'
                 'anon_LATE_12345_90512_03_image_texture.png|roemax_4072_text.html',
                 'Ab3dE|Ab3dE|90510_03_image_texture.png,90511_10_ray_footprints.png; '
                 '12345|12345|90512_03_image_texture.png; roemax|4072|'),
                # a number of the student's own before the chapter's name, or before its number
                ('doe_1234567_03_image_texture.png|doe_1234567_10_ray_footprints (2).png|'
                 'o.brien-li_2345678_03-Image-Texture.png|王小明_20231234_04_uv_conventions.png|'
                 'max_m_3456789_03.png|my_03_image_texture.png',
                 'doe|1234567|doe_1234567_03_image_texture.png,footprints (2).png; '
                 'o.brien-li|2345678|Image-Texture.png; 王小明|20231234|uv_conventions.png; '
                 'max_m|3456789|_03.png'),
                ('doe_1234567_03_image_texture/a_90510_03_image_texture.png|roe/03.png',
                 'doe_1234567_03_image_texture||image_texture.png; roe||03.png'),
                # Brightspace, flat and in folders: the newest by its time
                ('1-7 - Jane Doe - Nov 20, 2026 130 PM - 03_image_texture.png|'
                 '1-7 - Jane Doe - Nov 20, 2026 1130 AM - 03_image_texture.png|'
                 "2-7 - Zoë O'Brien-Li - Dec 1, 2026 1205 AM - Chapter 3.png|index.html",
                 "Jane Doe|1|130 PM - 03_image_texture.png 2; Zoë O'Brien-Li|2|Chapter 3.png"),
                ('1-7 - Jane Doe - 30 nov. 2026 1330/out/03.png|'
                 '1-7 - Jane Doe - 1 déc. 2026 930/out/03.png|'
                 '2-7 - 王小明 - 2 dic. 2026 930/03.png',
                 'Jane Doe|1|déc. 2026 930/out/03.png 2; 王小明|2|03.png'),
                # a drive, and forms
                ('Jane Doe - 03_image_texture.png|Jane Doe - 04_uv_conventions.png|'
                 'J. R. Müller - 03.png|王小明 - IMG_4.png|王小明03.png',
                 'Jane Doe||Doe - 03_image_texture.png,04_uv_conventions.png; '
                 'J. R. Müller||03.png; 王小明||王小明03.png,IMG_4.png'),
                ('03_image_texture - Jane Doe.png|03_image_texture - Ann.png|04 - Ann.png',
                 'Jane Doe||Doe.png; Ann||texture - Ann.png,04 - Ann.png'),
                ('03_image_texture_Jane Doe.png|03_image_texture_王小明.png',
                 'Jane Doe||Doe.png; 王小明||明.png'),
                # one student's files
                ('03.png|04.png|screenshot 03.png|old_03_image_texture.png|globe 03.png',
                 'class||03.png,04.png'),
                ('ada/03_image_texture - Copy.png|ada/old_03.png', 'ada||Copy.png'),
                # e-mails of several students; ILIAS, whose names begin with a time
                ('mail/2026-11-20 Jane Doe/03.png|mail/Re_ work - Max/03.png',
                 '2026-11-20 Jane Doe||03.png; Re_ work - Max||03.png'),
                ('Doe_Jane_7/20261121101010_03.png|Doe_Jane_7/20261120101010_03.png|roe/03.png|'
                 'roe/work (2)/03.png|roe/work (10)/03.png',
                 'Doe_Jane_7||20261121101010_03.png 2; roe||work (10)/03.png 3'),
                ('ada/a/03.png|ada/b/03.png|bob/03.png', 'ada||/03.png 2; bob||03.png'),
                ('Doe, Jane(jd)/Submission attachment(s)/03.png|Roe, Max(mr)/timestamp.txt|'
                 'Doe, Jane(jd)/Feedback Attachment(s)/03.png',
                 'Doe, Jane|jd|03.png; Roe, Max|mr|')]:
            with self.subTest(paths):
                shutil.rmtree(self.at / 'class', ignore_errors=True)
                self.put({f'class/{path}': '' for path in paths.split('|')})
                found, _ = find_submissions([f'{self.at}/class'], chapters)
                wanted = {tuple(line.split('|')[:2]): line.split('|')[2].split(',')
                          for line in students.split('; ')}
                self.assertEqual({(one.person, one.id) for one in found}, set(wanted))
                for one in found:
                    files = sorted(one.pictures.items()) or [('', (one.checkout, ''))]
                    wants = [re.fullmatch(r'(.*?)(?: (\d+))?', want).groups()
                             for want in wanted[one.person, one.id]]
                    self.assertEqual(len(files), len(wants))
                    for (item, (path, why_not)), (want, count) in zip(files, wants):
                        self.assertTrue(path.endswith(want) and not why_not, (path, want))
                        note = one.versions.get(item, '')
                        folder = '.*/' * ('/' in want)
                        self.assertRegex(note,
                                         f'^the newest of {count}: {folder}' if count else '^$')

    def test_archives_of_all_kinds_are_read_safely(self):
        # A student's archive with a picture, and what must not be read or written.
        for ending, mode in {'tar': 'w', 'tar.gz': 'w:gz', 'tgz': 'w:gz', 'tar.xz': 'w:xz',
                             'tbz2': 'w:bz2'}.items():
            (self.at / 'class').mkdir(exist_ok=True)
            name = f'class/王 {ending.replace(".", "")}.{ending}'
            with tarfile.open(self.at / name, mode) as made:
                for name, kind, link in (('wörk/03.png', tarfile.REGTYPE, ''),
                                         ('../../escaped.png', tarfile.REGTYPE, ''),
                                         ('04.png', tarfile.SYMTYPE, '/etc/passwd'),
                                         ('4.png', tarfile.LNKTYPE, '/etc/passwd'),
                                         ('etc', tarfile.SYMTYPE, '/etc'),
                                         ('10.png', tarfile.FIFOTYPE, '')):
                    info = tarfile.TarInfo(name)
                    info.type, info.linkname, info.size = kind, link, len(RIGHT) * (not link)
                    made.addfile(info, io.BytesIO(RIGHT))
        self.put({'class/bad.tar.gz': '\x1f', 'class/bad.7z': '7z', 'class/bomb.tgz':
                  gzip.compress(bytes(1 << 24)), 'bin/7zz': """#!/bin/sh
[ "$1" = l ] && printf 'Path = ./wörk\\nPath = ./wörk/03 [1].png\\nPath = ../../out.png\\n' && exit
for name; do :; done
[ "$1 $name" = 'x ./wörk/03 [1].png' ] && cat "$(dirname "$0")/right.png"
""", 'bin/right.png': RIGHT, 'class/ada.7z': '7z', 'class/bob.rar': 'rar'})
        (self.at / 'bin/7zz').chmod(0o755)
        for path, missing in {f'{self.at}/bin:/bin': ['bad', 'bomb'],
                              f'{self.at}/none': ['ada', 'bad', 'bad', 'bob', 'bomb']}.items():
            unpacked.cache_clear()
            most = mock.patch('submissions.MOST_BYTES', 1 << 22)
            with mock.patch.dict(os.environ, PATH=path), most:
                found, _ = find_submissions([f'{self.at}/class'], [GLOBE, SHEET])
            without = [one for one in found if not one.pictures]
            self.assertEqual([one.name for one in without], missing)
        self.assertIn('needs the program unrar, 7z, 7zz or bsdtar (Debian: ', without[3].why)
        self.assertFalse(list(self.at.rglob('escaped.png')))

    def test_a_class_is_read_from_a_zip_and_joined_with_a_list(self):
        inner = zip_of({'work/out/03.png': RIGHT, '../../escaped.png': RIGHT})
        (self.at / 'work.zip').write_bytes(inner)
        with mock.patch('submissions.MOST_BYTES', 2 * len(RIGHT) - 1):
            self.assertIsNone(unpacked(f'{self.at}/work.zip'))
        # a student's zip may hold others, but not thousands in each other
        for depth, seen in {2: 'escaped.png', 4: 'work.zip, which is not read'}.items():
            packing = inner
            for _ in range(depth - 1):
                packing = zip_of({'work.zip': packing})
            self.put({'nested/ada.zip': packing})
            unpacked.cache_clear()
            found, _ = find_submissions([f'{self.at}/nested'], [GLOBE])
            self.assertEqual([one.seen for one in found], [seen])
        # what one student hands in does not make the class unreadable; no work is lost in silence
        (self.at / 'bad.zip').write_bytes(zip_of({
            'ada/03.png': RIGHT, 'ada/03.png/03.png': '', f'bob/{"王" * 99}03.png': RIGHT,
            f'eve/{"a/" * 2100}03.png': RIGHT, 'jo/w.zip': zip_of({
                'a/w.zip': zip_of({'b/c/03.png': RIGHT})})}))
        with mock.patch.object(sys, 'platform', 'win32'):
            (self.at / 'windows.zip').write_bytes(zip_of(
                {'#### 7/03.png': RIGHT, 'J#rg/03.png': RIGHT}).replace(b'J#', b'J\x94').replace(
                    b'####', '李雷'.encode('gbk')))
        found, _ = find_submissions([f'{self.at}/windows.zip'], [GLOBE])
        self.assertEqual([one.name for one in found], ['Jörg', '李雷 7'])
        found, _ = find_submissions([f'{self.at}/bad.zip'], [GLOBE])
        self.assertEqual([(one.name, len(one.pictures), one.why[:6]) for one in found], [
            ('ada', 1, ''), ('bob', 1, ''), ('eve', 0, 'a: no '), ('jo', 1, '')])
        self.put({'class.zip': zip_of({
            'müllerjörg_1_11_03.png': RIGHT, 'doejane_2_12_work.zip': inner,
            'liwei_3_13_03.png': 'x', 'smithann_4_14_broken.zip': 'PK',
            'smithann_5_15_03.png': RIGHT}), 'class.csv': '\ufeffStudent;ID;Section\n'
            '    Points Possible;;\n'
            '"Müller, Jörg";1;A\n"Doe, Jane";2;A\n"Smith, Ann";4;A\n'
            '"Smith, Ann";5;A\n"Absent, Eve";6;A\n"Student, Test";9;A\n',
            'out/overrides.csv': 'name,chapter,points,note\n"Doe, Jane",,7.5,oral\n'
            '4,3,1,by mail\n'})
        for run in range(2):  # what was written by hand stays
            self.grade('class.zip', '--class-list', 'class.csv', '--chapters', '3', '--points',
                       '3=2.5', '--format', 'gradescope')
            self.assertEqual([(row['person'], row['id'], row['points'], row['of'], row['note'])
                              for row in self.table('points.csv')], [
                ('Jane Doe', '2', '7.5', '2.5', 'points by hand: oral'),
                ('liwei', '3', '0', '2.5', ''),
                ('Jörg Müller', '1', '2.5', '2.5', ''), ('Ann Smith', '4', '1', '2.5', ''),
                ('Ann Smith', '5', '2.5', '2.5', ''),
                ('Eve Absent', '6', '0', '2.5', 'handed in nothing')])
        self.assertTrue(self.ended.stdout.startswith("5 students in Canvas's flat files, 4 "
                                                     "pictures\n"))
        self.assertIn('liwei (3)\nhanded in nothing: Eve Absent (6)\n', self.ended.stderr)
        self.assertIn('1 of 2.5  Ann Smith (4)            missing; found broken.zip, which',
                      self.ended.stdout)
        self.assertIn('found broken.zip, which is not read; points by hand: by mail',
                      self.text('Ann_Smith__4_.html'))
        test = json.loads(self.text('Ann_Smith__4_.results.json'))['tests'][0]
        self.assertEqual((test['score'], test['max_score'], test['status']), (1, 2.5, 'failed'))
        # A list whose ids are others, such as a number for each line, is joined by names.
        self.put({'class.csv': 'ID,Last name,First name\n2,Müller,Jörg\n1,Doe,Jane\n3,Absent,Eve\n'
                               '8,Smith,Ann\n9,Smith,Ann\n'})
        self.grade('class.zip', '--class-list', 'class.csv', '--chapters', '3', '--overrides',
                   'class.csv', status=2)
        self.assertRegex(self.ended.stderr,
                         r'(?s)several of the name: liwei \(3\); smithann \(4\); smithann \(5\)\n'
                               r'handed in nothing: Eve Absent \(3\)\n.*class.csv: no line names')
        self.put({'class.csv': 'Section\nA\n', 'out/overrides.csv': 'name,points\nnobody,1\n'})
        for words, why in {
            '--class-list class.csv class.zip': 'class.csv: no line names the columns id or name '
                                                'or last first',
            '--overrides out/overrides.csv class.zip':
                'overrides.csv, line 2: no student is nobody'}.items():
            self.grade('--chapters', '3', *words.split(), status=2)
            self.assertIn(why, self.ended.stderr)
        # the class's own table is there when some of its students are graded, too
        self.grade('--chapters', '3', 'class.zip')
        self.assertIn('overrides.csv: who is not graded in this run: nobody (line 2)\n',
                      self.ended.stderr)

    def test_class_lists_of_all_systems_are_joined(self):
        flat = '{}_{}_assignsubmission_file_03.png'
        meta = ("---\nsubmission_1:\n  :submitters:\n  - :name: Jane Doe\n    :sid: '7'\n"
                '    :email: jane@x.org\n  - :name: "Zo\\xEB O\'Brien-Li"\n    :email: zoe@x.org\n'
                '  :results:\n    tests:\n    - name: no\nsubmission_2:\n  :submitters:\n'
                '  - :name: 王小明\n    :sid: 9\n')
        both = 'Jane Doe 7; Zoë O\'Brien-Li 8; 王小明 9'
        for paths, table, options, people in [
                (['Group 1-Jane Doe_12_assignsubmission_file/03.png',
                  flat.format("Group A-B-Zoë O'Brien-Li", 13), flat.format('Group-王小明', 14)],
                 "Prénom,Nom,Numéro d’identification\nJane,Doe,7\n"
                 "Zoë,O'Brien-Li,8\n,王小明,9\n",
                 '', 'Jane Doe 12; Zoë O\'Brien-Li 13; 王小明 14'),
                (['100-5 - Jane Doe - Nov 20, 2026 130 PM/03.png',
                  '100-5 - Jane Doe - Nov 21, 2026 130 PM/03.png',
                  "101-5 - Zoë O'Brien-Li - Nov 20, 2026 130 PM/03.png"],
                 "OrgDefinedId,Username,Last Name,First Name,End-of-Line Indicator\n"
                 "#7,#jd,Doe,Jane,#\n#8,#zo,O'Brien-Li,Zoë,#\n", '',
                 "Jane Doe 100; Zoë O'Brien-Li 101"),
                (['doe_1234567_03.png', 'li_7654321_03.png'],
                 'OrgDefinedId,Last Name,First Name\n#1234567,Other,Ann\n#7654321,Li,Zoë\n', '',
                 'Ann Other 1234567; Zoë Li 7654321'),
                (['a_export/submission_1/03.png', 'a_export/submission_2/03.png',
                  'a_export/submission_metadata.yml'],
                 "姓名,学号,电子邮件\nJane Doe,7,\n"
                 "Zoë O'Brien-Li,8,zoe@x.org\n王小明,9,\n", '',
                 both.replace('8', 'zoe@x.org')),
                # the id is that of one of the group
                (['teamone_7_90500_03.png', 'teamtwo_9_90501_03.png', '王小明_9_90502_03.png'],
                 "name,canvas_user_id,group_name\nJane Doe,7,Team One\nZoë O'Brien-Li,8,Team One\n"
                 '王小明,9,Team Two\n', '--columns canvas_user_id=id,no', None),
                (['teamone_7_90500_03.png', 'teamtwo_9_90501_03.png', '王小明_9_90502_03.png'],
                 "name,canvas_user_id,group_name\nJane Doe,7,Team One\nZoë O'Brien-Li,8,Team One\n"
                 '王小明,9,Team Two\n', '--columns name=name,id=canvas_user_id,group=Group_name',
                 both),
                (['doejane_7_text.html', 'doejane_7_90_03.png', 'zoe_8_text.html', 'li_9_9_03.png'],
                 "Estudiante,ID\n\"Doe, Jane\",7\n\"O'Brien-Li, Zoë\",8\n王小明,9\n", '', both),
                (['Jane - 03.png', 'jane doe - 04.png', '李 - 03.png'],
                 'Fornavn;Etternavn;Brukernavn\nJane;Doe;7\n李;;9\n'.encode('gb18030'), '',
                 'Jane ; Jane Doe 7; 李 9'),
                (['王小明/03.png', 'ada/03.png'],
                 '姓,名,学号\n王,小明,9\n'.encode('gb18030'), '',
                 '王小明 9; ada '),
                # of two whose ids are not in the list, one's line has none and the other's another
                ([flat.format('Jane Doe', 7), flat.format('Roe Max', 8), flat.format('Li Zoë', 9)],
                 'Name,ID\nJane Doe,7\nMax Roe,\nZoë Li,5\n', '',
                 'Jane Doe 7; Max Roe 8; Li Zoë 9'),
                (['ada b/03.png'], 'Nachname, Vorname;ID\n"B, Ada";1\nC, Jo;2\n', '', 'Ada B 1'),
                (['ada/03.png'], 'Name\n' + 'x' * 200000, '', 'has: . Heads'),
                (['ada/03.png'], 'Matrikel,Wer\n1,ada\n', '', 'has: Matrikel, Wer. Heads such as '),
                (['ada/03.png'], 'Matrikel,Wer\n1,ada\n', '--columns id=Matrikel,name=Wer',
                 'ada 1')]:
            with self.subTest(table):
                shutil.rmtree(self.at / 'class', ignore_errors=True)
                self.put({f'class/{path}': meta if path.endswith('yml') else RIGHT
                          for path in paths} | {'list.csv': table})
                is_wrong = people is None or 'Heads' in people
                self.grade('class', '--class-list', 'list.csv', '--chapters', '3',
                           *options.split(), status=2 if is_wrong else 0)
                if is_wrong:
                    self.assertIn(people or "not 'canvas_user_id=id'", self.ended.stderr)
                    continue
                found = [f'{row["person"]} {row["id"]}' for row in self.table('points.csv')
                         if row['note'] != 'handed in nothing']
                self.assertEqual(sorted(found), sorted(people.split('; ')))

    def test_what_is_not_understood_is_loud_and_a_dry_run_says_who_was_found(self):
        self.put({f'class/{i:02}/{"03.png" if i % 2 else "IMG.png"}': RIGHT for i in range(29)}
                 | {'class/report/report.pdf': '', 'class/empty/a': ''})
        (self.at / 'class/empty/a').unlink()
        why = ('NOT UNDERSTOOD: 30 students with files, 16 of them with none that fits a chapter. '
               'Names such as 03_image_texture.png or 03.png do. --dry-run shows who was found')
        for words in ['--dry-run'], []:
            self.grade('class', '--chapters', '3,04', *words, status=3)
            lines = self.ended.stdout.splitlines()
            self.assertEqual(lines[:2], ['31 students in folders, 14 pictures', why])
            self.assertEqual(lines[2], '  00: IMG.png: no name or number of a chapter, or several')
            self.assertEqual(lines[10 + bool(words)], f'  and {22 if words else 8} more')
            self.assertEqual((self.at / 'out').exists(), not words)
        self.assertIn(f'<p class="verdict bad">{why}<br>  00: IMG.png: no', self.text('index.html'))
        self.assertIn('<br>  report: report.pdf: no picture and no code</p>',
                      self.text('index.html'))
        # who has nothing has one word for all chapters
        for line in ('0 of 2    00                       missing; found IMG.png\n',
                     '0 of 2    report                   no chapter and no picture found\n'):
            self.assertIn(line, self.ended.stdout)
        # half of them is enough; versions and ids are shown, long lines are cut
        self.put({'class/report/3 (2).png': RIGHT, 'class/report/3.png': RIGHT,
                  'list.csv': 'name,id\nreport,77\n00,5\n'})
        self.grade('class', '--dry-run', '--chapters', '3', '--class-list', 'list.csv')
        self.assertIn('  report (77): 03 the newest of 2: 3 (2).png\n', self.ended.stdout)
        self.assertIn('  00 (5): IMG.png: no name', self.ended.stdout)
        self.assertLess(self.ended.stdout.count('\n'), 12)
        # a class list of which nobody is in the class, as its column of names is not known
        self.put({'list.csv': 'Naam,ID\nreport,77\n'})
        self.grade('class', '--dry-run', '--chapters', '3', '--class-list', 'list.csv', status=3)
        self.assertIn("31 students are not in the class list. Its first one is read as name '', id "
                      "'77': --columns", self.ended.stdout)
        # what one student has of another chapter is understood
        self.put({'one/4.png': ''})
        self.grade('one', '--dry-run', '--chapters', '3')
        self.grade('class/empty', '--dry-run', status=3)
        self.grade('class/empty', '--one', '--dry-run')

    def test_chapters_are_found_in_several_layouts(self):
        for i, (file, checkout) in enumerate({
                'chapters/03_image_texture/lesson.hpp': '.',
                'Chapters/03_image_texture/lesson.hpp': 'Chapters',
                '03_image_texture/lesson.hpp': '.',
                'homework/03_image_texture/lesson.hpp': 'homework',
                'texmap-main/chapters/03_image_texture/lesson.hpp': 'texmap-main',
                '04_uv_conventions/exercises/1_b.hpp': '.', '09_another/lesson.hpp': None}.items()):
            self.put({f'{i}/{file}': 'x', f'{i}/ada/03.png': 'x', f'{i}/bob/03.png': 'x'})
            exercise = Item('04.1', '04.1', exercise='/04_uv_conventions/')
            found, remarks = find_submissions([f'{self.at}/{i}'], [GLOBE, exercise])
            here = checkout in ('.', 'Chapters')  # else the others may be students, too
            self.assertEqual((len(found), len(remarks)), (1, 1) if here else (3, 0), file)
            checkouts = [os.path.relpath(one.checkout, self.at / str(i)) for one in found
                         if one.checkout]
            self.assertEqual(checkouts, [checkout] if checkout else [])

    def test_names_in_any_script_stay_and_harm_nothing(self):
        names = ['王小明', '=1+1', 'Ada', 'ada', 'index', '<script>', 'a\x1b[31mb', 'a\u202eb']
        shown = {name: name for name in names[:6]} | {names[6]: 'a[31mb', names[7]: 'ab',
                                                      '=1+1': "'=1+1"}
        if sys.platform.startswith('linux'):  # other systems make no such names
            names += ['M\udcfcller', 'M\udc81ller', 'tab\there']
            shown |= {'M\udcfcller': 'Müller', 'M\udc81ller': 'M\\x81ller', 'tab\there': 'tab here'}
        self.put({f'class/{name}/03.png': RIGHT for name in names[:-1]}
                 | {f'class/{names[-1]}/03.png': 'x'})
        rows = self.grade('--chapters', '3', 'class')
        self.assertEqual({name for name, _ in rows}, {shown[name] for name in names})
        index = self.text('index.html')
        self.assertNotRegex(index, '<script>(?!\nconst table)|\x1b|\u202e')
        self.assertIn('<bdi>&lt;script&gt;</bdi>', index)
        self.assertEqual(page_names(['ada', 'Ada', '王小', '李小红', 'index', 'a/..b', 'Müller',
                                     'Möller']),
                         ['ada', 'Ada-2', 'student', 'student-2', 'index-2', 'a___b', 'M__ller',
                          'M__ller-2'])


class Runs(Course):
    def test_wrong_command_lines_say_what_helps(self):
        self.put({'file': '', 'class/ada/03.png': RIGHT})
        for words, why in {'': 'DIR is missing', 'nowhere': "there is no folder 'nowhere'",
                           'file': 'there is nothing to grade',
                           '--chapters 99 class': "there is no chapter '99', and no exercise",
                           '--chapters 04.9 class': "'04.9', and no",
                           '--chapters 03, class': "'03,' has a comma with nothing before or",
                           '--format pdf class': '--format ',
                           '--points 03=x class':
                               "--points takes such as 02=2,02.1=0.5, not '03=x'",
                           '--one --class class': '--one and --class exclude each other',
                           '--nope class': '--nope',
                           '--columns name=x class': '--columns says how to read a class list',
                           '--overrides none class': "--overrides: there is no file 'none'",
                           '--jobs x class': "--jobs takes a whole number from 0 to 1024, not 'x'",
                           '--megabytes 1 class':
                               '--megabytes takes a whole number from 64 to 1048576'}.items():
            self.grade(*words.split(), status=2)
            self.assertRegex(self.ended.stderr, '(?m)^error: .*' + re.escape(why))
        # words and folders in any order
        rows = self.grade('class/ada', '--chapters', '3, 04.1 ,exercises', 'file')
        self.assertEqual(list(rows), [('ada', '03'), ('ada', '04.1')])
        self.assertEqual(self.ended.stderr, 'skipped, not a folder: file\n')
        # no exercise if none is asked for
        self.assertEqual(list(self.grade('class/ada')), [('ada', '03'), ('ada', '04')])
        # a run that fails leaves the grades of the one before
        before = self.text('grades.csv')
        self.put({'by_hand.csv': 'name,chapter,points\nada,02-Jan,1\n'})
        self.grade('class', '--overrides', 'by_hand.csv', status=2)
        self.assertIn("by_hand.csv, line 2: there is no chapter and no exercise '02-Jan'",
                      self.ended.stderr)
        self.assertEqual(self.text('grades.csv'), before)

    def test_formats_leave_a_file_with_the_pages_name_where_there_are_several(self):
        self.put({'class/ada/03.png': RIGHT, 'class/bob/03.png': RIGHT})
        for name, file in {'gradescope': 'results.json', 'classroom': 'classroom.json',
                           'junit': 'junit.xml'}.items():
            self.grade('--chapters', '3', '--format', name, 'class/ada')
            self.assertEqual(
                '::notice title=Autograding complete::Points 1/1\n' in self.ended.stdout,
                name == 'classroom')
            self.assertTrue((self.at / 'out' / file).exists())
            self.grade('--chapters', '3', '--format', name, 'class')
            self.assertTrue((self.at / 'out' / f'bob.{file}').exists())

    def test_the_zip_for_gradescope_has_the_course_and_nothing_beside_it(self):
        parts = ('assets/a chapters/a docs/a tests/a course CMakeLists.txt CMakePresets.json '
                 'LICENSE README.md vcpkg.json').split()
        self.put({f'course/{name}': '' for name in [*parts, 'students/ada/03.png', 'class.csv']})
        shutil.copytree(GRADE, self.at / 'course/common/tools/grade')
        subprocess.run(['sh', self.at / 'course/common/tools/grade/autograder.sh', 'made.zip'],
                       cwd=self.at, capture_output=True, check=True)
        with zipfile.ZipFile(self.at / 'made.zip') as made:
            names = {'/'.join(name.split('/')[:2]) for name in made.namelist()} - {'course/'}
        self.assertEqual(names, {'run_autograder', 'setup.sh', 'course/common'} | {
            f'course/{name.partition("/")[0]}' for name in parts})

    def test_one_run_at_a_time_uses_a_folder(self):
        self.put({'class/ada/chapters/03_image_texture/lesson.hpp': '', 'class/bob/03.png': RIGHT})
        for folder, words in {'out': ['class/bob'], 'work': ['class']}.items():
            (self.at / folder).mkdir(exist_ok=True)
            with open(self.at / folder / '.lock', 'w') as other:
                fcntl.flock(other, fcntl.LOCK_EX)
                self.grade('--chapters', '3', *words, status=2)
            if folder == 'out' or sys.platform.startswith('linux'):
                self.assertIn(f"another ./course grade is using the folder '{self.at}/{folder}'; "
                              "wait for it, or name another folder with "
                              f'--{folder}\n', self.ended.stderr)
        # What was graded before stays. The tests count for all, if anyone hands in a checkout.
        self.assertIn('"class/bob","bob","1","2","1","bob","","","bob","",""\r\n',
                      self.text('points.csv'))
        self.assertEqual(self.rows()['bob', '03']['verdict'], 'no tests')

    def test_a_run_that_is_ended_keeps_what_is_done_and_ends_what_runs(self):
        self.put({'class/ada/03.png': RIGHT, 'class/eve/03.png': png(noise(250, 40, 5))})
        judge = self.at / 'bin/judge_pictures'
        judge.unlink()
        # the real judge, but it takes long for eve's picture
        self.put({'bin/judge_pictures': f'''#!{sys.executable}
import os, subprocess, time
judge = subprocess.Popen(['{PROGRAMS}/judge_pictures'], stdin=subprocess.PIPE, bufsize=0)
question = b''
while byte := os.read(0, 1):
    question += byte
    if b'eve/03.png' in question:
        open('{judge}.begun', 'w').write(str(os.getpid()))
        time.sleep(1000)
    judge.stdin.write(byte)
'''})
        judge.chmod(0o755)
        with subprocess.Popen(self.command('--chapters', '3', 'class'), cwd=self.at,
                              stdout=subprocess.PIPE) as run:
            begun = self.at / 'bin/judge_pictures.begun'
            while run.poll() is None and not (begun.exists() and begun.read_text()):
                time.sleep(0.02)
            run.send_signal(signal.SIGINT)
            run.communicate()
        self.assertEqual(run.returncode, 130)
        with self.assertRaises(ProcessLookupError):
            os.kill(int(begun.read_text()), 0)
        self.assertEqual(list(self.rows()), [('ada', '03')])
        self.assertIn('<p>1 student graded of 2: the run was ended before the others',
                      self.text('index.html'))

    def test_a_judge_that_has_ended_is_no_broken_pipe(self):
        judge = pictures.Pictures(self.at / 'bin', threading.Event())
        judge.process.kill()
        judge.process.wait()
        with self.assertRaisesRegex(GradeError, 'judge_pictures, has ended'):
            judge.compare('a', 'b')
        judge.stopping.set()  # as Ctrl-C does
        with self.assertRaises(KeyboardInterrupt):
            judge.compare('a', 'b')
        judge.process.communicate()


class Results(unittest.TestCase):
    """Tables, pages and formats of students of every kind."""

    @staticmethod
    def row(item=GLOBE, picture=True, passed=5, note='', **other):
        row = Row(item, 'ok' if picture else 'mirrored', note, 'ok', 'ok', 'bwrap', '1.5', '5.0',
                  None, picture, with_tests=True, tests_passed=passed, tests_run=5)
        for name, value in other.items():
            setattr(row, name, value)
        return row

    def students(self):
        exercise = Item('02.1', '02.1',
                        exercise='chapters/02_checkerboard_uv/exercises/1_where_on_the_map.hpp')
        right = self.row(exercise, tests_passed=1, tests_run=1)
        broken = self.row(SHEET, False, 0, "lesson.hpp:7: error: expected ';'",
                          build='does not build', tests_run=0)
        broken.word = broken.build
        evil = self.row(picture=False, passed=4, note=EVIL)
        return [Student('s/ada', 'ada', 'ada', '', [self.row(), right]),
                Student(f's/{EVIL}', EVIL, 'evil', EVIL, [evil]),
                Student('s/bob', 'bob', 'bob', '', [broken, self.row()]),
                Student('s/eve', 'eve', 'eve', '', [broken])]

    def test_text_is_made_safe(self):
        for text, cell in {'ada': 'ada', 'say "hi"': 'say ""hi""', '=1+1': "'=1+1",
                           ' =1+1': " '=1+1", '\u3000=1': "\u3000'=1",
                           '＝1+1': "'＝1+1", '"=1': '""\'=1', 'x\n=1': 'x =1', 'a-b = c': 'a-b = c',
                           '\x1b@': "'@"}.items():
            self.assertEqual(csv_cell(text), f'"{cell}"')
        self.assertEqual(clean('a\nb\tc\x1b[31m\x7f\u202e\udcff'), 'a b c[31m\ufffd')
        self.assertEqual(shown_name('\ufffd'), '\ufffd')
        self.assertEqual(padded('王小明', 8), '王小明  ')
        for note, word in {
            'std::fmod keeps the sign: tried -1; yours -1': 'std::fmod keeps the sign',
            'not yet; tried: 1': 'not yet',
            'mirrored': 'mirrored'}.items():
            self.assertEqual((first_word(note), with_word(word, note)), (word, note))
        self.assertEqual((with_word('hang', 'it was stopped'), with_word('missing', '')),
                         ('hang: it was stopped', 'missing'))

    def test_tables(self):
        students = self.students()
        grades, points = grades_csv(students), points_csv(students)
        self.assertTrue(grades.startswith(
            '\ufeff"student","chapter","build","run","seconds","pixels_off","share_off","rmse",'
            '"ssim","picture_ok","tests","note","verdict","points","of","second_picture_ok",'
            '"limit_seconds","contained_by","folder","unchanged","same_as","id","person"\r\n'
            '"ada","03_image_texture","ok","ok","1.5","","","","","yes","5 of 5","","ok","2","2",'
            '"","5.0","bwrap","s/ada","","","",""\r\n'
            '"ada","02.1","ok","ok","1.5","","","","","","1 of 1","","ok","1","1",'
            '"","5.0","bwrap","s/ada","","","",""\r\n'))
        students[0].all_rows.append(None)
        self.assertTrue(points_csv(students).startswith(
            '\ufeff"folder","name","points","of","chapters","page","note","id","person",'
            '"unchanged","same_as"\r\n'
            '"s/ada","ada","3","3","2","ada","ended with 2 of 3 graded","","","",""\r\n'))
        students[2].all_rows[0].containment = 'none'
        for table in (grades_csv(students), points_csv(students)):
            self.assertTrue(table.startswith(f'\ufeff"{NOT_CONTAINED}"\r\n"'))
        self.assertNotIn(NOT_CONTAINED, grades + points)

    def test_class_page_has_the_worst_first_and_a_row_of_sums(self):
        students = [Student(f's/{i}', f'student {i}', f's{i}', '',
                            [Row(GLOBE, 'ok', picture_ok=True), Row(SHEET, 'ok', picture_ok=True)])
                    for i in range(200)]
        for i in range(150, 187):
            students[i].all_rows[0] = Row(GLOBE, 'mirrored')
        for i, word in enumerate(('differs 3 %', 'black', 'gray')):
            students[190 + i].all_rows[0] = Row(GLOBE, word)
        page = class_pages.class_page('@BODY@', [GLOBE, SHEET], students, 200)
        self.assertIn('<td>160 right<br>37 mirrored<br>1 black<br>1 differ<br>1 other</td><td>all '
                      'right</td>', page)
        self.assertLess(page.index('student 150<'), page.index('student 0<'))
        self.assertIn('<a href="s150.html">', page)
        self.assertNotIn('<a href="s7.html">', page)
        self.assertNotRegex(page, 'Tests|class="scroll"')  # a table to scroll would be cut on paper
        self.assertLess(len(page), 100000)
        students[0].all_rows = [self.row(), None]
        self.assertRegex(class_pages.class_page('@BODY@', [GLOBE, SHEET], students, 200),
                         'Tests</button>.*\n(.*\n)*.*>2 of 2<br>ended with 1 of 2 graded</td>')

    def test_pages_have_nothing_that_a_student_wrote_and_warn_first(self):
        students = self.students()
        students[1].all_rows[0].containment = 'none'
        pages = [class_pages.student_page('<title>@TITLE@</title>@BODY@', students[1]),
                 class_pages.class_page('@BODY@', [GLOBE], [students[1]], 1)]
        for page in pages:
            self.assertNotRegex(page, '<script|\x1b')
            self.assertIn('&lt;script&gt;', page)
            self.assertRegex(page, '^(<title>.*</title>)?<p class="verdict bad">NOT CONTAINED')
        self.assertIn('pre { white-space: pre-wrap',
                      class_pages.student_page('@STYLE@', students[1]))
        self.assertIn('<h2>Right</h2>\n<p>03_image_texture</p>',
                      class_pages.student_page('@BODY@', students[2]))

    def test_formats_have_what_each_system_reads(self):
        ada, evil, bob, eve = self.students()
        why, sheet, globe = ("does not build: lesson.hpp:7: error: expected ';'",
                             '04_uv_conventions', '03_image_texture')
        # Item, what of it, number, points, message and seconds: a program's time is counted once.
        tests = [(sheet, 'the picture', '4.1', 0, why, 1.5), (sheet, 'the tests', '4.2', 0, why, 0),
                 (globe, 'the picture', '3.1', 1, '', 1.5), (globe, 'the tests', '3.2', 1, '', 0)]
        self.assertEqual(json.loads(gradescope_json(bob)), {
            'score': 2, 'execution_time': 3, 'output': '2 of 4 points', 'output_format': 'text',
            'test_output_format': 'text', 'visibility': 'visible', 'stdout_visibility': 'hidden',
            'extra_data': {'folder': 's/bob'},
            'tests': [{'name': f'{item}: {what}', 'number': number, 'score': points, 'max_score': 1,
                       'output': message,
                       'status': ('failed', 'passed')[points], 'output_format': 'text',
                       'tags': [item], 'visibility': 'visible'}
                      for item, what, number, points, message, _ in tests]})
        self.assertEqual(json.loads(classroom_json(bob)), {
            'version': 1, 'status': 'fail', 'max_score': 4,
            'tests': [{'name': f'{item}: {what}', 'status': ('error', 'pass')[points],
                       'score': points, 'message': message,
                       'test_code': f'./course grade --chapters {item}',
                       'filename': f'chapters/{item}/lesson.hpp', 'line_no': 1,
                       'duration': 1000 * seconds} for item, what, _, points, message,
                      seconds in tests]})
        self.assertEqual([json.loads(classroom_json(one))['status'] for one in (ada, evil, eve)],
                         ['pass', 'fail', 'error'])
        self.assertEqual(json.loads(classroom_json(ada))['tests'][2]['filename'],
                         ada.rows[1].item.exercise)
        exercise = json.loads(gradescope_json(ada))['tests'][2]
        self.assertEqual((exercise['number'], exercise['name']), ('2.E1', '02.1: the exercise'))
        self.assertEqual(classroom_notices(evil),
                         '::notice title=Autograding complete::Points 0/2\n'
                         '::notice title=Autograding report::{"totalPoints": 0, "maxPoints": 2}\n')
        for student, counts in ((ada, [3, 0, 0]), (evil, [2, 2, 0]), (bob, [4, 0, 2])):
            suite = xml.dom.minidom.parseString(junit_xml(student)).documentElement
            self.assertEqual([len(suite.getElementsByTagName(kind))
                              for kind in ('testcase', 'failure', 'error')], counts)
            self.assertEqual([int(suite.getAttribute(name))
                              for name in ('tests', 'failures', 'errors')], counts)
        self.assertNotIn('\x1b', junit_xml(evil))
        evil.rows[0].item = Item(GLOBE.name, '03', worth=0.0)  # wrong, and worth nothing
        self.assertEqual((evil.of, evil.rows[0].right), (0, False))
        self.assertEqual(json.loads(classroom_json(evil))['status'], 'fail')
        evil.rows[0].containment = 'none'
        self.assertTrue(json.loads(gradescope_json(evil))['output'].startswith('NOT CONTAINED'))

    def test_messages_say_the_reason_once_and_not_at_length(self):
        mirrored = self.row(picture=False, passed=0,
                            note="mirrored: columns run; tests: the texture's left half: is blue")
        failed = self.row(SHEET, passed=0, note='tests: the pole: is red', word='tests 0 of 5')
        long = self.row(picture=False, passed=0, note='x' * 100000)
        tests = json.loads(gradescope_json(Student('s/ada', 'ada', 'ada', '',
                                                   [mirrored, failed, long])))['tests']
        self.assertEqual([test['output'] for test in tests[:4]],
                         [mirrored.note,
                          "0 of 5 tests passed: the texture's left half: is blue", '',
                          '0 of 5 tests passed: the pole: is red'])
        self.assertLess(len(tests[4]['output']), 65535)  # else a learning system refuses it


if __name__ == '__main__':
    if len(sys.argv) < 2:
        sys.exit(__doc__)
    PROGRAMS = Path(sys.argv[1]).resolve()
    unittest.main(argv=sys.argv[:1] + sys.argv[2:])
