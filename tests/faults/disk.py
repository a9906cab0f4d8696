#!/usr/bin/python3
"""A disk that is as slow and as faulty as it is told to be: a folder that shows another one (FUSE, python3-fusepy).

    disk.py FOLDER MOUNT_POINT RULES

RULES is a JSON file, read anew whenever it changes: a list of rules, of which the first that fits an operation holds.

    {"ops": ["write"],       which operations: open write fsync close rename truncate unlink mkdir list; all if left out
     "match": "frames/",     a part of the path; all if left out
     "seconds": 0.01,        how long each takes
     "rate": 1e6,            and writes: so many bytes per second
     "hang": true,           waits until the rules have changed
     "error": "EIO",         what it answers, undone
     "after": 3}             of operations that fit, the first ones that the rule leaves alone
"""
import errno
import json
import os
import sys
import threading
import time

import fusepy

FLAGS = os.O_RDONLY | os.O_WRONLY | os.O_RDWR | os.O_CREAT | os.O_TRUNC | os.O_EXCL


class Rules:
    """What is to happen to an operation."""

    def __init__(self, file):
        self.file, self.version, self.rules, self.lock = file, None, [], threading.Lock()

    def current(self):
        status = os.stat(self.file)
        version = status.st_mtime_ns, status.st_ino
        if version != self.version:
            with open(self.file) as text:
                self.rules = [dict(rule, seen=0) for rule in json.load(text)]
            self.version = version
        return self.rules

    def find(self, op, path):
        with self.lock:
            for rule in self.current():
                if op in rule.get("ops", [op]) and rule.get("match", "") in path:
                    rule["seen"] += 1
                    if rule["seen"] > rule.get("after", 0):
                        return rule
        return {}

    def apply(self, op, path, size=0):
        rule = self.find(op, path)
        time.sleep(rule.get("seconds", 0) + (size / rule["rate"] if "rate" in rule else 0))
        version = self.version
        while rule.get("hang"):
            time.sleep(0.02)
            with self.lock:
                self.current()
                if self.version != version:
                    break
        if "error" in rule:
            raise fusepy.FuseOSError(getattr(errno, rule["error"]))


class Disk(fusepy.Operations):
    def __init__(self, folder, rules):
        self.folder, self.rules = os.path.realpath(folder), Rules(rules)

    def real(self, path):
        return self.folder + path

    # What only asks is answered at once.
    def getattr(self, path, fh=None):
        status = os.lstat(self.real(path))
        return {key: getattr(status, key) for key in dir(status) if key.startswith("st_") and not key.endswith("_ns")}

    def access(self, path, mode):
        if not os.access(self.real(path), mode):
            raise fusepy.FuseOSError(errno.EACCES)

    def statfs(self, path):
        status = os.statvfs(self.real(path))
        return {key: getattr(status, key) for key in dir(status) if key.startswith("f_") and key != "f_fsid"}

    def read(self, path, size, offset, fh):
        return os.pread(fh, size, offset)

    def readdir(self, path, fh):
        self.rules.apply("list", path)
        return [".", "..", *os.listdir(self.real(path))]

    def create(self, path, mode, fi=None):
        self.rules.apply("open", path)
        return os.open(self.real(path), os.O_RDWR | os.O_CREAT, mode)

    def open(self, path, flags):
        self.rules.apply("open", path)
        return os.open(self.real(path), flags & FLAGS)

    def write(self, path, data, offset, fh):
        self.rules.apply("write", path, len(data))
        return os.pwrite(fh, data, offset)

    def truncate(self, path, length, fh=None):
        self.rules.apply("truncate", path)
        os.truncate(self.real(path), length)

    def fsync(self, path, datasync, fh):
        self.rules.apply("fsync", path)

    def fsyncdir(self, path, datasync, fh):
        self.rules.apply("fsync", path + "/")

    def flush(self, path, fh):
        self.rules.apply("close", path)

    def release(self, path, fh):
        os.close(fh)

    def unlink(self, path):
        self.rules.apply("unlink", path)
        os.unlink(self.real(path))

    def rename(self, old, new):
        self.rules.apply("rename", new)
        os.rename(self.real(old), self.real(new))

    def mkdir(self, path, mode):
        self.rules.apply("mkdir", path)
        os.mkdir(self.real(path), mode)

    def rmdir(self, path):
        os.rmdir(self.real(path))


if __name__ == "__main__":
    fusepy.FUSE(Disk(sys.argv[1], sys.argv[3]), sys.argv[2], foreground=True, big_writes=True)
