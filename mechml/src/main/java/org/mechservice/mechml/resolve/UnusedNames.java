package org.mechservice.mechml.resolve;

import java.util.ArrayList;
import java.util.List;
import org.mechservice.mechml.diagnosis.Phrase;
import org.mechservice.mechml.diagnosis.Quoted;
import org.mechservice.mechml.resolve.body.BodyDefinition;
import org.mechservice.mechml.resolve.formula.MechanismNames;
import org.mechservice.mechml.resolve.value.ParameterTable;
import org.mechservice.mechml.resolve.value.ResolvedParameter;

/** Lists the names that a file defines and does not use. An unused name is never an error. */
final class UnusedNames {
  private UnusedNames() {}

  /**
   * Lists them, such as {@code vector "u2" of body "bar"}.
   *
   * @param byClasses whether user force classes may refer to points and tunable parameters
   */
  static List<String> of(MechanismNames names, ParameterTable parameters, boolean byClasses) {
    List<String> unused = new ArrayList<>();
    for (ResolvedParameter parameter : parameters(parameters, byClasses)) {
      unused.add("parameter " + Quoted.of(parameter.name()));
    }
    for (BodyDefinition body : names.bodies()) {
      if (!byClasses) {
        add(unused, "point", body.points().unused(), body);
      }
      add(unused, "vector", body.directions().unused(), body);
    }
    return unused;
  }

  /**
   * Lists the parameters that nothing refers to.
   *
   * @param byClasses whether user force classes may refer to tunable parameters
   */
  static List<ResolvedParameter> parameters(ParameterTable parameters, boolean byClasses) {
    return parameters.unused().stream().filter(p -> !(byClasses && p.tunable())).toList();
  }

  private static void add(
      List<String> unused, String kind, List<String> names, BodyDefinition body) {
    for (String name : names) {
      unused.add(Phrase.of("%s %s of body %s", kind, Quoted.of(name), Quoted.of(body.name())));
    }
  }
}
