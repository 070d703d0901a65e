#!/usr/bin/python3
"""What can go wrong between pedzone, a SUMO that it has joined, and SUMO's other clients: real
processes that are really killed.

usage: test_faults.py PEDZONE_PROGRAM
"""

import json
import signal
import socket
import subprocess
import threading
import time
import unittest
import xml.etree.ElementTree as ElementTree

import attached
from attached import HERE, LONG, AttachedCase, rows, sumo_environment


class Faults(AttachedCase):
    def summary(self):
        return json.loads((self.folder / "s.json").read_text())

    def wait_for(self, path, size=100_000):
        deadline = time.monotonic() + LONG
        while not (path.exists() and path.stat().st_size > size):
            self.assertLess(time.monotonic(), deadline, f"{path.name} does not grow")
            time.sleep(0.05)

    def wait_for_client(self):
        """Until somebody has connected to SUMO; SUMO hears its clients in the order they came."""
        deadline = time.monotonic() + LONG
        while not established(self.port):
            self.assertLess(time.monotonic(), deadline, "no client comes")
            time.sleep(0.02)

    def begun(self):
        """pedzone and a SUMO that would go on for ever, in the middle."""
        sumo = self.start_sumo(1, "--end", 10**7, "--fcd-output", "fcd.xml")
        pedzone = self.attach("--order", 1, "--end", 10**7, "--summary", "s.json",
                              "--trajectories", "t.csv")
        self.wait_for(self.folder / "fcd.xml")
        return sumo, pedzone

    def test_sumo_is_not_there(self):
        began = time.monotonic()
        pedzone = self.attach("--summary", "s.json", patience=1)
        _, errors = pedzone.communicate(timeout=LONG)
        self.assertEqual(pedzone.returncode, 3)
        self.assertIn(f"No SUMO listens at localhost:{self.port} (tried for 1 s)", errors)
        self.assertIn(f"--remote-port {self.port}", errors)
        self.assertGreater(time.monotonic() - began, 1.0)
        self.assertFalse((self.folder / "s.json").exists())

    def test_sumo_comes_later(self):
        pedzone = self.attach("--order", 1, "--end", 20, "--summary", "s.json")
        time.sleep(2.0)
        sumo = self.start_sumo(1)
        _, errors = pedzone.communicate(timeout=LONG)
        self.assertEqual(pedzone.returncode, 0, errors)
        sumo.communicate(timeout=LONG)
        self.assertEqual(sumo.returncode, 0)

    def test_something_else_listens(self):
        with socket.create_server(("127.0.0.1", self.port)) as server:
            def answer():
                connection, _ = server.accept()
                with connection:
                    connection.recv(100)
                    connection.sendall(b"HTTP/1.1 400 Bad Request\r\n\r\n")
            threading.Thread(target=answer, daemon=True).start()
            pedzone = self.attach(patience=1)
            _, errors = pedzone.communicate(timeout=LONG)
        self.assertEqual(pedzone.returncode, 3)
        self.assertIn("does not speak TraCI", errors)

    def test_another_version_of_traci(self):
        sumo = self.start_sumo(1)
        with socket.create_server(("127.0.0.1", 0)) as server:
            threading.Thread(target=newer_sumo, args=(server, self.port), daemon=True).start()
            pedzone = self.start(self.pedzone, "attach", self.config, "--port",
                                 server.getsockname()[1])
            _, errors = pedzone.communicate(timeout=LONG)
        self.assertEqual(pedzone.returncode, 3)
        self.assertRegex(errors, "speaks version 99 of TraCI; pedzone is built with version 2[0-9]")
        sumo.kill()

    def test_sumo_dies(self):
        sumo, pedzone = self.begun()
        sumo.send_signal(signal.SIGKILL)
        _, errors = pedzone.communicate(timeout=LONG)
        self.assertEqual(pedzone.returncode, 3)
        self.assertRegex(errors, r"SUMO has gone at \d+\.\d+ s")
        summary = self.summary()
        self.assertTrue(summary["sumo_gone"])
        self.assertGreater(summary["persons"]["seen"], 0)
        self.assertGreater(len(rows(self.folder / "t.csv")), 10)
        self.assertEqual([], list(self.folder.glob("*.partial")))

    def test_another_client_leaves(self):
        sumo = self.start_sumo(2)
        client = self.client("--steps", 20, "--then", "close")
        pedzone = self.attach("--order", 2, "--end", 60, "--summary", "s.json")
        _, errors = pedzone.communicate(timeout=LONG)
        self.assertEqual(pedzone.returncode, 0, errors)
        self.assertFalse(self.summary()["sumo_gone"])
        client.communicate(timeout=LONG)
        sumo.communicate(timeout=LONG)
        self.assertEqual(sumo.returncode, 0)

    def test_another_client_is_killed(self):
        self.start_sumo(2)
        self.client("--steps", 40, "--then", "die")
        pedzone = self.attach("--order", 2, "--end", 10**6, "--summary", "s.json")
        _, errors = pedzone.communicate(timeout=LONG)
        self.assertEqual(pedzone.returncode, 3, errors)
        self.assertIn("another client broke off", errors)
        self.assertTrue(self.summary()["sumo_gone"])

    def test_another_client_stops_stepping(self):
        self.start_sumo(2)
        client = self.client("--steps", 40, "--then", "hang")
        pedzone = self.attach("--order", 2, "--end", 10**6, "--summary", "s.json")
        self.assertEqual(client.stdout.readline(), "hangs\n")
        self.hear(pedzone, "Waiting since 10 s for SUMO, which waits for another of its clients")
        self.assertIsNone(pedzone.poll(), "it goes on waiting")
        pedzone.send_signal(signal.SIGINT)
        _, errors = pedzone.communicate(timeout=LONG)
        self.assertEqual(pedzone.returncode, 130, errors)
        self.assertTrue(self.summary()["interrupted"])

    def test_interrupted_it_gives_people_back(self):
        """SUMO's people, pedzone's for half of the run, arrive as if they had always been SUMO's."""
        sumo = self.start_sumo(2, "--fcd-output", "fcd.xml", "--tripinfo-output", "trips.xml")
        client = self.client("--steps", 1900)
        pedzone = self.attach("--order", 2, "--end", 10**6, "--summary", "s.json")
        self.wait_for(self.folder / "fcd.xml", 150_000)
        pedzone.send_signal(signal.SIGTERM)
        _, errors = pedzone.communicate(timeout=LONG)
        self.assertEqual(pedzone.returncode, 143, errors)
        summary = self.summary()
        self.assertTrue(summary["interrupted"])
        self.assertGreater(summary["persons"]["controlled"], summary["persons"]["arrived"])
        client.communicate(timeout=LONG)
        sumo.communicate(timeout=LONG)
        self.assertEqual(sumo.returncode, 0)
        departed = [float(trip.get("depart")) for trip in
                    ElementTree.parse(self.folder / "trips.xml").iter("personinfo")]
        # 180 m in the 950 s that the client steps: at 0.75 m/s at least.
        self.assertEqual(len([time for time in departed if time <= 700.0]), 141)

    def test_who_has_no_lane_to_change_to_walks_on_too(self):
        """SUMO takes nobody back on the lane that it has the person on: its walk begins anew."""
        self.tiny.write("tiny.rou.xml", """<routes>
          <personFlow id="f" begin="0" end="60" period="6">
            <walk edges="shared" arrivalPos="50"/><stop lane="shared_0" endPos="50" duration="1"/>
          </personFlow></routes>""")
        sumo = self.start_sumo(2, "--tripinfo-output", "trips.xml")
        client = self.client("--steps", 390)
        pedzone = self.attach("--order", 2, "--end", 30, "--trajectories", "t.csv")
        _, errors = pedzone.communicate(timeout=LONG)
        self.assertEqual(pedzone.returncode, 0, errors)
        self.assertNotIn("stand where", errors)
        client.communicate(timeout=LONG)
        sumo.communicate(timeout=LONG)
        self.assertEqual(sumo.returncode, 0)
        walked = {row["id"] for row in rows(self.folder / "t.csv")}
        self.assertEqual(len(walked), 5)
        arrived = {trip.get("id") for trip in
                   ElementTree.parse(self.folder / "trips.xml").iter("personinfo")
                   if [stop.get("arrival") for stop in trip.iter("stop")]}
        self.assertEqual(walked - arrived, set())

    def test_a_second_pedzone(self):
        self.start_sumo(2)
        first = self.attach("--order", 1, "--end", 10**6)
        second = self.attach("--order", 2, "--end", 10**6)
        deadline = time.monotonic() + LONG
        while first.poll() is None and second.poll() is None:
            self.assertLess(time.monotonic(), deadline)
            time.sleep(0.05)
        refused, other = (first, second) if first.poll() is not None else (second, first)
        _, errors = refused.communicate(timeout=LONG)
        self.assertEqual(refused.returncode, 2)
        self.assertIn("another pedzone walks the people of zone", errors)
        time.sleep(1.0)
        self.assertIsNone(other.poll(), "the other one goes on")

    def test_an_order_that_another_client_has(self):
        self.start_sumo(2)
        self.client("--order", 2)
        self.wait_for_client()
        pedzone = self.attach("--order", 2)
        _, errors = pedzone.communicate(timeout=LONG)
        self.assertEqual(pedzone.returncode, 3)
        self.assertIn("SUMO refused order 2", errors)
        self.assertIn("choose another one with --order", errors)

    def test_another_client_wants_its_order(self):
        self.start_sumo(2)
        pedzone = self.attach("--order", 2)
        self.wait_for_client()
        self.client("--order", 2)
        _, errors = pedzone.communicate(timeout=LONG)
        self.assertEqual(pedzone.returncode, 3)
        self.assertIn("two clients have the same order", errors)

    def own(self, client):
        """pedzone with a SUMO and a client that it starts itself."""
        return self.start(self.pedzone, "run", self.config, "--end", 20, "--client", client,
                          "--summary", "s.json")

    def test_a_client_of_its_own(self):
        pedzone = self.own(f"/usr/bin/python3 '{HERE}/client.py' --port {{port}} --steps 40")
        _, errors = pedzone.communicate(timeout=LONG)
        self.assertEqual(pedzone.returncode, 0, errors)
        self.assertFalse(self.summary()["sumo_gone"])

    def test_a_client_of_its_own_that_cannot_be_started(self):
        pedzone = self.own("no-such-program {port}")
        _, errors = pedzone.communicate(timeout=LONG)
        self.assertEqual(pedzone.returncode, 3)
        self.assertIn("The client that was started ended with exit code 127", errors)

    def test_a_client_of_its_own_that_is_killed(self):
        pedzone = self.own(f"/usr/bin/python3 '{HERE}/client.py' --port {{port}} --steps 20 "
                           "--then die")
        _, errors = pedzone.communicate(timeout=LONG)
        self.assertEqual(pedzone.returncode, 3)
        self.assertIn("another client broke off", errors)
        self.assertTrue(self.summary()["sumo_gone"])

    def test_a_client_of_its_own_that_goes_on_after_the_end(self):
        pedzone = self.start(
            self.pedzone, "run", self.config, "--end", 20, "--summary", "s.json", "--client",
            f"/usr/bin/python3 '{HERE}/client.py' --port {{port}} --saves found.txt; true", "--",
            "--fcd-output", "fcd.xml", "--tripinfo-output", "trips.xml",
            "--tripinfo-output.write-unfinished")
        _, errors = pedzone.communicate(timeout=LONG)
        self.assertEqual(pedzone.returncode, 0, errors)
        self.assertIn("the client that was started went on", errors)
        self.assertFalse(self.summary()["sumo_gone"])
        steps = list(ElementTree.parse(self.folder / "fcd.xml").getroot())
        self.assertLessEqual(float(steps[-1].get("time")), 20)
        self.assertGreater(float(steps[-1].get("time")), 19)
        ElementTree.parse(self.folder / "trips.xml")
        self.assertEqual((self.folder / "found.txt").read_text(), "found", "it has time to save")

    def test_a_client_of_its_own_that_breaks_off_in_the_last_step(self):
        pedzone = self.own(f"/usr/bin/python3 '{HERE}/client.py' --port {{port}} --steps 40 "
                           "--then die")
        _, errors = pedzone.communicate(timeout=LONG)
        self.assertEqual(pedzone.returncode, 3, errors)
        self.assertIn("another client broke off", errors)
        self.assertTrue(self.summary()["sumo_gone"])

    def test_a_client_of_its_own_that_ends_badly_when_all_is_over(self):
        pedzone = self.own(f"/usr/bin/python3 '{HERE}/client.py' --port {{port}} --steps 40; exit 5")
        _, errors = pedzone.communicate(timeout=LONG)
        self.assertEqual(pedzone.returncode, 3)
        self.assertIn("The client that was started ended with exit code 5", errors)
        self.assertGreaterEqual(self.summary()["time"]["simulated_s"], 20)

    def test_a_client_of_its_own_that_never_comes(self):
        pedzone = self.own("true {port}")
        _, errors = pedzone.communicate(timeout=60)
        self.assertEqual(pedzone.returncode, 3)
        self.assertIn("The client that was started ended before the run began", errors)

    def test_another_network(self):
        self.start("sumo", "-n", self.other_network(), "--remote-port", self.port)
        pedzone = self.attach("--order", 1)
        _, errors = pedzone.communicate(timeout=LONG)
        self.assertEqual(pedzone.returncode, 2)
        self.assertIn("is not the network that SUMO runs", errors)

    def other_network(self):
        net = self.folder / "other.net.xml"
        subprocess.run(["netgenerate", "--grid", "-o", net], check=True, capture_output=True,
                       env=sumo_environment())
        return net


def established(port):
    """How many connections to a port of this machine there are."""
    connected = "01"  # a state of /proc/net/tcp
    with open("/proc/net/tcp") as file:
        lines = [line.split() for line in file][1:]
    return sum(line[1].endswith(f":{port:04X}") and line[3] == connected for line in lines)


def connected(port):
    """To a SUMO that may yet have to come."""
    while True:
        try:
            return socket.create_connection(("127.0.0.1", port))
        except ConnectionRefusedError:
            time.sleep(0.05)


def newer_sumo(server, port):
    """Hands on what is said, but for the version that SUMO tells."""
    connection, _ = server.accept()
    with connection, connected(port) as sumo:
        sumo.sendall(connection.recv(100))
        answer = bytearray(sumo.recv(1000))
        # length (4), status (7), then length (1), command (1), and the version (4)
        answer[4 + 7 + 2:4 + 7 + 6] = (99).to_bytes(4, "big")
        connection.sendall(answer)
        connection.recv(100)


if __name__ == "__main__":
    attached.main(__doc__)
