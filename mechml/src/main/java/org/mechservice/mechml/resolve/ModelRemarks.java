package org.mechservice.mechml.resolve;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.mechservice.mechml.SimulationTask;
import org.mechservice.mechml.diagnosis.Diagnostics;
import org.mechservice.mechml.diagnosis.Phrase;
import org.mechservice.mechml.diagnosis.Quoted;
import org.mechservice.mechml.document.Element;
import org.mechservice.mechml.resolve.body.BodyDefinition;
import org.mechservice.mechml.resolve.joint.JointLink;
import org.mechservice.mechml.resolve.value.ResolvedParameter;
import org.mechservice.solver.catalogue.MessageCode;
import org.mechservice.solver.expression.BodyPoint;
import org.mechservice.solver.mechanism.Body;
import org.mechservice.solver.mechanism.Mechanism;
import org.mechservice.solver.mechanism.force.CouplingSpringDamper;
import org.mechservice.solver.mechanism.force.ForceElement;
import org.mechservice.solver.mechanism.joint.Joint;
import org.mechservice.solver.spatial.InertiaTensor;
import org.mechservice.solver.spatial.Rotation;
import org.mechservice.solver.spatial.Vector3;

/**
 * Remarks on a model that can be used as it is, but probably is not what its author meant: no word
 * of gravity, parameters that nothing uses, inertia that does not fit the size of its body, axes of
 * a joint that are almost parallel, forces within one body. Each is a warning that a model may
 * silence.
 */
final class ModelRemarks {
  /**
   * Smallest and largest angle between two axes of a joint that nobody chose, rad. Vectors of eight
   * digits differ by less; angles that are chosen, as of a wheel's camber, are larger than half a
   * degree.
   */
  private static final double ROUNDED = 1e-7;

  private static final double CHOSEN = 0.01;

  /** Radius of gyration over the size of a body, squared, that no body of its size has. */
  private static final double TOO_LARGE = 1e3;

  private static final double TOO_SMALL = 1e-6;

  private final Element model;
  private final MechanismReader reader;
  private final Mechanism mechanism;
  private final Diagnostics diagnostics;

  ModelRemarks(
      Element model, MechanismReader reader, Mechanism mechanism, Diagnostics diagnostics) {
    this.model = model;
    this.reader = reader;
    this.mechanism = mechanism;
    this.diagnostics = diagnostics;
  }

  /**
   * Makes all remarks.
   *
   * @param task of the chosen simulation
   * @param unused parameters that nothing refers to
   */
  void make(SimulationTask task, List<ResolvedParameter> unused) {
    boolean underForces = !(task instanceof SimulationTask.Kinematic);
    if (underForces) {
      gravity();
    }
    unused.forEach(this::unused);
    reader.names().bodies().forEach(this::inertia);
    reader.links().forEach(this::axes);
    mechanism.forces().forEach(this::bodies);
  }

  /** A force whose ends all belong to one body, where its actions cancel each other. */
  private void bodies(ForceElement force) {
    List<Integer> bodies =
        force instanceof CouplingSpringDamper rope
            ? rope.points().stream().map(BodyPoint::body).toList()
            : force.bodies();
    if (bodies.size() > 1 && bodies.stream().distinct().count() == 1) {
      int body = bodies.get(0);
      String name =
          body == Mechanism.ROOT ? mechanism.root().name() : mechanism.bodies().get(body).name();
      Element element = element(force);
      diagnostics.warning(
          MessageCode.FORCE_WITHIN_ONE_BODY,
          element.position(),
          Phrase.of(
              "%s: all its ends belong to body %s, so that it moves nothing; give one of them"
                  + " another body, or leave it out",
              element.label(), Quoted.of(name)));
    }
  }

  /** Returns the element of a force; the model if none has its place. */
  private Element element(ForceElement force) {
    return model.child("Forces").stream()
        .flatMap(forces -> forces.children().stream())
        .filter(child -> diagnostics.origin(child.position()).equals(force.origin()))
        .findFirst()
        .orElse(model);
  }

