package org.mechservice.mechml.resolve;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.mechservice.mechml.diagnosis.Diagnostics;
import org.mechservice.mechml.diagnosis.MessageCode;
import org.mechservice.mechml.diagnosis.Phrase;
import org.mechservice.mechml.document.Element;
import org.mechservice.mechml.document.Limits;
import org.mechservice.mechml.unit.Dimension;
import org.mechservice.solver.mechanism.Body;
import org.mechservice.solver.mechanism.Joint;
import org.mechservice.solver.mechanism.Mechanism;
import org.mechservice.solver.mechanism.Root;
import org.mechservice.solver.spatial.Vector3;

/** Reads {@code MBSmodel}: bodies, the root, joints with their start, gravity. */
final class MechanismReader {
  private final ValueReader values;
  private final Diagnostics diagnostics;

  MechanismReader(ValueReader values, Diagnostics diagnostics) {
    this.values = values;
    this.diagnostics = diagnostics;
  }

  /** Returns the mechanism; empty if something was wrong and has been reported. */
  Optional<Mechanism> read(Element model) {
    NameRule.check(model, diagnostics);
    Element topology = model.requiredChild("topology");
    Element rootElement = topology.requiredChild("root");
    NameTable<BodyParts> names = new NameTable<>("body", "does not exist", diagnostics);
    List<BodyParts> bodies = bodies(model, names);
    Optional<Vector3> gravity = gravity(model);
    Optional<BodyParts> rootBody = names.find(rootElement, rootElement.required("name"));
    if (rootBody.isEmpty() || bodies.size() > Limits.BODIES) {
      return Optional.empty();
    }
    Optional<Root> root = new RootReader(values, diagnostics).read(rootElement, rootBody.get());
    BodyIndex index = new BodyIndex(bodies, rootBody.get());
    List<JointLink> links = links(model, topology, names, index);
    JointTree tree = tree(model, links, index);
    if (diagnostics.hasErrors()) {
      return Optional.empty();
    }
    return Optional.of(
        new Mechanism(
            model.required("name"),
            root.orElseThrow(),
            gravity.orElseThrow(),
            index.moving().stream().map(BodyParts::body).flatMap(Optional<Body>::stream).toList(),
            outward(links, tree.reversed())));
  }

  private List<BodyParts> bodies(Element model, NameTable<BodyParts> names) {
    List<Element> elements = model.requiredChild("Bodies").children("body");
    if (elements.size() > Limits.BODIES) {
      diagnostics.error(
          MessageCode.TOO_LARGE,
          model.place(),
          Phrase.of("the model has %d bodies; %d are allowed", elements.size(), Limits.BODIES));
    }
    BodyReader reader = new BodyReader(values, diagnostics);
    List<BodyParts> bodies = new ArrayList<>();
    for (Element element : elements) {
      BodyParts parts = reader.read(element);
      names.add(element, Optional.of(parts));
      bodies.add(parts);
    }
    return bodies;
  }

  private Optional<Vector3> gravity(Element model) {
    return model
        .child("Forces")
        .flatMap(forces -> forces.child("gravity"))
        .map(g -> values.vector(g, "gx", "gy", "gz", Dimension.ACCELERATION))
        .orElse(Optional.of(Vector3.ZERO));
  }

  private List<JointLink> links(
      Element model, Element topology, NameTable<BodyParts> names, BodyIndex index) {
    List<Element> jointVals =
        topology.child("relCoorVals").map(r -> r.children("jointVal")).orElse(List.of());
    return new JointsReader(values, names, index, diagnostics).read(joints(model), jointVals);
  }

  private static List<Element> joints(Element model) {
    return model.child("Joints").map(j -> j.children("joint")).orElse(List.of());
  }

  /** A joint whose body is unknown would make others look unconnected. */
  private JointTree tree(Element model, List<JointLink> links, BodyIndex index) {
    JointTree tree = new JointTree(links, index);
    tree.checkLoops(diagnostics);
    if (links.size() == joints(model).size()) {
      tree.checkConnection(diagnostics);
    }
    if (index.moving().isEmpty()) {
      diagnostics.error(
          MessageCode.NOTHING_MOVES,
          model.requiredChild("Bodies").place(),
          Phrase.of(
              "%s is the only body, and it is the root: nothing moves",
              index.root().element().label()));
    }
    return tree;
  }

  private static List<Joint> outward(List<JointLink> links, boolean[] reversed) {
    List<Joint> joints = new ArrayList<>();
    for (int j = 0; j < reversed.length; j++) {
      Joint joint = links.get(j).joint().orElseThrow();
      joints.add(reversed[j] ? joint.reversed() : joint);
    }
    return joints;
  }
}
