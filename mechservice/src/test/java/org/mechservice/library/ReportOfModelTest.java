package org.mechservice.library;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.CancellationException;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.mechservice.report.measure.Effort;
import org.mechservice.report.measure.MeasuredRun;
import org.mechservice.report.measure.MeasurementFile;
import org.mechservice.report.measure.ReportProgress;

/** The report of a model in process: its page, what it keeps, and what it refuses. */
@Tag("slow")
class ReportOfModelTest {
  private static final Path EXAMPLES = Path.of("../examples");

  /** One tolerance, each point timed once, no warm-up and no other Java machine. */
  private static final Effort LEAST =
      new Effort("least", new double[] {1e-3}, 1, 1, 0, 1, 0, 0, 60);

  @TempDir private Path folder = Path.of("");

  private static MechModel read(String example) throws Exception {
    return MechModel.read(EXAMPLES.resolve(example));
  }

  /** Reports up to a kind of work, to save the time of what follows. */
  private void reportUpTo(String work, MechModel model) {
    ReportProgress ending =
        (what, done, left) -> {
          if (what.startsWith(work)) {
            throw new CancellationException(what);
          }
        };
    assertThatThrownBy(() -> model.report(folder, LEAST, ending))
        .isInstanceOf(CancellationException.class)
        .hasMessageStartingWith(work);
  }

  @Test
  void fullDiskIsSaidOfTheFolder() throws Exception {
    Path full = Path.of("/dev/full");
    assumeTrue(Files.exists(full), "there is no /dev/full to write to");
    Files.createSymbolicLink(folder.resolve("Parameters-reference.csv.new"), full);
    MechModel model = read("elements/Parameters.xml").set("push", 3).until(0.2);

    assertThatThrownBy(() -> model.report(folder, LEAST, ReportProgress.SILENT))
        .isInstanceOf(IOException.class)
        .hasMessageStartingWith("S-042 cannot write in folder " + folder + ": No space left");
  }

  @Test
  void pageIsOfEveryMethodAndWhatWasMeasuredIsTakenUpAgain() throws Exception {
    MechModel model = read("elements/Parameters.xml").set("push", 3).until(0.2);
    Path page = model.report(folder, LEAST, ReportProgress.SILENT);
    Path runs = folder.resolve("Parameters.csv");

    assertThat(page).isEqualTo(folder.resolve("Parameters.html"));
    assertThat(Files.readString(page)).contains("DSR ode15s", "0.20 s");
    assertThat(folder.resolve("Parameters.svg")).exists();
    assertThat(MeasurementFile.read(runs).stream().map(MeasuredRun::method))
        .contains("DTR ode113", "DSR ode113", "RR ode15sR");
    assertThat(MeasurementFile.read(runs)).filteredOn(MeasuredRun::completed).isNotEmpty();

    String measured = Files.readString(runs);
    reportUpTo("shares", model);
    assertThat(runs).hasContent(measured);

    reportUpTo("errors", model.set("push", 4));
    assertThat(Files.readString(runs).lines().findFirst())
        .as("another value of a parameter is another model")
        .isNotEqualTo(measured.lines().findFirst());
  }

  /**
   * Bricard's trihedral linkage: six links along the edges of a cube, each hinge across its two
   * edges. Five of its six equations are independent, and the loop is closed by a constraint.
   */
  private static String bricard() {
    String[] corners = {"0;0;0", "1;0;0", "1;1;0", "1;1;1", "0;1;1", "0;0;1"};
    String[] centres = {"0.5 0 0", "1 0.5 0", "1 1 0.5", "0.5 1 1", "0 0.5 1", "0 0 0.5"};
    String[] axes = {"0;1;0", "0;0;1", "1;0;0", "0;1;0", "0;0;1", "1;0;0"};
    StringBuilder bodies = new StringBuilder();
    StringBuilder joints = new StringBuilder();
    String end = "<point name='end' x='0' y='0' z='0'/><vector name='axis' vx='0' vy='1' vz='0'/>";
    for (int i = 0; i < 6; i++) {
      String[] at = centres[i].split(" ", -1);
      bodies.append(
          ("<body name='l%d'>%s<cog x='%s' y='%s' z='%s'/><mass value='1'/>"
                  + "<inertiaTensor Ixx='0.1' Iyy='0.1' Izz='0.1'/></body>")
              .formatted(i, i == 0 || i == 5 ? end : "", at[0], at[1], at[2]));
      joints.append(
          i == 0
              ? ""
              : "<joint name='h%d' type='R' body1='l%d' body2='l%d' at='%s' axis='%s'/>"
                  .formatted(i, i - 1, i, corners[i], axes[i]));
    }
    return """
    <MechML>
      <MBSsimulation><dynamic>
        <timeSet tini='0' tend='0.05' tstep='0.01'/>
        <integrator name='auto' relTol='1e-6' absTol='1e-8'/>
      </dynamic></MBSsimulation>
      <MBSmodel name='Bricard' massUnits='kg' lengthUnits='m'>
        <Bodies>%s</Bodies><Joints>%s</Joints>
        <Constraints><JointConstraint name='closing' type='R'>
          <body1 name='l5' point='end' vector='axis'/>
          <body2 name='l0' point='end' vector='axis'/></JointConstraint></Constraints>
        <Forces><gravity gx='0' gy='0' gz='-9.81'/></Forces>
        <topology><root name='l0'/></topology>
      </MBSmodel>
    </MechML>
    """
        .formatted(bodies, joints);
  }

