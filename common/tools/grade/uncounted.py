"""A filter of system calls: those that give memory which is no process's fail with ENOSYS. box.py uses it.

The limit on memory counts the pages of processes. A file without a name (memfd_create), what System V shares, sockets, and shared pages
without a file hold memory that is on no process's account.
"""
import os
import struct

# By machine: its number in <linux/audit.h>; mmap; and what is forbidden: memfd_create, memfd_secret, shmget, semget, msgget, socket,
# socketpair, io_uring_setup, vmsplice.
MACHINES = {'x86_64': (0xC000003E, 9, (319, 447, 29, 64, 68, 41, 53, 425, 278)),
            'aarch64': (0xC00000B7, 222, (279, 447, 194, 190, 186, 198, 199, 425, 75))}
LOAD, AND, EQUAL, AT_LEAST, RETURN = 0x20, 0x54, 0x15, 0x35, 0x06  # of BPF
ALLOW, ENOSYS = 0x7FFF0000, 0x00050000 | 38
CALL, ARCHITECTURE, FLAGS = 0, 4, 40  # where a call's number and machine are, and mmap's flags
SHARED_WITHOUT_FILE = 0x01 | 0x20


def program():
    """The filter as the kernel reads it: code, how far to jump if true and if false, value. All is allowed on machines not named above."""
    machine = os.uname().machine
    found = []
    if machine in MACHINES and struct.calcsize('P') == 8:
        number, mmap, forbidden = MACHINES[machine]
        found = [(LOAD, 0, 0, ARCHITECTURE), (EQUAL, 0, 'no', number),  # programs of another machine have other numbers of calls
                 (LOAD, 0, 0, CALL), (AT_LEAST, 'no', 0, 0x40000000),  # so have those of x32
                 *((EQUAL, 'no', 0, call) for call in forbidden),
                 (EQUAL, 0, 'yes', mmap), (LOAD, 0, 0, FLAGS), (AND, 0, 0, SHARED_WITHOUT_FILE), (EQUAL, 'no', 0, SHARED_WITHOUT_FILE)]
    ends = {'yes': len(found), 'no': len(found) + 1}
    found += [(RETURN, 0, 0, ALLOW), (RETURN, 0, 0, ENOSYS)]
    return b''.join(struct.pack('=HBBI', code, *(ends[to] - at - 1 if to in ends else to for to in jumps), value)
                    for at, (code, *jumps, value) in enumerate(found))
