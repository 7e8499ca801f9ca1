package org.mechservice.report.method;

import org.mechservice.solver.catalogue.MethodNames;

/**
 * A method of simulating a scene: formulation, closure and integrator.
 *
 * @param formulation {@code DTR}, {@code DSR}, {@code RR} or {@code RR-JF}
 * @param closure {@code none}, {@code projection} or {@code penalty}
 * @param integrator {@code ode113}, {@code DE}, {@code ode15s} or {@code ode15sR}
 */
public record SimulationMethod(String formulation, String closure, String integrator) {
  /** Returns the method's name, such as {@code DSR penalty ode113}. */
  public String name() {
    String loops = closure.equals(MethodNames.NONE) ? "" : closure + " ";
    return formulation + " " + loops + integrator;
  }

  /** Returns the options of {@code mech simulate} that choose the method. */
  public String options() {
    String loops = closure.equals(MethodNames.NONE) ? "" : " --closure " + closure;
    return "--formulation " + formulation + loops + " --integrator " + integrator;
  }

  @Override
  public String toString() {
    return name();
  }
}
