package org.mechservice.mechml.resolve.formula;

import java.util.Optional;
import java.util.regex.Pattern;
import org.mechservice.mechml.diagnosis.Diagnostics;
import org.mechservice.mechml.diagnosis.Phrase;
import org.mechservice.mechml.diagnosis.Quoted;
import org.mechservice.mechml.document.Element;
import org.mechservice.solver.api.JointType;
import org.mechservice.solver.catalogue.MessageCode;

/**
 * Reads the attributes {@code joint} and {@code component}. A joint of one coordinate needs no
 * component; components count from 0.
 */
public final class CoordinateReader {
  private static final Pattern COMPONENT = Pattern.compile("[0-9]");

  private final MechanismNames names;
  private final Diagnostics diagnostics;

  public CoordinateReader(MechanismNames names, Diagnostics diagnostics) {
    this.names = names;
    this.diagnostics = diagnostics;
  }

  /** Returns a position coordinate whose rate is a velocity coordinate. */
  public Optional<ResolvedCoordinate> position(Element element) {
    Optional<ResolvedCoordinate> place =
        names
            .jointOf(element, "joint")
            .flatMap(joint -> place(element, joint, joint.type().positionCount()));
    if (place.isEmpty()) {
      return place;
    }
    JointType type = place.get().joint().type();
    if (type.positionUnit(place.get().component()).equals("1")) {
      error(
          element,
          Phrase.of(
              "component %d of a joint of type %s is an Euler parameter, which has no velocity or"
                  + " force of its own",
              place.get().component(), type));
      return Optional.empty();
    }
    boolean turns = type.positionUnit(place.get().component()).equals("rad");
    return place.map(p -> new ResolvedCoordinate(p.joint(), p.component(), turns));
  }

  /** Returns a coordinate by its velocity. */
  public Optional<ResolvedCoordinate> velocity(Element element) {
    return names
        .jointOf(element, "joint")
        .flatMap(joint -> place(element, joint, joint.type().velocityCount()))
        .map(p -> new ResolvedCoordinate(p.joint(), p.component(), p.joint().turns(p.component())));
  }

  private Optional<ResolvedCoordinate> place(Element element, ResolvedJoint joint, int count) {
    Optional<String> given = element.attribute("component").map(String::strip);
    if (given.isEmpty() && count == 1) {
      return Optional.of(new ResolvedCoordinate(joint, 0, false));
    }
    if (given.isPresent() && COMPONENT.matcher(given.get()).matches()) {
      int component = Integer.parseInt(given.get());
      if (component < count) {
        return Optional.of(new ResolvedCoordinate(joint, component, false));
      }
    }
    String found = given.map(g -> "component is " + Quoted.of(g)).orElse("component is missing");
    error(
        element,
        Phrase.of(
            "%s; joint %s of type %s has %s",
            found,
            Quoted.of(joint.element().required("name")),
            joint.type(),
            switch (count) {
              case 0 -> "none: it is a weld";
              case 1 -> "0 only";
              default -> "0 to " + (count - 1);
            }));
    return Optional.empty();
  }

  private void error(Element element, String message) {
    diagnostics.error(
        MessageCode.UNKNOWN_COORDINATE, element.position(), element.label() + ": " + message);
  }
}
