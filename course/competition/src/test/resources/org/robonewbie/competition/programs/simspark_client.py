"""A client for SimSpark as people write it: it knows the league's protocol, host, port, team and number, and nothing else."""

import socket
import struct
import sys

host, port, team, number = sys.argv[1], int(sys.argv[2]), sys.argv[3], int(sys.argv[4])
link = socket.create_connection((host, port))


def send(text):
    link.sendall(struct.pack(">I", len(text)) + text.encode())


def receive():
    head = link.recv(4, socket.MSG_WAITALL)
    return link.recv(struct.unpack(">I", head)[0], socket.MSG_WAITALL).decode() if len(head) == 4 else ""


send("(scene rsg/agent/nao/nao.rsg)(syn)")
receive()
send(f"(init (unum {number})(teamname {team}))(syn)")
messages = 0
while receive():
    messages += 1
    send("(he1 1)(syn)" if messages % 100 < 50 else "(he1 -1)(syn)")
print(f"{messages} messages")
