package org.mechservice.mechml.resolve.joint;

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
import org.mechservice.solver.spatial.Vector3;

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
    refusePitch(input);
    Optional<AxisReader.Placement> placement = placement(input);
    Optional<JointStart> start = starts.read(input.start(), input.type());
    OptionalDouble pitch =
        input.type() == JointType.H ? pitch(input.element()) : OptionalDouble.of(0);
    if (placement.isEmpty() || start.isEmpty() || pitch.isEmpty()) {
      return Optional.empty();
    }
    return joint(input, placement.get(), start.get(), pitch.getAsDouble());
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

  private Optional<Joint> joint(
      JointInput input, AxisReader.Placement placement, JointStart start, double pitch) {
    String name = input.name();
    Attachment attachment = placement.attachment();
    Vector3 axis = placement.axis1();
    return switch (input.type()) {
      case R ->
          Optional.of(new Revolute(name, attachment, axis, q(start), v(start), input.origin()));
      case P ->
          Optional.of(new Prismatic(name, attachment, axis, q(start), v(start), input.origin()));
      case C -> Optional.of(new Cylindrical(name, attachment, axis, start, input.origin()));
      case H ->
          Optional.of(new Screw(name, attachment, axis, pitch, q(start), v(start), input.origin()));
      case PL ->
          axes.secondDirection(input, axis)
              .map(
                  direction ->
                      new Planar(name, attachment, axis, direction, start, false, input.origin()));
      case U ->
          Optional.of(
              new Universal(
                  name, attachment, axis, placement.axis2(), start, false, input.origin()));
      case S -> Optional.of(new Spherical(name, attachment, start, false, input.origin()));
      case F -> Optional.of(new Free(name, attachment, start, false, input.origin()));
      case W -> Optional.of(new Weld(name, attachment, input.origin()));
    };
  }

  private static double q(JointStart start) {
    return start.positions().get(0);
  }

  private static double v(JointStart start) {
    return start.velocities().get(0);
  }

  private void refusePitch(JointInput input) {
    if (input.type() != JointType.H
        && (input.element().attribute("pitch").isPresent()
            || input.element().attribute("lead").isPresent())) {
      error(
          input.element(),
          Phrase.of("a joint of type %s has no pitch; only a screw, type H, has", input.type()));
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
