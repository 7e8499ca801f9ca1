package org.mechservice.library;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.util.Arrays;
import java.util.Locale;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.mechservice.solver.api.program.Trajectory;
import org.mechservice.solver.catalogue.MessageCode;

/** What rows of prescribed motions do not hold is told. */
class InverseDynamicsNotesTest {
  /** A wheel of 0.5 kg m² turned by half a radian to and fro, sin(π t), by a table of its way. */
  private static String wheel(String task, String method) {
    String x =
        IntStream.rangeClosed(0, 20)
            .mapToObj(i -> String.format(Locale.ROOT, "%.3f", 0.1 * i))
            .collect(Collectors.joining(";"));
    String y =
        IntStream.rangeClosed(0, 20)
            .mapToObj(i -> String.format(Locale.ROOT, "%.9f", 0.5 * Math.sin(Math.PI * 0.1 * i)))
            .collect(Collectors.joining(";"));
    return ("<MechML><MBSsimulation><%1$s><timeSet tini='0' tend='2' tstep='0.01'/><output"
            + " columns='all'/></%1$s></MBSsimulation><MBSmodel name='wheel' massUnits='kg'"
            + " lengthUnits='m' silence='no-gravity'><Tables><table name='path' method='%2$s'"
            + " x='%3$s' y='%4$s'/></Tables><Bodies><body name='G'><point name='o' x='0' y='0'"
            + " z='0'/><vector name='z' vx='0' vy='0' vz='1'/></body><body name='a'><point name='o'"
            + " x='0' y='0' z='0'/><vector name='z' vx='0' vy='0' vz='1'/><mass value='1'/>"
            + "<inertiaTensor Ixx='0.5' Iyy='0.5' Izz='0.5' Ixy='0' Ixz='0' Iyz='0'/></body>"
            + "</Bodies><Joints><joint name='h' type='R'><body1 name='G' point='o' vector='z'/>"
            + "<body2 name='a' point='o' vector='z'/></joint></Joints><Forces><gravity gx='0'"
            + " gy='0' gz='0'/></Forces><topology><root name='G'/><relCoorVals><jointVal name='h'"
            + " driven='path(t)'/></relCoorVals></topology></MBSmodel></MechML>")
        .formatted(task, method, x, y);
  }

  @ParameterizedTest
  @ValueSource(strings = {"inverseDynamic", "kinematic"})
  void impulsesAtThePointsOfALinearTableAreToldAndAreErrorsIfStrict(String task) throws Exception {
    MechModel model = MechModel.of("wheel.xml", wheel(task, "linear"));
    Trajectory run = model.simulate();
    // the corner at 1 s lies on a straight line: the slopes before and after are the same
    assertThat(run.report().notes())
        .filteredOn(note -> note.code() == MessageCode.DRIVEN_VELOCITY_JUMPED)
        .hasSize(18)
        .allSatisfy(note -> assertThat(note.warning()).isTrue());
    MechModel strict = model.strict();
    assertThatThrownBy(strict::simulate).hasMessageContaining("N-027");
  }

  /** The torque is I q'' of the sine, 0.25 π² N·m at most. */
  @Test
  void cubicTableHasTheTorqueOfTheMotionAndNoNote() throws Exception {
    Trajectory run = MechModel.of("wheel.xml", wheel("inverseDynamic", "cubic")).simulate();
    assertThat(run.report().notes()).isEmpty();
    double largest = Arrays.stream(run.column("h.drive")).map(Math::abs).max().orElseThrow();
    // a spline's second derivative errs by h²/12 of the fourth: 0.01 π²/12
    assertThat(largest).isCloseTo(0.25 * Math.PI * Math.PI, within(0.03));
  }
}
