"""Models built in code; written by python/write-stubs from the classes in Java."""

import os
from typing import Any, Sequence, Union, overload

from typing_extensions import Self

from ._model import Model

class Element:
    """An element of a model that is built: each verb is that of the class in Java."""

    def __init__(self, java: Any) -> None: ...
    def element(self, element: str, *attributes: str) -> OtherElement:
        """Adds any element that the grammar allows in this one, at the last place where it may stand."""
        ...
    @overload
    def set(self, attribute: str, value: str) -> Self:
        """Sets an attribute"""
        ...
    @overload
    def set(self, attribute: str, *values: float) -> Self:
        """Sets an attribute to numbers, written so that they are read back exactly."""
        ...
    @overload
    def set(self, attribute: str, value: float, unit: str) -> Self:
        """Sets an attribute to a number and its unit beside it: as ``kUnit`` for ``k`` if there is such an attribute, else as ``unit``."""
        ...
    @overload
    def set(self, attribute: str, value: str, unit: str) -> Self:
        """Sets an attribute to an expression and its unit beside it."""
        ...
    def unit(self, unit: str) -> Self:
        """Sets the attribute ``unit``."""
        ...

class BodyElement(Element):
    def box(self, x: float, y: float, z: float) -> OtherElement:
        """Adds a box with its edges along the axes"""
        ...
    def center(self, x: float, y: float, z: float) -> Self:
        """Gives the body its centre of mass."""
        ...
    def cone(self, radius: float, from_: str, to: str) -> OtherElement:
        """Adds a pointed cone"""
        ...
    def cylinder(self, radius: float, from_: str, to: str) -> OtherElement:
        """Adds a cylinder"""
        ...
    @overload
    def inertia(self, ixx: float, iyy: float, izz: float) -> Self:
        """Gives the body its moments of inertia about the centre of mass."""
        ...
    @overload
    def inertia(self, ixx: float, iyy: float, izz: float, ixy: float, ixz: float, iyz: float) -> Self:
        """Gives the body its inertia about the centre of mass"""
        ...
    @overload
    def mass(self, value: float) -> Self:
        """Gives the body a mass."""
        ...
    @overload
    def mass(self, value: float, unit: str) -> Self:
        """Gives the body a mass in a unit of its own."""
        ...
    def point(self, name: str, x: float, y: float, z: float) -> Self:
        """Adds a point."""
        ...
    def sphere(self, radius: float) -> OtherElement:
        """Adds a sphere about the origin, or about its ``point`` if that is set."""
        ...
    def vector(self, name: str, vx: float, vy: float, vz: float) -> Self:
        """Adds a vector"""
        ...

class ConnectionElement(Element):
    def at(self, x: float, y: float, z: float) -> Self:
        """Gives a joint the place of its point in the world at assembly, in the model's unit."""
        ...
    def axis(self, x: float, y: float, z: float) -> Self:
        """Gives a joint the direction of its axis in the world at assembly."""
        ...
    @overload
    def between(self, body1: str, point1: str, body2: str, point2: str) -> Self:
        """Connects a point of a body with a point of another."""
        ...
    @overload
    def between(self, body1: str, body2: str) -> Self:
        """Connects two bodies by a joint whose place in the world is given."""
        ...
    def secondAxis(self, x: float, y: float, z: float) -> Self:
        """Gives a joint the direction of its second axis in the world at assembly."""
        ...
    def secondVectors(self, vector1: str, vector2: str) -> Self:
        """Gives both bodies, which are connected with points already, their second vector each."""
        ...
    def vectors(self, vector1: str, vector2: str) -> Self:
        """Gives both bodies, which are connected with points already, one of their vectors each."""
        ...

class SimulationElement(Element):
    def columns(self, *groups: str) -> Self:
        """Chooses groups of columns, such as ``energy``."""
        ...
    def event(self, name: str, expression: str, action: str) -> OtherElement:
        """Adds an event at the zeros of an expression."""
        ...
    def formulation(self, name: str) -> Self:
        """Chooses a formulation: ``auto``, ``DTR``, ``RR`` etc."""
        ...
    def integrator(self, name: str, relative: float, *absolute: float) -> Self:
        """Chooses an integrator, such as ``ode113`` or ``auto``."""
        ...
    def named(self, name: str) -> Self:
        """Gives it a name, by which ``MechModel#simulation`` chooses it."""
        ...
    def time(self, tStart: float, tEnd: float, tStep: float) -> Self:
        """Sets start, end and distance of the rows, s."""
        ...

class OtherElement(Element):
    ...

