"""The crowd from Python: people walk, arrays show its memory, mistakes are named."""
import gc
import math
import threading
import unittest

import numpy

import pedzone

HALL = [(0, 0), (40, 0), (40, 20), (0, 20)]


def hall(**wishes):
    return pedzone.Zone.from_polygons(HALL, **wishes)


def busy_crowd(people=30, **choice):
    crowd = pedzone.Crowd(hall(), **choice)
    for k in range(people):
        crowd.add((2 + k % 6, 2 + 0.5 * k), (38, 18 - 0.5 * k), id=f"p{k}")
    return crowd


class Walking(unittest.TestCase):
    def test_somebody_reaches_its_goal_at_its_speed(self):
        crowd = pedzone.Crowd(hall(parameters={"headingNoise": 0}))
        person = crowd.add((5, 10), (30, 10), speed=1.25, velocity=(1.25, 0))
        seconds = 0.0
        while not crowd.arrived[0]:
            crowd.step(0.1)
            seconds += 0.1
            self.assertLess(seconds, 30)
        # 0.5 m before a single point it has arrived.
        self.assertAlmostEqual(seconds, (25 - 0.5) / 1.25, delta=0.2)
        self.assertAlmostEqual(crowd.person(person).position[1], 10, delta=0.01)

    def test_nobody_walks_through_a_hole(self):
        block = [(15, 5), (25, 5), (25, 15), (15, 15)]
        zone = hall(holes=[block])
        self.assertAlmostEqual(zone.area, 40 * 20 - 100)
        self.assertEqual(zone.inside([(20, 10), (5, 5)]).tolist(), [False, True])
        self.assertEqual(zone.room([(10, 10)]).tolist(), [5.0])
        for limit in (-1.0, math.nan):
            with self.assertRaises(ValueError):
                zone.room([(10, 10)], limit)
        self.assertGreater(len(zone.way((5, 10), (35, 10))), 2)
        crowd = pedzone.Crowd(zone)
        crowd.add((5, 10), (35, 10))
        places = []
        while not crowd.arrived.all():
            crowd.step(0.5)
            places.append(crowd.positions()[0])
        self.assertTrue(zone.inside(places).all())
        self.assertGreater(numpy.ptp(numpy.array(places)[:, 1]), 4)

    def test_people_wait_for_a_vehicle_that_comes(self):
        crowd = pedzone.Crowd(hall())
        person = crowd.add((20, 4), (20, 18), velocity=(0, 1.34))
        nearest, clock = math.inf, 0.0
        while clock < 6:
            van = pedzone.Vehicle("van", (2 + 5 * clock, 9), heading=0.0, speed=5.0)
            crowd.step(0.1, [van])
            clock += 0.1
            at, front = crowd.person(person).position, (2 + 5 * clock, 9)
            room = pedzone.clearance([at], [(0, 0)], [front], [(5, 0)], [0.0])[0]
            nearest = min(nearest, room)
        self.assertGreater(nearest, 0.3)
        self.assertLess(nearest, 4.0)

    def test_who_is_run_into_is_told(self):
        def pushed(let_through):
            crowd = pedzone.Crowd(hall(), model="constant-velocity")  # minds no vehicle
            person = crowd.add((20, 9), (20, 18), id="anna", speed=0.5)
            if let_through:
                crowd.let_vehicles_through()
            found = []
            for step in range(30):
                crowd.step(0.1, [pedzone.Vehicle("van", (15 + 0.8 * step, 9.5), speed=8.0)])
                found += crowd.pushes()
            return crowd.person(person), found
        person, found = pushed(False)
        self.assertEqual({(one.person, one.vehicle) for one in found},
                         {(pedzone.key_of("anna"), pedzone.key_of("van"))})
        hits = [one for one in found if one.run_into]
        self.assertTrue(hits)
        self.assertAlmostEqual(max(one.contact_speed for one in hits), 8.0)
        self.assertGreater(sum(one.way for one in found), 0.2)
        _, found = pushed(True)
        self.assertEqual(found, [])

    def test_every_model_walks(self):
        ends = {}
        for model in pedzone.MODELS:
            crowd = busy_crowd(model=model)
            for step in range(20):
                crowd.step(0.1, [pedzone.Vehicle("van", (25 - 0.3 * step, 10), math.pi, 3.0)])
            self.assertGreater(crowd.x.mean(), 5.5, model)
            ends[model] = crowd.positions().tobytes()
        self.assertEqual(len(set(ends.values())), len(pedzone.MODELS))

    def test_seed_and_id_decide_what_is_drawn(self):
        def end(seed, first_id):
            crowd = pedzone.Crowd(hall(), seed=seed)
            crowd.add((2, 10), (38, 10), id=first_id)
            for _ in range(50):
                crowd.step(0.1)
            return crowd.positions().tolist()
        self.assertEqual(end(3, "a"), end(3, "a"))
        self.assertNotEqual(end(3, "a"), end(4, "a"))
        self.assertNotEqual(end(3, "a"), end(3, "b"))

    def test_goals_speeds_groups_paths_and_those_seen(self):
        crowd = pedzone.Crowd(hall())
        line = crowd.add((5, 5), ((30, 2), (30, 9)), profile="adult", group="friends")
        tour = crowd.add((5, 15), (35, 15), path=[(20, 18), (25, 12, 2.0)])
        crowd.set_goal(line, (5, 12))
        crowd.set_speed(tour, 2.0)
        crowd.see([(20, 10)], [(0, 0)], ids=["post"])
        highest = 0.0
        while not crowd.arrived.all():
            crowd.step(0.1)
            highest = max(highest, crowd.person(tour).position[1])
        self.assertGreater(highest, 16.9)  # within 1 m of the first waypoint
        self.assertAlmostEqual(crowd.person(line).position[0], 5, delta=0.6)
        self.assertEqual(len(crowd), 2)  # who is only seen is no row

    def test_a_crowd_needs_a_zone(self):
        with self.assertRaises(TypeError):
            pedzone.Crowd(None)

    def test_who_is_removed_is_not_there(self):
        crowd = busy_crowd(4)
        second = int(crowd.handles[1])
        crowd.remove(second)
        self.assertNotIn(second, crowd)
        self.assertEqual(len(crowd), 3)
        self.assertEqual(crowd.x.shape, (3,))
        for name, call in {"remove": lambda: crowd.remove(second),
                           "person": lambda: crowd.person(second),
                           "set_goal": lambda: crowd.set_goal(77, (1, 1))}.items():
            with self.subTest(name), self.assertRaisesRegex(KeyError, "nobody .* handle"):
                call()