  @Test
  void loopClosedByAConstraintIsNoOpenChain() throws Exception {
    Path file = Files.writeString(folder.resolve("bricard.xml"), bricard());
    Path page = MechModel.read(file).report(folder, LEAST, ReportProgress.SILENT);
    assertThat(Files.readString(page)).contains("1 degree of freedom · closed loops ·");
  }

  /** What the progress throws ends the report; measurements before are kept. */
  @Test
  void loopsAreMeasuredWithEveryClosure() throws Exception {
    reportUpTo("shares", read("four-bar/four-bar.xml").until(0.1));

    List<MeasuredRun> runs = MeasurementFile.read(folder.resolve("four-bar.csv"));
    assertThat(runs.stream().map(MeasuredRun::method))
        .contains("DSR penalty ode113", "DSR projection ode15s");
    assertThat(runs)
        .filteredOn(run -> run.completed() && run.round() == 0)
        .isNotEmpty()
        .as("loops are closed to far less than the tolerance 1e-3")
        .allSatisfy(run -> assertThat(run.errors().residual()).isBetween(0.0, 1e-9));
  }

  @Test
  void simulationThatIsNotIntegratedIsRefused() throws Exception {
    MechModel still = read("elements/static.xml");

    assertThatThrownBy(() -> still.report(folder))
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessageStartingWith("S-008 the simulation is <static>");
  }

  /** Sixty-one pendulums have 122 unknowns, too many for the codes with dense matrices. */
  @Test
  void largeMechanismHasAReferenceInItsPartOfTheTime() throws Exception {
    Path file = Files.writeString(folder.resolve("row.xml"), row(61));
    reportUpTo("errors", MechModel.read(file));

    assertThat(Files.readString(folder.resolve("row-reference.csv")))
        .contains("Large mechanism:", "is the tightest tolerance that a solution kept")
        .contains("Checked by: Gragg-Bulirsch-Stoer extrapolation, order 10");
  }

  /** Pendulums beside each other, as many as there are velocities. */
  private static String row(int pendulums) {
    StringBuilder points = new StringBuilder();
    StringBuilder bodies = new StringBuilder();
    StringBuilder joints = new StringBuilder();
    StringBuilder starts = new StringBuilder();
    for (int i = 0; i < pendulums; i++) {
      points.append("<point name='p%d' x='%d' y='0' z='0'/>".formatted(i, i));
      bodies.append(
          ("<body name='k%d'><point name='p' x='0' y='0' z='0'/>"
                  + "<vector name='y' vx='0' vy='1' vz='0'/><cog x='%s' y='0' z='0'/>"
                  + "<mass value='1'/><inertiaTensor Ixx='0.1' Iyy='0.1' Izz='0.1'/></body>")
              .formatted(i, 0.5 + 0.01 * i));
      joints.append(
          ("<joint name='a%d' type='R'><body1 name='g' point='p%d' vector='y'/>"
                  + "<body2 name='k%d' point='p' vector='y'/></joint>")
              .formatted(i, i, i));
      starts.append("<jointVal name='a%d' posVals='0.3' velVals='0'/>".formatted(i));
    }
    return """
    <MechML>
      <MBSsimulation><dynamic>
        <timeSet tini='0' tend='0.2' tstep='0.02'/>
        <integrator name='auto' relTol='1e-6' absTol='1e-8'/>
      </dynamic></MBSsimulation>
      <MBSmodel name='Row' massUnits='kg' lengthUnits='m'>
        <Bodies><body name='g'>%s<vector name='y' vx='0' vy='1' vz='0'/></body>%s</Bodies>
        <Joints>%s</Joints>
        <Forces><gravity gx='0' gy='0' gz='-9.81'/></Forces>
        <topology><root name='g'/><relCoorVals>%s</relCoorVals></topology>
      </MBSmodel>
    </MechML>
    """
        .formatted(points, bodies, joints, starts);
  }

  @Test
  void reportWithAlmostNoTimeSaysWhatItLeftOut() throws Exception {
    Path page =
        read("elements/Parameters.xml")
            .until(0.2)
            .report(folder, LEAST.withBudget(1e-6), ReportProgress.SILENT);

    assertThat(Files.readString(page))
        .contains("The time for the report", "<code>mech report --budget SECONDS</code>")
        .contains("in place of 1 s to make the reference. Without one nothing was measured.");
  }
}
