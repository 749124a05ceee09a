#!/usr/bin/env python3
"""Runs a command without the system calls that give memory which is no process's; box.py starts it.

usage: uncounted.py COMMAND [WORD...]

The limit on memory counts the pages of processes. A file without a name (memfd_create), what System V shares, sockets, and shared pages
without a file hold memory that is on no process's account. Here these calls fail with ENOSYS, for all that the command starts.
"""
import ctypes
import os
import struct
import sys

# By machine: its number in <linux/audit.h>; the numbers of mmap and socket; those of memfd_create, memfd_secret, shmget, semget, msgget,
# socketpair, io_uring_setup and vmsplice, which are forbidden.
MACHINES = {'x86_64': (0xC000003E, 9, 41, (319, 447, 29, 64, 68, 53, 425, 278)),
            'aarch64': (0xC00000B7, 222, 198, (279, 447, 194, 190, 186, 199, 425, 75))}
LOAD, AND, EQUAL, AT_LEAST, RETURN = 0x20, 0x54, 0x15, 0x35, 0x06  # of BPF
ALLOW, ENOSYS = 0x7FFF0000, 0x00050000 | 38
CALL, MACHINE, FIRST, FOURTH = 0, 4, 16, 40  # where a call's number, machine and arguments are
NETLINK = 16  # bwrap makes a socket of this kind
SHARED_WITHOUT_FILE = 0x01 | 0x20


def instructions(machine):
    """The filter as instructions (code, jump if true, jump if false, value); jumps to 'no' and 'yes' go to the end."""
    audit, mmap, socket, forbidden = MACHINES[machine]
    return [(LOAD, 0, 0, MACHINE), (EQUAL, 0, 'no', audit),  # programs of another machine number their calls in another way
            (LOAD, 0, 0, CALL), (AT_LEAST, 'no', 0, 0x40000000),  # so do those of x32
            *((EQUAL, 'no', 0, number) for number in forbidden),
            (EQUAL, 0, 2, socket), (LOAD, 0, 0, FIRST), (EQUAL, 'yes', 'no', NETLINK),
            (EQUAL, 0, 'yes', mmap), (LOAD, 0, 0, FOURTH), (AND, 0, 0, SHARED_WITHOUT_FILE), (EQUAL, 'no', 'yes', SHARED_WITHOUT_FILE)]


def program(machine):
    """The filter as the kernel reads it."""
    found = instructions(machine)
    ends = {'yes': len(found), 'no': len(found) + 1}
    found += [(RETURN, 0, 0, ALLOW), (RETURN, 0, 0, ENOSYS)]
    return b''.join(struct.pack('=HBBI', code, *(ends[to] - at - 1 if to in ends else to for to in jumps), value)
                    for at, (code, *jumps, value) in enumerate(found))


def forbid():
    """Forbids the calls to this process and all that it starts. Other machines than those above have no filter."""
    machine = os.uname().machine
    if machine not in MACHINES or struct.calcsize('P') != 8:
        return
    filter_ = ctypes.create_string_buffer(program(machine))
    described = struct.pack('@HP', len(filter_) // 8, ctypes.addressof(filter_))
    prctl = ctypes.CDLL(None, use_errno=True).prctl
    prctl.argtypes = [ctypes.c_int, *[ctypes.c_ulong] * 4]
    address = ctypes.cast(ctypes.c_char_p(described), ctypes.c_void_p).value
    if prctl(38, 1, 0, 0, 0) or prctl(22, 2, address, 0, 0):  # PR_SET_NO_NEW_PRIVS, PR_SET_SECCOMP
        sys.exit('error: this kernel takes no filter of system calls')


if __name__ == '__main__':
    forbid()
    os.execvp(sys.argv[1], sys.argv[1:])
