"""A street where chance decides who walks and drives when, and how fast: short runs that differ."""

import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parent.parent / "cli"))
from tiny_scenario import TinyScenario  # noqa: E402

DESIRED_SPEED = 1.25  # [m/s] of people, mean
# So few people that they walk nearly freely: with twice as many SUMO 1.18's striping holds them up,
# and of a tenth of the desired speed 8.5 % is left in the zone (1.15: 10.0 %; with this many: 10 %).

ROUTES = """<routes>
  <vType id="walker" vClass="pedestrian" desiredMaxSpeed="{speed}"
         speedFactor="normc(1,0.15,0.7,1.3)"/>
  <vType id="driver" vClass="passenger" sigma="0.5" speedFactor="normc(1,0.1,0.6,1.4)"/>
  <flow id="cars" type="driver" begin="0" end="90" probability="0.1" from="west" to="east"/>
  <personFlow id="east" type="walker" begin="0" end="90" probability="0.12">
    <walk edges="west shared east"/>
  </personFlow>
  <personFlow id="west" type="walker" begin="0" end="90" probability="0.12">
    <walk edges="east shared west"/>
  </personFlow>
</routes>"""


def random_street(folder):
    """Writes street.sumocfg and slow.sumocfg, where people want to walk at 90 % of the speed."""
    scenario = TinyScenario(folder)
    for name, share in (("street", 1.0), ("slow", 0.9)):
        scenario.write(f"{name}.rou.xml", ROUTES.format(speed=share * DESIRED_SPEED))
        config = scenario.config(routes=f"{name}.rou.xml")
        text = config.read_text().replace('end value="200"', 'end value="300"')
        scenario.write(f"{name}.sumocfg", text)
        config.unlink()
