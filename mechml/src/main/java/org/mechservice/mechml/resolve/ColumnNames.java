package org.mechservice.mechml.resolve;

import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.mechservice.mechml.diagnosis.Diagnostics;
import org.mechservice.mechml.diagnosis.Phrase;
import org.mechservice.mechml.diagnosis.Quoted;
import org.mechservice.mechml.document.Element;
import org.mechservice.solver.catalogue.MessageCode;
import org.mechservice.solver.mechanism.Body;
import org.mechservice.solver.mechanism.Mechanism;
import org.mechservice.solver.mechanism.closure.JointClosure;
import org.mechservice.solver.mechanism.closure.LoopClosure;
import org.mechservice.solver.mechanism.force.ForceElement;
import org.mechservice.solver.mechanism.joint.Joint;

/**
 * The names of the columns that results may have besides outputs of the file, in any group. An
 * output of such a name would be a second column of it.
 */
final class ColumnNames {
  private static final Set<String> OF_JOINT =
      Set.of("q", "v", "a", "drive", "power", "fx", "fy", "fz", "tx", "ty", "tz");
  private static final Set<String> OF_BODY =
      Set.of("x", "y", "z", "e0", "e1", "e2", "e3", "vx", "vy", "vz", "wx", "wy", "wz");
  private static final Set<String> OF_MOMENTUM = Set.of("px", "py", "pz", "lx", "ly", "lz");

  /** What may follow a name and a dot. */
  private final Map<String, Set<String>> suffixes = new HashMap<>();

  private final Set<String> whole = new HashSet<>(Set.of("t"));

  ColumnNames(Mechanism mechanism) {
    mechanism.stateVariables().forEach(state -> whole.add(state.name()));
    add("energy", Set.of("kinetic", "potential", "work"));
    add("constraint", Set.of("position", "velocity"));
    add("momentum", OF_MOMENTUM);
    add("impulse", OF_MOMENTUM);
    for (Joint joint : mechanism.joints()) {
      add(joint.name(), OF_JOINT);
    }
    for (Body body : mechanism.bodies()) {
      add(body.name(), OF_BODY);
    }
    for (LoopClosure closure : mechanism.closures()) {
      add(closure.name(), Set.of("lambda"));
      if (closure instanceof JointClosure cut) {
        add(cut.joint().name(), OF_JOINT);
      }
    }
    for (ForceElement force : mechanism.forces()) {
      force
          .values(mechanism::jointOf)
          .forEach(value -> add(force.name(), Set.of(withoutIndex(value.name()))));
    }
  }

  private void add(String name, Set<String> behind) {
    suffixes.computeIfAbsent(name, n -> new HashSet<>()).addAll(behind);
  }

  private static String withoutIndex(String name) {
    int bracket = name.indexOf('[');
    return bracket < 0 ? name : name.substring(0, bracket);
  }

  /** Returns whether a column may have a name. */
  private boolean has(String name) {
    int dot = name.lastIndexOf('.');
    return whole.contains(name)
        || (dot > 0
            && suffixes
                .getOrDefault(name.substring(0, dot), Set.of())
                .contains(withoutIndex(name.substring(dot + 1))));
  }

  /** Refuses the outputs that have such a name. */
  void refuse(Element model, Diagnostics diagnostics) {
    List<Element> outputs = model.child("Outputs").map(o -> o.children("output")).orElse(List.of());
    for (Element output : outputs) {
      String name = output.attribute("name").orElse("");
      if (has(name)) {
        diagnostics.error(
            MessageCode.UNUSABLE_NAME,
            output.position(),
            Phrase.of(
                "%s: %s is the name of another column of results; give the output one of its own",
                output.label(), Quoted.of(name)));
      }
    }
  }
}
