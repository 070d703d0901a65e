"""Processes and what they have started, from /proc."""

from pathlib import Path


def children(process):
    try:
        tasks = list(Path(f"/proc/{process}/task").iterdir())
        return [int(word) for task in tasks for word in (task / "children").read_text().split()]
    except OSError:  # it has ended
        return []


def family(process):
    """The process, its children, theirs, and so on."""
    found = [process]
    for one in found:
        found += children(one)
    return found


def in_use(folder):
    """Processes whose command line names something in the folder."""
    found = []
    for entry in Path("/proc").iterdir():
        if entry.name.isdigit():
            try:
                command = (entry / "cmdline").read_bytes()
            except OSError:
                continue
            if str(folder).encode() in command:
                found.append(int(entry.name))
    return found


def wait_until_none_uses(folder):
    """Those that were killed take a moment to be gone; ctest's time limit ends the wait."""
    while in_use(folder):
        pass
