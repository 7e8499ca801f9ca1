package org.mechservice.robot;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Collectors;
import org.mechservice.mechml.MechmlModel;
import org.mechservice.mechml.Solid;
import org.mechservice.mechml.document.Element;
import org.mechservice.robot.Robot.Frame;
import org.mechservice.solver.spatial.Rotation;
import org.mechservice.solver.spatial.Vector3;
import org.mechservice.solver.text.Origin;
import org.mechservice.solver.text.ShortestDecimal;

/**
 * The shapes of the bodies of a model: their geometry files and solids as visuals of URDF. Cones,
 * which URDF lacks, are reported as lost; the inertia of the body does not depend on them.
 */
final class UrdfShapes {
  private static final Vector3 Z = new Vector3(0, 0, 1);
  private static final List<String> SOLIDS = List.of("box", "cylinder", "cone", "sphere", "mesh");

  private final Map<String, Element> bodies;
  private final ExportLosses losses;
  private final MechmlModel model;

  UrdfShapes(MechmlModel model, Element file, ExportLosses losses) {
    this.model = model;
    this.losses = losses;
    bodies =
        file.children("MBSmodel").stream()
            .flatMap(one -> one.children("Bodies").stream())
            .flatMap(all -> all.children("body").stream())
            .collect(
                Collectors.toMap(
                    body -> body.required("name"), b -> b, (a, b) -> a, LinkedHashMap::new));
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
    List<Solid> solids = model.solids(body);
    for (int i = 0; i < solids.size(); i++) {
      Optional<TagBuilder> visual = visual(solids.get(i), frame);
      visual.ifPresent(visuals::add);
      if (visual.isEmpty()) {
        losses.add(
            origin(element, i),
            "cone of body \"" + body + "\": URDF cannot show it; its mass and inertia are kept");
      }
    }
    return visuals;
  }

  /** Returns where a solid is in the file. */
  private static Origin origin(Optional<Element> body, int solid) {
    return body.stream()
        .flatMap(element -> element.children().stream())
        .filter(child -> SOLIDS.contains(child.name()))
        .skip(solid)
        .findFirst()
        .map(shape -> new Origin("", shape.position().line()))
        .orElse(Origin.NONE);
  }

  private static TagBuilder visual(Frame frame, TagBuilder shape) {
    TagBuilder visual = new TagBuilder("visual");
    UrdfFrames.origin(frame).ifPresent(visual::add);
    return visual.add(new TagBuilder("geometry").add(shape));
  }

  /** Returns a solid as a visual; empty for cones. */
  private static Optional<TagBuilder> visual(Solid solid, Vector3 frame) {
    if (solid instanceof Solid.Block block) {
      return Optional.of(
          visual(
              new Frame(frame.plus(block.center()), Rotation.IDENTITY),
              new TagBuilder("box").set("size", UrdfFrames.text(block.edges()))));
    } else if (solid instanceof Solid.Ball ball) {
      return Optional.of(
          visual(
              new Frame(frame.plus(ball.center()), Rotation.IDENTITY),
              new TagBuilder("sphere").set("radius", ball.radius())));
    } else if (solid instanceof Solid.Surface surface) {
      return Optional.of(surface(surface, frame));
    }
    Solid.Round round = (Solid.Round) solid;
    return round.radius() == round.top() ? Optional.of(cylinder(round, frame)) : Optional.empty();
  }

  /** A cylinder of URDF has its axis along z and its origin in the middle; it has no bore. */
  private static TagBuilder cylinder(Solid.Round cylinder, Vector3 frame) {
    Vector3 along = cylinder.to().minus(cylinder.from());
    return visual(
        new Frame(
            frame.plus(cylinder.from()).plus(along.times(0.5)),
            UrdfFrames.toZ(along.normalized(), Z).transposed()),
        new TagBuilder("cylinder")
            .set("radius", ShortestDecimal.format(cylinder.radius()))
            .set("length", ShortestDecimal.format(along.norm())));
  }

  private static TagBuilder surface(Solid.Surface surface, Vector3 frame) {
    TagBuilder mesh = new TagBuilder("mesh").set("filename", surface.file());
    if (surface.scale() != 1) {
      double s = surface.scale();
      mesh.set("scale", UrdfFrames.text(new Vector3(s, s, s)));
    }
    return visual(new Frame(frame.plus(surface.origin()), Rotation.IDENTITY), mesh);
  }
}
