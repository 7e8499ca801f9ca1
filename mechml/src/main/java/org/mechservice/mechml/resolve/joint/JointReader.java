package org.mechservice.mechml.resolve.joint;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import org.mechservice.mechml.diagnosis.Diagnostics;
import org.mechservice.mechml.diagnosis.Phrase;
import org.mechservice.mechml.document.Element;
import org.mechservice.mechml.resolve.value.ValueReader;
import org.mechservice.mechml.unit.Quantity;
import org.mechservice.solver.api.JointType;
import org.mechservice.solver.catalogue.MessageCode;
import org.mechservice.solver.mechanism.joint.Attachment;
import org.mechservice.solver.mechanism.joint.Cylindrical;
import org.mechservice.solver.mechanism.joint.Free;
import org.mechservice.solver.mechanism.joint.Joint;
import org.mechservice.solver.mechanism.joint.JointStart;
import org.mechservice.solver.mechanism.joint.Planar;
import org.mechservice.solver.mechanism.joint.Prismatic;
import org.mechservice.solver.mechanism.joint.Revolute;
import org.mechservice.solver.mechanism.joint.Screw;
import org.mechservice.solver.mechanism.joint.Spherical;
import org.mechservice.solver.mechanism.joint.Universal;
import org.mechservice.solver.mechanism.joint.Weld;
import org.mechservice.solver.spatial.EulerParameters;
import org.mechservice.solver.spatial.Rotation;
import org.mechservice.solver.spatial.Vector3;
import org.mechservice.solver.text.Origin;

/** Reads a joint of any type: its axes, its start, the pitch of a screw. */
final class JointReader {
  private final AxisReader axes;
  private final StartReader starts;
  private final ValueReader values;
  private final Diagnostics diagnostics;

  JointReader(ValueReader values, Diagnostics diagnostics) {
    this.axes = new AxisReader(diagnostics);
    this.starts = new StartReader(values, diagnostics);
    this.values = values;
    this.diagnostics = diagnostics;
  }

  /** Returns the joint with body1 as parent and body2 as child; empty after a reported error. */
  Optional<Joint> read(JointInput input) {
    return read(input.element(), input.type(), input.start(), input.origin(), placement(input));
  }

  /**
   * Returns a joint with a given placement.
   *
   * @param jointVal its start, if there is one
   * @param placement empty after a reported error
   */
  Optional<Joint> read(
      Element element,
      JointType type,
      Optional<Element> jointVal,
      Origin origin,
      Optional<AxisReader.Placement> placement) {
    refusePitch(element, type);
    Optional<JointStart> start = starts.read(jointVal, type);
    OptionalDouble pitch = type == JointType.H ? pitch(element) : OptionalDouble.of(0);
    if (placement.isEmpty() || start.isEmpty() || pitch.isEmpty()) {
      return Optional.empty();
    }
    boolean open = jointVal.flatMap(given -> given.attribute("posVals")).isEmpty();
    return Optional.of(
        joint(
            element.required("name"),
            type,
            parallel(type, placement.get()),
            open ? turned(type, placement.get(), start.get()) : start.get(),
            pitch.getAsDouble(),
            origin));
  }

  /** The axes of S and F are parallel at zero; their Euler parameters hold every rotation. */
  private static AxisReader.Placement parallel(JointType type, AxisReader.Placement placement) {
    Attachment at = placement.attachment();
    return type == JointType.S || type == JointType.F
        ? new AxisReader.Placement(
            new Attachment(
                at.parent(), at.parentPoint(), at.child(), at.childPoint(), Rotation.IDENTITY),
            placement.axis1(),
            placement.axis2(),
            placement.second())
        : placement;
  }

  /** Returns the start with the Euler parameters of the rotation at assembly. */
  private static JointStart turned(
      JointType type, AxisReader.Placement placement, JointStart start) {
    Rotation r = placement.attachment().zeroRotation();
    if ((type != JointType.S && type != JointType.F) || r.isIdentity()) {
      return start;
    }
    double[] rows = {r.xx(), r.xy(), r.xz(), r.yx(), r.yy(), r.yz(), r.zx(), r.zy(), r.zz()};
    double[] e = new double[4];
    EulerParameters.of(rows, 0, e, 0);
    List<Double> positions = new ArrayList<>(start.positions());
    for (int i = 0; i < 4; i++) {
      positions.set(i, e[i]);
    }
    return new JointStart(positions, start.velocities());
  }

  private Optional<AxisReader.Placement> placement(JointInput input) {
    return switch (input.type()) {
      case R, P, C, H -> axes.read(input);
      case PL -> axes.readPlane(input);
      case U -> axes.readCross(input);
      case S, F -> axes.readPoints(input);
      case W -> axes.readWeld(input);
    };
  }

  private static Joint joint(
      String name,
      JointType type,
      AxisReader.Placement placement,
      JointStart start,
      double pitch,
      Origin origin) {
    Attachment attachment = placement.attachment();
    Vector3 axis = placement.axis1();
    return switch (type) {
      case R -> new Revolute(name, attachment, axis, q(start), v(start), origin);
      case P -> new Prismatic(name, attachment, axis, q(start), v(start), origin);
      case C -> new Cylindrical(name, attachment, axis, start, origin);
      case H -> new Screw(name, attachment, axis, pitch, q(start), v(start), origin);
      case PL -> new Planar(name, attachment, axis, placement.second(), start, false, origin);
      case U -> new Universal(name, attachment, axis, placement.axis2(), start, false, origin);
      case S -> new Spherical(name, attachment, start, false, origin);
      case F -> new Free(name, attachment, start, false, origin);
      case W -> new Weld(name, attachment, origin);
    };
  }

  private static double q(JointStart start) {
    return start.positions().get(0);
  }

  private static double v(JointStart start) {
    return start.velocities().get(0);
  }

  private void refusePitch(Element element, JointType type) {
    if (type != JointType.H
        && (element.attribute("pitch").isPresent() || element.attribute("lead").isPresent())) {
      error(element, Phrase.of("a joint of type %s has no pitch; only a screw, type H, has", type));
    }
  }

  /** Returns the displacement per angle, m/rad. */
  private OptionalDouble pitch(Element element) {
    boolean pitch = element.attribute("pitch").isPresent();
    if (pitch == element.attribute("lead").isPresent()) {
      error(
          element,
          pitch
              ? "pitch (length per radian) and lead (length per turn) define the same quantity;"
                  + " give only one"
              : "a screw needs its pitch (length per radian) or its lead (length per turn)");
      return OptionalDouble.empty();
    }
    if (pitch) {
      return values.quantity(element, "pitch", Quantity.PITCH);
    }
    OptionalDouble lead = values.quantity(element, "lead", Quantity.LENGTH);
    return lead.isPresent() ? OptionalDouble.of(lead.getAsDouble() / (2 * Math.PI)) : lead;
  }

  private void error(Element element, String message) {
    diagnostics.error(
        MessageCode.SCREW_PITCH, element.position(), element.label() + ": " + message);
  }
}
