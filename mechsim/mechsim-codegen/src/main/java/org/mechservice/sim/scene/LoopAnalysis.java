package org.mechservice.sim.scene;

import java.util.ArrayList;
import java.util.List;
import org.mechservice.mechml.MechmlModel;
import org.mechservice.solver.catalogue.MessageCode;
import org.mechservice.solver.closure.assembly.ClosedStart;
import org.mechservice.solver.closure.assembly.LoopFinding;
import org.mechservice.solver.closure.equations.LoopEquations;
import org.mechservice.solver.kinematics.TreeGeometry;
import org.mechservice.solver.kinematics.TreeMotion;
import org.mechservice.solver.mechanism.Mechanism;
import org.mechservice.solver.mechanism.closure.LoopClosure;
import org.mechservice.solver.text.Origin;

/**
 * The loops of a mechanism: their constraints, their residuals at the start and the rank of their
 * equations.
 *
 * @param loops constraints in the mechanism's order
 * @param equations number of all their equations
 * @param independent number of independent equations; −1 if unknown
 */
public record LoopAnalysis(List<LoopEntry> loops, int equations, int independent) {
  /** A mechanism that is a tree. */
  public static final LoopAnalysis NONE = new LoopAnalysis(List.of(), 0, 0);

  private static final int NOT_JUDGED = -1;

  public LoopAnalysis {
    loops = List.copyOf(loops);
  }

  /**
   * Analyses the loops at the start of a run.
   *
   * @param model model with the settings of the run, whose start time is used
   */
  public static LoopAnalysis of(MechmlModel model) {
    Mechanism mechanism = model.mechanism();
    if (mechanism.closures().isEmpty()) {
      return NONE;
    }
    double startTime = model.settings().run().tStart();
    TreeGeometry tree = new TreeGeometry(mechanism);
    LoopEquations loops = new LoopEquations(tree);
    double[] y = new double[mechanism.positionCount() + mechanism.velocityCount()];
    mechanism.initialState(y);
    TreeMotion motion = new TreeMotion(tree);
    motion.sweep(startTime, y);
    loops.place(motion, startTime);
    loops.move(motion, startTime);
    List<LoopEntry> entries = entries(mechanism, loops);
    ClosedStart start = model.closedStart(startTime);
    int independent = start.isAssembled() ? start.rank() : NOT_JUDGED;
    return new LoopAnalysis(entries, loops.count(), independent);
  }

  /**
   * Returns the findings about the loops of a model.
   *
   * @param startTime start of the run, s
   */
  public static List<Finding> findings(MechmlModel model, double startTime) {
    Mechanism mechanism = model.mechanism();
    return mechanism.closures().isEmpty()
        ? List.of()
        : findings(mechanism, model.closedStart(startTime).findings());
  }

  private static List<LoopEntry> entries(Mechanism mechanism, LoopEquations loops) {
    LoopPaths paths = new LoopPaths(mechanism);
    List<LoopEntry> entries = new ArrayList<>();
    for (LoopClosure closure : mechanism.closures()) {
      int count = 0;
      int worst = -1;
      int fastest = -1;
      for (int row = 0; row < loops.count(); row++) {
        if (loops.closure(row) == closure) {
          count++;
          worst = worse(loops.value, loops, row, worst);
          fastest = worse(loops.rate, loops, row, fastest);
        }
      }
      entries.add(
          new LoopEntry(
              closure.name(),
              LoopKind.of(closure),
              paths.bodies(closure),
              paths.path(closure),
              count,
              worst < 0 ? 0 : Math.abs(loops.value[worst]),
              fastest < 0 ? 0 : Math.abs(loops.rate[fastest]),
              worst < 0 ? "1" : loops.unit(worst)));
    }
    return entries;
  }

  /** Returns the row with the larger residual relative to its size. */
  private static int worse(double[] residual, LoopEquations loops, int row, int best) {
    boolean larger =
        best < 0
            || Math.abs(residual[row]) / loops.size(row)
                > Math.abs(residual[best]) / loops.size(best);
    return larger ? row : best;
  }

  private static List<Finding> findings(Mechanism mechanism, List<LoopFinding> found) {
    List<Finding> findings = new ArrayList<>();
    for (LoopFinding finding : found) {
      findings.add(new Finding(code(finding), finding.message(), origin(mechanism, finding)));
    }
    return findings;
  }

  private static MessageCode code(LoopFinding finding) {
    return switch (finding.kind()) {
      case REDUNDANT -> MessageCode.LOOPS_REDUNDANT;
      case SINGULAR_START -> MessageCode.LOOPS_START_SINGULAR;
      default -> MessageCode.LOOPS_OPEN_AT_START;
    };
  }

  /** Returns the line of the first constraint a finding names. */
  private static Origin origin(Mechanism mechanism, LoopFinding finding) {
    return mechanism.closures().stream()
        .filter(closure -> finding.part().contains("\"" + closure.name() + "\""))
        .map(LoopClosure::origin)
        .findFirst()
        .orElse(Origin.NONE);
  }

  /** Returns whether the number of independent equations is known. */
  public boolean isJudged() {
    return independent != NOT_JUDGED;
  }

  /** Returns the number of redundant equations; 0 if unknown. */
  public int redundant() {
    return isJudged() ? equations - independent : 0;
  }
}
