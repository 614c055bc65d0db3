"""A faulty network between teams and a soccer server: forwards UDP, and loses, cuts, repeats, delays,
exchanges, changes and invents datagrams to the teams."""
import random
import selectors
import socket
import threading
import time

PORTS = 3  # players, trainer, coaches: neighbors, as teams expect them
INVENTIONS = [b"", b"(\0", b"(think)\0", b"(init l 3 before_kick_off)\0", b"(init r 12 play_on)\0",
              b"(error unsupported_version)\0", b"(sense_body 2147483647)\0",
              b"(hear 5 referee goal_l_99999999999)\0", b"(ok synch_see)\0", b"\xff\xfe\x1b[2J",
              b"(server_param (synch_mode 0))\0", b"(" * 8000]


def free_ports():
    """The first of three neighboring UDP ports that are free now."""
    while True:
        first = random.randint(20000, 32000)
        try:
            for port in range(first, first + PORTS):
                with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as probe:
                    probe.bind(("127.0.0.1", port))
            return first
        except OSError:
            continue


class Client:
    """A client of the server: it is known by its address and the port that it asked."""

    def __init__(self, address):
        self.address = address
        # As the server does, the liar answers each client from a port of its own.
        self.down = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
        self.up = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
        for end in (self.down, self.up):
            end.bind(("127.0.0.1", 0))
            end.setblocking(False)
        self.server = None
        self.old = []


class Liar:
    def __init__(self, seed, server_port, honest=0, rate=0.2):
        """Forwards to the server at `server_port` and the two ports after it. Tells the truth in the
        first `honest` datagrams."""
        self.random = random.Random(seed)
        self.rate = rate
        self.honest = honest
        self.port = free_ports()
        self.server_port = server_port
        self.lies = self.messages = 0
        self.late = []  # time, client, datagram
        self.selector = selectors.DefaultSelector()
        self.clients = {}
        self.open = True
        for offset in range(PORTS):
            listener = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
            listener.bind(("127.0.0.1", self.port + offset))
            listener.setblocking(False)
            self.selector.register(listener, selectors.EVENT_READ, ("ask", offset))
        self.thread = threading.Thread(target=self._run, daemon=True)
        self.thread.start()

    def close(self):
        self.open = False
        self.thread.join()
        for key in list(self.selector.get_map().values()):
            key.fileobj.close()
        self.selector.close()

    def _run(self):
        while self.open:
            for key, _ in self.selector.select(0.01):
                kind, what = key.data
                try:
                    while True:
                        datagram, sender = key.fileobj.recvfrom(65536)
                        if kind == "ask":
                            self._ask(what, datagram, sender)
                        elif kind == "up":
                            what.server = sender
                            self._answer(what, datagram)
                        elif what.server is not None:
                            what.up.sendto(datagram, what.server)
                except OSError:
                    pass
            now = time.monotonic()
            due = [entry for entry in self.late if entry[0] <= now]
            self.late = [entry for entry in self.late if entry[0] > now]
            for _, client, datagram in due:
                self._send(client, datagram)

    def _ask(self, offset, datagram, sender):
        client = self.clients.get((offset, sender))
        if client is None:
            client = self.clients[offset, sender] = Client(sender)
            self.selector.register(client.down, selectors.EVENT_READ, ("down", client))
            self.selector.register(client.up, selectors.EVENT_READ, ("up", client))
        client.up.sendto(datagram, ("127.0.0.1", self.server_port + offset))

    @staticmethod
    def _send(client, datagram):
        try:
            client.down.sendto(datagram, client.address)
        except OSError:
            pass

    def _answer(self, client, datagram):
        self.messages += 1
        if len(client.old) < 40 or self.random.random() < 0.02:
            client.old.append(datagram)
        if self.messages <= self.honest or self.random.random() >= self.rate:
            return self._send(client, datagram)
        self.lies += 1
        kind = self.random.randrange(8)
        if kind == 1:
            datagram = datagram[:self.random.randrange(len(datagram) + 1)]
        elif kind == 2:
            self._send(client, datagram)
        elif kind in (3, 4):
            delay = self.random.choice([0.001, 0.01, 0.1, 1.0])
            return self.late.append((time.monotonic() + delay, client, datagram))
        elif kind == 5:
            changed = bytearray(datagram)
            for _ in range(self.random.randint(1, 8)):
                if changed:
                    changed[self.random.randrange(len(changed))] = self.random.choice(b"0159-.e()\0 x\xff")
            datagram = bytes(changed)
        elif kind == 6:
            self._send(client, self.random.choice(client.old))
        elif kind == 7:
            self._send(client, self.random.choice(INVENTIONS))
        if kind != 0:  # lost
            self._send(client, datagram)
        return None
