"""Multibody simulation: models in MechML, simulated and analysed.

>>> import mechservice
>>> model = mechservice.read("examples/pendulum/pendulum.xml")
>>> motion = model.simulate(t_end=1, t_step=0.5)
>>> motion["j1.q"].round(4).tolist()
[0.0, 0.6613, 1.3977]
>>> motion.unit("j1.q")
'rad'
"""

from ._builder import Builder
from ._errors import MechError, ModelError, RunError, RunInterrupted, ServerError
from ._model import Model, parse, read, sweep
from ._service import Connection, connect
from ._stepped import Stepped
from ._trajectory import LinearSystem, Trajectory

__version__ = "0.1.0"

__all__ = [
    "Builder",
    "Connection",
    "LinearSystem",
    "MechError",
    "Model",
    "ModelError",
    "RunError",
    "RunInterrupted",
    "ServerError",
    "Stepped",
    "Trajectory",
    "connect",
    "parse",
    "read",
    "sweep",
]