class Arrays(unittest.TestCase):
    def test_columns_are_the_crowds_own_memory(self):
        crowd = busy_crowd()
        for name in ("x", "y", "vx", "vy", "heading", "radius", "keys"):
            one, same = getattr(crowd, name), getattr(crowd, name)
            self.assertFalse(one.flags.owndata, name)
            self.assertEqual(one.ctypes.data, same.ctypes.data, name)
            self.assertEqual(one.shape, (len(crowd),))
        self.assertEqual(crowd.keys[3], pedzone.key_of("p3"))
        self.assertEqual(crowd.positions().tolist(), numpy.stack([crowd.x, crowd.y], 1).tolist())

    def test_they_cannot_be_written_to(self):
        x = busy_crowd().x
        with self.assertRaises(ValueError):
            x[0] = 1.0
        with self.assertRaises(ValueError):
            x.flags.writeable = True

    def test_an_array_stays_what_it_was(self):
        crowd = busy_crowd()
        x, was = crowd.x, crowd.x.copy()
        address = x.ctypes.data
        for _ in range(3):
            crowd.step(0.1)
        self.assertEqual(x.tolist(), was.tolist())
        self.assertEqual(x.ctypes.data, address)
        self.assertNotEqual(crowd.x.tolist(), was.tolist())
        before_more = crowd.vx
        for k in range(2000):  # more than any memory that the crowd had in reserve
            crowd.add((1 + k % 38, 1 + k % 18), (38, 10), place_freely=False)
        self.assertEqual(len(before_more), 30)
        crowd.remove(int(crowd.handles[0]))
        self.assertEqual(len(before_more), 30)

    def test_an_array_outlives_its_crowd(self):
        crowd = busy_crowd()
        x, was = crowd.x, crowd.x.tolist()
        del crowd
        gc.collect()
        rubbish = [busy_crowd() for _ in range(20)]  # takes the memory, if it was free
        self.assertEqual(x.tolist(), was)
        self.assertEqual(len(rubbish), 20)

    def test_arrays_that_are_held_change_nothing(self):
        def end(hold):
            crowd, held = busy_crowd(), []
            for _ in range(60):
                crowd.step(0.1)
                if hold:
                    held.append((crowd.x, crowd.vy, crowd.keys))
            return crowd.positions().tobytes()
        self.assertEqual(end(False), end(True))


