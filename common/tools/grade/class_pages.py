"""The pages of a class: the table of all students, and a page for a student where there is more to
see than the table shows."""
import collections
import re

from results import NOT_CONTAINED, clean, clean_lines, counted, escaped

TABLE_STYLE = '''
body { max-width: none; }
.grades { width: 100%; border-collapse: separate; border-spacing: 0; }
.grades th, .grades td { padding: .2rem .3rem; font-size: .8rem; line-height: 1.3; }
.grades td { min-width: 3rem; }
.grades .name { min-width: 8rem; max-width: 16rem; overflow-wrap: anywhere; }
.grades thead { position: sticky; top: 0; background: var(--paper); }
.grades thead td { color: var(--soft); font-size: .8rem; border-bottom: 2px solid var(--line); }
.grades .points { white-space: nowrap; font-weight: 600; }
.grades button { border: 0; padding: 0; background: none; color: inherit; font: inherit;
  cursor: pointer; text-decoration: underline dotted; }
@page { size: landscape; margin: 1cm; }
@media print {
  .grades thead { position: static; }
  .grades tr { break-inside: avoid; }
  .grades button { display: contents; } /* or Chromium leaves it out where a head stands again */
}
'''

# A compiler's message is one long line.
NOTES_STYLE = '''
pre { white-space: pre-wrap; overflow-wrap: anywhere; }
'''

# A cell is sorted by its data-key, a number, or by its text.
SORT_SCRIPT = '''
const table = document.querySelector(".grades");
const heads = [...table.querySelectorAll("thead th")];
const collator = new Intl.Collator(undefined, { numeric: true });
heads.forEach((head, column) => head.querySelector("button").addEventListener("click", () => {
  const down = head.getAttribute("aria-sort") === "ascending";
  const key = (row) => row.cells[column].dataset.key ?? row.cells[column].textContent;
  const rows = [...table.tBodies[0].rows];
  rows.sort((a, b) => collator.compare(key(a), key(b)) * (down ? -1 : 1));
  table.tBodies[0].append(...rows);
  for (const other of heads) other.removeAttribute("aria-sort");
  head.setAttribute("aria-sort", down ? "descending" : "ascending");
}));
'''


def framed(page, title, style, body, script=''):
    """The page of the course's programs, which the program judge_pictures has, with these parts."""
    parts = {'@TITLE@': escaped(title), '@STYLE@': style, '@SCRIPT@': script, '@BODY@': body}
    return re.sub('@[A-Z]+@', lambda name: parts[name[0]], page)


def colored(element, good, text):
    return f'<{element} class="{"good" if good else "bad"}">{escaped(text)}</{element}>'


def warning_of(contained):
    return '' if contained else f'<p class="verdict bad">{escaped(NOT_CONTAINED)}</p>\n'


def sum_of(rows):
    """Such as "149 right", and below it the words that most students share: "37 mirrored"."""
    def shared(word):  # shares of pixels and numbers of tests differ from student to student
        return 'differ' if word.startswith('differs') else 'fail tests' if word.startswith(
            'tests ') else word
    count = collections.Counter(sorted(shared(row.word) for row in rows if not row.right))
    if not count:
        return 'all right'
    most = count.most_common(3)
    lines = [f'{sum(row.right for row in rows)} right',
             *(f'{students} {escaped(word)}' for word, students in most)]
    others = sum(count.values()) - sum(students for _, students in most)
    return '<br>'.join(lines + ([f'{others} other'] if others else []))


def head_of_table(items, students, with_tests):
    def column(name, attributes):
        return f'<th scope="col"{attributes}><button type="button">{escaped(name)}</button></th>'
    html = '<thead><tr>' + column('Points',
                                  ' aria-sort="ascending"') + column('Student', ' class="name"')
    html += ''.join(column(item.number, f' title="{escaped(item.name)}"') for item in items)
    html += (column('Tests', '') if with_tests else '') + '</tr>\n<tr><td>'
    points, of = (sum(getattr(student, what) for student in students) for what in ('points', 'of'))
    html += (f'mean {100 * points / of:.0f} %' if of else '') + f'</td><td>all {len(students)}</td>'
    for place in range(len(items)):
        rows = [student.all_rows[place] for student in students if student.all_rows[place]]
        html += f'<td>{sum_of(rows)}</td>'
    return html + ('<td></td>' if with_tests else '') + '</tr></thead>\n'


