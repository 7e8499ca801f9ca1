package org.mechservice.mechml.robot;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Collectors;
import org.mechservice.mechml.document.Element;
import org.mechservice.mechml.robot.Robot.Frame;
import org.mechservice.mechml.unit.Unit;
import org.mechservice.mechml.unit.UnitSymbols;
import org.mechservice.solver.spatial.Rotation;
import org.mechservice.solver.spatial.Vector3;
import org.mechservice.solver.text.Origin;
import org.mechservice.solver.text.ShortestDecimal;

/**
 * The shapes of the bodies of a model: their geometry files and solids as visuals of URDF. Sizes
 * that are expressions, and cones, which URDF lacks, are reported as lost; the inertia of the body
 * does not depend on them.
 */
final class UrdfShapes {
  private static final Vector3 Z = new Vector3(0, 0, 1);
  private static final List<String> SOLIDS = List.of("box", "cylinder", "cone", "sphere", "mesh");

  private final Map<String, Element> bodies;
  private final ExportLosses losses;
  private final Unit length;

  UrdfShapes(Element file, ExportLosses losses) {
    this.losses = losses;
    List<Element> models = file.children("MBSmodel");
    bodies =
        models.stream()
            .flatMap(model -> model.children("Bodies").stream())
            .flatMap(all -> all.children("body").stream())
            .collect(
                Collectors.toMap(
                    body -> body.required("name"), b -> b, (a, b) -> a, LinkedHashMap::new));
    length =
        models.stream()
            .flatMap(model -> model.attribute("lengthUnits").stream())
            .flatMap(symbol -> UnitSymbols.unit(symbol).stream())
            .findFirst()
            .orElse(Unit.ONE);
  }

  /**
   * Returns the visuals of a body.
   *
   * @param body its name
   * @param frame of the body in the link, along its axes, m
   */
  List<TagBuilder> of(String body, Vector3 frame) {
    Optional<Element> element = Optional.ofNullable(bodies.get(body));
    List<TagBuilder> visuals = new ArrayList<>();
    element
        .flatMap(e -> e.attribute("graphSrc"))
        .ifPresent(
            source ->
                visuals.add(
                    visual(
                        new Frame(frame, Rotation.IDENTITY),
                        new TagBuilder("mesh").set("filename", source))));
    for (Element shape : element.map(Element::children).orElse(List.of())) {
      if (SOLIDS.contains(shape.name())) {
        Optional<TagBuilder> visual = solid(element.orElseThrow(), shape, frame);
        visual.ifPresent(visuals::add);
        if (visual.isEmpty()) {
          losses.add(
              new Origin("", shape.position().line()),
              shape.name()
                  + " of body \""
                  + body
                  + "\": URDF cannot show it; its mass and inertia are kept");
        }
      }
    }
    return visuals;
  }

  private static TagBuilder visual(Frame frame, TagBuilder shape) {
    TagBuilder visual = new TagBuilder("visual");
    UrdfFrames.origin(frame).ifPresent(visual::add);
    return visual.add(new TagBuilder("geometry").add(shape));
  }

  private Optional<TagBuilder> solid(Element body, Element shape, Vector3 frame) {
    return switch (shape.name()) {
      case "box" -> box(body, shape, frame);
      case "sphere" -> sphere(body, shape, frame);
      case "cylinder" -> cylinder(body, shape, frame);
      default -> Optional.empty();
    };
  }

  private Optional<TagBuilder> box(Element body, Element box, Vector3 frame) {
    Optional<Double> x = size(box, "x");
    Optional<Double> y = size(box, "y");
    Optional<Double> z = size(box, "z");
    Optional<Vector3> center = center(body, box);
    if (x.isEmpty() || y.isEmpty() || z.isEmpty() || center.isEmpty()) {
      return Optional.empty();
    }
    String sides = UrdfFrames.text(new Vector3(x.get(), y.get(), z.get()));
    return Optional.of(
        visual(
            new Frame(frame.plus(center.get()), Rotation.IDENTITY),
            new TagBuilder("box").set("size", sides)));
  }

  private Optional<TagBuilder> sphere(Element body, Element sphere, Vector3 frame) {
    Optional<Double> radius = size(sphere, "radius");
    Optional<Vector3> center = center(body, sphere);
    return radius.isEmpty() || center.isEmpty()
        ? Optional.empty()
        : Optional.of(
            visual(
                new Frame(frame.plus(center.get()), Rotation.IDENTITY),
                new TagBuilder("sphere").set("radius", radius.get())));
  }

  /** A cylinder of URDF has its axis along z and its origin in the middle. */
  private Optional<TagBuilder> cylinder(Element body, Element cylinder, Vector3 frame) {
    Optional<Double> radius = size(cylinder, "radius");
    Optional<Vector3> from = place(body, cylinder.required("from"));
    Optional<Vector3> to = place(body, cylinder.required("to"));
    if (radius.isEmpty() || from.isEmpty() || to.isEmpty()) {
      return Optional.empty();
    }
    Vector3 along = to.get().minus(from.get());
    if (!(along.norm() > 0)) {
      return Optional.empty();
    }
    return Optional.of(
        visual(
            new Frame(
                frame.plus(from.get()).plus(along.times(0.5)),
                UrdfFrames.toZ(along.normalized(), Z).transposed()),
            new TagBuilder("cylinder")
                .set("radius", ShortestDecimal.format(radius.get()))
                .set("length", ShortestDecimal.format(along.norm()))));
  }

  private Optional<Vector3> center(Element body, Element shape) {
    return shape
        .attribute("point")
        .map(text -> place(body, text))
        .orElse(Optional.of(Vector3.ZERO));
  }

  /** Returns a point of the body by its name, or three coordinates. */
  private Optional<Vector3> place(Element body, String text) {
    for (Element point : body.children("point")) {
      if (point.required("name").equals(text)) {
        return vector(size(point, "x"), size(point, "y"), size(point, "z"));
      }
    }
    String[] words = text.split(";", -1);
    return words.length == 3
        ? vector(number(words[0], length), number(words[1], length), number(words[2], length))
        : Optional.empty();
  }

  private static Optional<Vector3> vector(
      Optional<Double> x, Optional<Double> y, Optional<Double> z) {
    return x.isPresent() && y.isPresent() && z.isPresent()
        ? Optional.of(new Vector3(x.get(), y.get(), z.get()))
        : Optional.empty();
  }

  private Optional<Double> size(Element element, String attribute) {
    Optional<Unit> unit =
        element.attribute("unit").map(UnitSymbols::unit).orElse(Optional.of(length));
    return unit.flatMap(u -> number(element.required(attribute), u));
  }

  /** Returns a plain number in metres; empty if it is an expression. */
  private static Optional<Double> number(String text, Unit unit) {
    return text.strip().matches("[+-]?(\\d+\\.?\\d*|\\.\\d+)([eE][+-]?\\d+)?")
        ? Optional.of(unit.toSi(Double.parseDouble(text.strip())))
        : Optional.empty();
  }
}
