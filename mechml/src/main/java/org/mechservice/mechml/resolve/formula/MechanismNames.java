package org.mechservice.mechml.resolve.formula;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.mechservice.mechml.diagnosis.Diagnostics;
import org.mechservice.mechml.diagnosis.NearestName;
import org.mechservice.mechml.diagnosis.Phrase;
import org.mechservice.mechml.diagnosis.Quoted;
import org.mechservice.mechml.document.Element;
import org.mechservice.mechml.resolve.body.BodyDefinition;
import org.mechservice.mechml.resolve.body.BodyEnd;
import org.mechservice.mechml.resolve.body.BodyIndex;
import org.mechservice.mechml.resolve.value.NameTable;
import org.mechservice.solver.catalogue.MessageCode;
import org.mechservice.solver.expression.BodyPoint;
import org.mechservice.solver.expression.PointFunction;
import org.mechservice.solver.mechanism.force.NamedPoint;
import org.mechservice.solver.spatial.Vector3;
import org.mechservice.solver.text.Origin;

/** Finds bodies, points and joints by name; needs the choice of the cut joints. */
public final class MechanismNames {
  private final NameTable<BodyDefinition> bodies;
  private final BodyIndex index;
  private final Map<String, ResolvedJoint> joints = new LinkedHashMap<>();
  private final Map<String, Signal> signals = new LinkedHashMap<>();
  private final Map<String, PointFunction> tables = new LinkedHashMap<>();
  private final Diagnostics diagnostics;

  public MechanismNames(
      NameTable<BodyDefinition> bodies, BodyIndex index, Diagnostics diagnostics) {
    this.bodies = bodies;
    this.index = index;
    this.diagnostics = diagnostics;
  }

  public void add(ResolvedJoint joint) {
    joints.putIfAbsent(joint.element().required("name"), joint);
  }

  /** Adds a table or map that formulas may call by name. */
  public void add(PointFunction table) {
    tables.putIfAbsent(table.name(), table);
  }

  /** Returns a table or map by name. */
  public Optional<PointFunction> table(String name) {
    return Optional.ofNullable(tables.get(name));
  }

  public Set<String> tableNames() {
    return tables.keySet();
  }

  /** Returns the tables and maps by name. */
  Map<String, PointFunction> tables() {
    return tables;
  }

  /** Adds a value that formulas may refer to by name. */
  public void add(String name, Signal signal) {
    signals.putIfAbsent(name, signal);
  }

  /** Returns a value that formulas refer to by name besides coordinates. */
  public Optional<Signal> signal(String name) {
    return Optional.ofNullable(signals.get(name));
  }

  public Set<String> signalNames() {
    return signals.keySet();
  }

  public Optional<ResolvedJoint> joint(String name) {
    return Optional.ofNullable(joints.get(name));
  }

  public Set<String> jointNames() {
    return joints.keySet();
  }

  /** Returns the joint that an attribute names; reports an unknown name. */
  Optional<ResolvedJoint> jointOf(Element user, String attribute) {
    String name = user.required(attribute);
    Optional<ResolvedJoint> joint = joint(name);
    if (joint.isEmpty() && !diagnostics.isFull()) {
      diagnostics.error(
          MessageCode.UNKNOWN_NAME,
          user.position(),
          Phrase.of(
              "%s names joint %s, which does not exist%s",
              user.label(), Quoted.of(name), NearestName.suggestion(name, joints.keySet())));
    }
    return joint;
  }

  /** Returns one end of a joint, constraint or force; reports an unknown body. */
  Optional<BodyEnd> end(Element element) {
    return bodies.find(element, element.required("name")).map(body -> new BodyEnd(element, body));
  }

  /** Returns the point that an end names; reports an unknown body or point. */
  public Optional<BodyPoint> point(Element element) {
    return end(element)
        .flatMap(end -> end.point().map(point -> new BodyPoint(index.of(end.body()), point)));
  }

  /** Returns a body's index among the mechanism's. */
  public int indexOf(BodyDefinition body) {
    return index.of(body);
  }

  /** Returns a body by name. */
  public Optional<BodyDefinition> body(String name) {
    return bodies.names().contains(name) ? bodies.value(name) : Optional.empty();
  }

  /** Returns the bodies in file order, the root among them. */
  public List<BodyDefinition> bodies() {
    return bodies.names().stream()
        .map(bodies::value)
        .flatMap(Optional<BodyDefinition>::stream)
        .toList();
  }

  public Set<String> bodyNames() {
    return bodies.names();
  }

  /** Returns every point of the file with its name, for user forces. */
  public List<NamedPoint> points() {
    List<NamedPoint> points = new ArrayList<>();
    for (String body : bodies.names()) {
      BodyDefinition parts = bodies.value(body).orElseThrow();
      for (String name : parts.points().names()) {
        Optional<Vector3> point = parts.points().value(name);
        point.ifPresent(
            p -> points.add(new NamedPoint(body, name, new BodyPoint(index.of(parts), p))));
      }
    }
    return points;
  }

  /** Returns the position of an element in the file. */
  public Origin origin(Element element) {
    return diagnostics.origin(element.position());
  }
}
