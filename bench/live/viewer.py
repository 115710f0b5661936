# SPDX-FileCopyrightText: 2026 The echoarc authors
# SPDX-License-Identifier: Apache-2.0
"""A small WebSocket client for measuring: as little work per frame as Python allows, on sockets that a selector watches.

Speaks just enough of RFC 6455: no extensions, no fragments from us; frames of the server may come in pieces.
"""

import base64
import json
import os
import socket
import struct
import time

TEXT, BINARY, CLOSE, PING, PONG = 0x1, 0x2, 0x8, 0x9, 0xA


def monotonic_us():
    return time.clock_gettime_ns(time.CLOCK_MONOTONIC) // 1000


class Closed(Exception):
    """The server ended the connection."""


class Viewer:
    """One connection. `on_text(bytes)` and `on_binary(bytes)` see the payloads as they are read."""

    def __init__(self, port, token=None, room="main", receive_buffer=None, name=None, timeout_s=10):
        self.on_text = lambda payload: None
        self.on_binary = lambda payload: None
        self.bytes_read = 0
        self.buffer = bytearray()
        self.socket = socket.socket()
        if receive_buffer:
            self.socket.setsockopt(socket.SOL_SOCKET, socket.SO_RCVBUF, receive_buffer)
        self.socket.settimeout(timeout_s)
        self.socket.connect(("127.0.0.1", port))
        self.socket.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
        self._shake_hands(port, room)
        hello = {"type": "hello", "protocol": 1}
        if token:
            hello["token"] = token
        if name:
            hello["name"] = name
        self.say(hello)

    def _shake_hands(self, port, room):
        key = base64.b64encode(os.urandom(16)).decode()
        self.socket.sendall((f"GET /ws?room={room} HTTP/1.1\r\nHost: 127.0.0.1:{port}\r\nUpgrade: websocket\r\n"
                             f"Connection: Upgrade\r\nSec-WebSocket-Key: {key}\r\nSec-WebSocket-Version: 13\r\n"
                             f"Sec-WebSocket-Protocol: echoarc.v1\r\nOrigin: http://127.0.0.1:{port}\r\n\r\n").encode())
        answer = b""
        while b"\r\n\r\n" not in answer:
            piece = self.socket.recv(4096)
            if not piece:
                raise Closed("during the handshake")
            answer += piece
        head, rest = answer.split(b"\r\n\r\n", 1)
        if b" 101 " not in head.split(b"\r\n", 1)[0]:
            raise Closed(head.split(b"\r\n", 1)[0].decode())
        self.buffer += rest

    def fileno(self):
        return self.socket.fileno()

    def say(self, message):
        self._send(TEXT, json.dumps(message).encode())

    def _send(self, opcode, payload):
        mask = os.urandom(4)
        size = len(payload)
        head = bytes([0x80 | opcode])
        head += bytes([0x80 | size]) if size < 126 else bytes([0x80 | 126]) + struct.pack(">H", size)
        body = bytes(byte ^ mask[i & 3] for i, byte in enumerate(payload))
        self.socket.sendall(head + mask + body)

    def pump(self):
        """Reads what there is (blocks for the first byte unless the socket does not) and hands out whole frames."""
        piece = self.socket.recv(1 << 18)
        if not piece:
            raise Closed("by the server")
        self.bytes_read += len(piece)
        self.buffer += piece
        self.take_frames()

    def take_frames(self):
        at, buffer = 0, self.buffer
        while len(buffer) - at >= 2:
            size, head = buffer[at + 1] & 0x7F, 2
            if size == 126:
                head = 4
            elif size == 127:
                head = 10
            if len(buffer) - at < head:
                break
            if head == 4:
                size = struct.unpack_from(">H", buffer, at + 2)[0]
            elif head == 10:
                size = struct.unpack_from(">Q", buffer, at + 2)[0]
            if len(buffer) - at < head + size:
                break
            opcode = buffer[at] & 0x0F
            payload = bytes(buffer[at + head:at + head + size])
            at += head + size
            self._frame(opcode, payload)
        del buffer[:at]

    def _frame(self, opcode, payload):
        if opcode == TEXT:
            self.on_text(payload)
        elif opcode == BINARY:
            self.on_binary(payload)
        elif opcode == PING:
            self._send(PONG, payload)
        elif opcode == CLOSE:
            code = struct.unpack(">H", payload[:2])[0] if len(payload) >= 2 else 1005
            raise Closed(str(code))

    def wait_for(self, kind, timeout_s=10):
        """The next text message of that type."""
        found = []

        def look(payload):
            message = json.loads(payload)
            if message["type"] == kind:
                found.append(message)

        before, self.on_text = self.on_text, look
        try:
            deadline = time.monotonic() + timeout_s
            self.take_frames()
            while not found:
                if time.monotonic() > deadline:
                    raise TimeoutError(f"no '{kind}' within {timeout_s} s")
                self.pump()
        finally:
            self.on_text = before
        return found[0]

    def close(self):
        self.socket.close()
