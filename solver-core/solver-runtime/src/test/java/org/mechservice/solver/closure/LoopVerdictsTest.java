package org.mechservice.solver.closure;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.LocalDate;
import java.time.ZoneOffset;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Random;
import java.util.TreeMap;
import java.util.function.Predicate;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.mechservice.solver.api.JointType;
import org.mechservice.solver.closure.assembly.Assembly;
import org.mechservice.solver.closure.assembly.LoopFinding;
import org.mechservice.solver.closure.assembly.RankAnalysis;
import org.mechservice.solver.closure.equations.LoopEquations;
import org.mechservice.solver.kinematics.TreeGeometry;
import org.mechservice.solver.mechanism.Mechanism;
import org.mechservice.solver.mechanism.closure.LoopClosure;

/**
 * Verdicts on loops by sparse elimination, against those by singular values of the whole matrix, on
 * seeded mechanisms: whether the start closes, the rank, the rank of the positions, the number of
 * redundant equations, and whether the start is singular.
 *
 * <p>Both ways have a threshold, so they may differ where an equation is neither clearly dependent
 * nor clearly independent; none of the thousand has such an equation.
 */
class LoopVerdictsTest {
  private static final Path PAGE = Path.of("..", "..", "docs", "reports", "loop-verdicts.md");
  private static final int SLICE = 20;
  private static final int ALL = 1000;

  private record Verdict(
      boolean closes, int rank, int ofPositions, int redundant, boolean singular) {
    static Verdict of(Mechanism mechanism, Predicate<LoopEquations> isSparse) {
      TreeGeometry tree = new TreeGeometry(mechanism);
      double[] y = new double[mechanism.stateCount()];
      mechanism.initialState(y);
      List<LoopFinding> findings = new Assembly(tree, isSparse).assemble(0, y);
      if (!findings.stream().allMatch(finding -> finding.kind().isWarning())) {
        return new Verdict(false, 0, 0, 0, false);
      }
      RankAnalysis analysis = new RankAnalysis(tree, 0, y, isSparse);
      return new Verdict(
          true,
          analysis.rank(),
          analysis.positionRank(),
          analysis.redundant().size(),
          analysis.startsSingular());
    }
  }

  /** Families of mechanisms, taken in turn. */
  private enum Family {
    FEW_LOOPS("random trees of all joints with 1 to 4 loops of all kinds"),
    LOOPS_TWICE("the same, every closure twice: half of the equations are redundant"),
    MANY_LOOPS("2 to 4 bodies with 6 to 9 closures: as a rule nothing is left to move"),
    LINKAGES("planar four-bars of spatial joints, rings, rows of windows: redundant equations");

    private final String text;

    Family(String text) {
      this.text = text;
    }

    Mechanism mechanism(int seed) {
      Random random = new Random(seed);
      return switch (this) {
        case FEW_LOOPS -> RandomLoops.of(seed, 3 + random.nextInt(7), 1 + random.nextInt(4));
        case LOOPS_TWICE ->
            twice(RandomLoops.of(seed, 3 + random.nextInt(5), 1 + random.nextInt(3)));
        case MANY_LOOPS -> RandomLoops.of(seed, 2 + random.nextInt(3), 6 + random.nextInt(4));
        case LINKAGES -> linkage(random);
      };
    }

    private static Mechanism linkage(Random random) {
      List<JointType> types = List.of(JointType.R, JointType.C, JointType.S);
      return switch (random.nextInt(3)) {
        case 0 ->
            Linkages.fourBar(
                IntStream.range(0, 4)
                    .mapToObj(i -> types.get(i == 0 ? 0 : random.nextInt(3)))
                    .toList(),
                random.nextInt(4));
        case 1 -> Linkages.ring(4 + random.nextInt(9));
        default -> Linkages.windows(1 + random.nextInt(8), random.nextDouble());
      };
    }

    private static Mechanism twice(Mechanism mechanism) {
      List<LoopClosure> closures = new ArrayList<>(mechanism.closures());
      closures.addAll(mechanism.closures());
      return new Mechanism(
              mechanism.name(),
              mechanism.root(),
              mechanism.gravity(),
              mechanism.bodies(),
              mechanism.joints(),
              List.of(),
              mechanism.startRoles(),
              closures,
              List.of(),
              List.of())
          .withArmatures(mechanism.armatures());
    }
  }

  /** Compares the verdicts on the mechanisms up to a seed and counts what they say. */
  private static Map<Family, int[]> compared(int count) {
    Map<Family, int[]> counts = new TreeMap<>();
    for (int seed = 1; seed <= count; seed++) {
      Family family = Family.values()[seed % Family.values().length];
      Mechanism mechanism = family.mechanism(seed);
      Verdict dense = Verdict.of(mechanism, loops -> false);
      Verdict sparse = Verdict.of(mechanism, loops -> true);
      assertThat(sparse).as("%s, seed %d", family, seed).isEqualTo(dense);
      int[] of = counts.computeIfAbsent(family, first -> new int[5]);
      of[0]++;
      of[1] += dense.closes() ? 1 : 0;
      of[2] += dense.redundant() > 0 ? 1 : 0;
      of[3] += dense.redundant();
      of[4] += dense.singular() ? 1 : 0;
    }
    return counts;
  }

  @Test
  void sparseEliminationSaysWhatSingularValuesSay() {
    assertThat(compared(SLICE)).hasSize(Family.values().length);
  }

  @Tag("soak")
  @Test
  void aThousandMechanismsHaveTheSameVerdictsBothWays() throws IOException {
    List<String> lines = new ArrayList<>();
    lines.add("# Verdicts on loops: sparse elimination against singular values");
    lines.add("");
    lines.add(
        "Written on %s by `mvn verify -Psoak`, test `LoopVerdictsTest`, %s %s, Java %s: %d seeded mechanisms, each set"
                .formatted(
                    LocalDate.now(ZoneOffset.UTC),
                    System.getProperty("os.name"),
                    System.getProperty("os.arch"),
                    System.getProperty("java.version"),
                    ALL)
            + " up by sparse elimination and by singular values of the whole matrix. Both ways say the"
            + " same of every mechanism: whether the start closes, the rank, the rank of the positions,"
            + " the number of redundant equations, and whether the start is singular. The table says"
            + " what they say.");
    lines.add("");
    lines.add(
        "| mechanisms | number | start closes | with redundant equations | redundant equations |"
            + " start singular |");
    lines.add("|---|---|---|---|---|---|");
    compared(ALL)
        .forEach(
            (family, of) ->
                lines.add(
                    "| %s | %d | %d | %d | %d | %d |"
                        .formatted(family.text, of[0], of[1], of[2], of[3], of[4])));
    Files.writeString(PAGE, String.join("\n", lines) + "\n");
  }
}
