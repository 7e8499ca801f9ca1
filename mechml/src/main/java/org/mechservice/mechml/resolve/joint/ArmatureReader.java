package org.mechservice.mechml.resolve.joint;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import org.mechservice.mechml.diagnosis.Diagnostics;
import org.mechservice.mechml.diagnosis.Phrase;
import org.mechservice.mechml.document.Element;
import org.mechservice.mechml.resolve.value.AttributeText;
import org.mechservice.mechml.resolve.value.ValueReader;
import org.mechservice.mechml.unit.Quantity;
import org.mechservice.mechml.unit.Unit;
import org.mechservice.solver.api.JointType;
import org.mechservice.solver.catalogue.MessageCode;
import org.mechservice.solver.mechanism.Armature;

/**
 * Reads the attributes {@code armature} and {@code gearRatio} of joints: what a rotor adds to the
 * inertia of a coordinate, its own inertia times the square of the ratio.
 */
public final class ArmatureReader {
  private final ValueReader values;
  private final Diagnostics diagnostics;

  public ArmatureReader(ValueReader values, Diagnostics diagnostics) {
    this.values = values;
    this.diagnostics = diagnostics;
  }

  /** Returns whether a joint has an armature. */
  static boolean isGiven(Element joint) {
    return joint.attribute("armature").isPresent();
  }

  /**
   * Returns the armature of a joint; empty if it has none or after a reported error.
   *
   * @param cut whether the joint closes a loop
   * @param index among the joints of the tree
   */
  public Optional<Armature> read(JointLink joint, boolean cut, int index) {
    Element element = joint.element();
    if (!isGiven(element)) {
      if (element.attribute("gearRatio").isPresent()) {
        error(element, "gearRatio is that of an armature; give armature beside it");
      }
      return Optional.empty();
    }
    JointType type = joint.type();
    if (type == JointType.W) {
      error(element, "a weld does not move and has no armature");
      return Optional.empty();
    }
    if (cut) {
      error(
          element,
          "it closes a loop, and only joints of the tree have an armature; write cut=\"true\" in a"
              + " joint of the loop without armature");
      return Optional.empty();
    }
    Optional<List<Double>> own = list(element, "armature", quantities(type));
    Optional<List<Double>> ratios =
        element.attribute("gearRatio").isPresent()
            ? list(element, "gearRatio", Collections.nCopies(groups(type), Quantity.NUMBER))
            : Optional.of(Collections.nCopies(groups(type), 1.0));
    if (own.isEmpty() || ratios.isEmpty()) {
      return Optional.empty();
    }
    List<Double> inertias = new ArrayList<>();
    for (int k = 0; k < type.velocityCount(); k++) {
      int group = group(type, k);
      double ratio = ratios.get().get(group);
      double inertia = ratio * ratio * own.get().get(group);
      if (!(inertia >= 0 && Double.isFinite(inertia))) {
        error(element, Phrase.of("its armature is %s; it must not be negative", inertia));
        return Optional.empty();
      }
      inertias.add(inertia);
    }
    return Optional.of(new Armature(index, inertias));
  }

  /** Returns the number of values: the rotations of S and F share one, as do the ways of F. */
  private static int groups(JointType type) {
    return group(type, type.velocityCount() - 1) + 1;
  }

  private static int group(JointType type, int velocity) {
    return type == JointType.S || type == JointType.F ? velocity / 3 : velocity;
  }

  private static List<Quantity> quantities(JointType type) {
    List<Quantity> quantities = new ArrayList<>();
    for (int k = 0; k < type.velocityCount(); k++) {
      if (group(type, k) == quantities.size()) {
        boolean turns = type.velocityUnit(k).startsWith("rad");
        quantities.add(turns ? Quantity.INERTIA : Quantity.MASS);
      }
    }
    return quantities;
  }

  /** A unit beside a list of several quantities applies to the items of its dimension. */
  private Optional<List<Double>> list(
      Element element, String attribute, List<Quantity> quantities) {
    List<AttributeText> items = AttributeText.itemsOf(element, attribute);
    if (!values.hasCount(items, quantities.size())) {
      return Optional.empty();
    }
    List<Double> read = new ArrayList<>();
    for (int i = 0; i < items.size(); i++) {
      AttributeText item = items.get(i);
      OptionalDouble value = OptionalDouble.empty();
      Optional<Unit> unit = values.unitOfItem(element, attribute, quantities.get(i));
      if (unit.isPresent()) {
        value = values.evaluate(item, unit.get());
      }
      value.ifPresent(read::add);
    }
    return read.size() == items.size() ? Optional.of(read) : Optional.empty();
  }

  private void error(Element element, String message) {
    diagnostics.error(MessageCode.ARMATURE, element.position(), element.label() + ": " + message);
  }
}
