"""Walking models written in Python."""
import unittest

import numpy

import pedzone

HALL = pedzone.Zone.from_polygons([(0, 0), (40, 0), (40, 20), (0, 20)], parameters={"headingNoise": 0})


class Straight(pedzone.WalkingModel):
    """Goes for its goal and minds nobody: as the model constant-velocity."""

    def decide(self, snapshot):
        self.seen = snapshot
        return (snapshot.goal_direction[:snapshot.walking],
                snapshot.preferred_speed[:snapshot.walking])


def crowd_of(model, people=10):
    crowd = pedzone.Crowd(HALL, model=model)
    for k in range(people):
        crowd.add((2, 2 + k), (38, 2 + k), speed=1.0 + 0.02 * k)
    return crowd


class Models(unittest.TestCase):
    def test_walks_as_the_same_model_in_c_plus_plus(self):
        mine, built_in = crowd_of(Straight()), crowd_of("constant-velocity")
        for _ in range(40):
            mine.step(0.1)
            built_in.step(0.1)
        numpy.testing.assert_allclose(mine.positions(), built_in.positions(), atol=1e-9)
        self.assertGreater(mine.x.min(), 4)

    def test_many_people_are_decided_for_on_one_thread(self):
        """More than are shared out to threads."""
        crowd = pedzone.Crowd(pedzone.Zone.from_polygons([(0, 0), (99, 0), (99, 99), (0, 99)]),
                              model=Straight())
        for k in range(3000):
            crowd.add((1 + k % 60 * 1.5, 1 + k // 60 * 1.9), (98, 98))
        before = crowd.x.mean()
        for _ in range(5):
            crowd.step(0.1)
        self.assertGreater(crowd.x.mean(), before + 0.1)

    def test_snapshot_has_everybody_and_may_be_kept(self):
        model = Straight()
        crowd = crowd_of(model, 3)
        crowd.see([(20, 10)], [(0.5, 0)])
        van = pedzone.Vehicle("van", (30, 18), heading=1.0, speed=2.0, length=6.0)
        crowd.step(0.1, [van])
        kept = model.seen
        places = kept.x.tolist()
        crowd.step(0.1)
        self.assertEqual(kept.walking, 3)
        self.assertEqual(kept.x.shape, (4,))
        self.assertEqual(kept.x.tolist(), places)
        self.assertEqual(kept.time, 0.0)
        self.assertAlmostEqual(kept.step, 0.1)
        self.assertEqual([v.key for v in kept.vehicles], [pedzone.key_of("van")])
        self.assertAlmostEqual(kept.vehicles[0].length, 6.0)

    def test_waits_are_told(self):
        class Waiting(pedzone.WalkingModel):
            def decide(self, snapshot):
                n = snapshot.walking
                return numpy.zeros(n), numpy.zeros(n), numpy.arange(n) == 1
        crowd = crowd_of(Waiting(), 2)
        for _ in range(3):
            crowd.step(0.1)
        self.assertEqual([crowd.person(int(h)).motion for h in crowd.handles][1], "waiting")

    def test_a_model_that_sets_velocities_is_followed_at_once(self):
        class AtOnce(Straight):
            sets_velocity = True
        lazy, quick = crowd_of(Straight(), 1), crowd_of(AtOnce(), 1)
        lazy.step(0.1)
        quick.step(0.1)
        self.assertAlmostEqual(quick.vx[0], 1.0, places=6)
        self.assertLess(lazy.vx[0], 0.5)


class Mistakes(unittest.TestCase):
    def decides(self, answer):
        class Model(pedzone.WalkingModel):
            def decide(self, snapshot):
                return answer
        crowd = crowd_of(Model(), 2)
        crowd.step(0.1)

    def test_what_makes_no_sense_is_refused_with_the_models_name(self):
        cases = {
            "Model: .*NoneType.*decide.*tuple .direction, speed": None,
            "direction: shape .3,.; allowed: .2,.": ([0, 0, 0], [1, 1]),
            "Model: speed of the walking model's decision.*out of range.*preferred speed":
                ([0, 0], [1, 9]),
            "Model: speed of .*-1": ([0, 0], [1, -1]),
            "direction: nan": ([0, float("nan")], [1, 1]),
            "Model: speed .*is no array of numbers": ([0, 0], "fast"),
        }
        for text, answer in cases.items():
            with self.subTest(text), self.assertRaisesRegex(ValueError, text):
                self.decides(answer)

    def test_what_it_raises_arrives_and_ends_the_crowd(self):
        class Broken(pedzone.WalkingModel):
            def decide(self, snapshot):
                raise ZeroDivisionError("my mistake")
        crowd = crowd_of(Broken())
        with self.assertRaisesRegex(ZeroDivisionError, "my mistake"):
            crowd.step(0.1)
        with self.assertRaisesRegex(RuntimeError, "failed within a step"):
            crowd.step(0.1)
        with self.assertRaisesRegex(RuntimeError, "failed within a step"):
            crowd.x

    def test_a_class_without_decide_is_told_so(self):
        class Empty(pedzone.WalkingModel):
            pass
        with self.assertRaisesRegex(NotImplementedError, "decide"):
            crowd_of(Empty()).step(0.1)
        with self.assertRaisesRegex(TypeError, "derived from pedzone.WalkingModel"):
            crowd_of(object())


if __name__ == "__main__":
    unittest.main()
