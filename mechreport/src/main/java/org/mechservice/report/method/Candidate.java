package org.mechservice.report.method;

import java.util.function.Supplier;
import org.mechservice.solver.api.Model;
import org.mechservice.solver.api.Solver;

/**
 * A method with the model built for it.
 *
 * @param method the method
 * @param models makes an instance for each run
 * @param solver runs it
 */
public record Candidate(Method method, Supplier<Model> models, Solver solver) {}
