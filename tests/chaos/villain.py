"""A program of a sandboxed team that takes more than its part of the host, until it is ended.

    villain.py burner PLAYER_PORT    keeps all processors busy
    villain.py flooder PLAYER_PORT   asks the server to connect without end, from many sockets
    villain.py filler PLAYER_PORT    fills the disk
"""
import os
import socket
import sys
import time

BURNERS = 16
# Teams in whose name it asks: the others, and one that does not exist. Its own players it would take
# over from its own programs, and so end its matches.
FLOODED = ("T1", "T3", "T4")
SOCKETS = 400
FILLED = 64 << 20


def burn(_port):
    for _ in range(BURNERS):
        if os.fork() == 0:
            os.setsid()
            while True:
                pass


def flood(port):
    """From sockets that are closed at once, next to many that stay open."""
    for team in FLOODED:
        if os.fork() != 0:
            continue
        held = [socket.socket(socket.AF_INET, socket.SOCK_DGRAM) for _ in range(SOCKETS)]
        while held:
            for player in range(1, 12):
                with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as peer:
                    peer.sendto(f"(reconnect {team} {player})\0".encode(), ("127.0.0.1", port))
            time.sleep(0.01)


def fill(_port):
    """With a file that has no name any more; the team plays on meanwhile."""
    time.sleep(1.0)
    path = os.path.join(os.environ["TMPDIR"], "filler")
    with open(path, "wb", buffering=0) as file:
        os.unlink(path)
        written = 0
        while written < FILLED:
            try:
                written += file.write(bytes(1 << 20))
            except OSError:
                break
        time.sleep(600)


def main():
    deeds = {"burner": burn, "flooder": flood, "filler": fill}
    deeds[sys.argv[1]](int(sys.argv[2]))
    time.sleep(600)


if __name__ == "__main__":
    main()
