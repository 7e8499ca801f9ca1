package org.mechservice.robot;

import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.mechservice.mechml.diagnosis.Diagnostics;
import org.mechservice.mechml.diagnosis.NearestName;
import org.mechservice.mechml.diagnosis.Phrase;
import org.mechservice.mechml.diagnosis.Quoted;
import org.mechservice.mechml.document.Element;
import org.mechservice.robot.Robot.Frame;
import org.mechservice.solver.catalogue.MessageCode;
import org.mechservice.solver.spatial.EulerParameters;
import org.mechservice.solver.spatial.Rotation;
import org.mechservice.solver.spatial.Vector3;

/**
 * The frames of an SDF file: links, joints, models and frames have a pose relative to another of
 * them. Names of nested models are joined by {@code ::}.
 *
 * <p>Source: "Pose frame semantics" of the SDF specification, version 1.7 and later; earlier files
 * name no frames and mean the same.
 */
final class SdfFrames {
  static final String WORLD = "world";
  static final String MODEL = "__model__";
  static final String SCOPE = "::";

  /**
   * A frame with a name.
   *
   * @param element its element
   * @param base name of the frame that its pose is relative to, from the outermost model
   * @param attachedTo name of the frame that it moves with; a link moves with itself
   */
  private record Named(Element element, String base, String attachedTo) {}

  private final Diagnostics diagnostics;
  private final RobotNumbers numbers;
  private final Map<String, Named> named = new HashMap<>();
  private final Map<String, Frame> known = new HashMap<>();

  SdfFrames(Diagnostics diagnostics, RobotNumbers numbers) {
    this.diagnostics = diagnostics;
    this.numbers = numbers;
    known.put(WORLD, Frame.SAME);
  }

  /**
   * Adds the frames of a model and of the models in it.
   *
   * @param scope of the names in the model, with {@code ::} at its end unless empty
   * @param outer scope of the model's own name
   */
  void addModel(String scope, String outer, Element model) {
    String within = named.containsKey(outer + MODEL) ? outer + MODEL : WORLD;
    String self = scope + MODEL;
    add(
        self,
        model,
        relativeTo(model).map(base -> outer + base).orElse(within),
        canonical(model, scope));
    if (!scope.isEmpty()) {
      named.put(
          scope.substring(0, scope.length() - SCOPE.length()),
          new Named(new Element("frame", List.of(), List.of(), model.position(), ""), self, self));
    }
    for (Element part : model.children()) {
      Optional<String> name = part.attribute("name");
      if (name.isEmpty()) {
        if (Set.of("link", "joint", "frame", "model").contains(part.name())) {
          numbers.missing(part, "attribute name");
        }
        continue;
      }
      String full = scope + name.get();
      switch (part.name()) {
        case "link" ->
            add(full, part, relativeTo(part).map(base -> scoped(scope, base)).orElse(self), full);
        case "joint" -> {
          String child = part.child("child").map(Element::text).orElse("");
          add(full, part, scoped(scope, relativeTo(part).orElse(child)), scoped(scope, child));
        }
        case "frame" -> {
          String attached =
              part.attribute("attached_to").map(base -> scoped(scope, base)).orElse(self);
          add(
              full,
              part,
              relativeTo(part).map(base -> scoped(scope, base)).orElse(attached),
              attached);
        }
        case "model" -> addModel(full + SCOPE, scope, part);
        default -> {
          // Lights, plugins and the like have no frame that a joint could name.
        }
      }
    }
  }

  /** Adds the frames and joints that stand in a world itself. */
  void addWorld(Element world) {
    for (Element part : world.children()) {
      String name = part.attribute("name").orElse("");
      if (part.name().equals("frame")) {
        String attached = part.attribute("attached_to").orElse(WORLD);
        add(name, part, relativeTo(part).orElse(attached), attached);
      } else if (part.name().equals("joint")) {
        String child = part.child("child").map(Element::text).orElse("");
        add(name, part, relativeTo(part).orElse(child), child);
      }
    }
  }

  private static String canonical(Element model, String scope) {
    return scope
        + model
            .attribute("canonical_link")
            .or(() -> model.child("link").flatMap(link -> link.attribute("name")))
            .orElse(MODEL);
  }

  private static String scoped(String scope, String name) {
    return name.equals(WORLD) ? WORLD : scope + name;
  }

  private void add(String name, Element element, String base, String attachedTo) {
    if (named.putIfAbsent(name, new Named(element, base, attachedTo)) != null
        || name.equals(WORLD)) {
      diagnostics.error(
          MessageCode.DUPLICATE_NAME,
          element.position(),
          Phrase.of(
              "another frame has the name %s; give each link, joint and frame its own",
              Quoted.of(name)));
    }
  }