class Mistakes(unittest.TestCase):
    def test_bad_input_is_an_InputError_with_the_programs_text(self):
        self.assertTrue(issubclass(pedzone.InputError, ValueError))
        cases = {
            "model: .telepathy. is no walking model; allowed: heuristic":
                lambda: hall(model="telepathy"),
            'walking model "telepathy" is not known; allowed: heuristic':
                lambda: pedzone.Crowd(hall(), model="telepathy"),
            "nothing.so. is missing":
                lambda: pedzone.Crowd(hall(), model="nothing.so"),
            "parameters: .sightt. is no parameter; allowed: sight":
                lambda: hall(parameters={"sightt": 1}),
            "parameter sight: .-1. is out of range; allowed":
                lambda: hall(parameters={"sight": -1}),
            "has no ground":
                lambda: pedzone.Zone.from_polygons([(0, 0), (1, 1)]),
            "profile: .*robot.* is no profile":
                lambda: pedzone.Crowd(hall()).add((1, 1), (2, 2), profile="robot"),
            "none.sumocfg":
                lambda: pedzone.read_zones("none.sumocfg"),
        }
        for text, call in cases.items():
            with self.subTest(text), self.assertRaisesRegex(pedzone.InputError, text):
                call()

    def test_numbers_that_make_no_sense_are_refused(self):
        crowd = pedzone.Crowd(hall())
        crowd.add((1, 1), (9, 9))
        cases = {
            "dt: .*allowed: more than 0 s": lambda: crowd.step(0),
            "dt": lambda: crowd.step(math.nan),
            "dt: .*at most 3600 s": lambda: crowd.step(1e9),
            "vehicle.*allowed": lambda: pedzone.Vehicle("v", (math.inf, 0)),
            "length": lambda: pedzone.Vehicle("v", (0, 0), length=0),
            "position": lambda: crowd.add((math.nan, 1), (2, 2)),
            r"outer: shape \(4, 3\); allowed: \(n, 2\)":
                lambda: pedzone.Zone.from_polygons(numpy.zeros((4, 3))),
        }
        for text, call in cases.items():
            with self.subTest(text), self.assertRaisesRegex(ValueError, text):
                call()
        van = pedzone.Vehicle("v", (0, 0))
        van.width = math.nan
        with self.assertRaisesRegex(ValueError, "vehicle"):
            crowd.step(0.1, [van])
        crowd.step(0.1)  # none of them has harmed the crowd

    def test_another_thread_may_not_ask_within_a_step(self):
        class Slow(pedzone.WalkingModel):
            def decide(self, snapshot):
                inside.set()
                go_on.wait(20)
                return snapshot.goal_direction[:snapshot.walking], snapshot.preferred_speed[:snapshot.walking]
        inside, go_on = threading.Event(), threading.Event()
        crowd = busy_crowd(model=Slow())
        walker = threading.Thread(target=crowd.step, args=(0.1,))
        walker.start()
        try:
            self.assertTrue(inside.wait(20))  # so the lock is free while people walk
            for call in (lambda: crowd.x, lambda: crowd.step(0.1), lambda: len(crowd)):
                with self.assertRaisesRegex(RuntimeError, "in a step"):
                    call()
        finally:
            go_on.set()
            walker.join()
        self.assertEqual(len(crowd.x), 30)


if __name__ == "__main__":
    unittest.main()