class Builder(Element):
    """Builds a model with the verbs of ``MechanismBuilder`` in docs/library.md."""

    def __init__(
        self, name: str, mass_units: str = "kg", length_units: str = "m"
    ) -> None: ...
    def body(self, name: str) -> BodyElement:
        """Adds a body."""
        ...
    def boxContact(self, name: str, box: str, stiffness: float) -> ConnectionElement:
        """Adds a contact of the corners of a box of body 2, given by its edges, with a plane."""
        ...
    def bushing(self, name: str) -> ConnectionElement:
        """Adds a bushing between two frames."""
        ...
    def contact(self, name: str, stiffness: float) -> ConnectionElement:
        """Adds a contact of a point or sphere of body 2 with a plane of body 1."""
        ...
    def coordinateConstraint(self, name: str, expression: str) -> Self:
        """Adds a constraint by which an expression of joint coordinates is zero."""
        ...
    def couplingSpringDamper(self, name: str, expression: str) -> OtherElement:
        """Adds a spring and damper along an expression of positions"""
        ...
    def discContact(self, name: str, radius: float, stiffness: float) -> ConnectionElement:
        """Adds a contact of the edge of a disc of body 2 with a plane of body 1."""
        ...
    def distance(self, name: str, distance: float) -> ConnectionElement:
        """Adds a constraint that keeps two points at a distance."""
        ...
    def drive(self, joint: str, motion: str) -> OtherElement:
        """Prescribes the motion of a joint: an expression of the time ``t`` for each coordinate, separated by semicolons"""
        ...
    def dynamic(self, tEnd: float, tStep: float) -> SimulationElement:
        """Adds a simulation of the motion from t = 0."""
        ...
    def elasticRope(self, name: str, k: float, length0: float) -> OtherElement:
        """Adds a rope that only pulls, with its stiffness and its length without load."""
        ...
    def forceTorque(self, name: str, body: str, point: str) -> OtherElement:
        """Adds a force and a torque at a point"""
        ...
    def friction(self, name: str, joint: str) -> OtherElement:
        """Adds friction in a joint."""
        ...
    def gravity(self, gx: float, gy: float, gz: float) -> Self:
        """Adds gravity."""
        ...
    def input(self, name: str) -> OtherElement:
        """Adds a signal from outside, which ``SteppedModel#input`` sets."""
        ...
    def inverseDynamic(self, tEnd: float, tStep: float) -> SimulationElement:
        """Adds a computation of the forces that produce a prescribed motion, from t = 0."""
        ...
    def joint(self, name: str, type: str) -> ConnectionElement:
        """Adds a joint."""
        ...
    def jointConstraint(self, name: str, type: str) -> ConnectionElement:
        """Adds the equations of a joint, without coordinates of its own."""
        ...
    def jointForce(self, name: str, joint: str, expression: str) -> OtherElement:
        """Adds the force of a joint along its coordinate, an expression."""
        ...
    def kinematic(self, tEnd: float, tStep: float) -> SimulationElement:
        """Adds a simulation of driven coordinates without forces, from t = 0."""
        ...
    def knifeEdge(self, name: str) -> ConnectionElement:
        """Adds a knife edge."""
        ...
    def map(self, name: str, x: Sequence[float], y: Sequence[float], z: Sequence[Sequence[float]]) -> OtherElement:
        """Adds a function of two arguments on a grid, for use in expressions."""
        ...
    def mechml(self) -> str:
        """Returns the model as canonical MechML text."""
        ...
    def model(self) -> Model:
        """Returns the model."""
        ...
    def output(self, name: str, expression: str) -> OtherElement:
        """Adds a column of results, an expression."""
        ...
    @overload
    def parameter(self, name: str, value: float) -> Self:
        """Adds a number for use in expressions, without unit."""
        ...
    @overload
    def parameter(self, name: str, value: float, unit: str) -> Self:
        """Adds a number for use in expressions."""
        ...
    def pid(self, name: str, measured: str) -> OtherElement:
        """Adds a controller of a measured value, an expression"""
        ...
    def pointOnLine(self, name: str) -> ConnectionElement:
        """Adds a constraint that keeps a point of body 2 on a line of body 1."""
        ...
    def pointOnPlane(self, name: str) -> ConnectionElement:
        """Adds a constraint that keeps a point of body 2 on a plane of body 1."""
        ...
    def rolling(self, name: str, radius: float) -> ConnectionElement:
        """Adds a wheel or ball that rolls on a plane of body 1."""
        ...
    def root(self, name: str) -> BodyElement:
        """Adds the body at rest, to which all others are connected."""
        ...
    def rope(self, name: str, length: float) -> OtherElement:
        """Adds a rope of constant length"""
        ...
    def sampled(self, name: str, value: str, period: float) -> OtherElement:
        """Adds a value that is taken once in a period, s, and constant in between."""
        ...
    def simulation(self, task: str) -> SimulationElement:
        """Adds a simulation."""
        ...
    def sphereContact(self, name: str, radius2: float, stiffness: float) -> ConnectionElement:
        """Adds a contact of a sphere of body 2 with a sphere, capsule or box of body 1, whose sizes are to be set."""
        ...
    def springDamper(self, name: str) -> ConnectionElement:
        """Adds a spring and damper between two points"""
        ...
    @overload
    def start(self, joint: str, position: float, velocity: float) -> OtherElement:
        """Starts a joint with one coordinate at a position and a velocity."""
        ...
    @overload
    def start(self, joint: str) -> OtherElement:
        """Returns the start of a joint, whose ``posVals``, ``velVals`` and so on are to be set"""
        ...
    def state(self, name: str, derivative: str) -> OtherElement:
        """Adds a state with its derivative, an expression."""
        ...
    def table(self, name: str, x: Sequence[float], y: Sequence[float]) -> OtherElement:
        """Adds a function of one argument through points, for use in expressions."""
        ...
    def torsionSpringDamper(self, name: str, joint: str) -> OtherElement:
        """Adds a spring and damper at an angle of a joint."""
        ...
    def transferFunction(self, name: str, input: str, num: Sequence[float], den: Sequence[float]) -> OtherElement:
        """Adds a transfer function num(s)/den(s) of an input, highest powers first."""
        ...
    def tyre(self, name: str, radius: float, stiffness: float) -> ConnectionElement:
        """Adds a tyre between a wheel, body 2, and a road of body 1"""
        ...
    def writeMechml(self, path: "Union[str, os.PathLike[str]]") -> Model:
        """Writes the model to a file and reads it from there."""
        ...