def table_row(student, with_tests):
    key = 1e6 * (student.points / student.of if student.of else 0)
    unfinished = f'<br>{student.unfinished}' if student.unfinished else ''
    name = escaped(student.name)
    if student.has_page:
        name = f'<a href="{student.page}.html">{name}</a>'
    html = (f'<tr><td class="points" data-key="{key:.0f}">{student.points} of '
            f'{student.of}{unfinished}</td>'
            f'<th scope="row" class="name"><bdi>{name}</bdi></th>')
    for row in student.all_rows:
        html += colored('td', row.right, '✓' if row.right else row.word) if row else '<td></td>'
    # an exercise's word says it all
    chapters = [row for row in student.rows if not row.item.exercise]
    passed, run = sum(row.tests_passed for row in chapters), sum(row.tests_run for row in chapters)
    if with_tests:
        html += f'<td data-key="{passed}">{passed} of {run}</td>' if run else '<td></td>'
    return html + '</tr>\n'


def section(row):
    name = escaped(row.item.name)
    html = (f'<h2 id="{name}">{name}: '
            f'{colored("span", row.right, "right" if row.right else row.word)}</h2>\n')
    if row.note:
        html += f'<pre>{escaped(clean_lines(row.note))}</pre>\n'
    html += row.shown
    entries = {'build': row.build, 'run': row.run}
    if row.cpu_seconds:
        entries['processor time'] = f'{row.cpu_seconds} s of {row.limit_cpu_seconds} s'
    if not row.item.exercise:
        entries['tests passed'] = row.tests
    if row.figures and not row.picture_ok:
        entries |= {'pixels off by more than one level': str(row.figures['pixels_off']),
                    'RMSE': '%.3g levels' % row.figures['rmse'],
                    'SSIM': '%.4f' % row.figures['ssim']}
    lines = [f'<tr><th scope="row">{name}</th><td>{escaped(value)}</td></tr>\n'
             for name, value in entries.items() if value]
    return html + ('<div class="scroll"><table>\n<tbody>\n' + ''.join(lines)
                   + '</tbody>\n</table></div>\n' if lines else '')


def class_page(page, items, students, asked, warning=()):
    """The worst first, sortable, with a row of sums such as "37 mirrored"."""
    ended = f' of {asked}: the run was ended before the others' if len(students) < asked else ''
    with_tests = any(not row.item.exercise and row.tests_run for student in students
                     for row in student.rows)
    warning = '<br>'.join(escaped(clean(line)) for line in warning)
    html = (
        f'{warning_of(all(student.contained for student in students))}'
        + (f'<p class="verdict bad">{warning}</p>\n' if warning else '') +
        f'<p>{counted(len(students), "student")} graded{ended}. '
        'All figures: <a href="grades.csv">grades.csv</a>, <a '
        'href="points.csv">points.csv</a>. A name with a link has a page.</p>\n'
        f'<table class="grades">\n{head_of_table(items, students, with_tests)}<tbody>\n')
    for student in sorted(students, key=lambda student: student.points / max(1, student.of)):
        html += table_row(student, with_tests)
    return framed(page, 'Grades', TABLE_STYLE, html + '</tbody>\n</table>\n', SORT_SCRIPT)


def student_page(page, student):
    """Complete in itself: what is not right, with small pictures."""
    html = (f'{warning_of(student.contained)}<p class="verdict '
            f'{"good" if student.points == student.of else "bad"}">'
            f'{student.points} of {student.of} points</p>\n<p><a href="index.html">All '
            'students</a></p>\n')
    if student.notes:
        html += f'<p>{escaped(clean(student.notes))}</p>\n'
    html += ''.join(section(row) for row in student.rows if not row.right or row.note)
    right = ', '.join(row.item.name for row in student.rows if row.right and not row.note)
    return framed(page, f'Grades of {student.name}', NOTES_STYLE,
                  html + (f'<h2>Right</h2>\n<p>{escaped(right)}</p>\n' if right else ''))
