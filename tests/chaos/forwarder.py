"""A Playmaker behind connections that can be cut: forwards TCP to `cls mock`."""
import select
import socket
import struct
import subprocess
import threading


class Forwarder:
    """Listens on a port; each connection is forwarded to a mock that lives as long as this."""

    def __init__(self, cls):
        self.mock = subprocess.Popen([cls, "mock", "--port", "0"], stdout=subprocess.PIPE, text=True)
        line = self.mock.stdout.readline()  # "listening on 127.0.0.1:PORT"
        self.target = ("127.0.0.1", int(line.rsplit(":", 1)[1].split()[0]))
        self.listener = socket.create_server(("127.0.0.1", 0))
        self.port = self.listener.getsockname()[1]
        self.pairs = []
        self.lock = threading.Lock()
        threading.Thread(target=self._accept, daemon=True).start()

    def _accept(self):
        while True:
            try:
                client, _ = self.listener.accept()
            except OSError:
                return
            try:
                server = socket.create_connection(self.target, 2)
            except OSError:
                client.close()
                continue
            with self.lock:
                self.pairs.append((client, server))
            threading.Thread(target=self._forward, args=(client, server), daemon=True).start()

    def _forward(self, client, server):
        other = {client: server, server: client}
        try:
            while True:
                for ready in select.select([client, server], [], [])[0]:
                    data = ready.recv(65536)
                    if not data:
                        return
                    other[ready].sendall(data)
        except (OSError, ValueError):
            pass
        finally:
            with self.lock:
                if (client, server) in self.pairs:
                    self.pairs.remove((client, server))
            client.close()
            server.close()

    def cut(self, reset):
        """Ends all connections; with `reset` without the goodbye of TCP."""
        with self.lock:
            pairs = list(self.pairs)
        for pair in pairs:
            for end in pair:
                try:
                    if reset:
                        end.setsockopt(socket.SOL_SOCKET, socket.SO_LINGER, struct.pack("ii", 1, 0))
                    end.shutdown(socket.SHUT_RDWR)
                except OSError:
                    pass

    def close(self):
        self.listener.close()
        self.cut(False)
        self.mock.kill()
        self.mock.wait()
