package org.mechservice.report.method;

import org.mechservice.solver.api.Model;

/**
 * Builds one model with any method: in this process or at a server. The models that it returns run
 * in this process.
 */
public interface MethodBuilds {
  /**
   * Returns what tells the model and its settings from others: what was measured with another one
   * is not taken up again.
   */
  String identity();

  /** Builds the model with the method that the builder chooses; throws what it refuses it with. */
  Model chosen();

  /**
   * Builds the model with a method.
   *
   * @throws BuildRefusedException if the model does not have the method
   */
  Candidate candidate(SimulationMethod method) throws BuildRefusedException;

  /** Builds the model with a method that it has and with the columns of its constraints. */
  Model withConstraints(SimulationMethod method);

  /** Returns hashes of solver and model as built with a method, which tell code from other code. */
  String code(SimulationMethod method);

  /**
   * Returns whether forces of the model are classes of users, which a JAR that starts by itself
   * would run with nothing around them; known after the first build.
   */
  boolean hasUserClasses();

  /** Returns a JAR of the model with a method and its solver, which starts with java -jar. */
  byte[] standalone(SimulationMethod method);
}