  private static Optional<String> relativeTo(Element element) {
    return element
        .child("pose")
        .flatMap(pose -> pose.attribute("relative_to"))
        .filter(base -> !base.isEmpty());
  }

  /** Returns a pose: x y z roll pitch yaw, or x y z and a quaternion x y z w. */
  Frame pose(Optional<Element> pose) {
    if (pose.isEmpty() || pose.get().text().isEmpty()) {
      return Frame.SAME;
    }
    Element element = pose.get();
    if (element.attribute("rotation_format").filter("quat_xyzw"::equals).isPresent()) {
      List<Double> p = numbers.text(element, 7);
      double[] e = {p.get(6), p.get(3), p.get(4), p.get(5)};
      double[] r = new double[9];
      if (!(EulerParameters.norm(e, 0) > 0)) {
        numbers.contradiction(element, "its quaternion is zero");
        return Frame.SAME;
      }
      EulerParameters.rotation(e, 0, r, 0);
      return new Frame(
          new Vector3(p.get(0), p.get(1), p.get(2)),
          new Rotation(r[0], r[1], r[2], r[3], r[4], r[5], r[6], r[7], r[8]));
    }
    List<Double> p = numbers.text(element, 6);
    double unit =
        element.attribute("degrees").filter(d -> d.equals("true") || d.equals("1")).isPresent()
            ? Math.PI / 180
            : 1;
    return Frame.ofRollPitchYaw(
        new Vector3(p.get(0), p.get(1), p.get(2)),
        new Vector3(p.get(3) * unit, p.get(4) * unit, p.get(5) * unit));
  }

  /** Returns a frame in the world; the name is from the outermost model. */
  Frame inWorld(String name) {
    return inWorld(name, new HashSet<>());
  }

  private Frame inWorld(String name, Set<String> asked) {
    Frame done = known.get(name);
    Named frame = named.get(name);
    if (done != null || frame == null) {
      return done == null ? Frame.SAME : done;
    }
    if (!asked.add(name)) {
      numbers.contradiction(frame.element(), "its pose is relative to itself");
      return Frame.SAME;
    }
    if (!known.containsKey(frame.base()) && !named.containsKey(frame.base())) {
      unknown(frame.element(), frame.base());
      return Frame.SAME;
    }
    Frame found = inWorld(frame.base(), asked).times(pose(frame.element().child("pose")));
    Optional<String> placed =
        frame.element().attribute("placement_frame").filter(one -> !one.isEmpty());
    if (placed.isPresent() && name.endsWith(MODEL)) {
      // The pose of a model is that of its placement frame.
      String scope = name.substring(0, name.length() - MODEL.length());
      found = found.times(within(name, scope + placed.get(), frame.element()).inverse());
    }
    known.put(name, found);
    return found;
  }

  /** Returns a frame of a model in the model's own frame. */
  private Frame within(String model, String name, Element asking) {
    Frame found = Frame.SAME;
    String at = name;
    Set<String> asked = new HashSet<>();
    while (!at.equals(model)) {
      Named frame = named.get(at);
      if (frame == null || !asked.add(at)) {
        unknown(asking, name);
        return Frame.SAME;
      }
      found = pose(frame.element().child("pose")).times(found);
      at = frame.base();
    }
    return found;
  }

  /** Returns the frame that a name means in a model, in the world. */
  Frame named(String scope, String name, Element asking) {
    String full = scoped(scope, name);
    if (!named.containsKey(full) && !known.containsKey(full)) {
      unknown(asking, name);
    }
    return inWorld(full);
  }

  /** Returns the full name of the link that a name means in a model; empty after an error. */
  Optional<String> link(String scope, String name, Element asking) {
    String full = scoped(scope, name);
    Set<String> asked = new HashSet<>();
    while (!full.equals(WORLD)) {
      Named frame = named.get(full);
      if (frame == null || !asked.add(full)) {
        unknown(asking, name);
        return Optional.empty();
      }
      if (frame.element().name().equals("link")) {
        return Optional.of(full);
      }
      full = frame.attachedTo();
    }
    return Optional.of(WORLD);
  }

  private void unknown(Element asking, String name) {
    diagnostics.error(
        MessageCode.UNKNOWN_NAME,
        asking.position(),
        Phrase.of(
            "%s: frame %s does not exist%s",
            asking.label(), Quoted.of(name), NearestName.suggestion(name, named.keySet())));
  }
}
