"""Boxes in which a command sees the system's programs and what is named for it, and nothing else:
by bwrap.

In a box there are no other files, no /proc, no network and no processes but its own, and it can
write nothing but its own small memory. What a command makes comes out through an open file.
Processor time, memory, processes and bytes written have limits. The limit on memory counts the
pages of processes. A file without a name (memfd_create), what System V shares, sockets, and shared
pages without a file hold memory that is on no process's account: system calls that give it fail
with ENOSYS.
"""
import dataclasses
import functools
import itertools
import os
import re
import select
import shlex
import signal
import struct
import subprocess
import tempfile
import time
from pathlib import Path

SYSTEM = ['/usr', '/bin', '/sbin', '/lib', '/lib32', '/lib64', '/libx32', '/etc/alternatives',
          '/etc/ld.so.cache', '/nix/store']
BOX = '/box'
ENVIRONMENT = {'PATH': '/usr/local/bin:/usr/bin:/bin:/usr/sbin:/sbin', 'LC_ALL': 'C', 'HOME': BOX,
               'TMPDIR': BOX}
LOG_BYTES = 1 << 16  # kept of what a command prints
TOO_SLOW = 'it was stopped after %.3g s of CPU time: it is too slow, or has no end'
SIGNALS = {'SIGXFSZ': 'it wrote a file that is too large',
           'SIGFPE': 'it divided a whole number by 0',
           'SIGSEGV': 'it ended by signal SIGSEGV: an index or a pointer is outside, or a '
                      'function calls itself for ever',
           'SIGABRT': 'it ended by signal SIGABRT: an exception that nothing catches, an '
                      'assertion, or an index outside'}
IDLE_SECONDS = 10  # without any CPU: the program waits for what never comes


@dataclasses.dataclass
class Limits:
    cpu: float
    megabytes: int
    disk_megabytes: int = 64
    processes: int = 64


@dataclasses.dataclass
class Ended:
    """How a command in a box ended: `how` is ok or one of the words of the column run."""
    how: str
    why: str
    cpu: float
    log: str
    product: bytes


