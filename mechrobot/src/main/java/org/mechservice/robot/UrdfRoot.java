package org.mechservice.robot;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.mechservice.mechml.document.Element;
import org.mechservice.robot.Robot.Frame;
import org.mechservice.solver.spatial.Rotation;
import org.mechservice.solver.spatial.Vector3;
import org.mechservice.solver.text.Origin;

/**
 * The inertia of the root, which the mechanism has no use for and URDF keeps: other programs let
 * the root move. It is taken from the file, where its numbers are plain ones in kg and m.
 */
final class UrdfRoot {
  private static final List<String> MOMENTS = List.of("Ixx", "Ixy", "Ixz", "Iyy", "Iyz", "Izz");

  private final Element file;
  private final ExportLosses losses;

  UrdfRoot(Element file, ExportLosses losses) {
    this.file = file;
    this.losses = losses;
  }

  /** Returns the element {@code inertial} of the root; empty if it has no mass. */
  Optional<TagBuilder> inertial(String name) {
    Optional<Element> model = file.child("MBSmodel");
    Optional<Element> body =
        model.flatMap(
            one ->
                one.children("Bodies").stream()
                    .flatMap(all -> all.children("body").stream())
                    .filter(b -> b.attribute("name").filter(name::equals).isPresent())
                    .findFirst());
    Optional<Element> mass = body.flatMap(b -> b.child("mass"));
    if (mass.isEmpty()) {
      return Optional.empty();
    }
    boolean si =
        model
            .filter(one -> has(one, "massUnits", "kg") && has(one, "lengthUnits", "m"))
            .isPresent();
    Optional<Double> value = number(mass, "value");
    Optional<Element> cog = body.flatMap(b -> b.child("cog"));
    Optional<Element> tensor = body.flatMap(b -> b.child("inertiaTensor"));
    List<Double> centre = numbers(cog, List.of("x", "y", "z"));
    List<Double> moments = numbers(tensor, MOMENTS);
    if (!si || value.isEmpty() || centre.isEmpty() || moments.isEmpty()) {
      losses.add(
          new Origin("", mass.get().position().line()),
          "mass and inertia of the root are left out: only plain numbers in kg and m are written");
      return Optional.empty();
    }
    if (value.get() == 0) {
      return Optional.empty();
    }
    TagBuilder inertial = new TagBuilder("inertial");
    Vector3 at = new Vector3(centre.get(0), centre.get(1), centre.get(2));
    UrdfFrames.origin(new Frame(at, Rotation.IDENTITY)).ifPresent(inertial::add);
    inertial.add(new TagBuilder("mass").set("value", value.get()));
    TagBuilder inertia = new TagBuilder("inertia");
    for (int i = 0; i < MOMENTS.size(); i++) {
      inertia.set(MOMENTS.get(i).replace('I', 'i'), moments.get(i));
    }
    return Optional.of(inertial.add(inertia));
  }

  private static boolean has(Element model, String attribute, String value) {
    return model.attribute(attribute).filter(value::equals).isPresent();
  }

  /** Returns the numbers of an element, 0 for one that is not there; none if one is no number. */
  private static List<Double> numbers(Optional<Element> element, List<String> names) {
    List<Double> all = new ArrayList<>();
    for (String name : names) {
      Optional<Double> one =
          element.flatMap(e -> e.attribute(name)).isEmpty()
              ? Optional.of(0.0)
              : number(element, name);
      if (one.isEmpty() || element.flatMap(e -> e.attribute("unit")).isPresent()) {
        return List.of();
      }
      all.add(one.get());
    }
    return all;
  }

  private static Optional<Double> number(Optional<Element> element, String name) {
    return element
        .filter(e -> e.attribute("unit").isEmpty())
        .flatMap(e -> e.attribute(name))
        .map(String::strip)
        .filter(text -> text.matches("[+-]?(\\d+\\.?\\d*|\\.\\d+)([eE][+-]?\\d+)?"))
        .map(Double::parseDouble)
        .filter(Double::isFinite);
  }
}
