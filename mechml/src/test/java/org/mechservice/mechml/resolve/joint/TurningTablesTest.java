package org.mechservice.mechml.resolve.joint;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatCode;
import static org.assertj.core.api.Assertions.catchThrowableOfType;

import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.function.IntPredicate;
import java.util.stream.Collectors;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.mechservice.mechml.diagnosis.MechmlException;
import org.mechservice.mechml.resolve.MechmlReader;

/** Driven Euler parameters by tables: signs that change between rows are refused. */
@Tag("slow")
class TurningTablesTest {
  @ParameterizedTest
  @CsvSource({
    "S, cubic, 17, 1, t, 1",
    "S, linear, 17, 1, t, 1",
    "S, akima, 120, 1, t, 1",
    "S, monotone, 90, 1, t, 1",
    "S, cubic, 2, 1000, t, 1",
    "F, cubic, 60, 1, t, 1",
    "F, linear, 60, 0.01, 2*t-0.3, 1",
    "S, linear, 60, 1, t, 20",
    "S, cubic, 60, 1, t, 19",
    "S, cubic, 60, 1, t*t, 13"
  })
  void signsThatChangeAreRefused(
      String type, String method, double step, double norm, String argument, int from) {
    String rows = model(type, method, step, norm, argument, row -> row >= from);
    assertThat(said(rows))
        .matches(
            "(?s)model.xml:\\d+:\\d+: M-034 jointVal \"s\": the Euler parameters fall to the norm"
                + " .* near t = .*");
    assertThat(said(model(type, method, step, norm, argument, row -> row % 2 == 1)))
        .contains("M-034");
    assertThatCode(() -> read(model(type, method, step, norm, argument, row -> false)))
        .doesNotThrowAnyException();
    assertThatCode(() -> read(model(type, method, step, norm, argument, row -> true)))
        .doesNotThrowAnyException();
  }

  /** Rows nearly half a turn apart are as near to each other as to their negatives. */
  @ParameterizedTest
  @CsvSource({"linear, 170", "cubic, 150", "monotone, 170"})
  void wideRowsArePaths(String method, double step) {
    assertThatCode(() -> read(model("S", method, step, 1, "t", row -> false)))
        .doesNotThrowAnyException();
  }

  private static String said(String text) {
    return catchThrowableOfType(MechmlException.class, () -> read(text)).diagnostics().stream()
        .map(Object::toString)
        .collect(Collectors.joining("\n"));
  }

  private static void read(String text) throws MechmlException {
    MechmlReader.read("model.xml", text.getBytes(StandardCharsets.UTF_8));
  }

  /**
   * Returns a body that turns about an axis.
   *
   * @param step rotation from one of the 21 rows to the next, degrees
   * @param norm of the rows
   * @param negative whether a row has the other sign
   */
  private static String model(
      String type,
      String method,
      double step,
      double norm,
      String argument,
      IntPredicate negative) {
    double[] axis = {0.6, 0, 0.8};
    List<List<Double>> columns =
        List.of(
            new ArrayList<>(),
            new ArrayList<>(),
            new ArrayList<>(),
            new ArrayList<>(),
            new ArrayList<>());
    for (int row = 0; row <= 20; row++) {
      double half = Math.toRadians(step) * row / 2;
      double scale = negative.test(row) ? -norm : norm;
      columns.get(0).add(0.05 * row);
      columns.get(1).add(scale * Math.cos(half));
      for (int i = 0; i < 3; i++) {
        columns.get(2 + i).add(scale * axis[i] * Math.sin(half));
      }
    }
    StringBuilder tables = new StringBuilder();
    for (int i = 0; i < 4; i++) {
      tables.append(
          "<table name='e%d' method='%s' extrapolation='hold' x='%s' y='%s'/>"
              .formatted(i, method, list(columns.get(0)), list(columns.get(1 + i))));
    }
    String driven =
        "e0(A);e1(A);e2(A);e3(A)".replace("A", argument) + (type.equals("F") ? ";0;0.1*t^2;0" : "");
    return """
        <MechML><MBSsimulation><dynamic><timeSet tini='0' tend='1' tstep='0.1'/></dynamic>
        </MBSsimulation>
        <MBSmodel name='m' massUnits='kg' lengthUnits='m' silence='no-gravity'>
        <Tables>TABLES</Tables>
        <Bodies><body name='G'><point name='o' x='0' y='0' z='0'/></body><body name='a'>
        <point name='o' x='0' y='0' z='0'/><mass value='2'/>
        <inertiaTensor Ixx='0.1' Iyy='0.1' Izz='0.1' Ixy='0' Ixz='0' Iyz='0'/></body></Bodies>
        <Joints><joint name='s' type='TYPE'><body1 name='G' point='o'/><body2 name='a' point='o'/>
        </joint></Joints><Forces/>
        <topology><root name='G'/><relCoorVals><jointVal name='s' driven='DRIVEN'/></relCoorVals>
        </topology></MBSmodel></MechML>
        """
        .replace("TABLES", tables)
        .replace("TYPE", type)
        .replace("DRIVEN", driven);
  }

  private static String list(List<Double> numbers) {
    return numbers.stream().map(Object::toString).collect(Collectors.joining(";"));
  }
}