def shortened(log):
    """The first half and the last of what is kept of a log: tests have their sum at the end."""
    return log if len(log) <= LOG_BYTES else log[:LOG_BYTES // 2] + log[-LOG_BYTES // 2:]


# Runs "$@" with limits. What was its input is the file that then gets, in three lines and the rest:
# whether processes are left, the times of the shell and of what it ran, the product.
INSIDE = '''
exec 3>&0 </dev/null
ulimit -c 0; ulimit -t "$1"; ulimit -v "$2"; ulimit -f "$3"; ulimit -n 256
ulimit -u "$4" 2>/dev/null || ulimit -p "$4" 2>/dev/null
product=$5 alone=$6
shift 6
"$@" 3>&-
status=$?
if [ "$alone" = yes ] && kill -s 0 -- -1 2>/dev/null; then echo left >&3; else echo none >&3; fi
times >&3
if [ -f "$product" ] && [ ! -L "$product" ]; then cat "$product" >&3; fi
exit $status
'''


def exempt():
    """Whether this is the machine's root: the kernel lets it have any number of processes, in a
    user namespace of its own, too."""
    ids = (map(int, line.split()) for line in Path('/proc/self/uid_map').read_text().splitlines())
    return os.geteuid() == 0 and any(inside == outside == 0 for inside, outside, _ in ids)


class Users:
    """A user namespace with more users than root. Each of root's boxes gets one, with a number of
    processes of its own."""

    # The user may read and run what root may: the course and what is made may be for root alone.
    # What it sees is mounted read-only. Who becomes another user has to ask again for the signal
    # that the parent ended.
    BECOME = ['setpriv', '--pdeathsig', 'KILL', '--clear-groups', '--no-new-privs',
              *(f'--{caps}=-all,+dac_override' for caps in ('bounding-set', 'inh-caps',
                                                            'ambient-caps'))]

    def __init__(self):
        with subprocess.Popen(['unshare', '--user', 'sh', '-c', 'echo; read _'],
                              stdin=subprocess.PIPE, stdout=subprocess.PIPE,
                              env=ENVIRONMENT) as made:
            made.stdout.readline()  # now it is in its namespace
            counts = {kind: int(Path(f'/proc/self/{kind}_map').read_text().split()[2])
                      for kind in ('uid', 'gid')}
            for kind, count in counts.items():
                Path(f'/proc/{made.pid}/{kind}_map').write_text(f'0 0 {count}')
            # it stays while this is open
            namespace = os.open(f'/proc/{made.pid}/ns/user', os.O_RDONLY)
        self.enter = ['nsenter', f'--user=/proc/{os.getpid()}/fd/{namespace}']
        subprocess.run([*self.enter, 'sh', '-c', 'echo 0 >/proc/sys/user/max_user_namespaces'],
                       check=True, env=ENVIRONMENT)
        # not 65534, the user nobody; if all ids are there, these are free
        last = min(*counts.values(), 1 << 31) - 3
        self.ids = itertools.cycle(range(last, last - 10000, -1))

    def next(self):
        """The words that enter the namespace as root, and those that become another user."""
        user = str(next(self.ids))
        return self.enter, [*self.BECOME, '--reuid', user, '--regid', user]


def usage(pid, most):
    """CPU seconds, bytes of memory and number of the processes below and with this one, or of
    `most` of them."""
    ticks = pages = count = 0
    todo = [pid]
    while todo and count < most:
        process = todo.pop()
        try:
            fields = Path(f'/proc/{process}/stat').read_text().rpartition(')')[2].split()
            for task in os.listdir(f'/proc/{process}/task'):
                todo += Path(f'/proc/{process}/task/{task}/children').read_text().split()
        except (OSError, ValueError):
            continue  # it has just ended
        ticks += sum(map(int, fields[11:15]))
        pages += int(fields[21])
        count += 1
    return ticks / os.sysconf('SC_CLK_TCK'), pages * os.sysconf('SC_PAGE_SIZE'), count


# By machine: its number in <linux/audit.h>; mmap; and what is forbidden: memfd_create,
# memfd_secret, shmget, semget, msgget, socket, socketpair, io_uring_setup, vmsplice.
MACHINES = {'x86_64': (0xC000003E, 9, (319, 447, 29, 64, 68, 41, 53, 425, 278)),
            'aarch64': (0xC00000B7, 222, (279, 447, 194, 190, 186, 198, 199, 425, 75))}
LOAD, AND, EQUAL, AT_LEAST, RETURN = 0x20, 0x54, 0x15, 0x35, 0x06  # of BPF
ALLOW, ENOSYS = 0x7FFF0000, 0x00050000 | 38
CALL, ARCHITECTURE, FLAGS = 0, 4, 40  # where a call's number and machine are, and mmap's flags
SHARED_WITHOUT_FILE = 0x01 | 0x20


def filter_of_calls():
    """A filter of system calls as the kernel reads it: code, how far to jump if true and if false,
    value. Other machines allow all."""
    machine = os.uname().machine
    found = []
    if machine in MACHINES and struct.calcsize('P') == 8:
        number, mmap, forbidden = MACHINES[machine]
        # programs of another machine have other numbers of calls
        found = [(LOAD, 0, 0, ARCHITECTURE), (EQUAL, 0, 'no', number),
                 (LOAD, 0, 0, CALL), (AT_LEAST, 'no', 0, 0x40000000),  # so have those of x32
                 *((EQUAL, 'no', 0, call) for call in forbidden),
                 (EQUAL, 0, 'yes', mmap), (LOAD, 0, 0, FLAGS), (AND, 0, 0, SHARED_WITHOUT_FILE),
                 (EQUAL, 'no', 0, SHARED_WITHOUT_FILE)]
    ends = {'yes': len(found), 'no': len(found) + 1}
    found += [(RETURN, 0, 0, ALLOW), (RETURN, 0, 0, ENOSYS)]
    return b''.join(struct.pack('=HBBI', code,
                                *(ends[to] - at - 1 if to in ends else to for to in jumps), value)
                    for at, (code, *jumps, value) in enumerate(found))


class Boxes:
    """Runs commands in boxes of one kind."""

    def __init__(self, kind, work, stopping):
        self.kind, self.work, self.stopping = kind, work, stopping
        self.system = [place for place in SYSTEM if os.path.lexists(place)]
        (work / 'filter').write_bytes(filter_of_calls())

    @functools.cached_property
    def users(self):
        return Users() if exempt() else None

    def why_not(self):
        """Why this machine makes no such boxes, or none that keep what they should; empty if it
        does."""
        try:
            ended = self.run(['sh', '-c', f'test ! -e {shlex.quote(str(self.work))} -a ! -e '
                                          '/proc/self && echo kept >it'], [],
                             Limits(10, 1024), 'it')
        except (OSError, subprocess.SubprocessError) as error:
            return str(error)
        return '' if ended.product == b'kept\n' else ' '.join(
            ended.log.split()) or ended.why or 'it keeps nothing'

    def boxed(self, argv, visible, limits):
        """The command that runs argv in a box of bwrap's, which makes a socket itself, and filters
        system calls afterwards."""
        enter, become = self.users.next() if self.users else ([], [])
        command = ['sh', '-c', 'exec "$@" 9<"$0"', str(self.work / 'filter'), *enter, 'bwrap',
                   '--seccomp', '9', '--unshare-ipc',
                   '--unshare-pid', '--unshare-net', '--unshare-uts', '--unshare-cgroup-try',
                   '--die-with-parent', '--cap-drop', 'ALL']
        if enter:
            for power in ('SETUID', 'SETGID', 'SETPCAP', 'DAC_OVERRIDE'):
                command += ['--cap-add', f'CAP_{power}']
        else:
            command += ['--unshare-user', '--disable-userns']
        for place in [*self.system, *map(str, visible)]:
            command += ['--symlink', os.readlink(place),
                        place] if os.path.islink(place) else ['--ro-bind', place, place]
        # Shared pages of /dev/zero would be memory without a process.
        return command + ['--dev', '/dev', '--ro-bind', '/dev/null', '/dev/zero', '--size',
                          str(limits.disk_megabytes << 20),
                          '--perms', '1777', '--tmpfs', BOX, '--remount-ro', '/', '--remount-ro',
                          '/dev', '--chdir', BOX, *become, *argv]

    def run(self, argv, visible, limits, product=''):
        """Runs argv where only `visible` and the system are seen; `product` is the file that it
        leaves in the box."""
        contained = self.kind != 'none'
        # where no box is, the kernel counts all of this user's
        processes = limits.processes + (0 if contained else 4000)
        argv = ['sh', '-c', INSIDE, 'sh', str(int(limits.cpu) + 2), str(limits.megabytes << 10),
                str(limits.disk_megabytes << 11),
                str(processes), product, 'yes' if contained else 'no', *argv]
        command = self.boxed(argv, visible, limits) if contained else argv
        with tempfile.TemporaryFile() as handed_over, tempfile.TemporaryDirectory() as place:
            environment = dict(ENVIRONMENT,
                               **({} if contained else {'HOME': place, 'TMPDIR': place}))
            process = subprocess.Popen(command, stdin=handed_over, stdout=subprocess.PIPE,
                                       stderr=subprocess.STDOUT, cwd=place,
                                       env=environment, start_new_session=True)
            log, cpu, why = self.watch(process, limits)
            process.wait()
            process.stdout.close()
            handed_over.seek(0)
            left, _, times, made = [*handed_over.read().split(b'\n', 3), b'', b'', b'', b''][:4]
            if not contained and self.kill_group(process):
                left = b'left'
        if self.stopping.is_set():
            raise KeyboardInterrupt
        counted = re.findall(r'(\d+)m([\d.]+)s', times.decode('latin-1'))
        cpu = max(cpu, sum(60 * float(minutes) + float(seconds) for minutes, seconds in counted))
        how, why = self.how_it_ended(process.returncode, why, cpu, limits, log, left == b'left')
        return Ended(how, why, cpu, log, made)

    def watch(self, process, limits):
        """Reads what the processes print, and ends them at a limit. Returns the log, CPU seconds
        and the limit that was met."""
        log, cpu, why = bytearray(), 0.0, ''
        start = busy = time.monotonic()
        pause, due = 0.01, start
        while True:
            if select.select([process.stdout], [], [], max(0.0, due - time.monotonic()))[0]:
                piece = os.read(process.stdout.fileno(), 1 << 16)
                if not piece:
                    break
                log = shortened(log + piece)
            now = time.monotonic()
            if now < due:
                continue
            due, pause = now + pause, min(0.1, 1.5 * pause)
            was, (cpu, memory, count) = cpu, usage(process.pid, limits.processes)
            busy = now if cpu > was else busy
            cpu = max(cpu, was)
            if why:
                if now > start:  # what is not contained may hold the pipe open
                    break
                continue
            met = {'interrupted': self.stopping.is_set(),
                   'hang: ' + TOO_SLOW % limits.cpu: cpu > limits.cpu,
                   f'hang: it waited for {IDLE_SECONDS} s and did nothing':
                       now - busy > IDLE_SECONDS,
                   'hang: it did not come to an end': now - start > 60 + 10 * limits.cpu,
                   f'too much memory: its processes took more than {limits.megabytes} MB':
                       memory > limits.megabytes << 20,
                   f'too many processes: it may not have {limits.processes}':
                       count >= limits.processes}
            why = next((limit for limit, is_met in met.items() if is_met), '')
            if why:
                # a box's first process takes all others with it
                os.kill(process.pid, signal.SIGKILL)
                self.kill_group(process)
                start = now + 2
        return log.decode('utf-8', 'replace'), cpu, why

    @staticmethod
    def kill_group(process):
        """Ends the processes that a program left in its group; true if there were any."""
        try:
            os.killpg(process.pid, signal.SIGKILL)
        except ProcessLookupError:
            return False
        return True

    @staticmethod
    def how_it_ended(status, why, cpu, limits, log, left):
        """The word of the column run, and a sentence about it."""
        number = status - 128 if status > 128 else -status if status < 0 else 0
        name = signal.Signals(number).name if number in set(signal.Signals) else ''
        if why:
            how, _, why = why.partition(': ')
            return how, why
        if name in ('SIGXCPU', 'SIGKILL') and cpu >= limits.cpu:
            return 'hang', TOO_SLOW % limits.cpu
        if status and re.search(
            r'bad_alloc|not enough memory|out of memory|[Cc]annot allocate memory', log):
            return 'too much memory', f'it had {limits.megabytes} MB'
        if name:
            return f'crashed {name}', SIGNALS.get(name, f'it ended by signal {name}')
        if status:
            return f'failed ({status})', f'it ended with status {status}'
        if left:
            return 'left processes', 'it ended, but not the processes that it started'
        return 'ok', ''
