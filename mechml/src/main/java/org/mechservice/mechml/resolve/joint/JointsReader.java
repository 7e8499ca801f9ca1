package org.mechservice.mechml.resolve.joint;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.mechservice.mechml.diagnosis.Diagnostics;
import org.mechservice.mechml.diagnosis.Phrase;
import org.mechservice.mechml.document.Element;
import org.mechservice.mechml.resolve.body.BodyDefinition;
import org.mechservice.mechml.resolve.body.BodyEnd;
import org.mechservice.mechml.resolve.body.BodyIndex;
import org.mechservice.mechml.resolve.value.NameTable;
import org.mechservice.mechml.resolve.value.ValueReader;
import org.mechservice.solver.catalogue.MessageCode;
import org.mechservice.solver.text.Origin;

/** Reads {@code Joints} with the starts that {@code relCoorVals} gives them. */
public final class JointsReader {
  private final JointReader reader;
  private final NameTable<BodyDefinition> bodies;
  private final BodyIndex index;
  private final Diagnostics diagnostics;

  public JointsReader(
      ValueReader values,
      NameTable<BodyDefinition> bodies,
      BodyIndex index,
      Diagnostics diagnostics) {
    this.reader = new JointReader(values, diagnostics);
    this.bodies = bodies;
    this.index = index;
    this.diagnostics = diagnostics;
  }

  /** Returns the joints whose two bodies exist, in file order. */
  public List<JointLink> read(List<Element> joints, List<Element> jointVals) {
    NameTable<Element> names = new NameTable<>("joint", "does not exist", diagnostics);
    joints.forEach(joint -> names.add(joint, Optional.of(joint)));
    Map<String, Element> starts = starts(jointVals, names);
    List<JointLink> links = new ArrayList<>();
    for (Element joint : joints) {
      link(joint, Optional.ofNullable(starts.get(joint.required("name")))).ifPresent(links::add);
    }
    return links;
  }

  private Map<String, Element> starts(List<Element> jointVals, NameTable<Element> joints) {
    Map<String, Element> starts = new HashMap<>();
    for (Element jointVal : jointVals) {
      String name = jointVal.required("name");
      Element first = starts.putIfAbsent(name, jointVal);
      if (first != null) {
        diagnostics.error(
            MessageCode.DUPLICATE_NAME,
            jointVal.position(),
            Phrase.of(
                "%s: line %d already gives the start of this joint",
                jointVal.label(), first.position().line()));
      } else {
        joints.find(jointVal, name);
      }
    }
    return starts;
  }

  /** Returns a joint, or the joint whose equations a constraint has; reports unknown bodies. */
  Optional<JointLink> link(Element element, Optional<Element> start) {
    Optional<BodyEnd> end1 = end(element.requiredChild("body1"));
    Optional<BodyEnd> end2 = end(element.requiredChild("body2"));
    if (end1.isEmpty() || end2.isEmpty()) {
      return Optional.empty();
    }
    JointInput input =
        new JointInput(
            element,
            end1.get(),
            end2.get(),
            index.of(end1.get().body()),
            index.of(end2.get().body()),
            start,
            new Origin(diagnostics.file(), element.position().line()));
    return Optional.of(
        new JointLink(element, start, input.body1(), input.body2(), reader.read(input)));
  }

  private Optional<BodyEnd> end(Element element) {
    return bodies.find(element, element.required("name")).map(body -> new BodyEnd(element, body));
  }
}