  /** Gravity that the file does not mention, though bodies have mass. */
  private void gravity() {
    boolean said = model.child("Forces").flatMap(forces -> forces.child("gravity")).isPresent();
    boolean heavy = mechanism.bodies().stream().anyMatch(body -> body.mass() > 0);
    if (!said && heavy) {
      diagnostics.warning(
          MessageCode.NO_GRAVITY,
          model.position(),
          "no gravity acts on the bodies, and the file does not say so; add <gravity> to Forces,"
              + " with zeros if there is none, or silence this with silence="
              + Quoted.of(MessageCode.NO_GRAVITY.word())
              + " in MBSmodel");
    }
  }

  private void unused(ResolvedParameter parameter) {
    diagnostics.warning(
        MessageCode.PARAMETER_NOT_USED,
        parameter.element().position(),
        Phrase.of(
            "parameter %s is not used: no value depends on it, and setting it changes nothing; use"
                + " it or leave it out",
            Quoted.of(parameter.name())));
  }

  /** Moments of inertia that do not fit mass and size, as by a wrong unit. */
  private void inertia(BodyDefinition definition) {
    Optional<Body> read = definition.body();
    double size = read.map(body -> size(definition, body)).orElse(0.0);
    if (read.isEmpty() || size == 0 || definition.element().child("inertiaTensor").isEmpty()) {
      return;
    }
    Body body = read.get();
    InertiaTensor tensor = body.inertia();
    double largest = Math.max(tensor.xx(), Math.max(tensor.yy(), tensor.zz()));
    if (body.mass() == 0 || largest == 0) {
      return;
    }
    double part = largest / (body.mass() * size * size);
    if (part > TOO_LARGE || part < TOO_SMALL) {
      diagnostics.warning(
          MessageCode.INERTIA_OFF_SIZE,
          definition.element().requiredChild("inertiaTensor").position(),
          Phrase.of(
              "inertiaTensor of body %s has a radius of gyration of %.3g m, and the points of the"
                  + " body reach %.3g m from its centre of mass: check the units of mass, length"
                  + " and inertia",
              Quoted.of(body.name()), Math.sqrt(largest / body.mass()), size));
    }
  }

  /** Returns the largest distance of a point of a body from its centre of mass, m. */
  private static double size(BodyDefinition definition, Body body) {
    double size = 0;
    for (String name : definition.points().names()) {
      Optional<Vector3> point = definition.points().value(name);
      size = Math.max(size, point.map(p -> p.minus(body.centerOfMass()).norm()).orElse(0.0));
    }
    return size;
  }

  /** Axes of a joint that differ a little between its two bodies. */
  private void axes(JointLink link) {
    Optional<Joint> joint = link.joint();
    boolean byVectors =
        link.element()
            .child("body1")
            .filter(body -> body.attribute("vector").isPresent())
            .isPresent();
    double angle = joint.map(j -> angle(j.attachment().zeroRotation())).orElse(0.0);
    if (byVectors && angle > ROUNDED && angle < CHOSEN) {
      List<String> bodies = new ArrayList<>();
      for (String end : List.of("body1", "body2")) {
        bodies.add(Quoted.of(link.element().requiredChild(end).required("name")));
      }
      diagnostics.warning(
          MessageCode.AXES_DIFFER,
          link.element().position(),
          Phrase.of(
              "%s: its vectors in bodies %s and %s differ by %.2g rad, by which one body is turned"
                  + " against the other when the joint is at zero; write them with the same"
                  + " digits, or as one expression",
              link.element().label(), bodies.get(0), bodies.get(1), angle));
    }
  }

  /** Returns the angle of a rotation of less than a right angle; larger ones give a larger one. */
  private static double angle(Rotation rotation) {
    boolean small = rotation.xx() + rotation.yy() + rotation.zz() > 1;
    Vector3 twice =
        new Vector3(
            rotation.zy() - rotation.yz(),
            rotation.xz() - rotation.zx(),
            rotation.yx() - rotation.xy());
    return small ? Math.asin(Math.min(1, 0.5 * twice.norm())) : Math.PI / 2;
  }
}
