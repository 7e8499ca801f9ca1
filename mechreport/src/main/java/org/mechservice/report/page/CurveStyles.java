package org.mechservice.report.page;

import java.util.ArrayList;
import java.util.List;
import org.mechservice.report.method.SimulationMethod;
import org.mechservice.solver.catalogue.IntegrationMethod;

/** Colours and marks of all methods of a page. */
final class CurveStyles {
  private static final List<String> INTEGRATORS = IntegrationMethod.labels();
  private static final int FAILURES_BESIDE_EACH_OTHER = 4;
  private static final double FAILURE_WIDTH = 7;

  private final List<String> groups = new ArrayList<>();

  CurveStyles(List<SimulationMethod> methods) {
    for (SimulationMethod method : methods) {
      if (!groups.contains(group(method))) {
        groups.add(group(method));
      }
    }
  }

  private static String group(SimulationMethod method) {
    return method.formulation() + method.closure();
  }

  /** Returns the style of one of the methods. */
  CurveStyle of(SimulationMethod method) {
    int colour = groups.indexOf(group(method));
    int mark = Math.max(0, INTEGRATORS.indexOf(method.integrator()));
    return new CurveStyle(colour, mark, FAILURE_WIDTH * (colour % FAILURES_BESIDE_EACH_OTHER));
  }

  /** Returns a table's cell with a method's mark and name. */
  String name(SimulationMethod method) {
    return "<td class=\"name\" data-m=\""
        + Html.escape(method.name())
        + "\">"
        + of(method).swatch()
        + Html.escape(method.name());
  }
}
